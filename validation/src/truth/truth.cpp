// SPDX-License-Identifier: MIT
#include "cageproof/validation/truth.h"

#include "element/element_sampling.h"
#include "truth/required_limits.h"
#include "truth/truth_cache.h"

#include "cageproof/core/input_error.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace cageproof::validation {
namespace {

bool all_finite(const std::vector<Mp100>& tensor) {
  for (const Mp100& x : tensor)
    if (!isfinite(x)) return false;
  return true;
}

template <Scalar R>
std::vector<Mp100> widened(const std::vector<R>& tensor) {
  std::vector<Mp100> wide;
  wide.reserve(tensor.size());
  for (const R& x : tensor) wide.push_back(static_cast<Mp100>(x));
  return wide;
}

Result<Mp100> widened(const Result<Mp50>& result) {
  Result<Mp100> wide;
  for (int o = 0; o < 3; ++o) wide.of(o) = widened(result.of(o));
  wide.stated_digits = result.stated_digits;
  wide.converged = result.converged;
  wide.nodes = result.nodes;
  return wide;
}

std::vector<Mp100> difference(std::vector<Mp100> a, const std::vector<Mp100>& b) {
  for (std::size_t i = 0; i < a.size(); ++i) a[i] -= b[i];
  return a;
}

// Whether both tensors have infinities, with the same signs, and NaN in the same entries.
bool same_limits(const std::vector<Mp100>& a, const std::vector<Mp100>& b) {
  for (std::size_t i = 0; i < a.size(); ++i)
    if (isnan(a[i]) != isnan(b[i]) || isfinite(a[i]) != isfinite(b[i]) || (isinf(a[i]) && a[i] != b[i])) return false;
  return true;
}

// The entries that are finite in both.
std::array<std::vector<Mp100>, 2> finite_entries(const std::vector<Mp100>& a, const std::vector<Mp100>& b) {
  std::array<std::vector<Mp100>, 2> finite;
  for (std::size_t i = 0; i < a.size(); ++i)
    if (isfinite(a[i]) && isfinite(b[i])) {
      finite[0].push_back(a[i]);
      finite[1].push_back(b[i]);
    }
  return finite;
}

// Relative step of the one-sided differences: their error, 1e-30 over the distance to a singularity, leaves 13 digits
// at 1e-16, and 50 digits leave twenty of them.
constexpr const char* kStep = "1e-30";

// Calls `f(vertex, axis)` for each coordinate of the input that is not zero.
template <Scalar R, class F>
void for_each_coordinate(const Formula& formula, QueryOf<R>& input, F&& f) {
  for (int vertex = 0; vertex <= input.point_vertex(); ++vertex)
    for (int axis = 0; axis < formula.dim(); ++axis)
      if (input.coordinate(vertex, axis) != 0) f(vertex, axis);
}

// Whether a moved point is outside the face. The function may jump there, so only moves to the inner side count.
template <Scalar R>
bool leaves_the_inner_side(const Formula& formula, const Query<R>& query) {
  std::vector<Vec3<Mp100>> corners;
  corners.reserve(query.corners.size());
  for (const Vec3<R>& corner : query.corners) corners.push_back(convert<Mp100>(corner));
  return sampling_of(formula.element).exact.height(corners, convert<Mp100>(query.point)) > 0;
}

// |moved - truth| over the relative step, of the entries that are finite in both.
template <Scalar R>
Mp100 change(const Result<R>& moved, const Truth& truth, int order, const R& step) {
  const auto [found, expected] = finite_entries(widened(moved.of(order)), truth.tensors.of(order));
  return norm(difference(found, expected)) / Mp100(step);
}

template <Scalar R>
void add_conditioning(const Evaluation& reference, const Sample& sample, int order, Truth& truth) {
  QueryOf<R> input(sample, order);
  Result<R> moved;
  const R relative(kStep);
  for_each_coordinate(reference.formula(), input, [&](int vertex, int axis) {
    R& x = input.coordinate(vertex, axis);
    const R original = x;
    x = original * (1 + relative);
    if (truth.on_element && leaves_the_inner_side(reference.formula(), input.query())) x = original * (1 - relative);
    reference(input.query(), moved);
    x = original;
    for (int o = 0; o <= order; ++o)
      if (truth.exists[o] && all_finite(widened(moved.of(o))))
        truth.conditioned[o] += change(moved, truth, o, relative);
  });
}

// On the border most moves of a single coordinate lead off the element, or to where no limit exists. Three kinds keep
// the point on the border: moves of a corner and the point together where they coincide, moves of a corner whose basis
// function is zero at the point, and scaling a whole axis. The factor has few bits, so that all are exact in 50 digits.
template <Scalar R>
void add_border_conditioning(const Evaluation& reference, const Sample& sample, int order, Truth& truth) {
  const Formula& formula = reference.formula();
  const R relative = ldexp(R(1), -100), factor = 1 + relative;
  const auto add = [&](const QueryOf<R>& input) {
    Result<R> moved;
    reference(input.query(), moved);
    for (int o = 0; o <= order; ++o)
      if (truth.exists[o] || truth.partial[o]) truth.conditioned[o] += change(moved, truth, o, relative);
  };
  const auto basis = type_of(formula.element).contact(sample.corners, sample.point).basis;
  for (int axis = 0; axis < formula.dim(); ++axis) {
    QueryOf<R> scaled(sample, order);
    const int point = scaled.point_vertex();
    for (int vertex = 0; vertex <= point; ++vertex) scaled.coordinate(vertex, axis) *= factor;
    add(scaled);
    for (int vertex = 0; vertex < point; ++vertex) {
      const bool is_point = sample.corners[vertex] == sample.point;
      if (sample.corners[vertex][axis] == 0 || (!is_point && basis[vertex] != 0)) continue;
      QueryOf<R> moved(sample, order);
      moved.coordinate(vertex, axis) *= factor;
      if (is_point) moved.coordinate(point, axis) *= factor;
      add(moved);
    }
  }
}

// How far a point may move while the gradient still predicts a value's change: the larger of |f'|/|f''| and
// sqrt(|f|/|f''|), where the gradient may vanish. |f|/|f'| would be zero in a plane where f vanishes. Where f is
// linear, the input's extent.
Mp50 reach_of(const Result<Mp50>& base, const Sample& sample) {
  std::array<Mp50, 3> size;
  for (int o = 0; o <= 2; ++o) {
    size[o] = 0;
    for (const Mp50& x : base.of(o)) size[o] += x * x;
    size[o] = sqrt(size[o]);
  }
  const Mp50 reach = std::max<Mp50>(size[1] / size[2], sqrt(Mp50(size[0] / size[2])));
  if (isfinite(reach) && reach > 0) return reach;
  double extent = sample.point.cwiseAbs().maxCoeff();
  for (const Vec3<double>& corner : sample.corners) extent = std::max(extent, corner.cwiseAbs().maxCoeff());
  return extent;
}

// As add_conditioning, from an evaluation in 50 digits that is right to twelve: steps are 1e-6 of what it takes to
// change a tensor.
void add_rough_conditioning(const Evaluation& rough, const Sample& sample, int order, Truth& truth) {
  QueryOf<Mp50> input(sample, order);
  QueryOf<Mp100> wide_input(sample, order);
  Result<Mp50> moved;
  const Result<Mp50> bent = evaluate<Mp50>(rough, sample, 2);
  const Result<Mp50> base = order == 2 ? bent : evaluate<Mp50>(rough, sample, order);
  const Mp50 reach = reach_of(bent, sample);
  for_each_coordinate(rough.formula(), input, [&](int vertex, int axis) {
    Mp50& x = input.coordinate(vertex, axis);
    const Mp50 original = x;
    Mp50 relative = Mp50("1e-6") * std::min<Mp50>(1, reach / abs(x));
    if (truth.on_element) {
      Mp100& wide = wide_input.coordinate(vertex, axis);
      const Mp100 wide_original = wide;
      wide = wide_original * (1 + Mp100(relative));
      if (leaves_the_inner_side(rough.formula(), wide_input.query())) relative = -relative;
      wide = wide_original;
    }
    x = original * (1 + relative);
    rough(input.query(), moved);
    x = original;
    for (int o = 0; o <= order; ++o) {
      std::vector<Mp50> change = moved.of(o);
      for (std::size_t i = 0; i < change.size(); ++i) change[i] -= base.of(o)[i];
      const std::vector<Mp100> wide = widened(change);
      if (truth.exists[o] && all_finite(wide)) truth.conditioned[o] += norm(wide) / Mp100(abs(relative));
    }
  });
}

// The evaluation of that name, or the given one where there is no name.
Evaluation named_or(const Evaluation& evaluation, const std::string& name) {
  return name.empty() ? evaluation : evaluation_named(evaluation.formula().name, name);
}

std::optional<TruthSource> find_truth_source(const Formula& formula) {
  auto& known = EvaluationRegister::instance();
  if (const auto closed = known.with_role(formula.name, Role::ClosedForm))
    return TruthSource{.evaluation = *closed,
                       .values = *closed,
                       .confirmation = *closed,
                       .yardstick = *closed,
                       .digits = TruthSource::Digits::Fifty};
  const auto recommended = known.with_role(formula.name, Role::Recommended);
  if (recommended && recommended->supports<Mp100>() && recommended->supports<Mp200>()) {
    const auto& substitutes = recommended->substitutes();
    return TruthSource{.evaluation = *recommended,
                       .values = named_or(*recommended, substitutes.truths),
                       .confirmation = named_or(*recommended, substitutes.confirmations),
                       .yardstick = named_or(*recommended, substitutes.yardsticks),
                       .rough_yardstick = !substitutes.yardsticks.empty()};
  }
  const auto integral = known.with_role(formula.name, Role::Integral);
  if (!integral) return std::nullopt;
  return TruthSource{.evaluation = *integral,
                     .values = *integral,
                     .confirmation = *integral,
                     .yardstick = *integral,
                     .rough_yardstick = true,
                     .digits = TruthSource::Digits::OfIntegral};
}

// Tensors that must agree with the truth's, and whether their evaluation converged.
struct Confirmation {
  std::array<std::vector<Mp100>, 3> tensors;
  bool converged = false;
};

template <Scalar R>
Confirmation confirmed_in(const Evaluation& evaluation, const Sample& sample, int order) {
  const Result<R> found = evaluate<R>(evaluation, sample, order);
  Confirmation confirmation{{}, found.converged};
  for (int o = 0; o <= order; ++o) confirmation.tensors[o] = widened(found.of(o));
  return confirmation;
}

Truth computed_truth(const TruthSource& source, const Sample& sample, int order) {
  using Digits = TruthSource::Digits;
  Truth truth;
  if (!is_finite(sample)) return truth;
  truth.required = limits_that_must_exist(source.evaluation.formula(), sample);
  if (source.digits == Digits::Fifty) truth.tensors = widened(evaluate<Mp50>(source.values, sample, order));
  else truth.tensors = evaluate<Mp100>(source.values, sample, order);
  const Confirmation confirmation =
      source.digits == Digits::Fifty        ? confirmed_in<Mp100>(source.confirmation, sample, order)
      : source.digits == Digits::OfIntegral ? confirmed_in<Mp50>(source.confirmation, sample, order)
                                            : confirmed_in<Mp200>(source.confirmation, sample, order);
  const Contact contact = contact_of(source.evaluation.formula().element, sample);
  truth.on_element = contact != Contact::Off;
  if (!truth.tensors.converged || !confirmation.converged) return truth;
  const bool on_input = truth.on_element && is_input(source.evaluation.formula(), sample);
  static const Mp100 agreement("1e-30");
  for (int o = 0; o <= order; ++o) {
    const std::vector<Mp100>& confirmed = confirmation.tensors[o];
    const bool limits = all_finite(truth.tensors.of(o)) && all_finite(confirmed);
    const auto [found, expected] = finite_entries(truth.tensors.of(o), confirmed);
    truth.norm[o] = truth.conditioned[o] = norm(expected);
    const bool agrees = norm(difference(found, expected)) <= agreement * truth.norm[o];
    truth.exists[o] = limits && agrees;
    truth.partial[o] = on_input && !limits && agrees && same_limits(truth.tensors.of(o), confirmed);
  }
  if (source.rough_yardstick) {
    if (contact != Contact::Border) add_rough_conditioning(source.yardstick, sample, order, truth);
    return truth;
  }
  const auto add = [&]<Scalar R>() {
    if (contact == Contact::Border) add_border_conditioning<R>(source.values, sample, order, truth);
    else add_conditioning<R>(source.values, sample, order, truth);
  };
  if (source.digits == Digits::Fifty) add.template operator()<Mp50>();
  else add.template operator()<Mp100>();
  return truth;
}

}  // namespace

Mp100 norm(const std::vector<Mp100>& tensor) {
  Mp100 sum = 0;
  for (const Mp100& x : tensor) sum += x * x;
  return sqrt(sum);
}

Contact contact_of(ElementKind element, const Sample& sample) {
  return type_of(element).contact(sample.corners, sample.point).contact;
}

TruthSource truth_source(const Formula& formula) {
  auto found = find_truth_source(formula);
  if (!found)
    throw InputError(fmt::format(
        "{} has neither a recommended evaluation in multiprecision nor the integral: nothing gives its truth",
        formula.name));
  return std::move(*found);
}

bool has_truth_source(const Formula& formula) { return find_truth_source(formula).has_value(); }

Truth truth_from(const TruthSource& source, const Sample& sample, int order) {
  const auto make = [&] { return computed_truth(source, sample, order); };
  TruthCache* const cache = truth_cache();
  return cache == nullptr ? make() : cache->get(question_of(source, sample, order), make);
}

}  // namespace cageproof::validation
