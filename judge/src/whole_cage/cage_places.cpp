// SPDX-License-Identifier: MIT
#include "whole_cage/cage_places.h"

#include "cageproof/core/cage/cage_elements.h"
#include "cageproof/core/cage/embedded_cages.h"
#include "cageproof/core/numbers/random_stream.h"

#include <cmath>
#include <map>
#include <string>

namespace cageproof::judge {
namespace {

constexpr int kAttempts = 100;

CageQuestion question_of(std::string_view embedded, double unit, const Vec3<double>& offset) {
  const CageElements elements(embedded_cage(embedded), false, Triangulation::Shortest);
  CageQuestion question;
  question.dimension = elements.dimension();
  for (const Vec3<double>& vertex : elements.vertices()) question.vertices.emplace_back((vertex + offset) * unit);
  for (std::size_t e = 0; e < elements.count(); ++e) {
    const auto face = elements.vertices_of(e);
    question.faces.push_back({face[0], face[1], face.size() > 2 ? face[2] : -1});
  }
  return question;
}

std::vector<CagePlaces> made_in_space(std::string_view regime) {
  const Vec3<double> origin = Vec3<double>::Zero();
  std::vector<CagePlaces> places;
  // Only on faces along the axes do doubles lie exactly.
  if (regime.starts_with("on-"))
    for (const std::string_view name : {"cube", "l-block", "thin-box"}) places.emplace_back(name, 1, origin);
  else if (regime == "units")
    for (const double unit : {0x1p-30, 0x1p30, 0x1p-10, 0x1p10}) places.emplace_back("icosphere", unit, origin);
  else if (regime == "offset")
    for (const double far : {1e2, 1e4}) places.emplace_back("icosphere", 1, Vec3<double>(far, -far, far));
  else
    for (const std::string_view name : {"cube", "icosphere", "l-block", "thin-box", "spiky-box"})
      places.emplace_back(name, 1, origin);
  return places;
}

std::vector<CagePlaces> made_in_plane(std::string_view regime) {
  const Vec3<double> origin = Vec3<double>::Zero();
  std::vector<CagePlaces> places;
  if (regime.starts_with("on-"))
    for (const std::string_view name : {"square", "l-shape", "comb", "frame"}) places.emplace_back(name, 1, origin);
  else if (regime == "units")
    for (const double unit : {0x1p-30, 0x1p30, 0x1p-10, 0x1p10}) places.emplace_back("star", unit, origin);
  else if (regime == "offset")
    for (const double far : {1e2, 1e4}) places.emplace_back("star", 1, Vec3<double>(far, -far, 0));
  else
    for (const std::string_view name : {"square", "l-shape", "star", "comb", "thin-bar", "frame", "figure"})
      places.emplace_back(name, 1, origin);
  return places;
}

}  // namespace

CagePlaces::CagePlaces(std::string_view embedded, double unit, const Vec3<double>& offset)
    : question_(question_of(embedded, unit, offset)),
      winding_(std::make_shared<WindingNumbers>(CageElements(question_.cage(), false, Triangulation::Shortest))),
      low_(question_.vertices[0]),
      high_(low_) {
  for (const Vec3<double>& vertex : question_.vertices) {
    low_ = low_.cwiseMin(vertex);
    high_ = high_.cwiseMax(vertex);
  }
}

Vec3<double> CagePlaces::anywhere(RandomStream& random) const {
  Vec3<double> point = Vec3<double>::Zero();
  for (int c = 0; c < question_.dimension; ++c) point[c] = random.uniform(low_[c], high_[c]);
  return point;
}

// Corners' weights are sixteenths, which axis-parallel faces take without rounding.
Vec3<double> CagePlaces::on_cage(std::string_view regime, RandomStream& random) const {
  const auto& face = question_.faces[static_cast<std::size_t>(random.below(static_cast<int>(question_.faces.size())))];
  int a = 1 + random.below(14), b = 1 + random.below(15 - a);
  if (regime.ends_with("edge")) b = question_.dimension == 2 ? 0 : 16 - a;
  if (regime.ends_with("vertex")) a = 16, b = 0;
  const auto corner = [&](int k) -> const Vec3<double>& {
    return question_.vertices[static_cast<std::size_t>(face[k])];
  };
  const Vec3<double> along = corner(0) + a / 16. * (corner(1) - corner(0));
  return b == 0 ? along : along + b / 16. * (corner(2) - corner(0));
}

std::optional<Vec3<double>> CagePlaces::point(std::string_view regime, std::uint64_t seed, std::uint64_t index) const {
  RandomStream random(seed, "whole cage " + std::string(regime), index);
  const bool is_on = regime.starts_with("on-"), is_near = regime.starts_with("near-");
  for (int attempt = 0; attempt < kAttempts; ++attempt) {
    Vec3<double> point = is_on ? on_cage(regime, random) : anywhere(random);
    if (is_near) {
      const double step = std::pow(10, random.uniform(-12, -1));
      const Vec3<double> from = on_cage(regime, random);
      point = from + step * (point - from);
    }
    const std::optional<int> winding = winding_->around(point);
    if (is_on ? !winding : winding == 1) return point;
  }
  return std::nullopt;
}

std::vector<std::string_view> cage_regimes(int dimension) {
  if (dimension == 2) return {"inside", "near-edge", "near-vertex", "on-edge", "on-vertex", "units", "offset"};
  return {"inside", "near-face", "near-edge", "near-vertex", "on-face", "on-edge", "on-vertex", "units", "offset"};
}

const std::vector<CagePlaces>& places_of(std::string_view regime, int dimension) {
  using All = std::map<std::string_view, std::vector<CagePlaces>>;
  const auto of = [](int space, auto made) {
    All places;
    for (const std::string_view one : cage_regimes(space)) places.emplace(one, made(one));
    return places;
  };
  if (dimension == 2) {
    static const All in_plane = of(2, made_in_plane);
    return in_plane.at(regime);
  }
  static const All in_space = of(3, made_in_space);
  return in_space.at(regime);
}

}  // namespace cageproof::judge
