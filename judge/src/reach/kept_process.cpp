// SPDX-License-Identifier: MIT
#include "reach/kept_process.h"

#include "reach/process_tree.h"
#include "reach/shared_block.h"

#include "cageproof/core/input_error.h"
#include "cageproof/judge/host.h"

#include <fmt/format.h>

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/stat.h>
#include <sys/wait.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <mutex>
#include <set>
#include <string_view>

extern char** environ;

namespace cageproof::judge {
namespace {

// Hosts that run, so that what they lose by being killed is told apart from them.
struct Hosts {
  std::mutex mutex;
  std::set<pid_t> running;
};

// Never destroyed: code that commands registered ends after all other statics.
Hosts& hosts() {
  static auto* const all = new Hosts;
  return *all;
}

[[noreturn]] void cannot(const char* what) {
  throw InputError(fmt::format("cannot start foreign code: {}: {}", what, std::strerror(errno)));
}

// Beyond the numbers that a host's descriptors have, so that setting one does not close another.
Descriptor moved_up(int fd, const char* what) {
  constexpr int beyond = 20;
  Descriptor low(fd);
  Descriptor high(fcntl(fd, F_DUPFD_CLOEXEC, beyond));
  if (high.get() < 0) cannot(what);
  return high;
}

struct Pipe {
  Descriptor read, write;
};

Pipe make_pipe() {
  std::array<int, 2> ends{};
  if (pipe2(ends.data(), O_CLOEXEC) != 0) cannot("pipe");
  Pipe made{Descriptor(ends[0]), Descriptor(ends[1])};
  Pipe high{Descriptor(fcntl(ends[0], F_DUPFD_CLOEXEC, 20)), Descriptor(fcntl(ends[1], F_DUPFD_CLOEXEC, 20))};
  if (high.read.get() < 0 || high.write.get() < 0) cannot("pipe");
  return high;
}

Descriptor make_file(const char* name) {
  const int fd = memfd_create(name, MFD_CLOEXEC);
  if (fd < 0) cannot(name);
  return moved_up(fd, name);
}

// Processes that a killed host has left to this one. What other rooms start stays in this session.
void sweep() {
  const std::scoped_lock lock(hosts().mutex);
  const pid_t own = getsid(0);
  kill_descendants([&](pid_t pid) { return !hosts().running.contains(pid) && getsid(pid) != own; });
}

class Actions {
 public:
  Actions() {
    posix_spawn_file_actions_init(&actions_);
    posix_spawnattr_init(&attributes_);
    sigset_t all, none;
    sigfillset(&all);
    sigemptyset(&none);
    posix_spawnattr_setsigdefault(&attributes_, &all);
    posix_spawnattr_setsigmask(&attributes_, &none);
    posix_spawnattr_setflags(&attributes_, POSIX_SPAWN_SETSID | POSIX_SPAWN_SETSIGDEF | POSIX_SPAWN_SETSIGMASK);
  }
  ~Actions() {
    posix_spawn_file_actions_destroy(&actions_);
    posix_spawnattr_destroy(&attributes_);
  }
  Actions(const Actions&) = delete;
  Actions& operator=(const Actions&) = delete;
  void give(int fd, int as) { posix_spawn_file_actions_adddup2(&actions_, fd, as); }
  pid_t spawn(const std::vector<std::string>& words) {
    std::vector<char*> arguments;
    arguments.reserve(words.size() + 1);
    for (const std::string& word : words) arguments.push_back(const_cast<char*>(word.c_str()));
    arguments.push_back(nullptr);
    pid_t pid = -1;
    const std::scoped_lock lock(hosts().mutex);
    const int error = posix_spawn(&pid, words.front().c_str(), &actions_, &attributes_, arguments.data(), environ);
    if (error != 0)
      throw InputError(fmt::format("cannot start foreign code: {}: {}", words.front(), std::strerror(error)));
    hosts().running.insert(pid);
    return pid;
  }

