// SPDX-License-Identifier: MIT
#include "truth/truth_cache.h"

#include "cageproof/core/input_error.h"
#include "cageproof/core/numbers/scalar_text.h"
#include "cageproof/core/whole_file.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <fstream>
#include <random>
#include <sstream>
#include <vector>

namespace cageproof::validation {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view first_word = "cageproof-truth-1";

std::atomic<TruthCache*> current{nullptr};

std::uint64_t hash_of(std::string_view text, std::uint64_t hash) {
  for (const char c : text) {
    hash = (hash ^ static_cast<unsigned char>(c)) * 1099511628211U;
    hash ^= hash >> 32;
  }
  return hash;
}

// Two hashes, for a file's name and for its content; a question that has another's name finds another's text there.
std::string digest_of(std::string_view text) {
  return fmt::format("{:016x}{:016x}", hash_of(text, 14695981039346656037U), hash_of(text, 88172645463325252U));
}

std::string framed(const std::string& question, const std::string& truth) {
  const std::string content = question + "\n" + truth;
  return fmt::format("{} {}\n{}", first_word, digest_of(content), content);
}

// The truth's text in a file's; nothing where the file is damaged or another question's.
std::optional<std::string> unframed(const std::string& file, const std::string& question) {
  const std::size_t line = file.find('\n');
  if (line == std::string::npos) return std::nullopt;
  const std::string content = file.substr(line + 1);
  if (file.substr(0, line) != fmt::format("{} {}", first_word, digest_of(content))) return std::nullopt;
  if (!content.starts_with(question + "\n")) return std::nullopt;
  return content.substr(question.size() + 1);
}

std::uintmax_t size_of(const fs::path& folder) {
  std::uintmax_t bytes = 0;
  std::error_code none;
  for (fs::recursive_directory_iterator at(folder, none), end; !none && at != end; at.increment(none))
    if (std::error_code failed; at->is_regular_file(failed)) {
      const std::uintmax_t size = at->file_size(failed);
      if (!failed) bytes += size;
    }
  return bytes;
}

// Other versions' folders, the oldest first, until there is room.
std::uintmax_t make_room(const fs::path& folder, const fs::path& own) {
  std::uintmax_t bytes = size_of(folder);
  std::vector<std::pair<fs::file_time_type, fs::path>> others;
  std::error_code none;
  for (fs::directory_iterator at(folder, none), end; !none && at != end; at.increment(none))
    if (at->path() != own && at->is_directory(none)) others.emplace_back(at->last_write_time(none), at->path());
  std::ranges::sort(others);
  for (const auto& [time, other] : others) {
    if (bytes < TruthCache::most_bytes / 2) break;
    bytes -= std::min(bytes, size_of(other));
    fs::remove_all(other, none);
  }
  return bytes;
}

void add(std::string& text, const std::vector<Mp100>& numbers) {
  text += fmt::format("{}", numbers.size());
  for (const Mp100& x : numbers)
    text += (isnan(x) ? " nan" : signbit(x) ? " -" : " ") + (isnan(x) ? "" : format_scalar(Mp100(abs(x))));
  text += "\n";
}

bool read(std::istream& in, std::vector<Mp100>& numbers) {
  std::size_t count = 0;
  if (!(in >> count) || count > 100000) return false;
  numbers.clear();
  std::string word;
  while (numbers.size() < count && in >> word) {
    const bool negative = word.starts_with('-');
    const auto size = parse_scalar<Mp100>(word.substr(negative ? 1 : 0));
    if (!size) return false;
    numbers.push_back(negative ? Mp100(-*size) : *size);
  }
  return numbers.size() == count;
}

}  // namespace

std::string text_of(const Truth& truth) {
  std::string text = fmt::format("{} {}", int{truth.tensors.converged}, int{truth.on_element});
  for (int o = 0; o < 3; ++o)
    text += fmt::format(" {} {} {}", int{truth.exists[o]}, int{truth.required[o]}, int{truth.partial[o]});
  text += "\n";
  for (int o = 0; o < 3; ++o) add(text, truth.tensors.of(o));
  add(text, {truth.norm.begin(), truth.norm.end()});
  add(text, {truth.conditioned.begin(), truth.conditioned.end()});
  return text;
}

