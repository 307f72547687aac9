// SPDX-License-Identifier: MIT
#include "blocks.h"

#include "faces_alone.h"
#include "long_sums.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace cageproof::closed_form::batch {
namespace {

// Distances in radii of the cage. Beyond kTooFar double-doubles may cancel too much, so sums of closed forms are taken.
// Beyond kFar double may cancel too much, where it is not measured: cancelling.h measures only values of Kelvin's
// layers, and mean values, whose weights' sum cancels far away, have limits of their own.
constexpr double kFar = 1.25, kTooFar = 256;

bool is_measured_far_away(Layers layers, int order) {
  return layers == Layers::Harmonic || layers == Layers::Biharmonic || (layers == Layers::Kelvin && order == 0);
}

}  // namespace

BlockRunner::BlockRunner(const Geometry& geometry, const CageElements* elements, const Request& request,
                         const Kernels& with)
    : geometry_(geometry),
      elements_(elements),
      request_(request),
      kernels_(with),
      tables_(geometry.tables()),
      points_(aligned<double>(3 * kernels_.lanes)),
      columns_(aligned<double>(static_cast<std::size_t>(request.layout.count) * kernels_.lanes)),
      scratch_(aligned<std::byte>(
          kernels_.scratch_bytes(geometry.vertices(), geometry.edges(), geometry.faces(), request.layout.count))),
      measured_(aligned<std::byte>(kernels_.measured_bytes())),
      marks_(geometry.faces()),
      beyond_(geometry.faces()) {
  block_.cage = &tables_;
  block_.layers = request.layers;
  block_.order = request.order;
  block_.beta = request.beta;
  block_.layout = request.layout;
  block_.points = points_.get();
  block_.columns = columns_.get();
  block_.scratch = scratch_.get();
  block_.measured = measured_.get();
  block_.marks = marks_.data();
  block_.beyond = beyond_.data();
}

unsigned BlockRunner::run(std::span<const Vec3<double>> points) {
  const int lanes = kernels_.lanes;
  const double scale = std::ldexp(1., -geometry_.exponent()), unit = std::ldexp(1., geometry_.exponent());
  const double too_far = kTooFar * geometry_.radius();
  const double far = is_measured_far_away(request_.layers, request_.order) ? too_far : kFar * geometry_.radius();
  unsigned left = 0;
  block_.whole = 0;
  for (int p = 0; p < lanes; ++p) {
    // A block that is not full goes on with its last point.
    const Vec3<double>& point = points[std::min<std::size_t>(p, points.size() - 1)];
    std::array<double, 3> x{};
    double squared = 0;  // distance from the centre
    bool exact = true;
    for (int i = 0; i < 3; ++i) {
      x[i] = point[i] * scale;
      exact = exact && x[i] * unit == point[i];
      squared += (x[i] - geometry_.centre()[i]) * (x[i] - geometry_.centre()[i]);
    }
    if (!exact || !(squared < too_far * too_far)) {
      left |= 1u << p;
      x = geometry_.centre();
    } else if (squared > far * far) {
      block_.whole |= 1u << p;
    }
    for (int i = 0; i < 3; ++i) points_[i * lanes + p] = x[i];
  }
  const unsigned all = (1u << points.size()) - 1;
  kernels_.sum(block_);
  if (request_.layers == Layers::MeanValue) {
    block_.left |= left;
    add_faces_alone(block_, lanes, static_cast<int>(points.size()));
    kernels_.normalise(block_);
    return block_.left & all;
  }
  left |= add_marked(points);
  while (elements_ != nullptr && kernels_.sum_again(block_)) left |= add_marked(points);
  return left & all;
}

bool BlockRunner::run_without(const std::vector<char>& left_out, const Vec3<double>& point) {
  const int lanes = kernels_.lanes;
  for (int i = 0; i < 3; ++i)
    for (int p = 0; p < lanes; ++p) points_[i * lanes + p] = std::ldexp(point[i], -geometry_.exponent());
  std::fill_n(columns_.get(), static_cast<std::size_t>(block_.layout.count) * lanes, 0.0);
  block_.marked = 0;
  block_.left = 0;
  for (int f = 0; f < geometry_.faces(); ++f)
    if (left_out[f] == 0) block_.marks[block_.marked++] = {f, 1u};
  return add_marked(std::span(&point, 1)) == 0;
}

unsigned BlockRunner::add_marked(std::span<const Vec3<double>> points) {
  if (block_.marked == 0) return block_.left;
  kernels_.sum_marked(block_);
  return block_.beyond_marked > 0 ? block_.left | add_beyond(points) : block_.left;
}

unsigned BlockRunner::add_beyond(std::span<const Vec3<double>> points) {
  const int lanes = kernels_.lanes;
  unsigned left = 0;
  for (std::size_t p = 0; p < points.size(); ++p) {
    std::vector<int> faces;
    for (int m = 0; m < block_.beyond_marked; ++m)
      if ((beyond_[m].points >> p & 1u) != 0) faces.push_back(beyond_[m].face);
    if (faces.empty()) continue;
    if (elements_ == nullptr) {
      left |= 1u << p;
      continue;
    }
    const std::array<double, 3> x{points_[p], points_[lanes + p], points_[2 * lanes + p]};
    // Within a face there are limits of all derivatives, on its border of none but values.
    const std::vector<Touching> touches = elements_->touching(points[p]);
    const int on = touches.size() == 1 ? touches.front().element : -1;
    if (touches.size() > 1 || !add_in_long(geometry_, request_.layers, request_.order, faces, on, x.data(),
                                           request_.long_beta, request_.layout, columns_.get() + p, lanes))
      left |= 1u << p;
  }
  return left;
}

}  // namespace cageproof::closed_form::batch