 private:
  posix_spawn_file_actions_t actions_{};
  posix_spawnattr_t attributes_{};
};

}  // namespace

KeptProcess::KeptProcess(const std::string& kind, const std::string& what, const Limits& limits, int memory)
    : limits_(limits) {
  // Whatever a killed host leaves becomes this process's, which ends it.
  prctl(PR_SET_CHILD_SUBREAPER, 1);
  Pipe requests = make_pipe(), answers = make_pipe(), status = make_pipe(), lifeline = make_pipe();
  out_ = make_file("standard output");
  err_ = make_file("standard error");
  const Descriptor nothing = moved_up(open("/dev/null", O_RDWR | O_CLOEXEC), "/dev/null");
  Actions actions;
  actions.give(nothing.get(), STDIN_FILENO);
  actions.give(out_.get(), STDOUT_FILENO);
  actions.give(err_.get(), STDERR_FILENO);
  actions.give(lifeline.read.get(), descriptor::lifeline);
  actions.give(status.write.get(), descriptor::status);
  actions.give(requests.read.get(), descriptor::requests);
  actions.give(answers.write.get(), descriptor::answers);
  actions.give(memory >= 0 ? memory : nothing.get(), descriptor::memory);
  std::vector<std::string> words = limits.host;
  if (words.empty()) words = {"/proc/self/exe"};
  for (const std::string& word :
       {std::string(host_argument), kind, what, std::to_string(limits.memory), std::to_string(limits.written)})
    words.push_back(word);
  host_ = actions.spawn(words);
  requests_ = std::move(requests.write);
  answers_ = std::move(answers.read);
  status_ = std::move(status.read);
  lifeline_ = std::move(lifeline.write);
  for (const int fd : {requests_.get(), answers_.get(), status_.get()}) fcntl(fd, F_SETFL, O_NONBLOCK);
}

KeptProcess::~KeptProcess() { end_all(); }

ssize_t KeptProcess::send(const void* bytes, std::size_t count) const {
  // A pipe that nobody reads is this process's news, not its end.
  sigset_t broken, before;
  sigemptyset(&broken);
  sigaddset(&broken, SIGPIPE);
  pthread_sigmask(SIG_BLOCK, &broken, &before);
  const ssize_t sent = write(requests_.get(), bytes, count);
  const int error = errno;
  if (sent < 0 && error == EPIPE && sigismember(&before, SIGPIPE) == 0) {
    const timespec at_once{};
    sigtimedwait(&broken, nullptr, &at_once);
  }
  pthread_sigmask(SIG_SETMASK, &before, nullptr);
  errno = error;
  return sent;
}

KeptProcess::Event KeptProcess::wait(Clock::time_point until, bool writes) {
  for (;;) {
    std::array<pollfd, 3> fds{pollfd{answers_.get(), POLLIN, 0}, pollfd{status_.get(), POLLIN, 0},
                              pollfd{writes ? requests_.get() : -1, POLLOUT, 0}};
    // Rounded up, so that nothing is late before its time; what is to be looked at only is not waited for.
    const auto left = std::chrono::ceil<std::chrono::milliseconds>(until - Clock::now()).count();
    const int ready = poll(fds.data(), fds.size(), static_cast<int>(std::clamp<long>(left, 0, 1 << 30)));
    if (ready < 0 && errno == EINTR) continue;
    if (ready <= 0) return Event::Late;
    // Bytes that came before the end count.
    if ((fds[0].revents & POLLIN) != 0) return Event::Readable;
    if (fds[1].revents != 0 && !read_status(Clock::now())) return Event::Ended;
    if ((fds[0].revents & (POLLHUP | POLLERR)) != 0) return Event::Ended;
    if (fds[2].revents != 0) return (fds[2].revents & POLLOUT) != 0 ? Event::Writable : Event::Ended;
  }
}

// Takes what the host has said up to now, or until its end. \return whether the code runs, as far as is known
bool KeptProcess::read_status(Clock::time_point until) {
  for (;;) {
    std::array<char, 256> bytes{};
    const ssize_t count = read(status_.get(), bytes.data(), bytes.size());
    if (count == 0) {
      host_is_gone_ = true;
      return false;
    }
    if (count > 0) {
      said_.append(bytes.data(), static_cast<std::size_t>(count));
      continue;
    }
    const bool is_over = said_.find("exit ") != std::string::npos || said_.find("signal ") != std::string::npos;
    const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(until - Clock::now()).count();
    if (left <= 0) return !is_over;
    pollfd fd{status_.get(), POLLIN, 0};
    poll(&fd, 1, static_cast<int>(left));
  }
}

void KeptProcess::end_all() {
  if (is_over_) return;
  is_over_ = true;
  lifeline_.reset();
  // A host that was stopped ends nothing.
  kill(host_, SIGCONT);
  constexpr double patience = 10;
  read_status(in_seconds(patience));
  if (!host_is_gone_) kill(host_, SIGKILL);
  int how = 0;
  waitpid(host_, &how, 0);
  {
    const std::scoped_lock lock(hosts().mutex);
    hosts().running.erase(host_);
  }
  if (said_.find("left ") == std::string::npos) sweep();
}

namespace {

// The number that the host said after a word; -1 where it did not.
long number_after(std::string_view said, const char* word) {
  const std::size_t at = said.find(word);
  return at == std::string_view::npos ? -1 : std::strtol(said.data() + at + std::strlen(word), nullptr, 10);
}

}  // namespace

Fault KeptProcess::fault(const std::string& kind, const std::string& why) {
  // The end may be known a moment after its pipe is closed, on a busy machine a second and more.
  constexpr double moment = 4;
  if (kind == "crash") {
    const Clock::time_point until = in_seconds(moment);
    while (read_status(Clock::now()) && Clock::now() < until) {
      pollfd fd{status_.get(), POLLIN, 0};
      poll(&fd, 1, 10);
    }
  }
  const long code = number_after(said_, "exit "), signal = number_after(said_, "signal ");
  const bool lost_host = host_is_gone_ && number_after(said_, "left ") < 0;
  end_all();
  const std::string words = last_words();
  if (signal == SIGXFSZ)
    return {"output",
            fmt::format("it wrote more than {} MB to a file or a standard stream{}", limits_.written >> 20U, words)};
  if (signal >= 0)
    return {"crash", fmt::format("it died by signal {} ({}){}", signal, strsignal(static_cast<int>(signal)), words)};
  // A shell's exit code for a program that a signal ended.
  constexpr long by_signal = 128, last_signal = 64;
  if (code > by_signal && code <= by_signal + last_signal)
    return {"crash", fmt::format("it died by signal {} ({}){}", code - by_signal,
                                 strsignal(static_cast<int>(code - by_signal)), words)};
  if (code >= 0) return {"exit", fmt::format("it exited with code {}{}", code, words)};
  if (lost_host) return {"killed others", "it killed the process that started it" + words};
  return {kind, why + words};
}

std::vector<std::pair<std::string, std::string>> KeptProcess::finish() {
  if (is_over_) return {};
  std::vector<std::pair<std::string, std::string>> found;
  requests_.reset();
  constexpr double patience = 2;
  const Clock::time_point until = in_seconds(patience);
  while (read_status(Clock::now()) && Clock::now() < until) {
    pollfd fd{status_.get(), POLLIN, 0};
    poll(&fd, 1, 10);
  }
  const bool by_itself = number_after(said_, "exit ") >= 0 || number_after(said_, "signal ") >= 0;
  const long signal = number_after(said_, "signal ");
  end_all();
  if (number_after(said_, "left ") < 0) found.emplace_back("killed others", "it killed the process that started it");
  else if (signal >= 0)
    found.emplace_back("crash", fmt::format("it died by signal {} ({}) when there was no more to do{}", signal,
                                            strsignal(static_cast<int>(signal)), last_words()));
  if (const long left = number_after(said_, "left "); by_itself && left > 0)
    found.emplace_back("left processes", fmt::format("it left {} processes running, which were killed", left));
  return found;
}

std::uint64_t KeptProcess::written_out() const {
  struct stat facts {};
  return fstat(out_.get(), &facts) == 0 ? static_cast<std::uint64_t>(facts.st_size) : 0;
}

// The last line of standard error, as the end of a sentence.
std::string KeptProcess::last_words() const {
  struct stat facts {};
  if (fstat(err_.get(), &facts) != 0 || facts.st_size == 0) return {};
  std::array<char, 512> bytes{};
  const off_t from = std::max<off_t>(0, facts.st_size - static_cast<off_t>(bytes.size()));
  const ssize_t count = pread(err_.get(), bytes.data(), bytes.size(), from);
  std::string text(bytes.data(), static_cast<std::size_t>(std::max<ssize_t>(0, count)));
  while (!text.empty() && (text.back() == '\n' || text.back() == '\r')) text.pop_back();
  text = text.substr(text.rfind('\n') + 1);
  for (char& c : text)
    if (static_cast<unsigned char>(c) < ' ' || static_cast<unsigned char>(c) > '~') c = '?';
  return text.empty() ? "" : fmt::format("; its last line on standard error: {}", text);
}

}  // namespace cageproof::judge
