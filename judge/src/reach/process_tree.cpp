// SPDX-License-Identifier: MIT
#include "reach/process_tree.h"

#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <charconv>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace cageproof::judge {
namespace {

struct Seen {
  pid_t parent;
  bool is_dead;
};

// /proc/PID/stat: "pid (name) state parent ...", where the name may hold anything.
std::map<pid_t, Seen> processes() {
  std::map<pid_t, Seen> found;
  std::error_code error;
  for (std::filesystem::directory_iterator entry("/proc", error), end; !error && entry != end; entry.increment(error)) {
    const std::string name = entry->path().filename().string();
    pid_t pid = 0;
    const auto read = std::from_chars(name.data(), name.data() + name.size(), pid);
    if (read.ec != std::errc{} || read.ptr != name.data() + name.size()) continue;
    std::ifstream file(entry->path() / "stat");
    std::string text;
    std::getline(file, text, '\0');
    const std::size_t after = text.rfind(')');
    if (after == std::string::npos || after + 4 > text.size()) continue;
    pid_t parent = 0;
    const char* const first = text.data() + after + 4;
    std::from_chars(first, text.data() + text.size(), parent);
    found[pid] = {parent, text[after + 2] == 'Z' || text[after + 2] == 'X'};
  }
  return found;
}

// Living ones, parents before their children.
std::vector<pid_t> descendants(const std::function<bool(pid_t)>& doomed) {
  const auto all = processes();
  std::multimap<pid_t, pid_t> children;
  for (const auto& [pid, seen] : all) children.emplace(seen.parent, pid);
  std::vector<pid_t> found;
  const auto [first, last] = children.equal_range(getpid());
  for (auto child = first; child != last; ++child)
    if (doomed(child->second)) found.push_back(child->second);
  for (std::size_t i = 0; i < found.size(); ++i) {
    const auto [begin, end] = children.equal_range(found[i]);
    for (auto child = begin; child != end; ++child) found.push_back(child->second);
  }
  std::erase_if(found, [&](pid_t pid) { return all.at(pid).is_dead; });
  return found;
}

}  // namespace

int kill_descendants(const std::function<bool(pid_t)>& doomed) {
  // A process that cannot be killed (another user's) ends no loop.
  constexpr int most_rounds = 100;
  std::set<pid_t> killed;
  for (int idle = 0, round = 0; idle < 2 && round < most_rounds; ++round) {
    std::set<pid_t> stopped;
    for (bool grows = true; grows;) {
      grows = false;
      for (const pid_t pid : descendants(doomed))
        if (stopped.insert(pid).second) {
          grows = true;
          kill(pid, SIGSTOP);
        }
    }
    for (const pid_t pid : stopped) {
      kill(pid, SIGKILL);
      killed.insert(pid);
    }
    // Orphans become this process's children, and are seen when the next round looks.
    for (const pid_t pid : stopped) waitpid(pid, nullptr, 0);
    idle = stopped.empty() ? idle + 1 : 0;
  }
  for (const pid_t pid : killed) waitpid(pid, nullptr, WNOHANG);
  return static_cast<int>(killed.size());
}

int tasks_of_user() {
  int count = 0;
  for (const auto& [pid, seen] : processes()) {
    const std::filesystem::path folder = "/proc/" + std::to_string(pid) + "/task";
    struct stat facts {};
    std::error_code error;
    if (stat(folder.c_str(), &facts) != 0 || facts.st_uid != getuid()) continue;
    for (std::filesystem::directory_iterator task(folder, error), end; !error && task != end; task.increment(error))
      ++count;
  }
  return count;
}

int kill_all_descendants() {
  constexpr int most_rounds = 50;
  int killed = 0;
  for (int round = 0; round < most_rounds; ++round) {
    pid_t ended = 0;
    while ((ended = waitpid(-1, nullptr, WNOHANG)) > 0) {
    }
    if (ended < 0 && errno == ECHILD) return killed;
    killed += kill_descendants([](pid_t) { return true; });
  }
  return killed;
}

}  // namespace cageproof::judge
