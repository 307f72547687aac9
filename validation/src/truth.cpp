// SPDX-License-Identifier: MIT
#include "cageproof/validation/truth.h"

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

std::vector<Mp100> difference(std::vector<Mp100> a, const std::vector<Mp100>& b) {
  for (std::size_t i = 0; i < a.size(); ++i) a[i] -= b[i];
  return a;
}

// Relative step of the one-sided differences: their error, 1e-30 over the distance to a singularity, leaves 13 digits at 1e-16.
const Mp100& step() {
  static const Mp100 h("1e-30");
  return h;
}

// Signed, unscaled height of the point over its triangle: positive outside.
Mp100 height(const Query<Mp100>& query) {
  const Vec3<Mp100> a = query.corners[1] - query.corners[0], b = query.corners[2] - query.corners[0];
  const Vec3<Mp100> normal = a.cross(b);
  return normal.dot(Vec3<Mp100>(query.point - query.corners[0]));
}

void add_conditioning(const Evaluation& reference, const Sample& sample, int order, Truth& truth) {
  QueryOf<Mp100> input(sample, order);
  Result<Mp100> moved;
  for (int k = 0; k < input.coordinate_count(); ++k) {
    Mp100& x = input.coordinate(k);
    if (x == 0) continue;
    const Mp100 original = x;
    x = original * (1 + step());
    // On a face the function jumps: only moves that keep to its inner side are its own change.
    if (truth.on_element && height(input.query()) > 0) x = original * (1 - step());
    reference(input.query(), moved);
    x = original;
    for (int o = 0; o <= order; ++o)
      if (truth.exists[o] && all_finite(moved.of(o)))
        truth.conditioned[o] += norm(difference(moved.of(o), truth.tensors.of(o))) / step();
  }
}

// As add_conditioning, from an evaluation in 50 digits that is right to twelve: steps are 1e-6 of what it takes to change a tensor.
void add_rough_conditioning(const Evaluation& rough, const Sample& sample, int order, Truth& truth) {
  QueryOf<Mp50> input(sample, order);
  Result<Mp50> base, moved;
  rough(input.query(), base);
  Mp100 reach = 1;
  for (int o = 1; o <= order; ++o)
    if (truth.exists[o] && truth.exists[o - 1] && truth.norm[o] > 0 && truth.norm[o - 1] > 0) {
      const Mp100 length = truth.norm[o - 1] / truth.norm[o];
      if (o == 1 || length < reach) reach = length;
    }
  for (int k = 0; k < input.coordinate_count(); ++k) {
    Mp50& x = input.coordinate(k);
    if (x == 0) continue;
    const Mp50 original = x;
    const Mp50 relative = Mp50("1e-6") * std::min(Mp50(1), Mp50(reach) / abs(x));
    x = original * (1 + relative);
    rough(input.query(), moved);
    x = original;
    for (int o = 0; o <= order; ++o) {
      std::vector<Mp50> change = moved.of(o);
      for (std::size_t i = 0; i < change.size(); ++i) change[i] -= base.of(o)[i];
      const std::vector<Mp100> wide = widened(change);
      if (truth.exists[o] && all_finite(wide)) truth.conditioned[o] += norm(wide) / Mp100(relative);
    }
  }
}

const Evaluation& substitute(const Evaluation& reference, const std::string& name, std::optional<Evaluation>& storage) {
  if (name.empty()) return reference;
  storage = EvaluationRegister::instance().find(reference.formula(), name);
  return *storage;
}

}  // namespace

Mp100 norm(const std::vector<Mp100>& tensor) {
  Mp100 sum = 0;
  for (const Mp100& x : tensor) sum += x * x;
  return sqrt(sum);
}

Contact contact_of(const Sample& sample) {
  if (sample.corners.size() != 3) return Contact::None;
  // 200 digits hold the products of three doubles exactly over 100 decades.
  std::array<Vec3<Mp200>, 3> p;
  for (int i = 0; i < 3; ++i) p[i] = convert<Mp200>(sample.corners[i]) - convert<Mp200>(sample.point);
  const Vec3<Mp200> normal = Vec3<Mp200>(p[1] - p[0]).cross(Vec3<Mp200>(p[2] - p[0]));
  if (normal.dot(p[0]) != 0) return Contact::None;
  Contact contact = Contact::Face;
  for (int i = 0; i < 3; ++i) {
    const Mp200 side = p[i].cross(p[(i + 1) % 3]).dot(normal);
    if (side < 0) return Contact::None;
    if (side == 0) contact = Contact::Border;
  }
  return contact;
}

Truth truth_from(const Evaluation& chosen, const Sample& sample, int order) {
  Truth truth;
  std::optional<Evaluation> for_truths, for_confirmations, for_yardsticks;
  const Evaluation& reference = substitute(chosen, chosen.substitutes().truths, for_truths);
  const Evaluation& confirmation = substitute(chosen, chosen.substitutes().confirmations, for_confirmations);
  const Evaluation& rough = substitute(chosen, chosen.substitutes().yardsticks, for_yardsticks);
  truth.tensors = evaluate<Mp100>(reference, sample, order);
  const Result<Mp200> wider = evaluate<Mp200>(confirmation, sample, order);
  const Contact contact = contact_of(sample);
  truth.on_element = contact != Contact::None;
  if (!truth.tensors.converged || !wider.converged) return truth;
  static const Mp100 agreement("1e-30");
  for (int o = 0; o <= order; ++o) {
    const std::vector<Mp100> confirmed = widened(wider.of(o));
    if (!all_finite(truth.tensors.of(o)) || !all_finite(confirmed)) continue;
    truth.norm[o] = norm(confirmed);
    truth.exists[o] = norm(difference(truth.tensors.of(o), confirmed)) <= agreement * truth.norm[o];
    truth.conditioned[o] = truth.norm[o];
  }
  if (for_yardsticks) add_rough_conditioning(rough, sample, order, truth);
  else if (contact != Contact::Border) add_conditioning(reference, sample, order, truth);
  return truth;
}

namespace {

template <Scalar R>
double error_over(const Result<R>& f, const Truth& truth, int order, const Mp100& denominator) {
  const std::vector<Mp100> found = widened(f.of(order));
  if (!all_finite(found)) return std::numeric_limits<double>::infinity();
  const Mp100 error = norm(difference(found, truth.tensors.of(order)));
  if (error == 0) return 0;
  return denominator == 0 ? std::numeric_limits<double>::infinity() : static_cast<double>(Mp100(error / denominator));
}

}  // namespace

template <Scalar R>
double conditioned_error(const Result<R>& f, const Truth& truth, int order, const Mp100& u) {
  return error_over(f, truth, order, u * truth.conditioned[order]);
}

template <Scalar R>
double relative_error(const Result<R>& f, const Truth& truth, int order) {
  return error_over(f, truth, order, truth.norm[order]);
}

#define CAGEPROOF_INSTANTIATE(R)                                                               \
  template double conditioned_error<R>(const Result<R>&, const Truth&, int, const Mp100&);     \
  template double relative_error<R>(const Result<R>&, const Truth&, int);
CAGEPROOF_INSTANTIATE(float)
CAGEPROOF_INSTANTIATE(double)
CAGEPROOF_INSTANTIATE(Mp50)
CAGEPROOF_INSTANTIATE(Mp100)
CAGEPROOF_INSTANTIATE(Mp200)
#undef CAGEPROOF_INSTANTIATE

}  // namespace cageproof::validation
