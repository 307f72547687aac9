// SPDX-License-Identifier: MIT
// Images that several checks of a deformer share.
#include "deformers/bent_images.h"

#include "cageproof/core/cage/embedded_cages.h"

#include <gtest/gtest.h>

namespace cageproof::validation {
namespace {

using deformation::Images;

// Counts how often it is asked, and says so.
class Counting final : public deformation::Posed<double> {
 public:
  explicit Counting(int& asked) : asked_(asked) {}
  Images<double> images(std::span<const CoordinateTable<double>>, std::size_t, int) const override {
    Images<double> found;
    found.tensors[0] = {static_cast<double>(++asked_)};
    return found;
  }
  const deformation::DeformationReport& report() const override { return report_; }

 private:
  int& asked_;
  deformation::DeformationReport report_;
};

class CountingDeformer final : public deformation::Deformer<double> {
 public:
  CountingDeformer(const Cage& cage, int& posed, int& asked)
      : coordinates_(cage, coordinate_kind_named("mean_value"), CoordinateOptions{}), posed_(posed), asked_(asked) {}
  const CageCoordinates& coordinates() const override { return coordinates_; }
  std::unique_ptr<const deformation::Posed<double>> pose(const deformation::Pose<double>&) const override {
    ++posed_;
    return std::make_unique<Counting>(asked_);
  }

 private:
  CageCoordinates coordinates_;
  int& posed_;
  int& asked_;
};

TEST(bent_images, are_computed_once_a_point_and_order) {
  const auto cage = std::make_shared<const Cage>(embedded_cage("cube"));
  int prepared = 0, posed = 0, asked = 0;
  const BentImages<double> images(cage, [&] {
    ++prepared;
    return std::make_shared<const CountingDeformer>(*cage, posed, asked);
  });
  EXPECT_EQ(prepared, 0);
  const Vec3<double> a(.1, .2, .3), b(.2, .1, .3);
  EXPECT_EQ(images.at(a, 2).tensors[0][0], 1);
  EXPECT_EQ(images.at(a, 2).tensors[0][0], 1);
  EXPECT_EQ(images.at(b, 2).tensors[0][0], 2);
  EXPECT_EQ(images.at(a, 0).tensors[0][0], 3) << "images of other orders have bits of their own";
  EXPECT_EQ(images.at(a, 2).tensors[0][0], 1);
  EXPECT_EQ(images.of(a, 2).tensors[0][0], 4) << "not kept";
  EXPECT_EQ(prepared, 1);
  EXPECT_EQ(posed, 1);
}

}  // namespace
}  // namespace cageproof::validation
