// SPDX-License-Identifier: MIT
#include "gnuplot.h"

#include "cageproof/core/input_error.h"
#include "cageproof/core/whole_file.h"
#include "cageproof/reports/checked_file.h"
#include "cageproof/reports/clean_end.h"
#include "small_png.h"

#include <fmt/format.h>
#include <vtksys/Process.h>

#include <algorithm>
#include <cmath>
#include <future>
#include <memory>
#include <thread>

namespace cageproof::reports {
namespace {

namespace fs = std::filesystem;

struct DeleteProcess {
  void operator()(vtksysProcess* process) const { vtksysProcess_Delete(process); }
};

// One gnuplot, its script and what it says, removed when it is done.
class Gnuplot {
 public:
  Gnuplot(const fs::path& folder, std::size_t number, const std::string& script)
      : script_(folder / fmt::format(".gnuplot-{}", number)), log_(script_.string() + ".log") {
    write_file(script_, script);
    process_.reset(vtksysProcess_New());
    // Default settings: someone's ~/.gnuplot must not change a report.
    const char* const command[] = {"gnuplot", "-d", script_.c_str(), nullptr};
    vtksysProcess_SetCommand(process_.get(), command);
    vtksysProcess_SetPipeFile(process_.get(), vtksysProcess_Pipe_STDOUT, "/dev/null");
    vtksysProcess_SetPipeFile(process_.get(), vtksysProcess_Pipe_STDERR, log_.c_str());
    vtksysProcess_Execute(process_.get());
    // It takes signals over, to end what it started: that comes after the removal of what is aside.
    rearm_clean_end();
  }
  ~Gnuplot() {
    process_.reset();
    std::error_code ignored;
    fs::remove(script_, ignored);
    fs::remove(log_, ignored);
  }
  Gnuplot(const Gnuplot&) = delete;
  Gnuplot& operator=(const Gnuplot&) = delete;

  void finish() {
    vtksysProcess_WaitForExit(process_.get(), nullptr);
    switch (vtksysProcess_GetState(process_.get())) {
      case vtksysProcess_State_Exited:
        if (vtksysProcess_GetExitValue(process_.get()) != 0)
          throw InputError(fmt::format("cannot draw pictures: gnuplot failed: {}", complaint()));
        return;
      case vtksysProcess_State_Error:
        throw InputError(fmt::format("cannot draw pictures: gnuplot does not start ({}); install gnuplot-nox",
                                     vtksysProcess_GetErrorString(process_.get())));
      default:
        throw InputError(
            fmt::format("cannot draw pictures: gnuplot died: {}", vtksysProcess_GetExceptionString(process_.get())));
    }
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

  fs::path script_, log_;
  std::unique_ptr<vtksysProcess, DeleteProcess> process_;
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
