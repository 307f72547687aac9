// SPDX-License-Identifier: MIT
#include "canvas.h"

#include <gtest/gtest.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPNGReader.h>

#include <string>

namespace cageproof::reports {
namespace {

constexpr Rgb kBlack{0, 0, 0};
constexpr int kSize = 40;

// Whether a pixel of a picture is darker than half; from the upper left corner.
class Pixels {
 public:
  explicit Pixels(Canvas& canvas) : png_(canvas.png()) {
    reader_->SetMemoryBuffer(png_.data());
    reader_->SetMemoryBufferLength(static_cast<vtkIdType>(png_.size()));
    reader_->Update();
  }
  bool is_dark(int column, int row) const {
    return reader_->GetOutput()->GetScalarComponentAsDouble(column, kSize - 1 - row, 0, 0) < 128;
  }

 private:
  std::string png_;
  vtkNew<vtkPNGReader> reader_;
};

TEST(canvas, arrow_ends_at_its_tip_in_both_directions) {
  for (const Place& along : {Place{20, 0}, Place{0, 20}, Place{-20, 0}, Place{0, -20}}) {
    Canvas canvas(kSize, kSize);
    canvas.set_smooth(false);
    const Place at{20 - along[0] / 2, 20 - along[1] / 2};
    canvas.arrow(at, along, kBlack, 3);
    const Pixels pixels(canvas);
    // Two pixels before the tip, and two behind it.
    const auto seen = [&](double way) {
      return pixels.is_dark(static_cast<int>(20 + way * along[0] / 20), static_cast<int>(20 + way * along[1] / 20));
    };
    EXPECT_TRUE(seen(7)) << along[0] << ' ' << along[1];
    EXPECT_FALSE(seen(12)) << along[0] << ' ' << along[1];
    EXPECT_TRUE(seen(-8)) << along[0] << ' ' << along[1];
    EXPECT_FALSE(seen(-12)) << along[0] << ' ' << along[1];
    // The head is as wide on one side of the arrow as on the other.
    const Place across{-along[1] / 20, along[0] / 20};
    const auto beside = [&](double way, double side) {
      return pixels.is_dark(static_cast<int>(20 + way * along[0] / 20 + side * across[0]),
                            static_cast<int>(20 + way * along[1] / 20 + side * across[1]));
    };
    EXPECT_TRUE(beside(2.5, 2) && beside(2.5, -2)) << along[0] << ' ' << along[1];
    EXPECT_FALSE(beside(2.5, 5) || beside(2.5, -5)) << along[0] << ' ' << along[1];
  }
}

}  // namespace
}  // namespace cageproof::reports
