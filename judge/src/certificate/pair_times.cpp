// SPDX-License-Identifier: MIT
#include "certificate/pair_times.h"

#include "cageproof/validation/regime.h"
#include "cageproof/validation/sample.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>

namespace cageproof::judge {
namespace {

constexpr std::size_t elements = 16, points = 64;
constexpr int repeats = 5;

// One element with the points of many samples: each is generic to it as to its own, except for its size.
struct Blocks {
  std::vector<std::vector<Vec3<double>>> corners;
  std::vector<Vec3<double>> places;
  std::vector<double> parameters;
};

Blocks blocks_of(const Formula& formula) {
  Blocks blocks;
  const validation::Regime& generic = *validation::find_regime("generic");
  for (std::size_t i = 0; i < points; ++i) {
    const validation::Sample sample = make_sample(formula, generic, 1, i);
    if (i < elements) blocks.corners.push_back(sample.corners);
    if (i == 0) blocks.parameters = sample.parameters;
    blocks.places.push_back(sample.point);
  }
  return blocks;
}

double foreign_time(ForeignCode& code, const Request& request, const Blocks& blocks) {
  const int dim = request.formula->dim();
  std::vector<Asked> asked(elements);
  for (std::size_t e = 0; e < elements; ++e) {
    asked[e].count = points;
    asked[e].parameters = blocks.parameters;
    for (const auto& corner : blocks.corners[e])
      for (int c = 0; c < dim; ++c) asked[e].corners.push_back(request.single ? float(corner[c]) : corner[c]);
    for (const auto& place : blocks.places)
      for (int c = 0; c < dim; ++c) asked[e].points.push_back(request.single ? float(place[c]) : place[c]);
  }
  double least = std::numeric_limits<double>::infinity();
  for (int repeat = 0; repeat < repeats; ++repeat) {
    double nanoseconds = 0;
    const std::vector<Answer> answers = code.ask(request, asked, &nanoseconds);
    if (std::ranges::any_of(answers, [](const Answer& a) { return a.status != Answer::Status::Given; })) return -1;
    least = std::min(least, nanoseconds);
  }
  return least / (elements * points);
}

template <Scalar R>
double own_time(const Evaluation& evaluation, int order, const Blocks& blocks) {
  const Formula& formula = evaluation.formula();
  std::vector<Vec3<R>> places, corners;
  for (const auto& place : blocks.places) places.push_back(convert<R>(place));
  const std::vector<R> parameters(blocks.parameters.begin(), blocks.parameters.end());
  std::array<std::vector<R>, 3> tensors;
  BatchOutput<R> output{.entries = static_cast<std::size_t>(formula.shape.entries()), .dim = formula.dim()};
  for (int o = 0; o <= order; ++o) {
    output.stride[o] = static_cast<std::size_t>(formula.components()) * derivative_count(formula.dim(), o);
    tensors[o].resize(points * output.stride[o]);
    output.tensors[o] = tensors[o].data();
  }
  double least = std::numeric_limits<double>::infinity();
  for (int repeat = 0; repeat < repeats; ++repeat) {
    const auto start = std::chrono::steady_clock::now();
    for (const auto& element : blocks.corners) {
      corners.clear();
      for (const auto& corner : element) corners.push_back(convert<R>(corner));
      evaluation(Batch<R>{corners, places, order, parameters, false}, output);
    }
    const auto time = std::chrono::steady_clock::now() - start;
    least = std::min(least, std::chrono::duration<double, std::nano>(time).count());
  }
  return least / (elements * points);
}

}  // namespace

std::vector<PairTime> pair_times(ForeignCode& code, const Request& request, const std::string& name) {
  std::vector<PairTime> times;
  const Blocks blocks = blocks_of(*request.formula);
  for (const int order : {0, request.order}) {
    Request asked = request;
    asked.order = order;
    if (const double time = foreign_time(code, asked, blocks); time >= 0) times.push_back({name, order, time});
    for (const Role role : {Role::Plain, Role::Recommended}) {
      const auto own = EvaluationRegister::instance().with_role(request.formula->name, role);
      if (!own || own->max_order() < order) continue;
      if (request.single && own->supports<float>())
        times.push_back({own->name(), order, own_time<float>(*own, order, blocks)});
      else if (!request.single) times.push_back({own->name(), order, own_time<double>(*own, order, blocks)});
    }
    if (request.order == 0) break;
  }
  return times;
}

}  // namespace cageproof::judge
