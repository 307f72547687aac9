// SPDX-License-Identifier: MIT
#include "cageproof/judge/foreign_code.h"

#include "reach/sha256.h"
#include "reach/worker.h"

#include "cageproof/core/catalogue/name_pattern.h"
#include "cageproof/core/input_error.h"
#include "cageproof/core/whole_file.h"
#include "cageproof/judge/foreign.h"

#include <fmt/format.h>

#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <regex>
#include <sstream>

namespace cageproof::judge {
namespace {

// Each costs its time limit, or the start of a process.
constexpr int most_hangs = 3, most_faults = 40;

bool names_library(const std::string& what) {
  static const std::regex library(R"(.*\.so(\.[0-9]+)*)");
  return std::regex_match(what, library);
}

// Where the shell finds a command.
std::string found_in_path(const std::string& word) {
  if (word.find('/') != std::string::npos) return word;
  const char* const path = std::getenv("PATH");
  std::istringstream folders(path == nullptr ? "" : path);
  for (std::string file; std::getline(folders, file, ':');) {
    file.append("/").append(word);
    if (access(file.c_str(), X_OK) == 0) return file;
  }
  return word;
}

// The library, or the words of a command that are files.
std::vector<JudgedFile> files_of(const std::string& what, bool is_library) {
  std::vector<JudgedFile> files;
  std::istringstream words(what);
  for (std::string word; is_library ? files.empty() : static_cast<bool>(words >> word);) {
    const std::string path = is_library ? what : files.empty() ? found_in_path(word) : word;
    std::error_code error;
    if (std::filesystem::is_regular_file(path, error)) files.push_back({path, sha256(read_file(path))});
    else if (is_library) throw InputError(fmt::format("cannot read {}: no such file", path));
  }
  return files;
}

// An element and a point that no formula finds difficult.
Asked easy_input(const Formula& formula) {
  constexpr std::array<std::array<double, 3>, 4> square{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}};
  constexpr std::array<double, 3> place{0.375, 0.25, 0.75};
  Asked asked;
  for (int k = 0; k < formula.corners(); ++k)
    for (int c = 0; c < formula.dim(); ++c) asked.corners.push_back(square[k][c]);
  for (int c = 0; c < formula.dim(); ++c) asked.points.push_back(place[c]);
  for (const Parameter& p : formula.parameters) asked.parameters.push_back(p.preset);
  return asked;
}

// Trouble at one input may be another's doing: the first of [begin, end) that fails by itself, or end.
template <class Attempt>
std::size_t culprit(std::size_t begin, std::size_t end, const Attempt& attempt) {
  while (begin < end && !attempt(begin, begin + 1)) ++begin;
  return begin;
}

}  // namespace

ForeignCode::ForeignCode(std::string what, Limits limits)
    : what_(std::move(what)), limits_(std::move(limits)), is_library_(names_library(what_)) {
  files_ = files_of(what_, is_library_);
  std::unique_ptr<Worker> worker = start();
  Description description;
  try {
    description = worker->describe();
  } catch (const Fault& fault) {
    throw InputError(fmt::format("{}: {}", what_, fault.what()));
  }
  about_ = description.about;
  says_formulas_ = description.orders.has_value();
  if (says_formulas_) said_ = std::move(*description.orders);
  give_back(std::move(worker));
}

ForeignCode::~ForeignCode() = default;

std::unique_ptr<Worker> ForeignCode::start() {
  return is_library_ ? library_worker(std::filesystem::absolute(what_), limits_) : command_worker(what_, limits_);
}

std::unique_ptr<Worker> ForeignCode::take() {
  {
    const std::scoped_lock lock(mutex_);
    if (!idle_.empty()) {
      std::unique_ptr<Worker> worker = std::move(idle_.back());
      idle_.pop_back();
      return worker;
    }
  }
  return start();
}

void ForeignCode::give_back(std::unique_ptr<Worker> worker) {
  const std::scoped_lock lock(mutex_);
  idle_.push_back(std::move(worker));
}

