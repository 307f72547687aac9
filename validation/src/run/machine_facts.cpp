// SPDX-License-Identifier: MIT
#include "cageproof/validation/machine_facts.h"

#include "run/build_id.h"
#include "cageproof/closed_form/batch/instruction_set.h"
#include "cageproof/core/results/build_facts.h"
#include "cageproof/core/numbers/scalar.h"
#include "cageproof/core/parallel.h"

#include <Eigen/Core>
#include <boost/version.hpp>
#include <fmt/chrono.h>
#include <tbb/version.h>

#include <gnu/libc-version.h>

#include <fstream>
#include <thread>

namespace cageproof::validation {
namespace {

std::string processor() {
  std::ifstream info("/proc/cpuinfo");
  for (std::string line; std::getline(info, line);)
    if (line.starts_with("model name")) return line.substr(line.find(':') + 2);
  return "unknown";
}

}  // namespace

std::map<std::string, std::string> machine_facts(int jobs) {
  return {{"processor", processor()},
          {"cores", fmt::format("{}", std::thread::hardware_concurrency())},
          {"threads", fmt::format("{}", threads_for(jobs))},
          {"commit", std::string(build_commit())},
          {"compiler", __VERSION__},
          {"flags", std::string(build_flags())},
          {"C library", fmt::format("glibc {}", gnu_get_libc_version())},
          {program_build, build_id()},
          {elementary_functions, elementary_function_variant()},
          {instruction_set_fact, std::string(name_of(closed_form::batch::instruction_set()))},
          {"Boost", BOOST_LIB_VERSION},
          {"Eigen", fmt::format("{}.{}.{}", EIGEN_WORLD_VERSION, EIGEN_MAJOR_VERSION, EIGEN_MINOR_VERSION)},
          {"MPFR", mpfr_get_version()},
          {"oneTBB", TBB_VERSION_STRING}};
}

std::string timestamp() { return fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(std::time(nullptr))); }

}  // namespace cageproof::validation
