// SPDX-License-Identifier: MIT
// A program of someone who has only the installed library. It checks that coordinates sum to one, reproduce points from
// vertices and normals, have the identity's derivatives, and scale with poses.
#include <cageproof/cageproof.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <string>

using namespace cageproof::library;

namespace {

int failures = 0;

void expect(bool holds, const char* what) {
  if (holds) return;
  std::printf("FAILED: %s\n", what);
  ++failures;
}

const std::vector<double> points{0.1, 0.2, 0.3, -0.2, 0.1, 0, 0.45, -0.4, 0.3};

// Largest distance of what values and gradients reproduce from the points, and from the derivatives of the identity.
double off_identity(const Cage& cage, const Coordinates& c, double expected_sum) {
  const std::size_t count = points.size() / 3, row = c.row(), d = 3;
  std::vector<double> values(count * row), gradients(count * c.row(1));
  c.evaluate(points, values, gradients);
  double worst = 0;
  for (std::size_t p = 0; p < count; ++p) {
    double sum = 0, at[3]{}, jacobian[3][3]{};
    for (const Block& block : c.blocks())
      for (std::size_t i = 0; i < block.count; ++i) {
        const bool vertex = block.reproduces == "vertices";
        if (!vertex && block.reproduces != "normals") continue;
        const double* data = vertex ? &cage.vertices[i * d] : c.elements()[i].normal.data();
        const double factor = vertex ? 1 : block.normal_factor, value = values[p * row + block.offset + i];
        if (vertex) sum += value;
        for (std::size_t k = 0; k < d; ++k) {
          at[k] += factor * value * data[k];
          for (std::size_t axis = 0; axis < d; ++axis)
            jacobian[k][axis] += factor * gradients[(p * row + block.offset + i) * d + axis] * data[k];
        }
      }
    worst = std::max(worst, std::abs(sum - expected_sum));
    for (std::size_t k = 0; k < d; ++k) {
      worst = std::max(worst, std::abs(at[k] - points[p * d + k]));
      for (std::size_t axis = 0; axis < d; ++axis) worst = std::max(worst, std::abs(jacobian[k][axis] - (k == axis)));
    }
  }
  return worst;
}

template <class F>
bool refuses(const char* word, F&& act) {
  try {
    act();
  } catch (const cageproof::InputError& error) {
    if (std::string(error.what()).find(word) != std::string::npos) return true;
    std::printf("%s\n", error.what());
  }
  return false;
}

}  // namespace

