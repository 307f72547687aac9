// SPDX-License-Identifier: MIT
#include "cageproof/judge/host.h"

#include "reach/library_server.h"
#include "reach/process_tree.h"
#include "reach/shared_block.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/signalfd.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <string_view>

namespace cageproof::judge {
namespace {

void say(const std::string& what, long number) {
  const std::string line = what + " " + std::to_string(number) + "\n";
  [[maybe_unused]] const auto written = write(descriptor::status, line.data(), line.size());
}

void limit(int resource, rlim_t most) {
  const rlimit both{most, most};
  // The kind of a resource is an enumeration of C's.
  setrlimit(static_cast<__rlimit_resource_t>(resource), &both);
}

// Runs the code in a session of its own, so that ending its group ends no more than itself.
[[noreturn]] void become_code(std::string_view kind, const char* what, rlim_t memory, rlim_t written) {
  setsid();
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  // Where memory runs out the kernel takes this process first.
  if (std::FILE* const score = std::fopen("/proc/self/oom_score_adj", "w")) {
    std::fputs("1000", score);
    std::fclose(score);
  }
  limit(RLIMIT_CORE, 0);
  limit(RLIMIT_FSIZE, written);
  limit(RLIMIT_AS, memory);
  // The system stops a process that forks without end, unless root runs it.
  constexpr rlim_t more_tasks = 256;
  if (const int tasks = tasks_of_user(); tasks > 0 && getuid() != 0)
    limit(RLIMIT_NPROC, static_cast<rlim_t>(tasks) + more_tasks);
  close(descriptor::lifeline);
  close(descriptor::status);
  if (kind == "library") _exit(serve_library(what));
  dup2(descriptor::requests, STDIN_FILENO);
  dup2(descriptor::answers, STDOUT_FILENO);
  close_range(descriptor::lifeline, ~0U, 0);
  setenv("PYTHONUNBUFFERED", "1", 0);
  execl("/bin/sh", "sh", "-c", what, static_cast<char*>(nullptr));
  std::perror("/bin/sh");
  _exit(127);
}

// Waits until the code has ended, which the status then says, or until all is to end.
void watch(pid_t code, int signals) {
  std::array<pollfd, 2> fds{pollfd{descriptor::lifeline, POLLIN, 0}, pollfd{signals, POLLIN, 0}};
  for (;;) {
    if (poll(fds.data(), fds.size(), -1) < 0 && errno != EINTR) return;
    if (fds[0].revents != 0) return;
    if (fds[1].revents == 0) continue;
    signalfd_siginfo info;
    [[maybe_unused]] const auto taken = read(signals, &info, sizeof info);
    int how = 0;
    for (pid_t ended = 0; (ended = waitpid(-1, &how, WNOHANG)) > 0;) {
      if (ended != code) continue;
      if (WIFSIGNALED(how)) say("signal", WTERMSIG(how));
      else say("exit", WEXITSTATUS(how));
      return;
    }
  }
}

}  // namespace

bool is_host(int argc, const char* const* argv) { return argc == 6 && std::string_view(argv[1]) == host_argument; }

int run_host(int /*argc*/, const char* const* argv) {
  const std::string_view kind = argv[2];
  const rlim_t memory = std::strtoull(argv[4], nullptr, 10), written = std::strtoull(argv[5], nullptr, 10);
  // Files that whoever started this had open are none of the code's.
  close_range(descriptor::memory + 1, ~0U, 0);
  prctl(PR_SET_CHILD_SUBREAPER, 1);
  sigset_t child, before;
  sigemptyset(&child);
  sigaddset(&child, SIGCHLD);
  sigprocmask(SIG_BLOCK, &child, &before);
  const int signals = signalfd(-1, &child, SFD_CLOEXEC);
  const pid_t code = fork();
  if (code < 0) return 1;
  if (code == 0) {
    close(signals);
    sigprocmask(SIG_SETMASK, &before, nullptr);
    become_code(kind, argv[3], memory, written);
  }
  for (const int fd : {descriptor::requests, descriptor::answers, descriptor::memory}) close(fd);
  say("code", code);
  watch(code, signals);
  // The code itself is no leftover.
  int own = waitpid(code, nullptr, WNOHANG) == 0 ? 1 : 0;
  const int killed = kill_all_descendants();
  if (killed == 0) own = 0;
  say("left", killed - own);
  return 0;
}

}  // namespace cageproof::judge
