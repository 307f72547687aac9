// SPDX-License-Identifier: MIT
#include "cageproof/reports/checked_file.h"
#include "cageproof/reports/piecewise_file.h"

#include "aside.h"
#include "aside_notes.h"

#include "cageproof/core/input_error.h"

#include <fmt/format.h>

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <charconv>
#include <cstdio>
#include <memory>
#include <optional>
#include <system_error>
#include <utility>

namespace cageproof::reports {

namespace fs = std::filesystem;

namespace {

[[noreturn]] void fail(const fs::path& path) {
  throw InputError(fmt::format("cannot write {}: {}", path.string(), std::generic_category().message(errno)));
}

struct Close {
  void operator()(std::FILE* file) const { std::fclose(file); }
};
using File = std::unique_ptr<std::FILE, Close>;

// \param named the file's name in messages
void write_to(File file, const fs::path& named, std::string_view bytes) {
  if (!file) fail(named);
  if (std::fwrite(bytes.data(), 1, bytes.size(), file.get()) != bytes.size()) fail(named);
  // A full disk may show only when the last buffer leaves.
  if (std::fclose(file.release()) != 0) fail(named);
}

// The open file that a path as /dev/stdout, /dev/fd/3 or /proc/self/fd/3 names.
std::optional<int> descriptor_of(const fs::path& path) {
  const std::string text = path.lexically_normal().string();
  for (const std::string_view folder : {"/dev/fd/", "/proc/self/fd/"}) {
    int number = 0;
    if (!text.starts_with(folder)) continue;
    const auto [end, error] = std::from_chars(text.data() + folder.size(), text.data() + text.size(), number);
    if (error == std::errc() && end == text.data() + text.size()) return number;
  }
  return std::nullopt;
}

// Where bytes go.
struct Target {
  fs::path path;
  bool direct = false;            // a device, a pipe or an open file: nothing can be renamed in its place
  std::optional<int> descriptor;  // of an open file

  File opened() const {
    if (!descriptor) return File(std::fopen(path.c_str(), "wb"));
    // A second descriptor of the same open file: later output continues behind the bytes written here.
    const int same = ::dup(*descriptor);
    return File(same < 0 ? nullptr : ::fdopen(same, "wb"));
  }
};

// Where a link leads, if need be to a file that does not exist yet: whoever made the link wants it kept.
Target target_of(const fs::path& named) {
  std::error_code error;
  fs::path path = named;
  for (int links = 0; !descriptor_of(path) && fs::is_symlink(path, error); ++links) {
    errno = ELOOP;
    if (links == 40) fail(named);
    const fs::path next = fs::read_symlink(path, error);
    path = next.is_absolute() ? next : path.parent_path() / next;
  }
  if (const auto descriptor = descriptor_of(path)) return {path, true, descriptor};
  const fs::file_type type = fs::status(path, error).type();
  const bool special = type == fs::file_type::character || type == fs::file_type::fifo ||
                       type == fs::file_type::block || type == fs::file_type::socket;
  return {path, special, std::nullopt};
}

std::vector<Target> targets_of(const std::vector<fs::path>& paths) {
  std::vector<Target> targets;
  for (const fs::path& path : paths) {
    targets.push_back(target_of(path));
    const auto place = [](const Target& target) { return fs::absolute(target.path).lexically_normal(); };
    for (std::size_t i = 0; i + 1 < targets.size(); ++i)
      if (!targets[i].direct && place(targets[i]) == place(targets.back()))
        throw InputError(fmt::format("cannot write {} and {}: they are the same file, {}", paths[i].string(),
                                     path.string(), targets[i].path.string()));
  }
  return targets;
}

}  // namespace

void write_file(const fs::path& path, std::string_view bytes) {
  write_to(File(std::fopen(path.c_str(), "wb")), path, bytes);
}

void require_writable(const std::vector<fs::path>& paths) {
  const std::vector<Target> targets = targets_of(paths);
  for (std::size_t i = 0; i < paths.size(); ++i) {
    const Target& target = targets[i];
    if (target.descriptor) continue;
    std::error_code reason;
    if (fs::is_directory(target.path, reason)) {
      errno = EISDIR;
      fail(paths[i]);
    }
    const fs::path parent = target.path.has_parent_path() ? target.path.parent_path() : fs::path(".");
    if (fs::status(parent, reason).type() == fs::file_type::not_found)
      throw InputError(
          fmt::format("cannot write {}: the folder {} does not exist", paths[i].string(), parent.string()));
    if (!target.direct && fs::exists(parent, reason) && !fs::is_directory(parent, reason))
      throw InputError(fmt::format("cannot write {}: {} is no folder", paths[i].string(), parent.string()));
    if (::access((target.direct ? target.path : parent).c_str(), target.direct ? W_OK : W_OK | X_OK) != 0)
      fail(paths[i]);
  }
}

struct PiecewiseFile::State {
  explicit State(const fs::path& path) : named(path), target(target_of(path)) {
    if (!target.direct) {
      remove_leftovers(target.path);
      fresh = aside(target.path, 0);
      note = std::make_unique<AsideNote>(fresh);
    }
    descriptor = target.descriptor ? ::dup(*target.descriptor)
                                   : ::open((target.direct ? target.path : fresh).c_str(),
                                            O_WRONLY | O_CLOEXEC | (target.direct ? 0 : O_CREAT | O_TRUNC), 0666);
    if (descriptor < 0) fail(named);
  }
  ~State() {
    if (descriptor >= 0) ::close(descriptor);
    std::error_code ignored;
    if (!is_renamed && !target.direct) fs::remove(fresh, ignored);
  }
  State(const State&) = delete;
  State& operator=(const State&) = delete;

