// SPDX-License-Identifier: MIT
// Every deformer on a cage: which maps of space it keeps, its derivatives and its truth.
#pragma once

#include "cageproof/validation/cage_points.h"
#include "deformer_checks.h"
#include "cageproof/validation/measurement.h"

namespace cageproof::validation {

struct DeformerCampaignOptions {
  std::string methods = "*";
  Triangulation triangulation = Triangulation::Shortest;
  std::uint64_t seed = 1;
  int points = 12;     ///< inside the cage, for the maps that are kept
  int few_points = 2;  ///< of these, for derivatives and what takes 50 digits or quadrature; one on larger cages
  int jobs = 0;
  /// Methods whose kind solves on samples in space are left out of cages with more elements: their kinds are, too.
  int solved_elements = std::numeric_limits<int>::max();
  /// Whether to ask what tells of a method's code more than of the cage, and takes most of the time in space: second
  /// routes, quadrature, and 50 digits of kinds that solve, whose coordinates have a truth of their own, or keep quads.
  bool proves_methods = true;
  /// Told which method is prepared, where `refused` is given. Null: nobody.
  std::function<void(const std::string&)> doing = nullptr;
};

/// The embedded cages that runs judge deformers on, in report order: small ones, so that all variants of all methods
/// are prepared in seconds.
const std::vector<std::string_view>& deformer_cage_names();

/// Embedded cages with a small face next to large ones, which suites with time judge deformers on as well.
const std::vector<std::string_view>& small_face_cage_names();

/// Points inside a cage, at least 2e-2 of its size from it; point i is a function of (seed, cage name, i).
/// Fewer, or none, of cages so thin that none is found.
std::vector<Vec3<double>> interior_points(const Cage& cage, Triangulation rule, std::uint64_t seed, int count);

/// Names of methods, with their variant where only that one refuses, by the reason for which they refuse a cage.
using RefusedMethods = std::map<std::string, std::vector<std::string>>;

/// One a variant of each method that matches and does not refuse the cage; on cages with more than few_elements only
/// the first and last variants.
/// \param refused if given, gets the methods that refuse the cage, by its kind or when they are prepared. What refuses
///   later, when it is measured, a moved copy of the cage or a pose, goes to PartialResult::refused. Without it methods
///   are prepared when they are measured, which fails where one refuses.
Measurements deformer_measurements(const std::shared_ptr<const Cage>& cage, const DeformerCampaignOptions& options,
                                   RefusedMethods* refused = nullptr);

/// Measures and judges them.
std::vector<ResultRow> run_deformer_campaign(const Cage& cage, const DeformerCampaignOptions& options);

}  // namespace cageproof::validation
