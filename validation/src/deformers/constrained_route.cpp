// SPDX-License-Identifier: MIT
#include "deformers/constrained_route.h"

#include "second_routes/thickness_energy.h"
#include "second_routes/variational_energy.h"

#include <algorithm>
#include <cmath>

namespace cageproof::validation {

using namespace second_routes;

namespace {

using Model = deformation::ConstrainedDeformer<double>;
using PosedModel = deformation::Posed<double>;

// A variant's parameter for this problem, or the name that its value has.
double parameter_of(const ConstrainedVariant& variant, std::string_view name) {
  const auto& all = variant.method->parameters;
  const auto found = std::ranges::find(all, name, [](const KindParameter& p) { return std::string_view(p.name); });
  return variant.parameters.at(static_cast<std::size_t>(found - all.begin()));
}

std::string_view named_parameter_of(const ConstrainedVariant& variant, std::string_view name) {
  const auto& all = variant.method->parameters;
  const auto found = std::ranges::find(all, name, [](const KindParameter& p) { return std::string_view(p.name); });
  return found->names.at(static_cast<std::size_t>(parameter_of(variant, name)));
}

// The places of constraints, kind by kind, with the order of derivatives that is asked for there.
template <class F>
MapAtConstraints at_constraints(const deformation::Constraints& constraints, const F& tensor) {
  MapAtConstraints found;
  for (const auto& [at, to] : constraints.positions) found.positions.push_back(tensor(at, 0));
  for (const auto& [at, jacobian] : constraints.orientations) found.orientations.push_back(tensor(at, 1));
  for (const Vec3<double>& at : constraints.rotations) found.rotations.push_back(tensor(at, 1));
  for (const Vec3<double>& at : constraints.hessians) found.hessians.push_back(tensor(at, 2));
  return found;
}

MapAtConstraints images_of(const Model& model, const PosedModel& posed, const deformation::Constraints& constraints) {
  return at_constraints(constraints, [&](const Vec3<double>& at, int order) {
    const auto images = model.images(posed, std::span(&at, 1), order);
    return MapTensor(images.tensors[order].begin(), images.tensors[order].end());
  });
}

MapAtConstraints identity_at(const deformation::Constraints& constraints, int d) {
  return at_constraints(constraints, [d](const Vec3<double>& at, int order) {
    MapTensor found(static_cast<std::size_t>(d) * derivative_count(d, order));
    for (int c = 0; c < d && order < 2; ++c) found[order == 0 ? c : (d + 1) * c] = order == 0 ? at[c] : 1;
    return found;
  });
}

// The directions of one coefficient, component by component, in a unit in which the cage's size is one. A coordinate
// that is a number moves only that component, one that is a matrix all, by its column.
class Directions {
 public:
  Directions(const CageCoordinates& coordinates, const deformation::Constraints& constraints, double size)
      : d_(coordinates.dimension()), blocks_(coordinates.blocks()), size_(size) {
    layers_ = at_constraints(constraints, [&](const Vec3<double>& at, int order) {
      MapTensor all;
      for (const Result<double>& block : coordinates.at<double>(at, order))
        all.insert(all.end(), block.of(order).begin(), block.of(order).end());
      return all;
    });
  }

  template <class F>
  void each(const F& use) const {
    std::size_t first = 0;
    for (const CoordinateBlock& block : blocks_)
      for (int k = 0; k < block.size; ++k, first += block.entries())
        for (int c = 0; c < d_; ++c) use(along(first, c, block.shape.rows > 1, std::pow(size_, -block.degree)));
  }

 private:
  MapAtConstraints along(std::size_t first, int component, bool is_matrix, const Mp50& unit) const {
    const auto of = [&](const std::vector<MapTensor>& layers, int order) {
      const std::size_t width = derivative_count(d_, order);
      std::vector<MapTensor> found;
      for (const MapTensor& all : layers) {
        MapTensor& tensor = found.emplace_back(static_cast<std::size_t>(d_) * width);
        for (int row = is_matrix ? 0 : component; row < (is_matrix ? d_ : component + 1); ++row)
          for (std::size_t i = 0; i < width; ++i)
            tensor[row * width + i] = unit * all[(first + (is_matrix ? row * d_ + component : 0)) * width + i];
      }
      return found;
    };
    return {of(layers_.positions, 0), of(layers_.orientations, 1), of(layers_.rotations, 1), of(layers_.hessians, 2)};
  }

