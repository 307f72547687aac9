// SPDX-License-Identifier: MIT
// Whether an evaluation gives each triangle's own derivatives, or ones that are right only in sums over a closed cage.
#pragma once

#include "cageproof/core/cage/cage.h"
#include "cageproof/core/catalogue/evaluation.h"
#include "cageproof/validation/measurement.h"
#include "cageproof/core/lazy.h"
#include "cageproof/validation/question.h"

namespace cageproof::validation {

/// The formula whose derivatives are looked at.
inline constexpr std::string_view one_ring_formula = "triangle.double_layer";

/// Whether the cage's elements are, or become, those of the formula.
bool one_ring_exists_on(const Cage& cage);

struct OneRingOptions {
  std::string evaluation = "curl-form";  ///< empty for the recommended one
  Triangulation triangulation = Triangulation::Shortest;
  std::uint64_t seed = 1;
  int points = 24;  ///< at least 2e-2 cage sizes away from it, inside and outside
  int jobs = 0;     ///< threads; 0: all cores
};

/// By order, relative and norm-wise.
struct OneRingErrors {
  std::array<double, 3> own{};  ///< of the worst triangle
  std::array<double, 3> sum{};  ///< of the sums over the triangles around each vertex
};

/// A point, and the errors there, which are found when first asked for.
class OneRingAt : public PointAt {
 public:
  OneRingAt(const Vec3<double>& place, std::uint64_t sample, std::function<OneRingErrors()> find)
      : PointAt{place, sample}, errors_(std::move(find)) {}
  const OneRingErrors& errors() const { return errors_.get(); }

 private:
  Lazy<OneRingErrors> errors_;
};

/// An evaluation of the formula on a cage's triangles. Safe from any thread.
class OneRing {
 public:
  /// \throws InputError when there is no evaluation of that name
  OneRing(std::shared_ptr<const Cage> cage, const OneRingOptions& options);
  const Evaluation& evaluation() const { return evaluation_; }
  /// The checks of its derivatives: `own_derivative` and `one_ring_sum`, or, of a form as printed on a cage with faces
  /// below some 3e-4 of its size, `one_ring_sum_small_faces`.
  std::vector<Question<OneRingAt>> questions() const;
  /// A point to ask at; valid while this object lives.
  OneRingAt at(const Vec3<double>& point, std::uint64_t index) const;

 private:
  std::shared_ptr<const Cage> cage_;
  Evaluation evaluation_, reference_;
  std::vector<std::array<int, 3>> triangles_;
};

/// For the derivatives of triangle.double_layer against the closed form's truth: `own_derivative`, the worst triangle,
/// and `one_ring_sum`, the sums over the triangles around each vertex; both norm-wise. An evaluation that keeps the
/// first has the gradients of phi_t^k. One that keeps only the second has a form like P x d/(2|t|), which must not be
/// mixed with others. \throws InputError when no evaluation has that name
std::unique_ptr<const Measurement> one_ring_measurement(std::shared_ptr<const Cage> cage,
                                                        const OneRingOptions& options);

/// Measures and judges them. \throws InputError as one_ring_measurement
std::vector<ResultRow> run_one_ring_check(const Cage& cage, const OneRingOptions& options);

}  // namespace cageproof::validation