int ForeignCode::order_of(const Formula& formula, bool single) {
  if (says_formulas_) {
    const auto found = said_.find(std::string(formula.name) + (single ? " float" : ""));
    return found == said_.end() ? -1 : found->second;
  }
  // Programs that do not say are taken to compute in double.
  if (single) return -1;
  {
    const std::scoped_lock lock(mutex_);
    const auto known = orders_.find({formula.name, single});
    if (known != orders_.end()) return known->second;
  }
  int order = -1;
  const Asked input = easy_input(formula);
  for (int asked = 0; asked <= 2; ++asked) {
    std::unique_ptr<Worker> worker = take();
    Answer answer;
    bool is_whole = true;
    try {
      worker->ask({&formula, asked, single}, {&input, 1}, {&answer, 1}, nullptr,
                  [&](const std::string&, const std::string&, std::size_t) { is_whole = false; });
      give_back(std::move(worker));
    } catch (const Fault& fault) {
      if (asked == 0) throw InputError(fmt::format("{}: {}, order 0: {}", what_, formula.name, fault.what()));
      break;
    }
    if (answer.status != Answer::Status::Given || !is_whole) break;
    order = asked;
  }
  const std::scoped_lock lock(mutex_);
  return orders_[{formula.name, single}] = order;
}

bool ForeignCode::has_had_enough(std::string_view subject) const {
  const std::scoped_lock lock(mutex_);
  const auto found = trouble_.find(subject);
  return found != trouble_.end() && (found->second.hangs >= most_hangs || found->second.others >= most_faults);
}

std::vector<Answer> ForeignCode::ask(const Request& request, std::span<const Asked> asked, double* nanoseconds) {
  std::vector<Answer> answers(asked.size());
  const auto incident = [&](std::string kind, std::string text, std::size_t index) {
    note({std::move(kind), std::move(text), std::string(request.subject()), request.order,
          index < asked.size() ? exact_line(request, asked[index], 0) : ""});
  };
  // Asks those in [begin, end); nothing, or the fault that it ended by.
  const auto attempt = [&](std::size_t begin, std::size_t end) -> std::optional<Fault> {
    std::unique_ptr<Worker> worker = take();
    try {
      worker->ask(request, asked.subspan(begin, end - begin), std::span(answers).subspan(begin, end - begin),
                  nanoseconds, [&](std::string kind, std::string text, std::size_t index) {
                    incident(std::move(kind), std::move(text), begin + index);
                  });
      give_back(std::move(worker));
      return std::nullopt;
    } catch (Fault& fault) {
      fault.index += begin;
      return fault;
    }
  };
  for (std::size_t begin = 0; begin < asked.size();) {
    if (has_had_enough(request.subject())) {
      const std::scoped_lock lock(mutex_);
      skipped_ += asked.size() - begin;
      break;
    }
    std::optional<Fault> fault = attempt(begin, asked.size());
    if (!fault) break;
    std::size_t at = fault->index;
    {
      const std::scoped_lock lock(mutex_);
      Trouble& trouble = trouble_[request.subject()];
      ++(fault->kind == "hang" ? trouble.hangs : trouble.others);
    }
    // By itself, in a fresh process: what came before it may be to blame.
    const bool was_alone = at == begin && asked.size() - begin == 1;
    answers[at] = {};
    if (!was_alone && fault->kind != "hang") {
      const std::size_t noticed = at;
      if (!attempt(at, at + 1)) at = culprit(begin, at, attempt);
      if (at == noticed && answers[at].status == Answer::Status::Given) fault->kind += " after others";
      else answers[at] = {};
      incident(fault->kind, fault->what(), at);
      begin = noticed + 1;
      continue;
    }
    incident(fault->kind, fault->what(), at);
    begin = at + 1;
  }
  return answers;
}

void ForeignCode::note(Incident incident) {
  const std::scoped_lock lock(mutex_);
  for (Incident& known : incidents_)
    if (known.kind == incident.kind && known.formula == incident.formula) {
      ++known.count;
      return;
    }
  incidents_.push_back(std::move(incident));
}

void ForeignCode::finish() {
  std::vector<std::unique_ptr<Worker>> ending;
  {
    const std::scoped_lock lock(mutex_);
    ending.swap(idle_);
  }
  for (const auto& worker : ending)
    for (auto& [kind, text] : worker->finish()) note({kind, text, "", 0, ""});
}

std::vector<Incident> ForeignCode::incidents() const {
  const std::scoped_lock lock(mutex_);
  return incidents_;
}

std::uint64_t ForeignCode::skipped() const {
  const std::scoped_lock lock(mutex_);
  return skipped_;
}

std::pair<std::string, std::string> name_and_what(const std::string& text) {
  static const std::regex form(R"(([A-Za-z][A-Za-z0-9_.+-]*)=(.*\S.*))");
  std::smatch parts;
  if (!std::regex_match(text, parts, form))
    throw InputError(fmt::format("'{}' is not NAME=WHAT, such as mine=./libmine.so or mine='./my_program'", text));
  return {parts[1], parts[2]};
}

}  // namespace cageproof::judge
