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

  // Gnuplot's error message; empty where it prints none. \throws InputError where it does not start
  std::string finish() {
    if (start_error_ != 0)
      throw InputError(fmt::format("cannot draw pictures: gnuplot does not start ({}); install gnuplot-nox",
                                   std::generic_category().message(start_error_)));
    const int status = wait();
    if (WIFSIGNALED(status)) return fmt::format("gnuplot died: {}", ::strsignal(WTERMSIG(status)));
    if (WEXITSTATUS(status) != 0) return fmt::format("gnuplot failed: {}", complaint());
    return {};
  }

 private:
  // The line of gnuplot's message that names the error.
  std::string complaint() const {
    const std::string log = read_file(log_);
    const std::size_t end = log.find_last_not_of("\n ");
    if (end == log.npos) return "no message";
    const std::size_t start = log.rfind('\n', end);
    const std::string line = log.substr(start == log.npos ? 0 : start + 1, end - (start == log.npos ? -1 : start));
    // The script is gone when somebody reads this.
    const std::string script = fmt::format("\"{}\" ", script_.string());
    return line.starts_with(script) ? line.substr(script.size()) : line;
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

// gnuplot exits with 0 when the disk is full, or when it could not draw; what it writes is large, too. Whether the
// picture is whole.
bool make_small(const fs::path& path) {
  constexpr int colours = 200;
  std::error_code ignored;
  if (!fs::exists(path, ignored)) return false;
  const auto small = small_png(read_file(path), colours);
  if (small) write_file(path, *small);
  return small.has_value();
}

// A picture that says why there is no other.
Picture placeholder(const Picture& picture, const std::string& reason) {
  return {picture.file, 560, 120,
          fmt::format("unset border\nunset tics\nset xrange [0:1]\nset yrange [0:1]\n"
                      "set label 1 {} at screen 0.5,0.6 center noenhanced\n"
                      "set label 2 {} at screen 0.5,0.4 center noenhanced\nplot NaN notitle\n",
                      gnuplot_text(fmt::format("no picture: {}", reason.substr(0, 90))),
                      gnuplot_text("the data beside it is whole"))};
}

// Draws one picture of a group that failed, or a placeholder with the returned reason. Nothing where it is drawn.
std::optional<std::string> draw_alone(const Picture& picture, const fs::path& folder, std::size_t number) {
  const fs::path path = folder / picture.file;
  const auto try_drawing = [&](const Picture& one) {
    std::error_code ignored;
    fs::remove(path, ignored);
    return Gnuplot(folder, number, commands(one, folder)).finish();
  };
  std::string reason = try_drawing(picture);
  if (reason.empty() && make_small(path)) return std::nullopt;
  if (reason.empty()) reason = "gnuplot cannot draw it";
  if (const std::string worse = try_drawing(placeholder(picture, reason)); !worse.empty())
    throw InputError(fmt::format("cannot draw pictures: {}", worse));
  if (!make_small(path))
    throw InputError(fmt::format("cannot write {}: the picture is not whole (is the disk full?)", path.string()));
  return fmt::format("{}: {}; a picture that says so is in its place", picture.file, reason);
}

}  // namespace

std::vector<std::string> draw(const std::vector<Picture>& pictures, const fs::path& folder) {
  const std::size_t jobs = std::min<std::size_t>(pictures.size(), std::max(1u, std::thread::hardware_concurrency()));
  std::vector<std::string> scripts(jobs);
  for (std::size_t i = 0; i < pictures.size(); ++i) scripts[i % jobs] += commands(pictures[i], folder);
  std::vector<std::unique_ptr<Gnuplot>> running;
  for (std::size_t i = 0; i < jobs; ++i) running.push_back(std::make_unique<Gnuplot>(folder, i, scripts[i]));
  // A script ends at the first picture that gnuplot refuses, so later ones of that script are missing.
  for (const auto& process : running) process->finish();
  std::vector<std::future<std::vector<std::size_t>>> finishing;
  for (std::size_t job = 0; job < jobs; ++job)
    finishing.push_back(std::async([&, job] {
      std::vector<std::size_t> missing;
      for (std::size_t i = job; i < pictures.size(); i += jobs)
        if (!make_small(folder / pictures[i].file)) missing.push_back(i);
      return missing;
    }));
  std::vector<std::string> notes;
  for (auto& job : finishing)
    for (const std::size_t i : job.get())
      if (auto note = draw_alone(pictures[i], folder, jobs)) notes.push_back(std::move(*note));
  return notes;
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
