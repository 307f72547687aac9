// SPDX-License-Identifier: MIT
#include "parts.h"

#include <limits>

namespace cageproof::deformation {
namespace {

class SomiglianaParts final : public CoordinatesIn<SomiglianaParts> {
 public:
  SomiglianaParts(const Cage& cage, const CoordinateOptions& options)
      : at_infinity_(with(cage, options, std::numeric_limits<double>::infinity())), at_zero_(with(cage, options, 0)) {
    blocks_ = at_infinity_.blocks();
    for (CoordinateBlock block : at_zero_.blocks()) {
      block.label += '2';
      block.reproduces = Reproduces::Nothing;
      blocks_.push_back(std::move(block));
    }
    for (std::size_t b = 0; b < 2; ++b) blocks_[b].label += '1';
  }

  const std::vector<CoordinateBlock>& blocks() const override { return blocks_; }
  int max_order() const override { return at_zero_.max_order(); }
  std::string evaluation() const override { return at_zero_.evaluation(); }
  bool is_exact_in(ScalarKind scalar) const override { return at_zero_.is_exact_in(scalar); }

  template <Scalar R>
  void compute(std::span<const Vec3<R>> points, int order, std::span<CoordinateTable<R>> tables) const {
    const auto first = at_infinity_.at<R>(points, order), whole = at_zero_.at<R>(points, order);
    for (std::size_t b = 0; b < first.size(); ++b)
      for (int o = 0; o <= order; ++o) {
        tables[b].tensors[o] = first[b].tensors[o];
        std::vector<R>& second = tables[first.size() + b].tensors[o];
        for (std::size_t i = 0; i < second.size(); ++i) second[i] = whole[b].tensors[o][i] - first[b].tensors[o][i];
      }
  }

 private:
  static CageCoordinates with(const Cage& cage, CoordinateOptions options, double nu) {
    options.parameters = {1, nu};
    return {cage, coordinate_kind_named("somigliana"), std::move(options)};
  }

  CageCoordinates at_infinity_, at_zero_;
  std::vector<CoordinateBlock> blocks_;
};

}  // namespace

CageCoordinates somigliana_parts(const Cage& cage, const CoordinateOptions& options) {
  // Of the deformer alone: users have the coordinates themselves.
  static const CoordinateKind kind{
      .name = "somigliana_parts",
      .source = "[C23] Section 5",
      .own_dimension = 0,
      .prepare = [](const Cage& of, const CoordinateOptions& with) -> std::shared_ptr<const PreparedCoordinates> {
        return std::make_shared<SomiglianaParts>(of, with);
      }};
  return {cage, kind, CoordinateOptions{options.evaluation, options.triangulation, {}}};
}

template <Scalar R>
std::vector<CoordinateTable<R>> assembled(std::span<const CoordinateTable<R>> parts, double nu) {
  const std::size_t blocks = parts.size() / 2;
  std::vector<CoordinateTable<R>> found(parts.begin(), parts.begin() + static_cast<std::ptrdiff_t>(blocks));
  if (std::isinf(nu)) return found;
  const R factor = 1 / (1 - R(nu));
  for (std::size_t b = 0; b < blocks; ++b)
    for (std::size_t o = 0; o < found[b].tensors.size(); ++o)
      for (std::size_t i = 0; i < found[b].tensors[o].size(); ++i)
        found[b].tensors[o][i] += factor * parts[blocks + b].tensors[o][i];
  return found;
}

template std::vector<CoordinateTable<double>> assembled<double>(std::span<const CoordinateTable<double>>, double);
template std::vector<CoordinateTable<Mp50>> assembled<Mp50>(std::span<const CoordinateTable<Mp50>>, double);

}  // namespace cageproof::deformation
