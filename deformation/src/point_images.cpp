// SPDX-License-Identifier: MIT
#include "cageproof/deformation/point_images.h"

#include "cageproof/core/parallel.h"
#include "extended.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace cageproof::deformation {
namespace {

bool has_coordinates(const std::vector<CoordinateTable<double>>& tables, std::size_t p) {
  return std::ranges::none_of(tables, [&](const CoordinateTable<double>& table) {
    const auto row = std::span(table.tensors[0]).subspan(p * table.stride[0], table.stride[0]);
    return std::ranges::any_of(row, [](double x) { return std::isnan(x); });
  });
}

// Numbers of a point in a tensor of that many.
std::size_t width_of(const std::vector<double>& tensor, std::size_t points) { return tensor.size() / points; }

}  // namespace

std::optional<Inside> region_of(const CageCoordinates& coordinates) {
  if (coordinates.kind().normalised) return std::nullopt;
  return Inside(coordinates.elements());
}

PointImages images_of(const CageCoordinates& coordinates, std::span<const Vec3<double>> points,
                      std::span<const Posed<double>* const> maps, const ImageRun& run,
                      const std::optional<Inside>& region) {
  const int d = coordinates.dimension(), order = run.order;
  PointImages all{std::vector<Images<double>>(maps.size()), std::vector<char>(points.size())};
  for (Images<double>& images : all.maps)
    for (int o = 0; o <= order; ++o) images.tensors[o].resize(points.size() * d * derivative_count(d, o));
  std::optional<Extended> extended;
  if (run.extend) {
    extended.emplace(coordinates);
    all.beyond.resize(points.size());
  }
  // Blocks of points share what evaluations prepare for an element.
  for_each_parallel((points.size() + run.block - 1) / run.block, run.jobs, [&](std::size_t block) {
    const std::size_t first = block * run.block, count = std::min(run.block, points.size() - first);
    auto tables = coordinates.at<double>(points.subspan(first, count), order);
    for (std::size_t p = 0; p < count; ++p) {
      const bool outside = region && !region->holds(points[first + p]);
      if (outside && extended) all.beyond[first + p] = extended->add_to(tables, p, points[first + p], order);
      all.missing[first + p] = (outside && !extended) || !has_coordinates(tables, p);
    }
    for (std::size_t k = 0; k < maps.size(); ++k) {
      const Images<double> found = maps[k]->images(tables, count, order);
      for (int o = 0; o <= order; ++o) {
        const std::size_t width = d * derivative_count(d, o);
        std::copy_n(found.tensors[o].begin(), count * width, &all.maps[k].tensors[o][first * width]);
      }
    }
  });
  return all;
}

std::optional<ImagePlace> first_not_finite(const PointImages& images) {
  const std::size_t points = images.missing.size();
  for (std::size_t p = 0; p < points; ++p)
    for (std::size_t k = images.maps.size(); k-- > 0 && !images.missing[p];) {
      const std::vector<double>& values = images.maps[k].tensors[0];
      const std::size_t d = width_of(values, points);
      if (!std::ranges::all_of(std::span(values).subspan(p * d, d), [](double x) { return std::isfinite(x); }))
        return ImagePlace{k, p};
    }
  return std::nullopt;
}

void fill_missing(PointImages& images, std::span<const Vec3<double>> points, int dimension, Missing as) {
  const auto d = static_cast<std::size_t>(dimension);
  for (std::size_t p = 0; p < points.size(); ++p)
    for (std::size_t k = 0; k < images.maps.size() && images.missing[p]; ++k) {
      auto& tensors = images.maps[k].tensors;
      for (std::vector<double>& tensor : tensors) {
        const std::size_t width = width_of(tensor, points.size());
        std::fill_n(tensor.begin() + static_cast<std::ptrdiff_t>(p * width), width,
                    as == Missing::Nan ? std::numeric_limits<double>::quiet_NaN() : 0);
      }
      for (std::size_t c = 0; c < d && as == Missing::Rest; ++c) {
        tensors[0][p * d + c] = points[p][static_cast<int>(c)];
        if (!tensors[1].empty()) tensors[1][(p * d + c) * d + c] = 1;
      }
    }
}

std::vector<Vec3<double>> vertices_of(const Images<double>& images, int dimension) {
  const auto d = static_cast<std::size_t>(dimension);
  std::vector<Vec3<double>> vertices(images.tensors[0].size() / d, Vec3<double>::Zero());
  for (std::size_t i = 0; i < images.tensors[0].size(); ++i)
    vertices[i / d][static_cast<int>(i % d)] = images.tensors[0][i];
  return vertices;
}

}  // namespace cageproof::deformation
