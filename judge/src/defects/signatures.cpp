// SPDX-License-Identifier: MIT
#include "defects/signatures.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace cageproof::judge {
namespace {

using validation::Sample;

Place place(const Study& study, const Case& c) { return place_of(study.formula().element, c.probe->sample); }

const Pattern& pattern(const Study& study, const Case& c) { return study.pattern(c.order); }
const Pattern& values(const Study& study) { return study.pattern(0); }

// The largest difference of two tensors over the largest entry of the second.
double difference(const std::vector<double>& a, const std::vector<double>& b) {
  double off = 0, size = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (!std::isfinite(a[i]) || !std::isfinite(b[i])) return INFINITY;
    off = std::max(off, std::abs(a[i] - b[i]));
    size = std::max(size, std::abs(b[i]));
  }
  return off == 0 ? 0 : off / size;
}

std::string error_text(const Study&, const Case& c) {
  if (!c.finite) return "the result is not finite, and the truth is";
  return fmt::format("a relative error of {:.1e}, {:.1e} conditioned units", c.relative, c.error);
}

bool by_quadrature(const Study& study, const Case&) {
  return study.pattern(0).quadrature || study.pattern(1).quadrature;
}
// A few digits less everywhere: of rounding to float, or of a tolerance.
bool few_digits(const Study& study, const Case& c) {
  const double error = pattern(study, c).generic_error;
  return error > 0 && error < 1e-5 && c.finite && c.relative < 1e3 * error;
}
std::string digits_text(const Study& study, const Case& c) {
  return fmt::format("{}; in the generic regime it keeps {:.0f} digits", error_text(study, c),
                     -std::log10(pattern(study, c).generic_error));
}
bool in_proportion(const Study& study, const Case&) { return values(study).everywhere && values(study).in_proportion; }
bool in_sum(const Study& study, const Case&) { return values(study).everywhere && values(study).right_in_sum; }
bool in_closed_sum(const Study& study, const Case& c) {
  return c.order == 1 && pattern(study, c).everywhere && pattern(study, c).right_when_closed;
}
bool wrong_gradient(const Study& study, const Case& c) {
  return c.order == 1 && pattern(study, c).everywhere && !values(study).everywhere;
}

constexpr std::array kCures{10, -10, 20, -20, 30, -30, 42, -42, 60};

// Units are powers of two, so that what no threshold decides rounds alike in all of them. Formulas with a logarithm of
// lengths do not: there a cure must bring back three digits.
std::optional<int> cure(const Study& study, const Case& c) {
  const bool has_logarithm = study.formula().behaviour(c.probe->sample.parameters).logarithmic.factor != 0;
  for (const int k : kCures) {
    const Probe scaled = study.prober().scaled(*c.probe, k);
    const Case there = study.ask(scaled, c.order);
    if (!there.bad && (!has_logarithm || 1e3 * there.error < c.error)) return k;
  }
  return std::nullopt;
}
bool by_unit(const Study& study, const Case& c) { return cure(study, c).has_value(); }
std::string unit_text(const Study& study, const Case& c) {
  return fmt::format("{}; with all coordinates times 2^{} the same formula is right", error_text(study, c),
                     cure(study, c).value_or(0));
}

bool by_edge_logarithm(const Study& study, const Case& c) {
  const Place at = place(study, c);
  const bool grows = std::max(study.pattern(0).edge_slope, study.pattern(1).edge_slope) > 0.7;
  return grows && (at.edge < 0.1 || at.line < 1e-3);
}
std::string slope_text(const Study& study, const Case& c) {
  return fmt::format("{}; errors grow as the distance from the edge falls, like its power {:.1f}", error_text(study, c),
                     -std::max(study.pattern(0).edge_slope, study.pattern(1).edge_slope));
}

// Sizes that count as next to a corner, an edge or a face.
constexpr double kNext = 1e-6;

bool nan_at_vertex(const Study& study, const Case& c) { return !c.finite && place(study, c).distance < kNext; }
bool nan_at_edge(const Study& study, const Case& c) {
  return !c.finite && study.formula().dim() == 3 && place(study, c).edge < kNext;
}
bool nan_at_face(const Study& study, const Case& c) {
  const Place at = place(study, c);
  const auto corners = static_cast<std::ptrdiff_t>(c.probe->sample.corners.size());
  return !c.finite && at.height < kNext &&
         std::all_of(at.basis.begin(), at.basis.begin() + corners, [](double b) { return b > 0; });
}

// The corner whose result, right there, a point on an edge is given; negative where it is none.
int taken_for(const Study& study, const Case& c) {
  const Place at = place(study, c);
  if (at.contact != Contact::Border || at.at_vertex || !c.finite) return -1;
  for (std::size_t k = 0; k < c.probe->sample.corners.size(); ++k) {
    Sample corner = c.probe->sample;
    corner.point = corner.corners[k];
    if (difference(study.ask(corner, study.prober().order()).of(c.order), c.found.of(c.order)) >= 1e-9) continue;
    const Probe at_corner = study.prober().at(corner);
    if (!study.ask(at_corner, c.order).bad) return static_cast<int>(k);
  }
  return -1;
}
bool vertex_for_edge(const Study& study, const Case& c) { return taken_for(study, c) >= 0; }
std::string vertex_text(const Study& study, const Case& c) {
  return fmt::format("{}; on the edge it gives the result of corner {}", error_text(study, c), taken_for(study, c) + 1);
}

