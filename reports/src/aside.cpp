// SPDX-License-Identifier: MIT
#include "aside.h"

#include <fmt/format.h>

#include <signal.h>
#include <unistd.h>

#include <cerrno>
#include <charconv>
#include <optional>
#include <string>
#include <string_view>

namespace cageproof::reports {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view earlier_suffix = ".earlier";

std::string host() {
  char name[256] = "";
  ::gethostname(name, sizeof name - 1);
  return name;
}

std::string prefix_for(const fs::path& path) { return fmt::format(".{}.partial-", path.filename().string()); }

// The process that made such a name; nothing where another machine did, or nobody.
std::optional<pid_t> maker_of(std::string_view name, std::string_view prefix) {
  if (!name.starts_with(prefix)) return std::nullopt;
  std::string_view rest = name.substr(prefix.size());
  if (rest.ends_with(earlier_suffix)) rest.remove_suffix(earlier_suffix.size());
  pid_t process = 0;
  const auto [end, error] = std::from_chars(rest.data(), rest.data() + rest.size(), process);
  if (error != std::errc() || process <= 0) return std::nullopt;
  // Version 0.1.0 named no machine.
  const auto at = rest.find('@');
  if (at != rest.npos && rest.substr(at + 1) != host()) return std::nullopt;
  return process;
}

bool lives(pid_t process) { return ::kill(process, 0) == 0 || errno != ESRCH; }

}  // namespace

fs::path aside(const fs::path& path, int n) {
  return path.parent_path() / fmt::format("{}{}-{}@{}", prefix_for(path), ::getpid(), n, host());
}

fs::path earlier(const fs::path& aside) { return aside.string() + std::string(earlier_suffix); }

void remove_leftovers(const fs::path& path) {
  std::error_code ignored;
  const std::string prefix = prefix_for(path);
  std::vector<fs::path> leftovers;
  const fs::path parent = path.has_parent_path() ? path.parent_path() : ".";
  for (const fs::directory_entry& entry : fs::directory_iterator(parent, ignored)) {
    const auto maker = maker_of(entry.path().filename().string(), prefix);
    if (maker && !lives(*maker)) leftovers.push_back(entry.path());
  }
  for (const fs::path& leftover : leftovers)
    if (leftover.string().ends_with(earlier_suffix) && !fs::exists(path, ignored)) fs::rename(leftover, path, ignored);
    else fs::remove_all(leftover, ignored);
}

}  // namespace cageproof::reports
