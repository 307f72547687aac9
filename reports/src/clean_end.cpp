// SPDX-License-Identifier: MIT
#include "cageproof/reports/clean_end.h"

#include "aside_notes.h"

#include <fcntl.h>
#include <signal.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <chrono>
#include <thread>

namespace cageproof::reports {
namespace {

namespace fs = std::filesystem;

constexpr std::array signals{SIGINT, SIGTERM, SIGHUP, SIGPIPE};

// The handler may touch nothing else: it writes the signal's number to a pipe, and a thread does the rest.
std::atomic<int> ending{0};
int to_thread = -1;
std::array<struct sigaction, signals.size()> actions_before{};

extern "C" void tell_thread(int number) {
  const int error = errno;
  ending.store(number);
  const auto byte = static_cast<unsigned char>(number);
  [[maybe_unused]] const auto written = ::write(to_thread, &byte, 1);
  // A thread that writes to a pipe without readers stops here, because nobody would read more, or a message.
  if (number == SIGPIPE)
    for (;;) ::pause();
  errno = error;
}

// Other threads may still be writing, so their new files are removed, too.
void remove_what_is_aside() {
  for (int round = 0; round < 100; ++round) {
    bool left = false;
    for (const fs::path& path : noted_aside()) {
      std::error_code error;
      fs::remove_all(path, error);
      left = left || error || fs::exists(fs::symlink_status(path, error));
    }
    if (!left) return;
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
}

[[noreturn]] void end_by(int number) {
  // Held to the end, so that no file is put in its place any more: threads that try to wait.
  const auto lock = undisturbed();
  remove_what_is_aside();
  // The original action ends the program, so that shells see the signal.
  for (std::size_t k = 0; k < signals.size(); ++k)
    if (signals[k] == number) ::sigaction(number, &actions_before[k], nullptr);
  ::kill(::getpid(), number);
  std::this_thread::sleep_for(std::chrono::milliseconds(500));
  ::_exit(128 + number);
}

void start_thread() {
  std::array<int, 2> ends{};
  if (::pipe2(ends.data(), O_CLOEXEC) != 0) return;
  to_thread = ends[1];
  std::thread([from = ends[0]] {
    unsigned char byte = 0;
    for (;;) {
      const auto count = ::read(from, &byte, 1);
      if (count == 1) end_by(byte);
      if (count == 0 || errno != EINTR) return;
    }
  }).detach();
}

}  // namespace

void end_cleanly_on_signals() {
  // A file beyond `ulimit -f` is an error of its write then, which is told as a full disk is.
  ::signal(SIGXFSZ, SIG_IGN);
  if (to_thread < 0) start_thread();
  if (to_thread < 0) return;
  for (std::size_t k = 0; k < signals.size(); ++k) {
    struct sigaction now {};
    if (::sigaction(signals[k], nullptr, &now) != 0) continue;
    const bool with_facts = (now.sa_flags & SA_SIGINFO) != 0;
    if (!with_facts && (now.sa_handler == SIG_IGN || now.sa_handler == &tell_thread)) continue;
    actions_before[k] = now;
    struct sigaction ours {};
    ours.sa_handler = &tell_thread;
    ours.sa_flags = SA_RESTART;
    ::sigaction(signals[k], &ours, nullptr);
  }
}

void wait_if_ending() {
  while (ending.load() != 0) ::pause();
}

}  // namespace cageproof::reports