int main(int, char** argv) {
  const Cage cube = embedded_cage("cube"), bar = embedded_cage("twisted-bar");
  // Kinds of every room in the library, so that no room that adds itself at the program's start is lost in linking.
  for (const char* kind : {"green", "biharmonic", "biharmonic_affine", "mean_value", "quad_mean_value",
                           "regularised_1_3", "spherical_mean_value"}) {
    const Coordinates c(cube, kind);
    // Each affine psi belongs to a corner, not an element.
    if (kind == std::string("biharmonic_affine")) expect(c.blocks()[1].one_a == "corner", "one a corner");
    else expect(off_identity(cube, c, 1) < 1e-12, kind);
  }
  // Kinds that keep quads have one coordinate per corner of each, along the bilinear surface's normals there.
  const Coordinates kept(bar, "quad_green");
  const std::vector<double> within{0.1, 0.05, 0.2};
  std::vector<double> kept_values(kept.row());
  kept.evaluate(within, kept_values);
  expect(kept.blocks()[1].one_a == "normal", "one a normal");
  double at[3] = {0, 0, 0};
  for (std::size_t v = 0; v < bar.vertices.size(); ++v) at[v % 3] += kept_values[v / 3] * bar.vertices[v];
  std::size_t column = kept.blocks()[1].offset;
  for (const Element& element : kept.elements())
    for (const std::vector<double>& normal : element.normals) {
      for (std::size_t i = 0; i < 3; ++i) at[i] += kept_values[column] * normal[i];
      ++column;
    }
  expect(column == kept_values.size(), "a normal for each");
  for (std::size_t i = 0; i < 3; ++i) expect(std::abs(at[i] - within[i]) < 1e-14, "quads that are kept");
  expect(Coordinates(cube, "green").evaluation() == "batched", "batched evaluation is kept");
  expect(Coordinates(cube, "green").elements().size() == 12, "quads are split");
  expect(Coordinates(bar, "somigliana", {.parameters = {{"nu", "0.3"}}}).blocks()[0].columns == 3, "matrices");
  // Faces of five corners, cut in triangles, which is said.
  const std::string prism_file = std::string(argv[0]) + ".obj";
  std::ofstream(prism_file) << "v 2 0 -1\nv 1 2 -1\nv -1 2 -1\nv -2 0 -1\nv 0 -2 -1\n"
                               "v 2 0 1\nv 1 2 1\nv -1 2 1\nv -2 0 1\nv 0 -2 1\nf 5 4 3 2 1\nf 6 7 8 9 10\n"
                               "f 1 2 7 6\nf 2 3 8 7\nf 3 4 9 8\nf 4 5 10 9\nf 5 1 6 10\n";
  const Cage prism = read_obj(prism_file);
  expect(prism.warnings.size() == 1 && prism.faces.size() == 11, "faces of five corners");
  expect(off_identity(prism, Coordinates(prism, "green"), 1) < 1e-12, "a prism");
  const Cage square{{0, 0, 1, 0, 1, 1, 0, 1}, {{0, 1}, {1, 2}, {2, 3}, {3, 0}}, 2};
  std::vector<double> values(8);
  Coordinates(square, "harmonic", {.parameters = {{"pieces", "4"}}})
      .evaluate(std::vector<double>{0.5, 0.5}, std::span(values).first(4));
  expect(std::abs(values[0] - 0.25) < 1e-12, "harmonic coordinates of a square's centre");

  // Sums with data equal those of coordinates; here the data are the vertices' own first coordinates.
  const Coordinates mean(cube, "mean_value");
  std::vector<double> data, sums(3);
  for (std::size_t v = 0; v < 8; ++v) data.push_back(cube.vertices[3 * v]);
  mean.apply(points, data, 1, sums);
  for (std::size_t p = 0; p < 3; ++p) expect(std::abs(sums[p] - points[3 * p]) < 1e-14, "apply");

  // A pose twice as large, by a method that keeps similarities; outside there is no image.
  Deformer green(cube, "green");
  std::vector<double> twice = cube.vertices, images(9), jacobians(27), outside{3, 0, 0};
  for (double& x : twice) x *= 2;
  expect(refuses("pose", [&] { green.images(points, images); }), "images before a pose");
  green.pose(twice);
  green.images(points, images, jacobians);
  for (std::size_t i = 0; i < 9; ++i) expect(std::abs(images[i] - 2 * points[i]) < 1e-14, "twice as large");
  expect(std::abs(jacobians[0] - 2) < 1e-13 && std::abs(jacobians[1]) < 1e-13, "Jacobians");
  green.images(outside, std::span(images).first(3));
  expect(std::isnan(images[0]), "no image outside");

  Deformer some(cube, "green", {.digits = 6});
  some.pose(twice);
  std::vector<double> some_images(9);
  some.images(points, some_images);
  for (std::size_t i = 0; i < 9; ++i)
    expect(std::abs(some_images[i] - 2 * points[i]) < 1e-14, "few faces have all digits");
  some.images(outside, std::span(some_images).first(3));
  expect(std::isnan(some_images[0]), "no image outside to some digits");
  expect(refuses("Jacobians", [&] { some.images(points, images, jacobians); }), "Jacobians to some digits");
  expect(refuses("green", [&] { Deformer(cube, "somigliana", {.digits = 6}); }), "digits of another method");
  expect(refuses("13", [&] { Deformer(cube, "green", {.digits = 13}); }), "too many digits");

  // Bound once, posed often: the same numbers.
  for (const char* method : {"green", "somigliana", "mean_value"}) {
    Deformer deformer(cube, method);
    std::vector<double> asked(12), again(12), asked_jacobians(36), again_jacobians(36), four = points;
    four.insert(four.end(), outside.begin(), outside.end());
    const BoundPoints bound = deformer.bind(four, true), places = deformer.bind(four);
    expect(bound.size() == 4 && bound.has_jacobians() && !places.has_jacobians(), "what was bound");
    for (const double factor : {1.0, 0.5, -0.25}) {
      std::vector<double> pose = twice;
      pose[0] *= factor;
      deformer.pose(pose);
      deformer.images(four, asked, asked_jacobians);
      deformer.images(bound, again, again_jacobians);
      const auto same = [](double x, double y) { return x == y || (std::isnan(x) && std::isnan(y)); };
      expect(std::ranges::equal(asked, again, same), "images of bound points");
      expect(std::ranges::equal(asked_jacobians, again_jacobians, same), "Jacobians of bound points");
      deformer.images(four, asked);
      deformer.images(places, again);
      expect(std::ranges::equal(asked, again, same), "images of points that are bound without Jacobians");
    }
    expect(refuses("without", [&] { deformer.images(places, again, again_jacobians); }),
           "Jacobians that are not bound");
    expect(refuses("another", [&] { green.images(places, again); }), "points of another deformer");
    expect(refuses("before", [&] { Deformer(cube, method).images(places, again); }), "bound points before a pose");
    expect(refuses("images", [&] { deformer.images(places, std::span(again).first(9)); }), "room for bound points");
  }

  Cage open = cube;
  open.faces.pop_back();
  expect(refuses("hole", [&] { Coordinates(open, "green"); }), "a hole is named");
  expect(refuses("face 0", [&] { Coordinates({cube.vertices, {{0, -1, 2}}}, "green"); }), "an index is named");
  expect(refuses("nonsense", [&] { Coordinates(cube, "nonsense"); }), "a kind is named");
  expect(refuses("nu",
                 [&] {
                   Coordinates(cube, "somigliana", {.parameters = {{"nu", "0.7"}}});
                 }),
         "a parameter is named");
  expect(refuses("values", [&] { mean.evaluate(points, values); }), "room is checked");
  if (failures == 0) std::printf("cageproof %s does what it says\n", version().c_str());
  return failures == 0 ? 0 : 1;
}
