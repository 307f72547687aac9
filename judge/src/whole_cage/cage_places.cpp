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

CageRequest question_of(std::string_view embedded, const Placing& placing) {
  const CageElements elements(embedded_cage(embedded), placing.keeps_quads, Triangulation::Shortest);
  const Vec3<double> x(1, 0.25, 0.5), y(0.5, 1, 0.25), z(-0.25, 0.5, 1);
  CageRequest question;
  question.dimension = elements.dimension();
  for (const Vec3<double>& vertex : elements.vertices()) {
    const Vec3<double> placed = placing.is_sheared ? Vec3<double>(x.dot(vertex), y.dot(vertex), z.dot(vertex)) : vertex;
    question.vertices.emplace_back((placed + placing.offset) * placing.unit);
    if (question.dimension == 2) question.vertices.back()[2] = 0;
  }
  question.faces = elements.all();
  return question;
}

using Names = std::initializer_list<std::string_view>;

// The cages that a regime takes: on those along the axes doubles lie exactly, in other units and places one cage does.
std::vector<CagePlaces> made(std::string_view regime, const Names& along_axes, std::string_view one, const Names& all,
                             bool keeps_quads) {
  std::vector<CagePlaces> places;
  const Placing origin{.keeps_quads = keeps_quads};
  if (regime == "units") {
    for (const double unit : {0x1p-30, 0x1p30, 0x1p-10, 0x1p10})
      places.emplace_back(one, Placing{.unit = unit, .keeps_quads = keeps_quads});
  } else if (regime == "offset") {
    for (const double far : {1e2, 1e4})
      places.emplace_back(one, Placing{.offset = Vec3<double>(far, -far, far), .keeps_quads = keeps_quads});
  } else {
    for (const std::string_view name : regime.starts_with("on-") ? along_axes : all) places.emplace_back(name, origin);
  }
  return places;
}

std::vector<CagePlaces> made_in_space(std::string_view regime, bool keeps_quads) {
  return made(regime, {"cube", "l-block", "thin-box"}, keeps_quads ? "spiky-box" : "icosphere",
              {"cube", "icosphere", "l-block", "thin-box", "spiky-box"}, keeps_quads);
}

std::vector<CagePlaces> made_in_plane(std::string_view regime) {
  return made(regime, {"square", "l-shape", "comb", "frame"}, "star",
              {"square", "l-shape", "star", "comb", "thin-bar", "frame", "figure"}, false);
}

}  // namespace

CagePlaces::CagePlaces(std::string_view embedded, const Placing& placing)
    : CagePlaces(question_of(embedded, placing), placing.keeps_quads) {}

CagePlaces::CagePlaces(CageRequest cage, bool keeps_quads)
    : question_(std::move(cage)),
      winding_(std::make_shared<WindingNumbers>(CageElements(question_.cage(), keeps_quads, Triangulation::Shortest))),
      box_(box_of(question_.vertices)) {}

int CagePlaces::side_of(const Vec3<double>& point) const {
  const std::optional<int> winding = winding_->around(point);
  if (!winding) return 0;
  return *winding != 0 ? 1 : -1;
}

Vec3<double> CagePlaces::anywhere(RandomStream& random) const {
  Vec3<double> point = Vec3<double>::Zero();
  for (int c = 0; c < question_.dimension; ++c) point[c] = random.uniform(box_.low[c], box_.high[c]);
  return point;
}

// Corners' weights are sixteenths, which axis-parallel faces take without rounding.
Vec3<double> CagePlaces::on_cage(std::string_view regime, RandomStream& random) const {
  const auto& face =
      question_.faces[static_cast<std::size_t>(random.below(static_cast<int>(question_.faces.size())))].vertices;
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

Vec3<double> CagePlaces::point_on_any_side(std::string_view regime, std::uint64_t seed, std::uint64_t index) const {
  RandomStream random(seed, "side " + std::string(regime), index);
  if (regime.starts_with("on-")) return on_cage(regime, random);
  const Vec3<double> middle = (box_.low + box_.high) / 2, somewhere = anywhere(random);
  if (regime == "far") return middle + std::pow(10, random.uniform(1, 8)) * (somewhere - middle);
  // Beside the cage as often as in its box.
  if (!regime.starts_with("near-")) return middle + 1.5 * (somewhere - middle);
  const Vec3<double> from = on_cage(regime, random);
  return from + std::pow(10, random.uniform(-16, -1)) * (somewhere - from);
}

std::vector<std::string_view> cage_regimes(int dimension) {
  if (dimension == 2) return {"inside", "near-edge", "near-vertex", "on-edge", "on-vertex", "units", "offset"};
  return {"inside", "near-face", "near-edge", "near-vertex", "on-face", "on-edge", "on-vertex", "units", "offset"};
}

const std::vector<CagePlaces>& places_of(std::string_view regime, int dimension, bool keeps_quads) {
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
  if (keeps_quads) {
    static const All of_quads = of(3, [](std::string_view one) { return made_in_space(one, true); });
    return of_quads.at(regime);
  }
  static const All in_space = of(3, [](std::string_view one) { return made_in_space(one, false); });
  return in_space.at(regime);
}

}  // namespace cageproof::judge