  int d_;
  const std::vector<CoordinateBlock>& blocks_;
  double size_;
  MapAtConstraints layers_;
};

double over(const Mp50& found, const Mp50& expected) {
  return std::abs(static_cast<double>(Mp50((found - expected) / expected)));
}

double of_variational(const ConstrainedProblem& problem, const ConstrainedVariant& variant, Triangulation rule) {
  constexpr int steps = 3;
  const deformation::Constraints& constraints = problem.constraints;
  const auto before = problem.prepared(variant, rule, steps - 1), model = problem.prepared(variant, rule, steps);
  const auto posed_before = before->pose(), posed = model->pose();
  const int d = model->coordinates().dimension();
  // Rounded to double, as ConstrainedProblem::prepared passes them.
  const auto weight = [&](std::string_view name, int power) {
    return Mp50(parameter_of(variant, name) * std::pow(problem.size, power));
  };
  VariationalEnergy energy{weight("alpha", 2), weight("beta", 2), weight("gamma", 4), {}, {}, {}};
  for (const auto& [at, to] : constraints.positions) energy.targets.emplace_back(to.data(), to.data() + d);
  for (const auto& [at, jacobian] : constraints.orientations) {
    MapTensor& wanted = energy.jacobians.emplace_back();
    for (int c = 0; c < d; ++c)
      for (int j = 0; j < d; ++j) wanted.emplace_back(jacobian(c, j));
  }
  const bool similar = named_parameter_of(variant, "rotations") == "similar";
  for (const MapTensor& jacobian : images_of(*before, *posed_before, constraints).rotations)
    energy.turns.push_back(nearest_turn(jacobian, d, similar));
  const MapAtConstraints found = images_of(*model, *posed, constraints), rest = identity_at(constraints, d);
  Mp50 left = 0, there_was = 0;
  Directions(model->coordinates(), constraints, problem.size).each([&](const MapAtConstraints& direction) {
    const Mp50 here = energy.slope(found, direction), of_rest = energy.slope(rest, direction);
    left += here * here;
    there_was += of_rest * of_rest;
  });
  return std::max(static_cast<double>(Mp50(sqrt(Mp50(left / there_was)))),
                  over(Mp50(posed->report().energies.back()), energy.of(found)));
}

double of_thickness(const ConstrainedProblem& problem, const ConstrainedVariant& variant, Triangulation rule) {
  constexpr int steps = 400;
  const auto model = problem.prepared(variant, rule, steps);
  const auto posed = model->pose();
  std::vector<Vec3<double>> at;
  at.reserve(problem.constraints.positions.size());
  for (const auto& position : problem.constraints.positions) at.push_back(position.at);
  const ThicknessEnergy energy(model->coordinates(), static_cast<int>(parameter_of(variant, "samples")), at);
  ThicknessEnergy::Unknowns vertices;
  for (const Vec3<double>& v : posed->vertices()) vertices.insert(vertices.end(), {Mp50(v[0]), Mp50(v[1])});
  const std::vector<Mp50> images = energy.images(vertices);
  double missed = 0;
  for (std::size_t k = 0; k < images.size(); ++k) {
    const double to = problem.constraints.positions[k / 2].to[static_cast<Eigen::Index>(k % 2)];
    missed = std::max(missed, std::abs(static_cast<double>(Mp50(images[k] - to))) / problem.size);
  }
  return std::max({missed, energy.slope_along_constraints(vertices),
                   over(Mp50(posed->report().energies.back()), energy.of(vertices))});
}

}  // namespace

double unmet_stationarity(const ConstrainedProblem& problem, const ConstrainedVariant& variant, Triangulation rule) {
  return variant.method->positions_alone ? of_thickness(problem, variant, rule)
                                         : of_variational(problem, variant, rule);
}

}  // namespace cageproof::validation
