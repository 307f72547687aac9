// SPDX-License-Identifier: MIT
// The segment's closed forms in numbers that count: the form in double, and how far up the ladder its bound sent the
// evaluation.
#include "cageproof/closed_form/segment/affine_single_layer.h"
#include "cageproof/closed_form/segment/biharmonic_double_layer.h"
#include "cageproof/closed_form/segment/biharmonic_single_layer.h"
#include "cageproof/closed_form/segment/double_layer.h"
#include "cageproof/closed_form/segment/engine/closed_form.h"
#include "cageproof/closed_form/segment/engine/counted.h"
#include "cageproof/closed_form/segment/kelvin_displacement.h"
#include "cageproof/closed_form/segment/kelvin_traction.h"
#include "cageproof/closed_form/segment/mean_value.h"
#include "cageproof/closed_form/segment/polyharmonic_double_layer.h"
#include "cageproof/closed_form/segment/polyharmonic_single_layer.h"
#include "cageproof/closed_form/segment/single_layer.h"
#include "cageproof/closed_form/segment/winding_angle.h"
#include "rung.h"

namespace cageproof::closed_form::segment {
namespace {

template <class F, int O>
Explanation explain_order(const Query<double>& query, std::span<const double> values,
                          std::optional<std::size_t> entry) {
  const Segment<double> ends{query.corners[0], query.corners[1]};
  PointFrames at(ends, query.point);
  const std::span<const double> parameters(query.parameters);
  const auto taken = bounded_form<F, O>(at, parameters, query.finite_part, kTolerance);
  Explanation explanation;
  if (!at.is_in_range()) {
    choose_none(explanation, values, entry);
    explanation.route =
        "form in " + arithmetic_name(taken.digits) + ": none in double, at an end, almost on the line or extreme";
    return explanation;
  }
  constexpr double largest = std::numeric_limits<double>::max();
  const double bound =
      bounded<O, double, double>(jet_at<F, O>(at.tracked<double>(), parameters, query.finite_part), largest).worst();
  const CountedTape tape;
  const Frame<Counted> frame =
      as_tracked(Frame<Counted>({convert<Counted>(ends[0]), convert<Counted>(ends[1])}, convert<Counted>(query.point)));
  const auto jet = jet_at<F, O>(frame, parameters, query.finite_part);
  choose(explanation, tape, entries_of<O>(jet), 0, values, entry);
  explanation.route = rung_name("form", taken, bound);
  return explanation;
}

template <class F>
Explanation explain_form(const Query<double>& query, std::span<const double> values, std::optional<std::size_t> entry) {
  if (query.order == 0) return explain_order<F, 0>(query, values, entry);
  if (query.order == 1) return explain_order<F, 1>(query, values, entry);
  return explain_order<F, 2>(query, values, entry);
}

const RegisterExplainer explainers[] = {
    {"segment.single_layer", "closed_form", &explain_form<SingleLayer>},
    {"segment.double_layer", "closed_form", &explain_form<DoubleLayer>},
    {"segment.affine_single_layer", "closed_form", &explain_form<AffineSingleLayer>},
    {"segment.biharmonic_single_layer", "closed_form", &explain_form<BiharmonicSingleLayer>},
    {"segment.biharmonic_double_layer", "closed_form", &explain_form<BiharmonicDoubleLayer>},
    {"segment.kelvin_displacement", "closed_form", &explain_form<KelvinDisplacement>},
    {"segment.kelvin_traction", "closed_form", &explain_form<KelvinTraction>},
    {"segment.mean_value", "closed_form", &explain_form<MeanValue>},
    {"segment.polyharmonic_single_layer", "closed_form", &explain_form<PolyharmonicSingleLayer>},
    {"segment.polyharmonic_double_layer", "closed_form", &explain_form<PolyharmonicDoubleLayer>},
    {"segment.winding_angle", "closed_form", &explain_form<WindingAngle>},
};

}  // namespace
}  // namespace cageproof::closed_form::segment