std::optional<Truth> truth_of(const std::string& text) {
  std::istringstream in(text);
  Truth truth;
  in >> truth.tensors.converged >> truth.on_element;
  for (int o = 0; o < 3; ++o) in >> truth.exists[o] >> truth.required[o] >> truth.partial[o];
  for (int o = 0; o < 3; ++o)
    if (!read(in, truth.tensors.of(o))) return std::nullopt;
  std::vector<Mp100> norm, conditioned;
  if (!read(in, norm) || !read(in, conditioned) || norm.size() != 3 || conditioned.size() != 3) return std::nullopt;
  std::ranges::copy(norm, truth.norm.begin());
  std::ranges::copy(conditioned, truth.conditioned.begin());
  return truth;
}

std::string question_of(const TruthSource& source, const Sample& sample, int order) {
  std::string question = fmt::format("{} by {} {} {}, order {}, at", source.evaluation.formula().name,
                                     source.values.name(), source.confirmation.name(), source.yardstick.name(), order);
  const auto add = [&](const Vec3<double>& v) {
    for (const double x : v) question += " " + format_hex(x);
  };
  for (const Vec3<double>& corner : sample.corners) add(corner);
  add(sample.point);
  for (const double p : sample.parameters) question += " " + format_hex(p);
  return question;
}

std::optional<std::string> TruthCache::why_not(const fs::path& folder, const std::string& version) {
  const fs::path own = folder / version;
  std::error_code failed;
  fs::create_directories(own, failed);
  if (!failed && ::access(own.c_str(), W_OK | X_OK) != 0) failed.assign(errno, std::generic_category());
  if (!failed) return std::nullopt;
  return fmt::format("{}: {}; name another folder with --truth-cache, or `off`", own.string(), failed.message());
}

TruthCache::TruthCache(const fs::path& folder, const std::string& version, unsigned checked)
    : folder_(folder / version), checked_(checked), chance_(std::random_device()()) {
  if (const auto reason = why_not(folder, version)) throw InputError(*reason);
  bytes_ = make_room(folder, folder_);
}

fs::path TruthCache::path_of(const std::string& question) const {
  const std::string name = digest_of(question);
  return folder_ / name.substr(0, 2) / name.substr(2);
}

bool TruthCache::is_checked(const std::string& question) const { return hash_of(question, chance_) % checked_ == 0; }

void TruthCache::keep(const fs::path& path, const std::string& text) {
  const std::uintmax_t bytes = bytes_ += text.size();
  if (bytes > most_bytes) return;
  static std::atomic<unsigned> number{0};
  // Whole or not at all; where nothing can be written, nothing is kept.
  const fs::path aside = fmt::format("{}.{}-{}", path.string(), ::getpid(), number++);
  std::error_code failed;
  fs::create_directories(path.parent_path(), failed);
  {
    std::ofstream file(aside, std::ios::binary);
    file << text;
    if (!file.flush()) failed = std::make_error_code(std::errc::io_error);
  }
  if (!failed) fs::rename(aside, path, failed);
  if (failed) fs::remove(aside, failed);
}

Truth TruthCache::get(const std::string& question, const std::function<Truth()>& make) {
  const fs::path path = path_of(question);
  std::optional<std::string> text;
  if (std::error_code none; fs::exists(path, none)) {
    try {
      text = unframed(read_file(path), question);
    } catch (const InputError&) {
      // Deleted, or not to be read.
      text.reset();
    }
  }
  std::optional<Truth> kept = text ? truth_of(*text) : std::nullopt;
  if (kept && !is_checked(question)) {
    ++taken_;
    return std::move(*kept);
  }
  Truth made = make();
  ++made_;
  const std::string found = text_of(made);
  if (kept && *text != found)
    throw InputError(
        fmt::format("{}: the truth that is kept there is not the one that this program computes ({}); delete the "
                    "folder {}, and ask "
                    "why: the same program gives the same truth",
                    path.string(), question, folder_.string()));
  if (!kept) keep(path, framed(question, found));
  return made;
}

TruthCache* truth_cache() { return current; }
CachedTruths::CachedTruths(TruthCache* cache) { current = cache; }
CachedTruths::~CachedTruths() { current = nullptr; }

}  // namespace cageproof::validation
