// SPDX-License-Identifier: MIT
// The main job: campaigns on elements, properties on cages, fields, and a report.
#pragma once

#include "cageproof/core/cage.h"
#include "cageproof/core/mesh_io.h"
#include "cageproof/core/run_result.h"

#include <filesystem>
#include <functional>
#include <optional>

namespace cageproof::validation {

/// How much a suite does.
struct Suite {
  std::string_view name;
  int samples;           ///< a formula and regime
  int integral_samples;  ///< of these, for the multiprecision integral
  int enclosures;        ///< a formula and regime, enclosed rigorously
  int cage_points;       ///< a cage, off it
  int truth_points;      ///< of these, against multiprecision
  int slice;             ///< samples a side of the fields of linear reproduction
  int pairs;             ///< multiprecision evaluations a field of errors may cost
};

/// On two cores quick takes about five minutes, standard about twenty; full as long as asked.
const std::vector<Suite>& suites();

struct VerifyOptions {
  std::string formulas = "*", evaluations = "*", regimes = "*";
  Suite suite;
  std::uint64_t seed = 1;
  int jobs = 0;
  std::optional<Cage> cage;  ///< nothing: the embedded cages
  std::optional<Mesh> mesh;  ///< points to try the cage at
  std::string mesh_name;
  Triangulation triangulation = Triangulation::Shortest;
  std::filesystem::path out;
  std::string command_line;
  /// Called as stages go on: what is being done, and how much of it.
  std::function<void(const std::string& stage, std::size_t done, std::size_t all)> progress;
};

/// Runs, writes the report and returns what it found.
/// \throws InputError for patterns that match nothing and reports that cannot be written
RunResult verify(const VerifyOptions& options);

/// Version, processor, compiler and libraries.
std::map<std::string, std::string> machine_facts();

/// Now, ISO 8601, UTC.
std::string timestamp();

}  // namespace cageproof::validation