  // \param write writes a part of the rest, as ::write does
  template <class Write>
  void put(std::string_view bytes, Write write) const {
    while (!bytes.empty()) {
      const ::ssize_t done = write(bytes);
      if (done < 0 && errno == EINTR) continue;
      if (done <= 0) fail(named);
      bytes.remove_prefix(static_cast<std::size_t>(done));
    }
  }

  // A full disk may show only here.
  void close() {
    if (::close(std::exchange(descriptor, -1)) != 0) fail(named);
  }

  fs::path named, fresh;
  Target target;
  std::unique_ptr<AsideNote> note;
  int descriptor = -1;
  bool is_renamed = false;
};

PiecewiseFile::PiecewiseFile(const fs::path& path) : state_(std::make_unique<State>(path)) {}
PiecewiseFile::~PiecewiseFile() = default;

bool PiecewiseFile::takes_any_order() const { return !state_->target.direct; }

void PiecewiseFile::append(std::string_view bytes) {
  state_->put(bytes, [&](std::string_view left) { return ::write(state_->descriptor, left.data(), left.size()); });
}

void PiecewiseFile::write_at(std::uint64_t offset, std::string_view bytes) {
  state_->put(bytes, [&](std::string_view left) {
    const auto at = static_cast<::off_t>(offset + bytes.size() - left.size());
    return ::pwrite(state_->descriptor, left.data(), left.size(), at);
  });
}

namespace {

// Files to be written, whole and aside, and where.
class Replacement {
 public:
  // \param first number of the first one aside
  Replacement(const std::vector<std::pair<fs::path, std::string>>& files, std::vector<Target> targets, int first)
      : files_(files), targets_(std::move(targets)), first_(first) {
    for (std::size_t i = 0; i < files_.size(); ++i) {
      if (targets_[i].direct) continue;
      remove_leftovers(targets_[i].path);
      notes_.push_back(std::make_unique<AsideNote>(fresh(i)));
    }
  }

  void write_aside() {
    try {
      while (written_ < files_.size()) {
        const std::size_t i = written_++;
        if (targets_[i].direct) continue;
        write_to(File(std::fopen(fresh(i).c_str(), "wb")), files_[i].first, files_[i].second);
        require_no_folder(targets_[i], files_[i].first);
      }
    } catch (const InputError&) {
      remove_fresh(0);
      throw;
    }
  }

  // \pre undisturbed() is held
  void rename() {
    for (std::size_t i = 0; i < files_.size(); ++i) {
      if (targets_[i].direct || std::rename(fresh(i).c_str(), targets_[i].path.c_str()) == 0) continue;
      const int reason = errno;
      remove_fresh(i);
      errno = reason;
      fail(files_[i].first);
    }
  }

  // Devices and pipes come last, because output to them cannot be taken back.
  void write_direct() const {
    for (std::size_t i = 0; i < files_.size(); ++i)
      if (targets_[i].direct) write_to(targets_[i].opened(), files_[i].first, files_[i].second);
  }

  void remove_fresh(std::size_t first) const {
    std::error_code ignored;
    for (std::size_t i = first; i < written_; ++i)
      if (!targets_[i].direct) fs::remove(fresh(i), ignored);
  }

  // A folder of that name is found before anything is renamed.
  static void require_no_folder(const Target& target, const fs::path& named) {
    std::error_code ignored;
    if (!fs::is_directory(target.path, ignored)) return;
    errno = EISDIR;
    fail(named);
  }

 private:
  fs::path fresh(std::size_t i) const { return aside(targets_[i].path, first_ + static_cast<int>(i)); }

  const std::vector<std::pair<fs::path, std::string>>& files_;
  std::vector<Target> targets_;
  int first_;
  std::vector<std::unique_ptr<AsideNote>> notes_;
  std::size_t written_ = 0;
};

std::vector<fs::path> paths_of(const std::vector<std::pair<fs::path, std::string>>& files) {
  std::vector<fs::path> paths;
  paths.reserve(files.size());
  for (const auto& file : files) paths.push_back(file.first);
  return paths;
}

}  // namespace

void replace_files(const std::vector<std::pair<fs::path, std::string>>& files) {
  Replacement replacement(files, targets_of(paths_of(files)), 0);
  replacement.write_aside();
  {
    const auto lock = undisturbed();
    replacement.rename();
  }
  replacement.write_direct();
}

void replace_files(PiecewiseFile& pieces, const std::vector<std::pair<fs::path, std::string>>& others) {
  PiecewiseFile::State& whole = *pieces.state_;
  std::vector<fs::path> paths = paths_of(others);
  paths.insert(paths.begin(), whole.named);
  std::vector<Target> targets = targets_of(paths);
  targets.erase(targets.begin());
  Replacement replacement(others, std::move(targets), 1);
  replacement.write_aside();
  try {
    whole.close();
    if (!whole.target.direct) {
      Replacement::require_no_folder(whole.target, whole.named);
      const auto lock = undisturbed();
      if (std::rename(whole.fresh.c_str(), whole.target.path.c_str()) != 0) fail(whole.named);
      whole.is_renamed = true;
      replacement.rename();
    } else {
      const auto lock = undisturbed();
      replacement.rename();
    }
  } catch (const InputError&) {
    replacement.remove_fresh(0);
    throw;
  }
  replacement.write_direct();
}

void replace_file(const fs::path& path, std::string_view bytes) { replace_files({{path, std::string(bytes)}}); }

}  // namespace cageproof::reports
