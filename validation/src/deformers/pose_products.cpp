// SPDX-License-Identifier: MIT
#include "pose_products.h"

#include "sampling/generic_change.h"
#include "sampling/generic_direction.h"

#include "cageproof/core/input_error.h"
#include "cageproof/deformation/point_images.h"
#include "cageproof/validation/cage_terms.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace cageproof::validation {

using deformation::Deformer;
using deformation::Posed;

namespace {

// In cage sizes. In double what differences of fourth order leave out is less than images' roundings over the step.
constexpr double product_step_in_50_digits = 1e-16, product_step_in_double = 0x1p-13;

}  // namespace

PoseProducts::PoseProducts(std::shared_ptr<const Cage> cage, const deformation::DeformMethod& method,
                           std::function<std::shared_ptr<const Deformer<double>>()> deformer, Prepare in_50_digits)
    : cage_(std::move(cage)),
      change_(generic_change(*cage_)),
      deformer_(std::move(deformer)),
      along_([this, &method] {
        Along found;
        if (!method.has_pose_derivative) return found;
        found.derivative = deformer_.get()->derivative({bent(*cage_)});
        if (found.derivative) found.posed = found.derivative->along(change_);
        return found;
      }),
      in_double_([this] { return moved<double>(deformer_.get(), product_step_in_double, 4); }),
      in_50_digits_([this, in_50_digits = std::move(in_50_digits)] {
        return moved<Mp50>(in_50_digits(), Mp50(product_step_in_50_digits), 2);
      }) {}

bool PoseProducts::exist() const {
  try {
    return along_.get().derivative != nullptr;
  } catch (const InputError&) {
    return true;
  }
}

template <Scalar R>
PoseProducts::Moved<R> PoseProducts::moved(std::shared_ptr<const Deformer<R>> deformer, const R& step,
                                           int steps) const {
  Moved<R> found{std::move(deformer), {}};
  const std::vector<Vec3<double>> from = bent(*cage_);
  for (const int by : {1, -1, 2, -2}) {
    if (std::ssize(found.posed) == steps) break;
    std::vector<Vec3<R>> vertices;
    for (std::size_t v = 0; v < from.size(); ++v)
      vertices.push_back(convert<R>(from[v]) + R(by) * step * convert<R>(change_[v]));
    found.posed.push_back(found.deformer->pose({vertices}));
  }
  return found;
}

template <Scalar R>
std::vector<double> PoseProducts::differences(const Vec3<double>& at) const {
  const Vec3<R> point = convert<R>(at);
  const auto images = [&](const Moved<R>& moved) {
    const auto tables = moved.deformer->coordinates().template at<R>(std::span(&point, 1), 0);
    std::vector<std::vector<R>> found;
    found.reserve(moved.posed.size());
    for (const auto& posed : moved.posed) found.push_back(posed->images(tables, 1, 0).tensors[0]);
    return found;
  };
  std::vector<double> found;
  if constexpr (is_multiprecision<R>) {
    const auto by = images(in_50_digits_.get());
    for (std::size_t i = 0; i < by[0].size(); ++i)
      found.push_back(static_cast<double>(R((by[0][i] - by[1][i]) / (2 * R(product_step_in_50_digits)))));
  } else {
    const auto by = images(in_double_.get());
    for (std::size_t i = 0; i < by[0].size(); ++i)
      found.push_back((8 * (by[0][i] - by[1][i]) - (by[2][i] - by[3][i])) / (12 * product_step_in_double));
  }
  return found;
}

std::vector<double> PoseProducts::jvp(const Vec3<double>& point) const {
  return images_at(*deformer_.get(), *along_.get().posed, point, 0).tensors[0];
}

std::vector<double> PoseProducts::vjp(const Vec3<double>& point, const std::vector<double>& weights) const {
  const std::vector<Vec3<double>> found =
      deformation::pulled_back(deformer_.get()->coordinates(), std::span(&point, 1), *along_.get().derivative, weights,
                               {.order = 0, .jobs = 1}, std::nullopt);
  std::vector<double> numbers;
  for (const Vec3<double>& v : found) numbers.insert(numbers.end(), v.data(), v.data() + cage_->dimension());
  return numbers;
}

std::vector<double> PoseProducts::terms(const Vec3<double>& point) const {
  const int d = cage_->dimension();
  std::vector<double> sums(static_cast<std::size_t>(d), 0);
  for (int c = 0; c < d; ++c) {
    std::vector<double> weights(static_cast<std::size_t>(d), 0);
    weights[static_cast<std::size_t>(c)] = 1;
    const std::vector<double> row = vjp(point, weights);
    for (std::size_t i = 0; i < row.size(); ++i)
      sums[static_cast<std::size_t>(c)] += std::abs(row[i] * change_[i / d][static_cast<int>(i) % d]);
  }
  return sums;
}

template <Scalar R>
double PoseProducts::error_of_jvp(const Vec3<double>& point) const {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  if (!along_.get().derivative) return nan;
  std::vector<double> error = jvp(point);
  if (std::ranges::any_of(error, [](double x) { return std::isnan(x); })) return nan;
  const std::vector<double> expected = differences<R>(point);
  for (std::size_t i = 0; i < error.size(); ++i) error[i] -= expected[i];
  return length_of(error) / std::max(cage_->size(), length_of(terms(point)));
}

template double PoseProducts::error_of_jvp<double>(const Vec3<double>&) const;
template double PoseProducts::error_of_jvp<Mp50>(const Vec3<double>&) const;

double PoseProducts::roundings_of_adjoint(const Vec3<double>& point) const {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  if (!along_.get().derivative) return nan;
  const std::vector<double> changes = jvp(point);
  if (std::ranges::any_of(changes, [](double x) { return std::isnan(x); })) return nan;
  const int d = cage_->dimension();
  const Vec3<double> direction = generic_direction<double>(point, d);
  const std::vector<double> weights(direction.data(), direction.data() + d), back = vjp(point, weights),
                                                                             of_terms = terms(point);
  double difference = 0, size = 0;
  for (std::size_t c = 0; c < weights.size(); ++c) {
    difference += weights[c] * changes[c];
    size += std::abs(weights[c]) * of_terms[c];
  }
  for (std::size_t i = 0; i < back.size(); ++i) difference -= back[i] * change_[i / d][static_cast<int>(i) % d];
  return std::abs(difference) / (unit_roundoff<double>() * size);
}

}  // namespace cageproof::validation