double jump_of(const Study& study, const Case& c) {
  const FaceJump jump = study.formula().behaviour(c.probe->sample.parameters).face_jump;
  return jump.diverges ? 0 : jump.number + jump.pi_multiple * std::numbers::pi;
}

bool plane_branch(const Study& study, const Case& c) {
  const Place at = place(study, c);
  return c.order == 0 && c.finite && at.in_plane && at.contact == Contact::Off &&
         off_by(c) > 0.1 * std::abs(jump_of(study, c)) && jump_of(study, c) != 0;
}
std::string jump_text(const Study& study, const Case& c) {
  return fmt::format("off by {:.6g}, where the jump across the element is {:.6g}", off_by(c),
                     std::abs(jump_of(study, c)));
}

// Whether a value on the element is the limit from inside less that share of the jump. A rounding outside of it the
// truth is the limit from outside.
bool less_jump(const Study& study, const Case& c, double share) {
  const Formula& formula = study.formula();
  if (c.order != 0 || !c.finite || formula.shape.entries() != 1 || place(study, c).contact != Contact::Interior)
    return false;
  const double jump = jump_of(study, c);
  const Place at = place(study, c);
  for (const double sign : {1.0, -1.0}) {
    bool fits = jump != 0 && (sign > 0 || at.exactly_off);
    for (std::size_t k = 0; fits && k < c.found.value.size(); ++k) {
      const auto truth = static_cast<double>(c.probe->truth.tensors.value[k]);
      const double wanted = truth - sign * share * jump * (formula.shape.per_corner ? at.basis[k] : 1);
      fits = std::abs(c.found.value[k] - wanted) <= 1e-6 * std::abs(jump);
    }
    if (fits) return true;
  }
  return false;
}
bool zero_on_face(const Study& study, const Case& c) { return less_jump(study, c, 0.5); }
double projected_below(const Study& study) {
  return std::max(study.pattern(0).projected_below, study.pattern(1).projected_below);
}

// A foot that is computed may lie a rounding outside of the face.
bool outer_limit(const Study& study, const Case& c) { return projected_below(study) == 0 && less_jump(study, c, 1); }

// Where feet fall on an element's border, or a rounding beyond the plane, theirs may differ from that of our foot.
bool projected(const Study& study, const Case& c) {
  if (c.finite && is_projected(study, c)) return true;
  const Place at = place(study, c);
  return projected_below(study) > 0 && (at.exactly_off || c.finite) && at.height <= projected_below(study);
}
std::string foot_text(const Study& study, const Case& c) {
  return fmt::format("{}; it gives the result of the point's foot in the plane", error_text(study, c));
}

bool far_off(const Study& study, const Case& c) { return pattern(study, c).far && place(study, c).distance > 5; }
std::string far_text(const Study& study, const Case& c) {
  return fmt::format(
      "{}; errors grow like the distance to the power {:.1f}, those of the plain closed form like {:.1f}",
      error_text(study, c), pattern(study, c).far_slope, pattern(study, c).plain_far_slope);
}
bool thin(const Study& study, const Case& c) { return pattern(study, c).sliver && place(study, c).aspect < 0.2; }
std::string thin_text(const Study& study, const Case& c) {
  return fmt::format(
      "{}; errors grow like one over the aspect to the power {:.1f}, those of the plain closed form like {:.1f}",
      error_text(study, c), pattern(study, c).sliver_slope, pattern(study, c).plain_sliver_slope);
}

double plane_slope(const Study& study) { return std::max(study.pattern(0).plane_slope, study.pattern(1).plane_slope); }

bool by_plane(const Study& study, const Case& c) { return plane_slope(study) > 0.7 && place(study, c).height < 0.1; }
std::string plane_text(const Study& study, const Case& c) {
  return fmt::format("{}; relative errors grow like the height over the plane to the power {:.1f}",
                     error_text(study, c), -plane_slope(study));
}

bool always(const Study&, const Case&) { return true; }

constexpr std::array kSignatures{Signature{"quadrature_near", by_quadrature, error_text},
                                 Signature{"right_after_normalising", in_proportion, error_text},
                                 Signature{"sum_made_right", in_sum, error_text},
                                 Signature{"gradient_only_in_sums", in_closed_sum, error_text},
                                 Signature{"few_digits", few_digits, digits_text},
                                 Signature{"wrong_gradient", wrong_gradient, error_text},
                                 Signature{"absolute_threshold", by_unit, unit_text},
                                 Signature{"log_next_to_edge", by_edge_logarithm, slope_text},
                                 Signature{"vertex_for_edge", vertex_for_edge, vertex_text},
                                 Signature{"plane_branch", plane_branch, jump_text},
                                 Signature{"zero_on_face", zero_on_face, jump_text},
                                 Signature{"outer_limit_on_face", outer_limit, jump_text},
                                 Signature{"far_cancellation", far_off, far_text},
                                 Signature{"sliver_cancellation", thin, thin_text},
                                 Signature{"plane_cancellation", by_plane, plane_text},
                                 Signature{"projected_into_face", projected, foot_text},
                                 Signature{"nan_at_vertex", nan_at_vertex, error_text},
                                 Signature{"nan_at_edge", nan_at_edge, error_text},
                                 Signature{"nan_at_face", nan_at_face, error_text},
                                 Signature{"wrong_values", always, error_text}};

}  // namespace

std::span<const Signature> signatures() { return kSignatures; }

}  // namespace cageproof::judge
