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
  for (const Vec3<double>& vertex : elements.vertices()) question.vertices.emplace_back((vertex + offset) * unit);
  for (std::size_t e = 0; e < elements.count(); ++e) {
    const auto face = elements.vertices_of(e);
    question.faces.push_back({face[0], face[1], face[2]});
  }
  return question;
}

std::vector<CagePlaces> made(std::string_view regime) {
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

}  // namespace

Cage triangle_cage(const CageQuestion& question) {
  std::vector<Face> faces;
  faces.reserve(question.faces.size());
  for (const auto& face : question.faces) faces.push_back({{face[0], face[1], face[2], -1}});
  return Cage::make("judged", question.vertices, faces);
}

CagePlaces::CagePlaces(std::string_view embedded, double unit, const Vec3<double>& offset)
    : question_(question_of(embedded, unit, offset)),
      winding_(
          std::make_shared<WindingNumbers>(CageElements(triangle_cage(question_), false, Triangulation::Shortest))),
      low_(question_.vertices[0]),
      high_(low_) {
  for (const Vec3<double>& vertex : question_.vertices) {
    low_ = low_.cwiseMin(vertex);
    high_ = high_.cwiseMax(vertex);
  }
}

Vec3<double> CagePlaces::anywhere(RandomStream& random) const {
  Vec3<double> point;
  for (int c = 0; c < 3; ++c) point[c] = random.uniform(low_[c], high_[c]);
  return point;
}

// Corners' weights are sixteenths, which axis-parallel faces take without rounding.
Vec3<double> CagePlaces::on_cage(std::string_view regime, RandomStream& random) const {
  const auto& face = question_.faces[static_cast<std::size_t>(random.below(static_cast<int>(question_.faces.size())))];
  int a = 1 + random.below(14), b = 1 + random.below(15 - a);
  if (regime.ends_with("edge")) b = 16 - a;
  if (regime.ends_with("vertex")) a = 16, b = 0;
  const auto corner = [&](int k) -> const Vec3<double>& {
    return question_.vertices[static_cast<std::size_t>(face[k])];
  };
  return corner(0) + a / 16. * (corner(1) - corner(0)) + b / 16. * (corner(2) - corner(0));
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

std::vector<std::string_view> cage_regimes() {
  return {"inside", "near-face", "near-edge", "near-vertex", "on-face", "on-edge", "on-vertex", "units", "offset"};
}

const std::vector<CagePlaces>& places_of(std::string_view regime) {
  static const std::map<std::string_view, std::vector<CagePlaces>> all = [] {
    std::map<std::string_view, std::vector<CagePlaces>> places;
    for (const std::string_view one : cage_regimes()) places.emplace(one, made(one));
    return places;
  }();
  return all.at(regime);
}

}  // namespace cageproof::judge
