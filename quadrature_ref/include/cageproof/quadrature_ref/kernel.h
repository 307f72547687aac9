// SPDX-License-Identifier: MIT
// The integrand of a formula, with its derivatives taken under the integral sign; rules feed it batches of nodes.
#pragma once

#include "cageproof/core/evaluation.h"
#include "cageproof/core/linear.h"

#include <array>
#include <memory>
#include <span>
#include <tuple>

namespace cageproof::quadrature_ref {

/// A point xi of the element's surface, as the point eta sees it. 2D segments leave z at zero.
/// Kernels are linear in the normal: on a curved element `normal` is N = xi_u x xi_v, `height` x.N, and `weight` leaves
/// the area element |N| out.
template <Scalar R>
struct Node {
  Vec3<R> x = Vec3<R>::Zero();  ///< xi - eta
  std::array<R, 4> hat{};  ///< basis function of each corner at xi; entries beyond the element's corners are unused
  Vec3<R> normal = Vec3<R>::Zero();  ///< of the surface at xi: of unit length on flat elements
  R height{};  ///< x . normal, stated by the rule: a dot product loses it next to the element's plane
  R weight{};  ///< of the rule, with the area element on flat elements
};

/// Appends nodes of a flat element, their positions and weights to be set, until there are `count`.
template <Scalar R>
void grow_flat(std::vector<Node<R>>& nodes, std::size_t count, const Vec3<R>& normal, const R& height) {
  while (nodes.size() < count) {
    Node<R>& node = nodes.emplace_back();
    node.normal = normal;
    node.height = height;
  }
}

/// The integrand of one formula at one precision.
template <Scalar R>
class Kernel {
 public:
  virtual ~Kernel() = default;
  /// Adds the sum over the nodes of weight * integrand to `sums.value`, of its gradient with respect to eta to
  /// `sums.gradient` if order >= 1, and the entries i <= j of its Hessian to `sums.hessian` if order >= 2
  /// (fill_symmetric does the rest). \param parameters in the order of Formula::parameters \pre `sums` was reset for
  /// the formula's components and at least that order; no node lies at eta
  virtual void accumulate(std::span<const Node<R>> nodes, std::span<const R> parameters, int order,
                          Result<R>& sums) const = 0;
};

/// Copies the Hessians' entries i < j to j, i.
template <Scalar R>
void fill_symmetric(Result<R>& sums, int dim) {
  for (std::size_t first = 0; first < sums.hessian.size(); first += dim * dim)
    for (int i = 0; i < dim; ++i)
      for (int j = 0; j < i; ++j) sums.hessian[first + i * dim + j] = sums.hessian[first + j * dim + i];
}

/// One formula's kernel at every precision.
class KernelSet {
 public:
  template <Scalar R>
  using Pointer = std::unique_ptr<const Kernel<R>>;

  template <Scalar R>
  void set(Pointer<R> kernel) {
    std::get<Pointer<R>>(kernels_) = std::move(kernel);
  }
  template <Scalar R>
  const Kernel<R>& at() const {
    return *std::get<Pointer<R>>(kernels_);
  }

 private:
  std::tuple<Pointer<float>, Pointer<double>, Pointer<Mp50>, Pointer<Mp100>, Pointer<Mp200>> kernels_;
};

/// What a rule integrates: the catalogue's row (components, degree of homogeneity) and its kernels. Refers to both.
struct Integrand {
  const Formula& formula;
  const KernelSet& kernels;
};

}  // namespace cageproof::quadrature_ref
