// SPDX-License-Identifier: MIT
#include "truth/required_limits.h"

#include "element/element_sampling.h"

#include <algorithm>
#include <vector>

namespace cageproof::validation {
namespace {

// As ElementType::contact(), in 100 and 200 digits: other code, which sees a point nearer than 1e-60 sizes on the
// element.
Contact contact_in_multiprecision(ElementKind kind, const Sample& sample) {
  const ExactShape& exact = sampling_of(kind).exact;
  std::vector<Vec3<Mp200>> corners;
  corners.reserve(sample.corners.size());
  for (const Vec3<double>& corner : sample.corners) corners.push_back(convert<Mp200>(corner));
  static const Mp200 nothing("1e-60");
  const Mp200 height = exact.off_surface(corners, convert<Mp200>(sample.point));
  if (!(abs(height) <= nothing * longest_edge<Mp200>(corners))) return Contact::Off;
  const std::array<Mp100, 4> basis = exact.basis(sample.corners, sample.point);
  const Mp100 least = *std::min_element(basis.begin(), basis.begin() + corner_count(kind));
  if (least < -Mp100(nothing)) return Contact::Off;
  return least > Mp100(nothing) ? Contact::Interior : Contact::Border;
}

}  // namespace

bool is_input(const Formula& formula, const Sample& sample) {
  if (!sample.point.allFinite()) return false;
  std::vector<Vec3<Mp200>> corners;
  corners.reserve(sample.corners.size());
  for (const Vec3<double>& corner : sample.corners) {
    if (!corner.allFinite()) return false;
    corners.push_back(convert<Mp200>(corner));
  }
  return !type_of(formula.element).degenerate(corners) && sampling_of(formula.element).search.valid(sample.corners);
}

std::array<bool, 3> limits_that_must_exist(const Formula& formula, const Sample& sample) {
  std::array<bool, 3> required{false, false, false};
  if (!is_input(formula, sample)) return required;
  const Behaviour behaviour = formula.behaviour(sample.parameters);
  // Only both contacts together excuse a missing limit, so that a fault of one cannot hide losses.
  const auto contacts = {type_of(formula.element).contact(sample.corners, sample.point).contact,
                         contact_in_multiprecision(formula.element, sample)};
  for (const Contact contact : contacts)
    for (int order = 0; order < 3; ++order)
      required[order] = required[order] || contact == Contact::Off ||
                        (!behaviour.face_jump.diverges && (contact == Contact::Interior || order < behaviour.degree));
  return required;
}

}  // namespace cageproof::validation
