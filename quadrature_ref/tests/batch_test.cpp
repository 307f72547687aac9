// SPDX-License-Identifier: MIT
// Blocks of points give the same bits as single points, are added to the caller's arrays, and take no memory of their
// own.
#include "support.h"

#include <atomic>
#include <cstdlib>
#include <new>

namespace {

std::atomic<long> allocations = 0;

}  // namespace

// Not inlined: GCC would then see malloc's memory go to delete, and warn.
[[gnu::noinline]] void* operator new(std::size_t size) {
  ++allocations;
  if (void* const memory = std::malloc(size)) return memory;
  throw std::bad_alloc();
}
[[gnu::noinline]] void operator delete(void* memory) noexcept { std::free(memory); }
[[gnu::noinline]] void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }

namespace cageproof::quadrature_ref {
namespace {

struct Rule {
  const char* formula;
  const char* name;
};
const std::vector<Rule> kFixed{{"triangle.single_layer", "gauss-8"},
                               {"triangle.double_layer", "three-quad-75"},
                               {"triangle.mean_value", "near-singular-16"},
                               {"triangle.affine_single_layer", "near-singular-8"},
                               {"quad.mean_value", "gauss-8"},
                               {"segment.single_layer", "gauss-8"},
                               {"segment.single_layer", "near-singular-16"}};

std::vector<Vec3<double>> corners_of(ElementKind kind) {
  std::vector<Vec3<double>> corners{{0, 0, 0}, {1, .125, 0}, {1.125, 1, 0}, {-.125, .75, 0}};
  corners.resize(corner_count(kind));
  if (kind == ElementKind::Quad) corners[2][2] = .5;
  return corners;
}

// Near, far, on the element and in its plane.
std::vector<Vec3<double>> points_of(ElementKind kind, std::size_t count) {
  RandomStream random(3, "quadrature-blocks", 0);
  std::vector<Vec3<double>> points{{.5, .0625, 0}, {4, -1, 0}};
  while (points.size() < count) {
    const double size = std::pow(10., random.uniform(-6, 4));
    points.emplace_back(.5 + size * random.uniform(-1, 1), .1 + size * random.uniform(-1, 1),
                        size * random.uniform(-1, 1));
    if (dimension(kind) == 2) points.back()[2] = 0;
  }
  return points;
}

/// A block's tensors, each order's one point after the other, with `gap` numbers between points.
struct Block {
  std::array<std::vector<double>, 3> tensors;
  std::vector<Statement> statements;
  BatchOutput<double> output;

  Block(const Formula& formula, std::size_t points, int order, double fill) : statements(points) {
    constexpr std::size_t gap = 3;
    output = {.entries = static_cast<std::size_t>(formula.shape.entries()),
              .dim = formula.dim(),
              .statements = statements.data()};
    for (int o = 0; o <= order; ++o) {
      output.stride[o] = formula.components() * derivative_count(formula.dim(), o) + gap;
      tensors[o].assign(points * output.stride[o], fill);
      output.tensors[o] = tensors[o].data();
    }
  }
};

// Bits, so that NaN equals itself.
bool same(double a, double b) { return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b); }

TEST(Batch, gives_the_bits_of_single_points) {
  for (const auto& [name, rule] : kFixed) {
    const Formula& formula = *find_formula(name);
    const Evaluation evaluation = evaluation_named(name, rule);
    const auto corners = corners_of(formula.element);
    const auto points = points_of(formula.element, 40);
    for (int order = 0; order <= 2; ++order) {
      Block block(formula, points.size(), order, -7);
      evaluation(Batch<double>{corners, points, order}, block.output);
      for (std::size_t p = 0; p < points.size(); ++p) {
        Result<double> single;
        evaluation(Query<double>{corners, points[p], order}, single);
        EXPECT_EQ(block.statements[p].nodes, single.nodes) << rule;
        for (int o = 0; o <= order; ++o) {
          const double* const first = block.tensors[o].data() + p * block.output.stride[o];
          for (std::size_t i = 0; i < single.of(o).size(); ++i)
            EXPECT_TRUE(same(first[i], single.of(o)[i])) << name << ' ' << rule << ' ' << p;
          EXPECT_EQ(first[single.of(o).size()], -7) << "written beyond its place";
        }
      }
    }
  }
}

// Rules that choose their nodes for each point know no blocks of their own.
TEST(Batch, of_rules_for_one_point_is_point_by_point) {
  for (const auto& [name, rule] : {Rule{"triangle.double_layer", "adaptive"},
                                   {"triangle.double_layer", "multiprecision"},
                                   {"quad.mean_value", "adaptive"},
                                   {"segment.single_layer", "adaptive"}}) {
    const Formula& formula = *find_formula(name);
    const Evaluation evaluation = evaluation_named(name, rule);
    const auto corners = corners_of(formula.element);
    const std::vector<Vec3<double>> points{{.5, -.25, 0}, {2, 1, 0}};
    Block block(formula, points.size(), 1, 0);
    evaluation(Batch<double>{corners, points, 1}, block.output);
    for (std::size_t p = 0; p < points.size(); ++p) {
      Result<double> single;
      evaluation(Query<double>{corners, points[p], 1}, single);
      for (int o = 0; o <= 1; ++o)
        for (std::size_t i = 0; i < single.of(o).size(); ++i)
          EXPECT_TRUE(same(block.tensors[o][p * block.output.stride[o] + i], single.of(o)[i])) << name << ' ' << rule;
    }
  }
}

TEST(Batch, adds_where_slots_say) {
  const Formula& formula = *find_formula("triangle.double_layer");
  const Evaluation evaluation = evaluation_named(formula.name, "gauss-4");
  const auto corners = corners_of(formula.element);
  const std::vector<Vec3<double>> points{{.3, .2, .5}};
  Result<double> single;
  evaluation(Query<double>{corners, points[0], 1}, single);
  std::vector<double> values(5, 1), gradients(15, 1);
  const std::array<int, 3> slots{4, 0, 2};
  evaluation(Batch<double>{corners, points, 1},
             BatchOutput<double>{.tensors = {values.data(), gradients.data()}, .slots = slots, .add = true});
  for (int k = 0; k < 3; ++k) {
    EXPECT_EQ(values[slots[k]], 1 + single.value[k]);
    for (int i = 0; i < 3; ++i) EXPECT_EQ(gradients[3 * slots[k] + i], 1 + single.gradient[3 * k + i]);
  }
  EXPECT_EQ(values[1], 1);
}

TEST(Batch, points_ask_for_no_memory) {
  for (const auto& [name, rule] : kFixed) {
    const Formula& formula = *find_formula(name);
    const Evaluation evaluation = evaluation_named(name, rule);
    const auto corners = corners_of(formula.element);
    const auto points = points_of(formula.element, 200);
    Block block(formula, points.size(), 2, 0);
    const auto spent = [&](std::size_t count) {
      const long before = allocations;
      evaluation(Batch<double>{corners, std::span(points).first(count), 2}, block.output);
      return allocations - before;
    };
    spent(200);  // buffers grow, tables are computed
    const long few = spent(1), many = spent(200);
    EXPECT_EQ(few, many) << name << ' ' << rule;
    EXPECT_LE(many, 8) << name << ' ' << rule << ": what a block needs";
  }
}

}  // namespace
}  // namespace cageproof::quadrature_ref
