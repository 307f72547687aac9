// SPDX-License-Identifier: MIT
#include "cage_routes.h"

#include "boundary_route.h"
#include "elastic_route.h"
#include "elastic_surface_route.h"
#include "entropy_route.h"
#include "spherical_route.h"
#include "surface_route.h"
#include "visibility_route.h"

#include "cageproof/core/lazy.h"

#include <algorithm>
#include <array>

namespace cageproof::second_routes {
namespace {

class OfSphericalPolygons final : public CageRoute {
 public:
  explicit OfSphericalPolygons(const Cage& cage) : cage_(cage) {}
  ScalarKind compared_in() const override { return ScalarKind::Digits100; }
  double error_at(const Vec3<double>& point, const Blocks& first) const override {
    return relative_distance(first.front(), spherical_coordinates(cage_, point));
  }

 private:
  const Cage& cage_;
};

// The prior is the definition's own input: quad mean value coordinates, where they are positive.
class OfEntropy final : public CageRoute {
 public:
  explicit OfEntropy(const Cage& cage)
      : cage_(cage), prior_(cage, coordinate_kind_named("quad_mean_value"), CoordinateOptions{}) {}
  ScalarKind compared_in() const override { return ScalarKind::Digits50; }
  double error_at(const Vec3<double>& point, const Blocks& first) const override {
    const auto prior = prior_.at<Mp50>(convert<Mp50>(point), 0).front().value;
    const EntropyProblem problem(cage_.vertices(), {prior.begin(), prior.end()}, point, cage_.size());
    const double unmet = unmet_optimality(problem, first.front());
    if (std::isnan(unmet)) return unmet;
    return std::max(unmet, relative_distance(first.front(), entropy_coordinates(problem)));
  }

 private:
  const Cage& cage_;
  CageCoordinates prior_;
};

class OfRays final : public CageRoute {
 public:
  explicit OfRays(const Cage& cage) : cage_(cage) {}
  ScalarKind compared_in() const override { return ScalarKind::Digits50; }
  double error_at(const Vec3<double>& point, const Blocks& first) const override {
    const std::vector<double> seen = coordinates_of_rays(cage_, point);
    return relative_distance(first.front(), std::vector<Mp100>(seen.begin(), seen.end()));
  }

 private:
  const Cage& cage_;
};

class OfBoundaryEquations final : public CageRoute {
 public:
  OfBoundaryEquations(const Cage& cage, int order) : route_([&cage, order] { return BoundaryRoute(cage, order); }) {}
  ScalarKind compared_in() const override { return ScalarKind::Digits50; }
  double error_at(const Vec3<double>& point, const Blocks& first) const override {
    double worst = 0;
    const auto expected = route_.get().at(point);
    for (std::size_t b = 0; b < first.size(); ++b) {
      const std::vector<Mp100> block(expected[b].begin(), expected[b].end());
      // Coordinates of vertices sum to one inside, and vanish outside where the scheme is exact, as on triangles: a
      // relative error there is one of nothing.
      worst = std::max(worst, relative_distance(first[b], block, b == 0 ? 1 : 0));
    }
    return worst;
  }

 private:
  Lazy<BoundaryRoute> route_;
};

// A route that gives the numbers of the kind's only block.
template <class Route>
class OfOneBlock final : public CageRoute {
 public:
  explicit OfOneBlock(const Cage& cage) : route_([&cage] { return Route(cage); }) {}
  ScalarKind compared_in() const override { return ScalarKind::Digits50; }
  double error_at(const Vec3<double>& point, const Blocks& first) const override {
    const std::vector<Mp200> expected = route_.get().at(point);
    // They sum to one inside, and vanish outside where the scheme is exact: a relative error there is one of nothing.
    return relative_distance(first.front(), std::vector<Mp100>(expected.begin(), expected.end()), 1);
  }

 private:
  Lazy<Route> route_;
};

}  // namespace

double relative_distance(std::span<const Mp100> found, std::span<const Mp100> expected, double least) {
  Mp100 error = 0, size = 0;
  for (std::size_t i = 0; i < found.size(); ++i) {
    const Mp100 difference = found[i] - expected[i];
    error += difference * difference;
    size += expected[i] * expected[i];
  }
  return static_cast<double>(Mp100(sqrt(Mp100(error / std::max(size, Mp100(least * least))))));
}

std::shared_ptr<const CageRoute> cage_route(const CoordinateKind& kind, const Cage& cage) {
  constexpr std::size_t most_faces = 50;
  if (cage.faces().size() > most_faces) return nullptr;
  if (kind.name == "spherical_mean_value") return std::make_shared<const OfSphericalPolygons>(cage);
  constexpr std::size_t most_edges = 8, most_triangles = 12;
  if (cage.dimension() == 3 && (kind.name == "harmonic" || kind.name == "elastic")) {
    if (cage.parts(false, Triangulation::Shortest).elements.size() > most_triangles) return nullptr;
    if (kind.name == "elastic") return std::make_shared<const OfOneBlock<ElasticSurfaceRoute>>(cage);
    return std::make_shared<const OfOneBlock<SurfaceRoute>>(cage);
  }
  static constexpr std::array by_order{"harmonic", "biharmonic_boundary", "triharmonic_boundary"};
  for (int k = 0; k < 3; ++k)
    if (kind.name == by_order[k] && cage.faces().size() <= most_edges)
      return std::make_shared<const OfBoundaryEquations>(cage, k + 1);
  if (kind.name == "elastic" && cage.faces().size() <= most_edges)
    return std::make_shared<const OfOneBlock<ElasticRoute>>(cage);
  if (kind.name == "positive_mean_value") return std::make_shared<const OfRays>(cage);
  if (kind.name == "maximum_entropy") return std::make_shared<const OfEntropy>(cage);
  return nullptr;
}

}  // namespace cageproof::second_routes
