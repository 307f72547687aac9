// SPDX-License-Identifier: MIT
// Foreign code in a process of its own, beside the host that keeps it, as who started it sees it.
#pragma once

#include "reach/descriptor.h"
#include "reach/worker.h"

#include <chrono>
#include <functional>

namespace cageproof::judge {

using Clock = std::chrono::steady_clock;

/// The time in so many seconds.
inline Clock::time_point in_seconds(double seconds) {
  return Clock::now() + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds));
}

class KeptProcess {
 public:
  /// Starts a host and the code in it. \param kind "library" or "command" \param memory descriptor of what a library
  /// shares with this process; -1: none \throws InputError where the host cannot be started
  KeptProcess(const std::string& kind, const std::string& what, const Limits& limits, int memory);
  ~KeptProcess();
  KeptProcess(const KeptProcess&) = delete;
  KeptProcess& operator=(const KeptProcess&) = delete;

  /// write() to the code, without a signal where it has gone.
  ssize_t send(const void* bytes, std::size_t count) const;
  int answers() const { return answers_.get(); }

  enum class Event { Readable, Writable, Ended, Late };
  /// Waits for the code's answer, or, where `writes`, until it takes more.
  Event wait(Clock::time_point until, bool writes);
  /// Says how code ended, or why it is not asked again, as kind and sentence. Ends whatever is left of it.
  /// \param why of code that is still there: kind and sentence; where it had ended by itself that is said instead
  Fault fault(const std::string& kind, const std::string& why);
  /// Lets it end by itself, for a while. \return as Worker::finish
  std::vector<std::pair<std::string, std::string>> finish();
  /// Bytes that a library has written to standard output.
  std::uint64_t written_out() const;

 private:
  bool read_status(Clock::time_point until);
  void end_all();
  std::string last_words() const;

  Limits limits_;
  Descriptor requests_, answers_, status_, lifeline_, out_, err_;
  pid_t host_ = -1;
  bool is_over_ = false, host_is_gone_ = false;
  std::string said_;
};

}  // namespace cageproof::judge
