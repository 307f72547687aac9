// SPDX-License-Identifier: MIT
#include "overlap.h"

#include "../kept_quads.h"
#include "samples.h"

#include "cageproof/core/coordinates/whole_evaluation.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>

namespace cageproof::deformation {
namespace {

// A face that lies within the cage, or outside of it.
struct BuriedFace {
  int face;    // by its number in the file
  double sum;  // of Green coordinates on it, from inside
};

// The first of them at the samples that regularised methods take by default.
std::optional<BuriedFace> buried_face(const Cage& cage, Triangulation rule) {
  constexpr int level = 1;
  constexpr std::size_t block = 64;
  constexpr double tolerance = 1e-6;
  const CageCoordinates coordinates(cage, coordinate_kind_named("green"), quickest, rule);
  const std::vector<Touching> samples = samples_of(coordinates.elements(), level);
  for (std::size_t first = 0; first < samples.size(); first += block) {
    const auto some = std::span(samples).subspan(first, std::min(block, samples.size() - first));
    const CoordinateTable<double> phi = coordinates.limits_at<double>(some, 0)[0];
    for (std::size_t s = 0; s < some.size(); ++s) {
      double sum = 0;
      for (std::size_t i = 0; i < phi.stride[0]; ++i) sum += phi.tensors[0][s * phi.stride[0] + i];
      if (std::abs(sum - 1) > tolerance)
        return BuriedFace{cage.face_number(cage.parts(false, rule).face_of[some[s].element]), sum};
    }
  }
  return std::nullopt;
}

}  // namespace

std::string why_overlap_is_refused(const Cage& cage) {
  constexpr std::size_t most = 3;
  const std::vector<std::string> crossings = crossing_faces(cage);
  if (crossings.empty()) return {};
  std::optional<BuriedFace> buried = buried_face(cage, Triangulation::Shortest);
  if (!buried && cage.has_quads()) buried = buried_face(cage, Triangulation::Fan);
  if (!buried) return {};
  return fmt::format(
      "the cage overlaps itself: {}{} cross, and on face {} Green coordinates sum to {:.3g}, not to 1, from which no "
      "densities can be solved (faces counted from 0); make one surface of it (a union), or take green or mean_value",
      fmt::join(std::span(crossings).first(std::min(most, crossings.size())), ", "),
      crossings.size() > most ? fmt::format(" and {} more", crossings.size() - most) : "", buried->face, buried->sum);
}

std::string why_kept_overlap_is_refused(const Cage& cage) {
  std::string reason = why_quads_are_refused(cage);
  return reason.empty() ? why_overlap_is_refused(cage) : reason;
}

}  // namespace cageproof::deformation
