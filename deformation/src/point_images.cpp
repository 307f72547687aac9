// SPDX-License-Identifier: MIT
#include "cageproof/deformation/point_images.h"

#include "block_maker.h"

#include "cageproof/core/memory.h"
#include "cageproof/core/parallel.h"
#include "cageproof/core/reused.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

namespace cageproof::deformation {
namespace {

// Numbers of a point in a tensor of that many.
std::size_t width_of(const std::vector<double>& tensor, std::size_t points) { return tensor.size() / points; }

PointImages room_for(int dimension, std::size_t points, std::size_t maps, int order) {
  PointImages all{std::vector<Images<double>>(maps), std::vector<char>(points)};
  for (Images<double>& images : all.maps)
    for (int o = 0; o <= order; ++o) images.tensors[o].resize(points * dimension * derivative_count(dimension, o));
  return all;
}

void add_images(const std::vector<CoordinateTable<double>>& tables, int dimension, const BlockPart& part,
                std::span<const Posed<double>* const> maps, int order, PointImages& all) {
  for (std::size_t k = 0; k < maps.size(); ++k) {
    const Images<double> found = maps[k]->images(tables, part.count, order);
    for (int o = 0; o <= order; ++o) {
      const std::size_t width = dimension * derivative_count(dimension, o);
      std::copy_n(found.tensors[o].begin(), part.count * width, &all.maps[k].tensors[o][part.first * width]);
    }
  }
}

}  // namespace

std::optional<Inside> region_of(const CageCoordinates& coordinates) {
  if (coordinates.kind().normalised) return std::nullopt;
  return Inside(coordinates.elements());
}

PointImages images_of(const CageCoordinates& coordinates, std::span<const Vec3<double>> points,
                      std::span<const Posed<double>* const> maps, const ImageRun& run,
                      const std::optional<Inside>& region) {
  PointImages all = room_for(coordinates.dimension(), points.size(), maps.size(), run.order);
  if (run.extend) all.beyond.resize(points.size());
  const BlockMaker maker(coordinates, points, run, region);
  Reused<std::vector<CoordinateTable<double>>> reused;
  // Blocks of points share what evaluations prepare for an element.
  for_each_parallel(maker.count(), run.jobs, [&](std::size_t block) {
    auto held = reused.taken();
    maker.make(block, *held, all.missing, all.beyond);
    add_images(*held, coordinates.dimension(), maker.part(block), maps, run.order, all);
  });
  return all;
}

BoundPoints::BoundPoints(const CageCoordinates& coordinates, std::span<const Vec3<double>> points, const ImageRun& run,
                         const std::optional<Inside>& region)
    : dimension_(coordinates.dimension()),
      order_(run.order),
      block_(0),
      missing_(points.size()),
      beyond_(run.extend ? points.size() : 0) {
  const double numbers = numbers_of_point(coordinates, run.order);
  require_memory(
      numbers * static_cast<double>(points.size()) * sizeof(double),
      fmt::format("binding {} points, which keeps {} numbers of each,", points.size(), numbers),
      "bind fewer points at a time, or ask for images of points that are not bound, which keeps no coordinates");
  const BlockMaker maker(coordinates, points, run, region);
  block_ = maker.length();
  blocks_.resize(maker.count());
  for_each_parallel(maker.count(), run.jobs,
                    [&](std::size_t block) { maker.make(block, blocks_[block], missing_, beyond_); });
}

PointImages BoundPoints::images(std::span<const Posed<double>* const> maps, int order, int jobs) const {
  PointImages all = room_for(dimension_, size(), maps.size(), order);
  all.missing = missing_;
  all.beyond = beyond_;
  for_each_parallel(blocks_.size(), jobs, [&](std::size_t block) {
    add_images(blocks_[block], dimension_, part_of(block, block_, size()), maps, order, all);
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
