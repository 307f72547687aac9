// SPDX-License-Identifier: MIT
#include "cage_regimes.h"

#include "cageproof/core/geometry/box.h"
#include "cageproof/core/numbers/random_stream.h"
#include "element/element_sampling.h"
#include "run/fingerprint.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>

namespace cageproof::validation {
namespace {

using Vec = Vec3<double>;

// An edge that elements share, and an element that it belongs to.
struct Edge {
  int from, to;
  std::size_t element;
  bool flat = false;  ///< whether the elements that share it lie in one plane
};

std::vector<Edge> edges_of(const CageElements& elements) {
  std::vector<Edge> edges;
  std::map<std::pair<int, int>, std::size_t> seen;
  for (std::size_t e = 0; e < elements.count(); ++e) {
    const auto vertices = elements.vertices_of(e);
    // In the plane an element is an edge itself.
    const int count = elements.dimension() == 2 ? 1 : sampling_of(elements.type(e).kind).border_edges;
    for (int i = 0; i < count; ++i) {
      const int from = vertices[i], to = vertices[(i + 1) % vertices.size()];
      const auto [at, fresh] = seen.try_emplace(std::minmax(from, to), edges.size());
      if (fresh) edges.push_back({from, to, e});
      else edges[at->second].flat = elements.normals()[e].dot(elements.normals()[edges[at->second].element]) > 1 - 1e-9;
    }
  }
  return edges;
}

// Input from which sample `turn` of a place is drawn.
struct Draw {
  const CageElements& elements;
  const std::vector<Edge>& edges;
  const CageLocator& locator;
  const std::vector<CagePoint>&off, &on;  // in the cage's own frame
  Vec low, high;
  double size;
  int turn;
  RandomStream& random;

