// SPDX-License-Identifier: MIT
#include "gnuplot.h"

#include "cageproof/core/input_error.h"
#include "cageproof/core/whole_file.h"
#include "cageproof/reports/checked_file.h"
#include "small_png.h"

#include <fmt/format.h>

#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <future>
#include <memory>
#include <system_error>
#include <thread>

namespace cageproof::reports {
namespace {

namespace fs = std::filesystem;

// One gnuplot, its script and what it says, removed when it is done. VTK's processes would take signals over, which
// would then end this program with what it has aside still there.
class Gnuplot {
 public:
  Gnuplot(const fs::path& folder, std::size_t number, const std::string& script)
      : script_(folder / fmt::format(".gnuplot-{}", number)), log_(script_.string() + ".log") {
    write_file(script_, script);
    posix_spawn_file_actions_t files;
    posix_spawn_file_actions_init(&files);
    posix_spawn_file_actions_addopen(&files, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_addopen(&files, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
    posix_spawn_file_actions_addopen(&files, STDERR_FILENO, log_.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0666);
    // Default settings: someone's ~/.gnuplot must not change a report.
    std::string name = "gnuplot", settings = "-d", file = script_.string();
    char* const command[] = {name.data(), settings.data(), file.data(), nullptr};
    start_error_ = posix_spawnp(&process_, name.c_str(), &files, nullptr, command, environ);
    posix_spawn_file_actions_destroy(&files);
    if (start_error_ != 0) process_ = 0;
  }
  ~Gnuplot() {
    if (process_ > 0) {
      ::kill(process_, SIGKILL);
      wait();
    }
    std::error_code ignored;
    fs::remove(script_, ignored);
    fs::remove(log_, ignored);
  }
  Gnuplot(const Gnuplot&) = delete;
  Gnuplot& operator=(const Gnuplot&) = delete;

  void finish() {
    if (start_error_ != 0)
      throw InputError(fmt::format("cannot draw pictures: gnuplot does not start ({}); install gnuplot-nox",
                                   std::generic_category().message(start_error_)));
    const int status = wait();
    if (WIFSIGNALED(status))
      throw InputError(fmt::format("cannot draw pictures: gnuplot died: {}", ::strsignal(WTERMSIG(status))));
    if (WEXITSTATUS(status) != 0)
      throw InputError(fmt::format("cannot draw pictures: gnuplot failed: {}", complaint()));
  }

 private:
  // The line of gnuplot's message that says what is wrong.
  std::string complaint() const {
    const std::string log = read_file(log_);
    const std::size_t end = log.find_last_not_of("\n ");
    if (end == log.npos) return "no message";
    const std::size_t start = log.rfind('\n', end);
    return log.substr(start == log.npos ? 0 : start + 1, end - (start == log.npos ? -1 : start));
  }

  int wait() {
    int status = 0;
    while (::waitpid(process_, &status, 0) < 0 && errno == EINTR) continue;
    process_ = 0;
    return status;
  }

  fs::path script_, log_;
  pid_t process_ = 0;
  int start_error_ = 0;
};

std::string commands(const Picture& picture, const fs::path& folder) {
  return fmt::format(
      "reset\nset encoding utf8\nset terminal pngcairo size {},{} font 'DejaVu Sans,9' linewidth 1.2 "
      "background rgb 'white'\n"
      "set output {}\n{}\nset output\n",
      picture.width, picture.height, gnuplot_text((folder / picture.file).string()), picture.commands);
}

// gnuplot exits with 0 when the disk is full; what it writes is large, too.
void finish(const fs::path& path) {
  constexpr int colours = 200;
  const auto small = small_png(read_file(path), colours);
  if (!small)
    throw InputError(fmt::format("cannot write {}: the picture is not whole (is the disk full?)", path.string()));
  write_file(path, *small);
}

}  // namespace

void draw(const std::vector<Picture>& pictures, const fs::path& folder) {
  const std::size_t jobs = std::min<std::size_t>(pictures.size(), std::max(1u, std::thread::hardware_concurrency()));
  std::vector<std::string> scripts(jobs);
  for (std::size_t i = 0; i < pictures.size(); ++i) scripts[i % jobs] += commands(pictures[i], folder);
  std::vector<std::unique_ptr<Gnuplot>> running;
  for (std::size_t i = 0; i < jobs; ++i) running.push_back(std::make_unique<Gnuplot>(folder, i, scripts[i]));
  for (const auto& process : running) process->finish();
  std::vector<std::future<void>> finishing;
  for (std::size_t job = 0; job < jobs; ++job)
    finishing.push_back(std::async([&, job] {
      for (std::size_t i = job; i < pictures.size(); i += jobs) finish(folder / pictures[i].file);
    }));
  for (auto& job : finishing) job.get();
}

std::string gnuplot_text(std::string_view text) {
  std::string result = "'";
  for (const char c : text) {
    if (c == '\'') result += "''";
    else result += static_cast<unsigned char>(c) < ' ' ? ' ' : c;
  }
  return result + "'";
}

std::string gnuplot_number(double x) { return std::isfinite(x) ? fmt::format("{}", x) : "NaN"; }

}  // namespace cageproof::reports
