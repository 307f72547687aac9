#include <cageproof/cageproof.h>

#include <cstdio>

int main() {
  using namespace cageproof::library;
  const Cage cube{{-1, -1, -1, 1, -1, -1, 1, 1, -1, -1, 1, -1, -1, -1, 1, 1, -1, 1, 1, 1, 1, -1, 1, 1},
                  {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}}};
  const std::vector<double> points{0.5, 0, 0, 0, 0.25, 0.5};  // three numbers per point

  const Coordinates green(cube, "green");
  std::vector<double> values(2 * green.row());
  green.evaluate(points, values);
  double sum = 0;
  for (std::size_t i = 0; i < green.blocks()[0].count; ++i) sum += values[i];  // the phi of the first point
  std::printf("phi sum to %.12f\n", sum);

  Deformer deformer(cube, "green");
  std::vector<double> posed = cube.vertices, images(points.size());
  for (double& x : posed) x *= 3;
  deformer.pose(posed);
  deformer.images(points, images);
  std::printf("the first point goes to %.12f\n", images[0]);
}
