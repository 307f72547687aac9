// SPDX-License-Identifier: MIT
// The segment's hybrids in numbers that count.
#include "cageproof/adaptive_qmvc/counted_rule.h"
#include "cageproof/closed_form/segment/affine_single_layer.h"
#include "cageproof/closed_form/segment/biharmonic_double_layer.h"
#include "cageproof/closed_form/segment/biharmonic_single_layer.h"
#include "cageproof/closed_form/segment/double_layer.h"
#include "cageproof/closed_form/segment/engine/counted.h"
#include "cageproof/closed_form/segment/kelvin_displacement.h"
#include "cageproof/closed_form/segment/kelvin_traction.h"
#include "cageproof/closed_form/segment/mean_value.h"
#include "cageproof/closed_form/segment/polyharmonic_double_layer.h"
#include "cageproof/closed_form/segment/polyharmonic_single_layer.h"
#include "cageproof/closed_form/segment/single_layer.h"
#include "cageproof/closed_form/segment/winding_angle.h"
#include "segment/hybrid.h"

namespace cageproof::fast::segment {

using namespace closed_form;

namespace {

template <class F, int O>
Explanation explain_order(const Query<double>& query, std::span<const double> values,
                          std::optional<std::size_t> entry) {
  const Segment<double> ends{query.corners[0], query.corners[1]};
  Explanation explanation;
  if (!hybrid<F, O>(SeenSegment(ends, query.point), query.parameters, query.finite_part)) {
    explanation.route = "none in double: the point is extreme";
    choose_none(explanation, values, entry);
    return explanation;
  }
  const CountedTape tape;
  const FarFrame<Counted> frame({convert<Counted>(ends[0]), convert<Counted>(ends[1])}, convert<Counted>(query.point));
  const auto jet = jet_at<F, O>(frame, query.parameters, query.finite_part);
  choose(explanation, tape, closed_form::segment::entries_of<O>(jet), 0, values, entry);
  explanation.route = frame.is_far() ? "the form far away, in double" : "the form nearby, in double";
  return explanation;
}

template <class F>
Explanation explain_form(const Query<double>& query, std::span<const double> values, std::optional<std::size_t> entry) {
  if (query.order == 0) return explain_order<F, 0>(query, values, entry);
  if (query.order == 1) return explain_order<F, 1>(query, values, entry);
  return explain_order<F, 2>(query, values, entry);
}

const RegisterExplainer explainers[] = {
    {"segment.single_layer", "hybrid", &explain_form<SingleLayer>},
    {"segment.double_layer", "hybrid", &explain_form<DoubleLayer>},
    {"segment.affine_single_layer", "hybrid", &explain_form<AffineSingleLayer>},
    {"segment.biharmonic_single_layer", "hybrid", &explain_form<BiharmonicSingleLayer>},
    {"segment.biharmonic_double_layer", "hybrid", &explain_form<BiharmonicDoubleLayer>},
    {"segment.kelvin_displacement", "hybrid", &explain_form<KelvinDisplacement>},
    {"segment.kelvin_traction", "hybrid", &explain_form<KelvinTraction>},
    {"segment.mean_value", "hybrid", &explain_form<MeanValue>},
    {"segment.polyharmonic_single_layer", "hybrid", &explain_form<PolyharmonicSingleLayer>},
    {"segment.polyharmonic_double_layer", "hybrid", &explain_form<PolyharmonicDoubleLayer>},
    {"segment.winding_angle", "hybrid", &explain_form<WindingAngle>},
};

}  // namespace
}  // namespace cageproof::fast::segment
