// SPDX-License-Identifier: MIT
#include "parts.h"

#include <array>
#include <cmath>
#include <string>

namespace cageproof::deformation {
namespace {

// Between which lie most of those that are asked for. At an infinite nu, the limit, evaluations take ten times as long
// on some cages, where entries are zero.
constexpr std::array known_nus{-0.75, 0.4375};

class SomiglianaParts final : public CoordinatesIn<SomiglianaParts> {
 public:
  SomiglianaParts(const Cage& cage, std::string_view kind, const CoordinateOptions& options)
      : parts_{with(cage, kind, options, known_nus[0]), with(cage, kind, options, known_nus[1])} {
    for (std::size_t k = 0; k < parts_.size(); ++k)
      for (CoordinateBlock block : parts_[k].blocks()) {
        block.label += std::to_string(k + 1);
        blocks_.push_back(std::move(block));
      }
  }

  const std::vector<CoordinateBlock>& blocks() const override { return blocks_; }
  int max_order() const override { return parts_[0].max_order(); }
  std::string evaluation() const override { return parts_[0].evaluation(); }
  bool is_exact_in(ScalarKind scalar) const override { return parts_[0].is_exact_in(scalar); }

  template <Scalar R>
  void compute(std::span<const Vec3<R>> points, int order, std::span<CoordinateTable<R>> tables) const {
    std::size_t to = 0;
    for (const CageCoordinates& part : parts_)
      for (CoordinateTable<R>& table : part.at<R>(points, order)) tables[to++] = std::move(table);
  }

 private:
  static CageCoordinates with(const Cage& cage, std::string_view kind, CoordinateOptions options, double nu) {
    options.parameters = {1, nu};
    return {cage, coordinate_kind_named(kind), std::move(options)};
  }

  std::array<CageCoordinates, 2> parts_;
  std::vector<CoordinateBlock> blocks_;
};

// 1/(1 - nu)
template <Scalar R>
R place_of(double nu) {
  return std::isinf(nu) ? R(0) : R(1 / (1 - R(nu)));
}

// Only the deformer uses it: users have the coordinates themselves.
template <bool KeepsQuads>
const CoordinateKind& kind_of_parts() {
  static const CoordinateKind kind{
      .name = KeepsQuads ? "quad_somigliana_parts" : "somigliana_parts",
      .source = "[C23] Section 5",
      .keeps_quads = KeepsQuads,
      .own_dimension = 0,
      .prepare = [](const Cage& of, const CoordinateOptions& with) -> std::shared_ptr<const PreparedCoordinates> {
        return std::make_shared<SomiglianaParts>(of, KeepsQuads ? "quad_somigliana" : "somigliana", with);
      },
      .made_of_sums = true};
  return kind;
}

}  // namespace

CageCoordinates somigliana_parts(const Cage& cage, bool keeps_quads, const CoordinateOptions& options) {
  return {cage, keeps_quads ? kind_of_parts<true>() : kind_of_parts<false>(),
          CoordinateOptions{options.evaluation, options.triangulation, {}}};
}

template <Scalar R>
std::vector<CoordinateTable<R>> assembled(std::span<const CoordinateTable<R>> parts, double nu) {
  const std::size_t blocks = parts.size() / 2;
  const R first = place_of<R>(known_nus[0]), second = place_of<R>(known_nus[1]);
  const R share = (place_of<R>(nu) - first) / (second - first), other = 1 - share;
  std::vector<CoordinateTable<R>> found(parts.begin(), parts.begin() + static_cast<std::ptrdiff_t>(blocks));
  for (std::size_t b = 0; b < blocks; ++b)
    for (std::size_t o = 0; o < found[b].tensors.size(); ++o)
      for (std::size_t i = 0; i < found[b].tensors[o].size(); ++i)
        found[b].tensors[o][i] = other * found[b].tensors[o][i] + share * parts[blocks + b].tensors[o][i];
  return found;
}

template std::vector<CoordinateTable<double>> assembled<double>(std::span<const CoordinateTable<double>>, double);
template std::vector<CoordinateTable<Mp50>> assembled<Mp50>(std::span<const CoordinateTable<Mp50>>, double);

}  // namespace cageproof::deformation
