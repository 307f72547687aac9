// SPDX-License-Identifier: MIT
// A jet times a coordinate, without the multiplications by zero, against the general product of two jets.
#include "kernel/tensor_kernel.h"

#include <gtest/gtest.h>

namespace cageproof::quadrature_ref {
namespace {

template <int Dim>
void expect_the_general_product() {
  // Small integers: every sum and product is exact.
  KernelJet<Dim, double> a;
  a.value = 3;
  for (int i = 0; i < Dim; ++i) a.gradient[i] = 5 + 2 * i;
  for (std::size_t i = 0; i < a.hessian.size(); ++i) a.hessian[i] = 11 - 3 * static_cast<double>(i);
  Node<double> node;
  node.x = {7, -4, 2};
  for (int c = 0; c < Dim; ++c) {
    KernelJet<Dim, double> coordinate;
    coordinate.value = node.x[c];
    coordinate.gradient[c] = -1;
    const auto expected = product<2>(a, coordinate), found = times_coordinate<2>(a, node, c);
    EXPECT_EQ(found.value, expected.value);
    EXPECT_EQ(found.gradient, expected.gradient) << c;
    EXPECT_EQ(found.hessian, expected.hessian) << c;
  }
}

TEST(TensorKernel, a_jet_times_a_coordinate) {
  expect_the_general_product<2>();
  expect_the_general_product<3>();
}

}  // namespace
}  // namespace cageproof::quadrature_ref
