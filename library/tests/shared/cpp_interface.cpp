// SPDX-License-Identifier: MIT
// The C++ header over the C interface: the same numbers as C gives, errors as exceptions.
#include <cageproof.hpp>

#include <cmath>
#include <cstdio>

int main() {
  using namespace cageproof::shared;
  int failures = 0;
  const auto expect = [&](bool holds, const char* what) {
    if (!holds) std::printf("FAILED: %s\n", what), ++failures;
  };
  const Cage cube = Cage::embedded("cube");
  const std::vector<double> points{0.1, 0.2, 0.3, -0.2, 0.1, 0};
  const Coordinates green(cube, "green", {{"threads", "1"}});
  std::vector<double> values(2 * green.row()), gradients(6 * green.row());
  green.evaluate(points, values, gradients);
  double sum = 0;
  for (std::size_t i = 0; i < 8; ++i) sum += values[i];
  expect(std::abs(sum - 1) < 1e-14, "phi sum to one");
  std::vector<double> shift(24, 1.0), changed(2 * green.row()), to_cage(24);
  green.jvp(points, shift, changed);
  expect(std::abs(changed[0] + gradients[0] + gradients[1] + gradients[2]) < 1e-14, "a shift of the cage");
  green.vjp(points, changed, to_cage);
  double both_of_cage = 0;
  for (const double x : to_cage) both_of_cage += x;
  for (const double x : changed) both_of_cage -= x * x;
  expect(std::abs(both_of_cage) < 1e-14, "both directions by the cage");
  Deformer deformer(cube, "green");
  std::vector<double> posed = cube.vertices(), images(6), again(6);
  for (double& x : posed) x *= 3;
  deformer.pose(posed);
  deformer.images(points, images);
  const BoundPoints bound = deformer.bind(points);
  deformer.images(bound, again);
  expect(images == again && std::abs(images[0] - 0.3) < 1e-14, "images");
  std::vector<double> back(24), back_of_bound(24);
  deformer.jvp(points, posed, again);
  expect(std::abs(again[1] - images[1]) < 1e-14, "along the pose");
  deformer.jvp(bound, posed, again);
  deformer.vjp(points, again, back);
  deformer.vjp(bound, again, back_of_bound);
  double both = 0;
  for (std::size_t i = 0; i < 24; ++i) both += back[i] * posed[i];
  for (std::size_t i = 0; i < 6; ++i) both -= again[i] * again[i];
  expect(back == back_of_bound && std::abs(both) < 1e-14, "both directions of a derivative");
  expect(list("methods").find("somigliana") != std::string::npos, "names");
  try {
    Coordinates(cube, "nonsense");
    expect(false, "an unknown kind");
  } catch (const Error& error) {
    expect(error.code() == CAGEPROOF_BAD_INPUT && std::string(error.what()).find("nonsense") != std::string::npos,
           "an exception with C's text");
  }
  return failures;
}
