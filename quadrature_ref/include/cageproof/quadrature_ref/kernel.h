// SPDX-License-Identifier: MIT
// The integrand of a formula, with its derivatives taken under the integral sign; rules feed it batches of nodes.
#pragma once

#include "cageproof/core/catalogue/evaluation.h"
#include "cageproof/core/numbers/linear.h"

#include <array>
#include <memory>
#include <span>
#include <tuple>

namespace cageproof::quadrature_ref {

/// Corners of the element with the most of them.
inline constexpr int kMostCorners = 4;

/// A point xi of the element, as the point eta sees it. In the plane every third coordinate is zero.
/// Kernels are linear in the normal: on a curved element `normal` is N = xi_u x xi_v, `height` x.N, and `weight` leaves
/// the area element |N| out.
template <Scalar R>
struct Node {
  Vec3<R> x = Vec3<R>::Zero();  ///< xi - eta, in the rule's unit of length
  std::array<R, kMostCorners>
      hat{};  ///< basis function of each corner at xi; entries beyond the element's corners are unused
  Vec3<R> normal = Vec3<R>::Zero();  ///< of the element at xi: of unit length on flat elements
  R height{};    ///< x . normal, stated by the rule: a dot product loses it next to the element's plane or line
  R weight{};    ///< of the rule, with the length or area element on flat elements
  R log_unit{};  ///< natural logarithm of the rule's unit of length; added to log |x|, it gives that of the distance
};

/// A request to a kernel, the same at all nodes.
template <Scalar R>
struct KernelTask {
  std::span<const R> parameters;  ///< in the order of Formula::parameters
  int order = 0;                  ///< highest derivative
  int corners =
      0;  ///< how many corners' basis functions weight the tensor, which gives a tensor each; 0: the tensor alone
};

/// The integrand of one formula at one precision, in a space of one dimension.
template <Scalar R>
class Kernel {
 public:
  virtual ~Kernel() = default;
  /// Adds the sum over the nodes of weight * integrand to `sums.value`, of its gradient with respect to eta to
  /// `sums.gradient` if order >= 1, and the entries i <= j of its Hessian to `sums.hessian` if order >= 2
  /// (fill_symmetric does the rest). \pre `sums` was reset for the tensors that the task asks for and at least its
  /// order; no node lies at eta
  virtual void accumulate(std::span<const Node<R>> nodes, const KernelTask<R>& task, Result<R>& sums) const = 0;
};

/// Copies the Hessians' entries i < j to j, i.
template <Scalar R>
void fill_symmetric(Result<R>& sums, int dim) {
  for (std::size_t first = 0; first < sums.hessian.size(); first += dim * dim)
    for (int i = 0; i < dim; ++i)
      for (int j = 0; j < i; ++j) sums.hessian[first + i * dim + j] = sums.hessian[first + j * dim + i];
}

/// A kernel at every precision, in the plane, in space or in both.
class KernelSet {
 public:
  template <Scalar R>
  using Pointer = std::unique_ptr<const Kernel<R>>;

  /// \param dim of the space: 2 or 3
  template <Scalar R>
  void set(int dim, Pointer<R> kernel) {
    of<R>()[dim - 2] = std::move(kernel);
  }
  /// \pre it was set
  template <Scalar R>
  const Kernel<R>& at(int dim) const {
    return *of<R>()[dim - 2];
  }
  /// Whether the kernel is defined in that dimension: at every precision.
  bool defined_in(int dim) const {
    return std::apply([&](const auto&... of_scalar) { return (of_scalar[dim - 2] && ...); }, kernels_);
  }

 private:
  template <Scalar R>
  using InDimensions = std::array<Pointer<R>, 2>;
  template <Scalar R>
  InDimensions<R>& of() {
    return std::get<InDimensions<R>>(kernels_);
  }
  template <Scalar R>
  const InDimensions<R>& of() const {
    return std::get<InDimensions<R>>(kernels_);
  }

  std::tuple<InDimensions<float>, InDimensions<double>, InDimensions<Mp50>, InDimensions<Mp100>, InDimensions<Mp200>>
      kernels_;
};

/// An integrand: the catalogue's row (element, tensors, degree of homogeneity) and its kernels. It refers to both, and
/// owns neither.
struct Integrand {
  const Formula& formula;
  const KernelSet& kernels;
  int degree;  ///< of homogeneity, for the parameters that are asked for: Behaviour::degree

  template <Scalar R>
  const Kernel<R>& kernel() const {
    return kernels.at<R>(formula.dim());
  }
  template <Scalar R>
  KernelTask<R> task(std::span<const R> parameters, int order) const {
    return {parameters, order, formula.shape.per_corner ? formula.corners() : 0};
  }
  /// Sizes the tensors up to `order` and sets them to zero.
  template <Scalar R>
  void reset(Result<R>& tensors, int order) const {
    tensors.reset(formula.components(), formula.dim(), order);
  }
};

/// Registers a kernel with all rules of the elements it lives on, at program start: `const RegisterKernel
/// r{"my_kernel", ...};` at namespace scope of the kernel's .cpp. Each element of a dimension that the kernel is
/// defined in, for which the catalogue has a row
/// `<element>.<kernel>` by the time that evaluations are asked for, gets them; the row says whether basis functions
/// weight the tensor.
struct RegisterKernel {
  RegisterKernel(std::string_view kernel, const std::shared_ptr<const KernelSet>& kernels);
};

}  // namespace cageproof::quadrature_ref
