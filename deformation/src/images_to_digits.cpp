// SPDX-License-Identifier: MIT
#include "cageproof/deformation/point_images.h"

#include "linear_posed.h"
#include "own_place.h"

#include "cageproof/core/geometry/box.h"
#include "cageproof/core/input_error.h"
#include "cageproof/core/parallel.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace cageproof::deformation {
namespace {

// The data that images are sums of coordinates with.
CageData data_of(const CageCoordinates& coordinates, const Posed<double>& map) {
  const auto* const linear = dynamic_cast<const LinearPosed<double>*>(&map);
  CageData data{coordinates.dimension(), {}};
  for (std::size_t b = 0; linear != nullptr && b < linear->data().size(); ++b) {
    const Matrix<double>& rows = linear->data()[b];
    std::vector<double>& numbers = data.blocks.emplace_back();
    numbers.reserve(static_cast<std::size_t>(rows.size()));
    for (Eigen::Index i = 0; i < rows.rows(); ++i)
      for (Eigen::Index c = 0; c < rows.cols(); ++c) numbers.push_back(rows(i, c));
  }
  return data;
}

// The diagonal of the box of what vertices are mapped to.
double size_of(const CageData& data) {
  std::vector<Vec3<double>> vertices;
  for (std::size_t i = 0; i + 2 < data.blocks[0].size(); i += 3)
    vertices.emplace_back(data.blocks[0][i], data.blocks[0][i + 1], data.blocks[0][i + 2]);
  const auto [low, high] = box_of(vertices);
  return (high - low).norm();
}

}  // namespace

PointImages images_to_digits(const CageCoordinates& coordinates, std::span<const Vec3<double>> points,
                             std::span<const Posed<double>* const> maps, int digits, int jobs,
                             const std::optional<Inside>& region, std::vector<DigitsReport>& reports) {
  PointImages all{std::vector<Images<double>>(maps.size()), std::vector<char>(points.size(), 0)};
  constexpr std::size_t together = 256;
  for_each_parallel((points.size() + together - 1) / together, jobs, [&](std::size_t block) {
    for (std::size_t p = block * together; p < std::min((block + 1) * together, points.size()); ++p)
      all.missing[p] = static_cast<char>(!points[p].allFinite() || (region && !region->holds(points[p])));
  });
  std::vector<Vec3<double>> asked;
  std::vector<std::size_t> number;
  for (std::size_t p = 0; p < points.size(); ++p)
    if (all.missing[p] == 0) {
      asked.push_back(points[p]);
      number.push_back(p);
    }
  reports.assign(maps.size(), {});
  std::vector<double> values(3 * asked.size()), errors(asked.size());
  for (std::size_t k = 0; k < maps.size(); ++k) {
    const auto [map, place] = without_shift(*maps[k]);
    const CageData data = data_of(coordinates, *map);
    const double size = data.blocks.empty() ? 0 : size_of(data);
    std::unique_ptr<const StatedSum> sum;
    // As a task, so that loops within take no more threads.
    for_each_parallel(data.blocks.empty() ? 0 : 1, jobs, [&](std::size_t /*only*/) {
      sum = coordinates.sum_to(std::pow(10., -digits) * size, data, asked.size());
    });
    // Cages at the ends of the exponent range are not computed in blocks: all faces are summed there, too.
    const bool beyond_blocks = sum == nullptr && coordinates.kind().name == "green" && coordinates.dimension() == 3 &&
                               coordinates.evaluation() == "batched";
    if (sum == nullptr && !beyond_blocks)
      throw InputError(fmt::format(
          "images by {} coordinates, evaluation {}, always have all digits; only green by batched in space has fewer",
          coordinates.kind().name, coordinates.evaluation()));
    // The same numbers as without digits.
    if (beyond_blocks || sum->degree() == 0) {
      reports.assign(maps.size(), {.by_faces = asked.size()});
      return images_of(coordinates, points, maps, {.order = 0, .jobs = jobs}, region);
    }
    sum->fill(asked, jobs, values, errors);
    std::vector<double>& to = all.maps[k].tensors[0];
    to.assign(3 * points.size(), 0.0);
    for (std::size_t i = 0; i < asked.size(); ++i)
      for (int c = 0; c < 3; ++c) to[3 * number[i] + c] = values[3 * i + c] + place[c];
    reports[k] = {.degree = sum->degree(),
                  .by_faces = static_cast<std::size_t>(std::ranges::count(errors, 0.0)),
                  .error = errors.empty() ? 0 : std::ranges::max(errors) / size};
  }
  return all;
}

}  // namespace cageproof::deformation
