// SPDX-License-Identifier: MIT
// One process of foreign code, as who asks it sees it.
#pragma once

#include "cageproof/judge/foreign_code.h"

#include <map>
#include <optional>
#include <stdexcept>

namespace cageproof::judge {

/// The process cannot be asked any more.
struct Fault : std::runtime_error {
  Fault(std::string what_kind, const std::string& text, std::size_t at = 0)
      : std::runtime_error(text), kind(std::move(what_kind)), index(at) {}
  std::string kind;   ///< Incident::kind
  std::size_t index;  ///< of what was asked when it happened
};

/// Its description of itself.
struct Description {
  std::string about;
  std::optional<std::map<std::string, int>> orders;  ///< by formula; nothing where it does not say
};

class Worker {
 public:
  Worker() = default;
  virtual ~Worker() = default;
  Worker(const Worker&) = delete;
  Worker& operator=(const Worker&) = delete;

  virtual Description describe() = 0;
  /// Fills answers up to where a fault happens. \param note takes what is wrong and ends nothing: kind, text, index
  using Note = std::function<void(std::string kind, std::string text, std::size_t index)>;
  virtual void ask(const Request& request, std::span<const Asked> asked, std::span<Answer> answers, double* nanoseconds,
                   const Note& note) = 0;
  /// Ends it. \return what it leaves behind, and should not: kind and text
  virtual std::vector<std::pair<std::string, std::string>> finish() = 0;
};

std::unique_ptr<Worker> library_worker(const std::string& path, const Limits& limits);
std::unique_ptr<Worker> command_worker(const std::string& command, const Limits& limits);

}  // namespace cageproof::judge