  template <class T>
  const T& one_of(const std::vector<T>& items) const {
    return items[random.below(static_cast<int>(items.size()))];
  }
  const Vec& vertex(int v) const { return elements.vertices()[v]; }
  // The steps of a sweep in turn, by a stride that no sweep's length divides.
  int step(int steps) const { return 7 * turn % steps; }
  Vec direction() const {
    Vec d = Vec::Zero();
    do
      for (int c = 0; c < elements.dimension(); ++c) d[c] = random.uniform(-1, 1);
    while (!(d.norm() > 0.1 && d.norm() < 1));
    return d.normalized();
  }
  // Somewhere in the box half as large again.
  const CagePoint& anywhere() const { return one_of(off); }
};

// A point as far off its foot as the turn's step of the sweep says. Only next to the origin can a double be 1e-16 sizes
// away: half of the cages are moved so that the foot is there.
void put_beside(const Draw& draw, const Vec& foot, const Vec& direction, CageSample& sample) {
  constexpr int decades = 16;
  const int step = draw.step(decades + 1);
  if (draw.turn % 2 == 1) sample.frame.shift = -foot;
  const Vec at = foot + sample.frame.shift;
  if (step < decades) {
    sample.parameter = std::pow(10.0, -1 - step);
    sample.point = at + sample.parameter * draw.size * direction;
    return;
  }
  sample.point = at;
  // The unit of the cage's frame, also where the foot is the origin; of all coordinates, so that the point is off faces
  // that are at right angles to axes.
  const double ulp = std::ldexp(draw.size, -53);
  for (int c = 0; c < draw.elements.dimension(); ++c) {
    const double towards = draw.random.uniform() < 0.5 ? -1 : 1;
    double& x = sample.point[c];
    x = x == 0 ? towards * ulp : std::nextafter(x, towards * 2 * (std::abs(x) + draw.size));
  }
}

bool near_face(const Draw& draw, CageSample& sample) {
  const SurfacePoint foot = draw.locator.surface_point(draw.random.below(draw.locator.patches()), draw.random.uniform(),
                                                       draw.random.uniform());
  put_beside(draw, foot.point, (draw.turn / 2 % 2 == 0 ? 1 : -1) * foot.normal, sample);
  return true;
}

// Where faces are split, the terms of both halves are large next to the edge and their sums are not: such edges, where
// there are any, take every second turn. Around the edge in any direction, along a face of it, and at right angles to
// that.
bool near_edge(const Draw& draw, CageSample& sample) {
  if (draw.elements.dimension() == 2) return false;  // near_face
  std::vector<Edge> flat;
  if (draw.turn % 4 < 2) std::ranges::copy_if(draw.edges, std::back_inserter(flat), &Edge::flat);
  const Edge& edge = draw.one_of(flat.empty() ? draw.edges : flat);
  const Vec along = draw.vertex(edge.to) - draw.vertex(edge.from);
  const Vec foot = draw.vertex(edge.from) + draw.random.uniform(0.1, 0.9) * along;
  const Vec normal = draw.elements.normals()[edge.element];
  const double side = draw.random.uniform() < 0.5 ? -1 : 1;
  Vec direction = draw.turn % 3 == 0                 ? Vec(side * normal)
                  : draw.turn % 3 == 1 && !edge.flat ? Vec(side * normal.cross(along))
                                                     : Vec(draw.direction());
  direction -= direction.dot(along) / along.squaredNorm() * along;
  put_beside(draw, foot, direction.stableNormalized(), sample);
  return true;
}

bool near_vertex(const Draw& draw, CageSample& sample) {
  put_beside(draw, draw.one_of(draw.elements.vertices()), draw.direction(), sample);
  return true;
}

bool on_place(const Draw& draw, Place place, CageSample& sample) {
  std::vector<CagePoint> here;
  std::ranges::copy_if(draw.on, std::back_inserter(here), [&](const CagePoint& p) { return p.place == place; });
  if (here.empty()) return false;
  sample.point = draw.one_of(here).point;
  return true;
}

bool on_face(const Draw& draw, CageSample& sample) { return on_place(draw, Place::OnFace, sample); }
bool on_edge(const Draw& draw, CageSample& sample) { return on_place(draw, Place::OnEdge, sample); }
bool on_vertex(const Draw& draw, CageSample& sample) { return on_place(draw, Place::OnVertex, sample); }

bool off_place(const Draw& draw, Place place, CageSample& sample) {
  std::vector<CagePoint> here;
  std::ranges::copy_if(draw.off, std::back_inserter(here), [&](const CagePoint& p) { return p.place == place; });
  if (here.empty()) return false;
  sample.point = here[draw.turn % here.size()].point;
  return true;
}

bool inside(const Draw& draw, CageSample& sample) { return off_place(draw, Place::Inside, sample); }
bool outside(const Draw& draw, CageSample& sample) { return off_place(draw, Place::Outside, sample); }

// On an edge's line beyond its ends, in a face's plane beyond its border, and on a grid of halves of a power of two.
bool aligned(const Draw& draw, CageSample& sample) {
  constexpr std::array beyond{-1.0, -0.5, 1.5, 2.0};
  const Edge& edge = draw.one_of(draw.edges);
  const Vec from = draw.vertex(edge.from), along = draw.vertex(edge.to) - from;
  if (draw.turn % 3 == 2) {
    const double unit = std::exp2(std::ilogb(draw.size));
    for (int c = 0; c < draw.elements.dimension(); ++c) sample.point[c] = unit / 2 * (draw.random.below(9) - 4);
    return true;
  }
  sample.point = from + beyond[draw.random.below(4)] * along;
  if (draw.turn % 3 == 0) return true;
  for (const int v : draw.elements.vertices_of(edge.element))
    if (v != edge.from && v != edge.to) {
      sample.point += beyond[draw.random.below(4)] * (draw.vertex(v) - from);
      break;
    }
  return true;
}

bool far(const Draw& draw, CageSample& sample) {
  sample.parameter = std::pow(10.0, 1 + draw.step(8));
  sample.point = (draw.low + draw.high) / 2 + sample.parameter * draw.size * draw.direction();
  return true;
}

bool offset(const Draw& draw, CageSample& sample) {
  sample.parameter = std::pow(10.0, 3 + draw.step(6));
  sample.frame.shift = sample.parameter * draw.size * draw.direction();
  sample.point = draw.anywhere().point + sample.frame.shift;
  return true;
}

bool scaled(const Draw& draw, CageSample& sample) {
  sample.parameter = std::pow(10.0, -100 + 20 * draw.step(11));
  sample.frame.unit = sample.parameter;
  sample.point = sample.parameter * draw.anywhere().point;
  return true;
}

struct PlaceMaker {
  std::string_view name;
  bool (*make)(const Draw& draw, CageSample& sample);
};

constexpr std::array place_makers{PlaceMaker{"near-edge", near_edge},     PlaceMaker{"near-face", near_face},
                                  PlaceMaker{"near-vertex", near_vertex}, PlaceMaker{"on-face", on_face},
                                  PlaceMaker{"on-edge", on_edge},         PlaceMaker{"on-vertex", on_vertex},
                                  PlaceMaker{"inside", inside},           PlaceMaker{"outside", outside},
                                  PlaceMaker{"aligned", aligned},         PlaceMaker{"far", far},
                                  PlaceMaker{"offset", offset},           PlaceMaker{"scaled", scaled}};

constexpr int kInside = 6;
static_assert(place_makers[kInside].name == "inside");

// Which place sample i has: each once, then those with sweeps more often.
constexpr std::array<int, 24> schedule{0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 0, 1, 2, 0, 1, 9, 0, 1, 2, 8, 0, 10};

// Where a cage begins in a sweep, so that cages that are asked for few samples are asked for different ones.
int first_turn(std::string_view stream, int place) {
  RandomStream random(0, stream, static_cast<std::uint64_t>(place));
  return random.below(1000);
}

}  // namespace

Cage framed(const Cage& cage, const CageFrame& frame) {
  if (frame.is_own()) return cage;
  std::vector<Vec> vertices = cage.vertices();
  for (Vec& v : vertices) v = frame.unit * Vec(v + frame.shift);
  return cage.with(std::move(vertices), cage.faces());
}

std::vector<std::string_view> cage_places() {
  std::vector<std::string_view> names;
  names.reserve(place_makers.size());
  for (const PlaceMaker& place : place_makers) names.push_back(place.name);
  return names;
}

std::vector<CageSample> cage_samples(const CageCoordinates& coordinates, const Cage& cage, const CageLocator& locator,
                                     std::uint64_t seed, int count) {
  const CageElements& elements = coordinates.elements();
  const std::vector<Edge> edges = edges_of(elements);
  const std::vector<CagePoint> off = points_off(cage, locator, seed, std::max(64, count));
  std::vector<CagePoint> on = points_on(coordinates, cage);
  std::erase_if(on, [&](const CagePoint& p) { return !p.exact || elements.touching(p.point).empty(); });
  const auto [low, high] = box_of(elements.vertices());
  const std::string stream = fmt::format("cage regimes/{}", drawn_by(cage));
  std::array<int, place_makers.size()> turns{};
  for (std::size_t p = 0; p < place_makers.size(); ++p) turns[p] = first_turn(stream, static_cast<int>(p));
  // Cages that are asked for few samples are asked for other places of other kinds, except that all are asked inside.
  const auto begin =
      static_cast<std::size_t>(RandomStream(0, fmt::format("{}/{}", stream, coordinates.kind().name), 0).below(12));
  std::vector<CageSample> samples;
  samples.reserve(count);
  for (int i = 0; i < count; ++i) {
    const auto turn = static_cast<std::size_t>(i);
    const bool few = static_cast<std::size_t>(count) < place_makers.size();
    const int place = few && turn == 0             ? kInside
                      : turn < place_makers.size() ? static_cast<int>((turn + begin) % place_makers.size())
                                                   : schedule[turn % schedule.size()];
    RandomStream random(seed, fmt::format("{}/{}", stream, place_makers[place].name), i);
    CageSample sample{.place = place_makers[place].name, .index = static_cast<std::uint64_t>(i)};
    const Draw draw{elements, edges, locator, off, on, low, high, cage.size(), turns[place]++, random};
    if (place_makers[place].make(draw, sample)) samples.push_back(sample);
  }
  return samples;
}

}  // namespace cageproof::validation
