// SPDX-License-Identifier: MIT
// The table of element sampling is true of each kind of element.
#include "element/element_sampling.h"

#include "cageproof/core/cage/embedded_cages.h"
#include "cageproof/core/input_error.h"
#include "cageproof/core/geometry/quad_geometry.h"
#include "cageproof/validation/regime.h"
#include "cageproof/validation/truth.h"
#include "checks/turn.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <set>

namespace cageproof::validation {
namespace {

using Vec = Vec3<double>;

const Formula& formula_on(ElementKind kind) { return *std::ranges::find(catalogue(), kind, &Formula::element); }

std::vector<const Regime*> regimes_of(ElementKind kind) {
  std::vector<const Regime*> found;
  for (const Regime& regime : regimes())
    if (exists_for(regime, kind)) found.push_back(&regime);
  return found;
}

std::vector<Vec3<Mp100>> wide(const std::vector<Vec>& corners) {
  std::vector<Vec3<Mp100>> found;
  found.reserve(corners.size());
  for (const Vec& v : corners) found.push_back(convert<Mp100>(v));
  return found;
}

TEST(element_regimes, are_all_of_space_and_those_of_the_plane_that_exist_there) {
  for (const ElementKind kind : {ElementKind::Triangle, ElementKind::Quad})
    EXPECT_EQ(regimes_of(kind).size(), regimes().size()) << name_of(kind);
  std::set<std::string_view> of_segments;
  for (const Regime* regime : regimes_of(ElementKind::Segment)) of_segments.insert(regime->name);
  EXPECT_EQ(of_segments,
            (std::set<std::string_view>{"generic", "near-face", "near-line", "near-vertex", "on-face", "on-vertex",
                                        "on-line", "aligned", "tiny", "far", "scaled", "offset"}));
  EXPECT_THROW(make_sample(formula_on(ElementKind::Segment), *find_regime("needle"), 1, 0), InputError);
}

TEST(element_regimes, every_maker_is_of_a_regime_that_exists) {
  for (const ElementKind kind : element_kinds)
    for (const SampleMaker& maker : sampling_of(kind).regimes) EXPECT_TRUE(find_regime(maker.regime)) << maker.regime;
}

TEST(element_regimes, samples_have_their_elements_corners_and_lie_in_its_space) {
  for (const ElementKind kind : element_kinds)
    for (const Regime* regime : regimes_of(kind))
      for (std::uint64_t i = 0; i < 60; ++i) {
        const Sample s = make_sample(formula_on(kind), *regime, 3, i);
        ASSERT_EQ(static_cast<int>(s.corners.size()), corner_count(kind));
        for (int c = dimension(kind); c < 3; ++c) {
          for (const Vec& v : s.corners) EXPECT_EQ(v[c], 0) << regime->name;
          EXPECT_EQ(s.point[c], 0) << regime->name;
        }
        if (regime->name == "tiny") continue;
        const double unit = regime->name == "scaled" ? s.parameter : 1;
        const double longest = longest_edge<double>(s.corners) / unit;
        EXPECT_GT(longest, 0.3) << name_of(kind) << ' ' << regime->name;
        EXPECT_LT(longest, regime->name == "aligned" ? 6 : 4) << name_of(kind) << ' ' << regime->name;
      }
}

TEST(element_regimes, aligned_samples_have_exact_distances_and_zeros_and_are_off_the_element) {
  for (const ElementKind kind : element_kinds) {
    const Regime& regime = *find_regime("aligned");
    int exact = 0, zeros = 0;
    for (std::uint64_t i = 0; i < 300; ++i) {
      const Sample s = make_sample(formula_on(kind), regime, 3, i);
      EXPECT_EQ(type_of(kind).contact(s.corners, s.point).contact, Contact::Off) << name_of(kind) << ' ' << i;
      bool steps = true;  // every coordinate is zero or the distance itself
      for (int c = 0; c < dimension(kind); ++c) {
        steps = steps && (s.point[c] == 0 || std::abs(s.point[c]) == s.parameter);
        zeros += s.point[c] == 0;
      }
      exact += steps;
    }
    EXPECT_GT(exact, 150) << name_of(kind);
    EXPECT_GT(zeros, 100) << name_of(kind);
  }
}

TEST(element_regimes, aligned_samples_lie_over_the_centres_of_symmetric_elements) {
  for (const ElementKind kind : element_kinds) {
    int equally_far = 0, over_centroid = 0, equilateral = 0, right = 0;
    for (std::uint64_t i = 0; i < 300; ++i) {
      const Sample s = make_sample(formula_on(kind), *find_regime("aligned"), 3, i);
      const auto corners = wide(s.corners);
      const Vec3<Mp100> point = convert<Mp100>(s.point);
      Vec3<Mp100> from_centroid = Vec3<Mp100>::Zero();
      std::set<Mp100> distances, lengths;
      bool right_angle = false;
      const std::size_t n = corners.size();
      for (std::size_t k = 0; k < n; ++k) {
        const Vec3<Mp100> to = point - corners[k], edge = corners[(k + 1) % n] - corners[k],
                          last = corners[(k + n - 1) % n] - corners[k];
        from_centroid += to;
        distances.insert(to.dot(to));
        lengths.insert(edge.dot(edge));
        right_angle = right_angle || edge.dot(last) == 0;
      }
      const Vec3<Mp100> n_of = convert<Mp100>(type_of(kind).extent(s.corners));
      const Vec3<Mp100> beside = from_centroid.cross(n_of);
      const bool over = beside == Vec3<Mp100>::Zero();
      equally_far += distances.size() == 1;
      over_centroid += over;
      equilateral += lengths.size() == 1 && (over || distances.size() == 1);
      right += right_angle && (over || distances.size() == 1);
    }
    EXPECT_GT(equally_far, 25) << name_of(kind);
    EXPECT_GT(over_centroid, 25) << name_of(kind);
    EXPECT_GT(equilateral, 12) << name_of(kind);
    if (kind != ElementKind::Segment) {
      EXPECT_GT(right, 12) << name_of(kind);
    }
  }
}

TEST(element_regimes, few_samples_see_every_kind_of_parameter_and_a_generic_one_first) {
  const Formula& kelvin = *find_formula("triangle.kelvin_displacement");
  const auto nu = [&](const Regime& regime, std::uint64_t i) {
    return make_sample(kelvin, regime, 1, i).parameters[1];
  };
  const double preset = kelvin.parameters[1].preset;
  const auto is_generic = [&](double x) { return std::isfinite(x) && x != 0 && x != 0.5 && x != preset; };
  std::set<double> seconds;
  for (const Regime& regime : regimes()) {
    EXPECT_TRUE(is_generic(nu(regime, 0))) << regime.name;
    // The second sample that the gate takes in the suite quick; on the element only this one has derivatives.
    const double second = nu(regime, 7);
    EXPECT_TRUE(!regime.name.starts_with("on-") || is_generic(second)) << regime.name;
    seconds.insert(std::isinf(second) ? HUGE_VAL : is_generic(second) ? -1 : second);
    std::array<int, 5> seen{};
    for (std::uint64_t i = 0; i < 6; ++i) {
      const double x = nu(regime, i);
      seen[0] += std::isinf(x);
      seen[1] += x == 0.5;
      seen[2] += x == 0;
      seen[3] += std::isfinite(x) && x < 0;
      seen[4] += x > 0 && is_generic(x);
    }
    EXPECT_TRUE(std::ranges::all_of(seen, [](int count) { return count > 0; })) << regime.name;
  }
  // Generic, zero, the default, incompressible, infinite.
  EXPECT_EQ(seconds, (std::set<double>{-1, 0, preset, 0.5, HUGE_VAL}));
}

// Smallest and largest numbers in a sample of the regime `tiny`.
struct Extremes {
  double size = 0;       // the element's longest edge
  double point = 0;      // the point's largest coordinate
  double nearest = 1;    // of the point's coordinates, in sizes, but zero
  double tilt = 1;       // of the corners' coordinates, in sizes, but zero
  bool slanted = false;  // across two axes at least
};

Extremes extremes_of(ElementKind kind, const Sample& s) {
  Extremes found;
  const auto largest = [](const Vec& v) { return v.cwiseAbs().maxCoeff(); };
  for (const Vec& v : s.corners) found.size = std::max({found.size, largest(v)});
  found.point = largest(s.point) / found.size;
  const auto smallest = [&](const Vec& v, double& least) {
    for (const double x : v)
      if (x != 0) least = std::min(least, std::abs(x) / found.size);
  };
  smallest(s.point, found.nearest);
  for (const Vec& v : s.corners) smallest(v, found.tilt);
  found.slanted = (type_of(kind).extent(s.corners).array() != 0).count() > 1;
  return found;
}

TEST(element_regimes, tiny_samples_are_at_all_ends_of_the_exponent_range_and_off_the_element) {
  const Regime& regime = *find_regime("tiny");
  for (const ElementKind kind : element_kinds) {
    int near = 0, denormal = 0, beside_slanted = 0, tilted = 0, small = 0, large = 0, far = 0, in_plane = 0;
    for (std::uint64_t i = 0; i < 400; ++i) {
      const Sample s = make_sample(formula_on(kind), regime, 3, i);
      EXPECT_EQ(type_of(kind).contact(s.corners, s.point).contact, Contact::Off) << name_of(kind) << ' ' << i;
      const Extremes e = extremes_of(kind, s);
      EXPECT_GE(e.size, 1e-316);
      EXPECT_LE(e.size, 1e300);
      near += e.nearest < 1e-16;
      denormal += e.nearest < 1e-308 && e.size > 0.1;
      beside_slanted += e.nearest < 1e-16 && e.slanted && e.point < 1e-16;
      tilted += e.tilt < 1e-16;
      small += e.size < 1e-99;
      large += e.size > 1e98;
      far += e.point > 1e8;
      // Exactly, as in a plane of the axes no term of the height is rounded.
      in_plane += e.nearest < 1e-16 && e.tilt > 1e-3 &&
                  sampling_of(kind).exact.height(wide(s.corners), convert<Mp100>(s.point)) == 0;
    }
    EXPECT_GT(near, 150) << name_of(kind);
    EXPECT_GT(denormal, 25) << name_of(kind);
    EXPECT_GT(beside_slanted, 25) << name_of(kind);
    for (const int count : {tilted, in_plane}) EXPECT_GT(count, 25) << name_of(kind);
    for (const int count : {small, large}) EXPECT_GT(count, 10) << name_of(kind);
    EXPECT_GT(far, 25) << name_of(kind);
  }
}

TEST(element_regimes, near_samples_lie_as_far_from_the_surface_as_they_say) {
  for (const ElementKind kind : element_kinds)
    for (const char* name : {"near-face", "near-line", "near-plane"}) {
      const Regime& regime = *find_regime(name);
      // Across an edge's line in space any direction is a sample's.
      if (!exists_for(regime, kind) || (regime.name == "near-line" && dimension(kind) == 3)) continue;
      for (std::uint64_t i = 0; i < 200; ++i) {
        const Sample s = make_sample(formula_on(kind), regime, 3, i);
        std::vector<Vec3<Mp200>> corners;
        corners.reserve(s.corners.size());
        for (const Vec& v : s.corners) corners.push_back(convert<Mp200>(v));
        const double off =
            std::abs(static_cast<double>(sampling_of(kind).exact.off_surface(corners, convert<Mp200>(s.point))));
        // A curved surface may come nearer elsewhere.
        const double slack = type_of(kind).flat ? 1e-9 : 0.5;
        EXPECT_GT(off, (1 - slack) * s.parameter - 1e-15) << name_of(kind) << ' ' << name << ' ' << i;
        EXPECT_LT(off, (1 + 1e-9) * s.parameter + 1e-14) << name_of(kind) << ' ' << name << ' ' << i;
      }
    }
}

TEST(element_regimes, on_samples_touch_or_are_one_ulp_off) {
  for (const ElementKind kind : element_kinds)
    for (const auto& [name, contact] :
         {std::pair{"on-face", Contact::Interior}, {"on-edge", Contact::Border}, {"on-vertex", Contact::Border}}) {
      const Regime& regime = *find_regime(name);
      if (!exists_for(regime, kind)) continue;
      int touching = 0, as_named = 0;
      for (std::uint64_t i = 0; i < 240; ++i) {
        const Contact found = contact_of(kind, make_sample(formula_on(kind), regime, 3, i));
        touching += found != Contact::Off;
        as_named += found == contact;
      }
      EXPECT_GT(as_named, 80) << name_of(kind) << ' ' << name;
      EXPECT_LT(touching, 220) << name_of(kind) << ' ' << name;
    }
}

// Whether a coordinate is no multiple of 2^-40.
bool has_many_bits(const Vec& v) {
  return std::ranges::any_of(std::array{v[0], v[1], v[2]},
                             [](double x) { return std::ldexp(x, 40) != std::nearbyint(std::ldexp(x, 40)); });
}

// Whether the point is exactly on the surface: for bilinear quads, to the digits of a search for the nearest point.
bool on_surface(ElementKind kind, const Sample& s) {
  std::vector<Vec3<Mp200>> corners;
  corners.reserve(s.corners.size());
  for (const Vec& v : s.corners) corners.push_back(convert<Mp200>(v));
  return abs(sampling_of(kind).exact.off_surface(corners, convert<Mp200>(s.point))) < 1e-90;
}

TEST(element_regimes, on_samples_have_many_bits_and_few_by_turns) {
  for (const ElementKind kind : element_kinds)
    for (const char* name : {"on-face", "on-edge", "on-vertex", "on-plane", "on-line"}) {
      const Regime& regime = *find_regime(name);
      if (!exists_for(regime, kind)) continue;
      int many = 0, few = 0, slanted = 0;
      for (std::uint64_t i = 0; i < 240; ++i) {
        const Sample s = make_sample(formula_on(kind), regime, 3, i);
        if (!on_surface(kind, s)) continue;
        const bool of_many = has_many_bits(s.point) && has_many_bits(s.corners[1]);
        many += of_many;
        few += !has_many_bits(s.point);
        const Vec n = type_of(kind).extent(s.corners);
        slanted += of_many && (n.array() != 0).count() > 1;
      }
      EXPECT_GT(many, 40) << name_of(kind) << ' ' << name;
      EXPECT_GT(few, 40) << name_of(kind) << ' ' << name;
      EXPECT_GT(slanted, 20) << name_of(kind) << ' ' << name;
      EXPECT_LT(slanted, many) << name_of(kind) << ' ' << name;
    }
}

// Where the point lies on the line of an edge, 0 at its start and 1 at its end; nothing where it is on none.
std::optional<double> share_of_line(const Sample& s) {
  const auto corners = wide(s.corners);
  const Vec3<Mp100> point = convert<Mp100>(s.point);
  for (std::size_t e = 0; e < corners.size(); ++e) {
    const Vec3<Mp100> edge = corners[(e + 1) % corners.size()] - corners[e], to = point - corners[e];
    const Vec3<Mp100> off = edge.cross(to);
    if (off == Vec3<Mp100>::Zero()) return static_cast<double>(Mp100(to.dot(edge) / edge.dot(edge)));
  }
  return std::nullopt;
}

TEST(element_regimes, on_line_samples_lie_before_an_edges_start_and_after_its_end) {
  for (const ElementKind kind : element_kinds) {
    int before = 0, after = 0;
    for (std::uint64_t i = 0; i < 240; ++i) {
      const auto share = share_of_line(make_sample(formula_on(kind), *find_regime("on-line"), 3, i));
      if (!share) continue;
      before += *share < 0;
      after += *share > 1;
    }
    EXPECT_GT(before, 40) << name_of(kind);
    EXPECT_GT(after, 40) << name_of(kind);
  }
}

TEST(element_shape, basis_reproduces_the_point_and_the_height_has_the_normals_sign) {
  for (const ElementKind kind : element_kinds) {
    const ElementSampling& sampling = sampling_of(kind);
    int interior = 0;
    for (std::uint64_t i = 0; i < 120; ++i) {
      const Sample s = make_sample(formula_on(kind), *find_regime("on-face"), 7, i);
      const auto corners = wide(s.corners);
      const Vec3<Mp100> point = convert<Mp100>(s.point);
      const Mp100 off = sampling.exact.height(corners, point);
      if (contact_of(kind, s) != Contact::Interior) continue;
      ++interior;
      EXPECT_LT(abs(off), 1e-80) << name_of(kind) << ' ' << i;
      const auto basis = sampling.exact.basis(s.corners, s.point);
      Vec3<Mp100> at = -point;
      Mp100 sum = -1;
      for (std::size_t k = 0; k < corners.size(); ++k) at += basis[k] * corners[k], sum += basis[k];
      EXPECT_LT(abs(sum), 1e-80);
      EXPECT_LT(at.dot(at), 1e-160) << name_of(kind) << ' ' << i;
      const Vec3<Mp100> n = sampling.exact.normal(corners, basis);
      const Vec3<Mp100> outside = point + Mp100("1e-40") * n, inside = point - Mp100("1e-40") * n;
      EXPECT_GT(sampling.exact.height(corners, outside), 0) << name_of(kind) << ' ' << i;
      EXPECT_LT(sampling.exact.height(corners, inside), 0) << name_of(kind) << ' ' << i;
      // The table of core says which side is outside.
      const Vec expected =
          type_of(kind).normal(s.corners, type_of(kind).contact(s.corners, s.point).basis).normalized();
      const Vec found = convert<double>(n).normalized();
      EXPECT_NEAR(found.dot(expected), 1, 1e-12);
    }
    EXPECT_GT(interior, 50) << name_of(kind);
  }
}

TEST(element_shape, feet_lie_on_the_surface_at_right_angles) {
  for (const ElementKind kind : element_kinds) {
    const ElementSampling& sampling = sampling_of(kind);
    for (std::uint64_t i = 0; i < 100; ++i) {
      const Sample s = make_sample(formula_on(kind), *find_regime("near-face"), 5, 16 * i);  // a tenth away
      const Vec foot = sampling.search.foot(s.corners, s.point);
      EXPECT_LT(abs(sampling.exact.height(wide(s.corners), convert<Mp100>(foot))), 1e-14) << name_of(kind) << ' ' << i;
      EXPECT_LT((s.point - foot).norm(), 0.1 + 1e-9) << name_of(kind) << ' ' << i;
    }
  }
}

TEST(element_locator, surface_points_lie_on_the_element_and_their_normals_point_out) {
  for (const ElementKind kind : element_kinds) {
    const LocatorShape& locator = sampling_of(kind).locator;
    for (std::uint64_t i = 0; i < 60; ++i) {
      const Sample s = make_sample(formula_on(kind), *find_regime("generic"), 5, i);
      RandomStream random(4, "surface", i);
      const double a = random.uniform(), b = random.uniform();
      const SurfacePoint on = locator.surface_point(s.corners, a, b);
      EXPECT_LT(locator.distance(s.corners, on.point, HUGE_VAL), 1e-14) << name_of(kind) << ' ' << i;
      for (const double height : {1e-3, -1e-3}) {
        const Vec off = on.point + height * on.normal;
        EXPECT_EQ(sampling_of(kind).exact.height(wide(s.corners), convert<Mp100>(off)) > 0, height > 0);
        EXPECT_NEAR(locator.distance(s.corners, off, HUGE_VAL), 1e-3, 1.1e-6) << name_of(kind) << ' ' << i;
      }
    }
  }
}

TEST(element_locator, square_is_where_it_is) {
  const Cage square = embedded_cage("square");
  const CageLocator locator(square, Triangulation::Shortest);
  ASSERT_EQ(locator.patches(), 4);
  int inside = 0;
  for (const CagePoint& p : points_off(square, locator, 5, 600)) {
    EXPECT_EQ(p.point[2], 0);
    const double dx = std::max(-p.point[0], p.point[0] - 1), dy = std::max(-p.point[1], p.point[1] - 1);
    const double expected = dx <= 0 || dy <= 0 ? std::abs(std::max(dx, dy)) : std::hypot(dx, dy);
    EXPECT_NEAR(locator.distance(p.point), expected, 1e-14);
    if (p.place == Place::TooClose) continue;
    EXPECT_EQ(p.place == Place::Inside, dx < 0 && dy < 0) << p.point.transpose();
    inside += p.place == Place::Inside;
  }
  EXPECT_GT(inside, 100);
}

TEST(element_turn, keeps_the_plane_and_turns_tensors_back) {
  const Turn turn(2);
  const Vec v(3, 5, 0), w(-2, 7, 0);
  EXPECT_EQ(turn(v)[2], 0);
  EXPECT_EQ(turn(v).dot(turn(w)), v.dot(w));
  EXPECT_NE(turn(v), v);
  for (const int dim : {2, 3}) {
    const Turn t(dim);
    std::vector<double> turned;
    const Vec a = t(v), b = t(w);
    for (int i = 0; i < dim; ++i)
      for (int j = 0; j < dim; ++j) turned.push_back(a[i] * b[j]);
    const auto plain = t.undo(turned, 2);
    for (int i = 0; i < dim; ++i)
      for (int j = 0; j < dim; ++j) EXPECT_EQ(plain[dim * i + j], v[i] * w[j]) << dim << ' ' << i << ' ' << j;
  }
}

}  // namespace
}  // namespace cageproof::validation
