// SPDX-License-Identifier: MIT
// Enters a segment formula's hybrid into the register.
#pragma once

#include "../algebra.h"

#include "cageproof/closed_form/joint.h"
#include "hybrid.h"

namespace cageproof::fast::segment {

/// What hybrids on a segment share: the ends, and at each point the frame in double.
struct SharedOnSegment {
  template <cageproof::Scalar R>
  struct Element {
    std::span<const Vec3<R>> given;
    Segment<double> s;

    explicit Element(std::span<const Vec3<R>> ends)
        : given(ends), s{convert<double>(ends[0]), convert<double>(ends[1])} {}
  };
  template <cageproof::Scalar R, int O>
  struct At {
    std::span<const Vec3<R>> ends;
    const Vec3<R>& given;
    SeenSegment seen;

    At(const Element<R>& element, const Vec3<R>& point)
        : ends(element.given), given(point), seen(element.s, convert<double>(point)) {}
  };
};

/// Puts a formula's tensors at a point.
template <class F>
struct PutHybrid {
  template <cageproof::Scalar R, int O>
  static void put(SharedOnSegment::At<R, O>& at, std::span<const R> parameters, bool finite_part, std::size_t point,
                  const BatchOutput<R>& output) {
    std::array<double, 4> wide;
    std::ranges::copy(parameters, wide.begin());
    if (const auto jet = hybrid<F, O>(at.seen, std::span<const double>(wide).first(parameters.size()), finite_part))
      return closed_form::put(closed_form::narrowed<R>(*jet), O, point, output);
    Algebra<F>::put(at.ends, at.given, O, parameters, finite_part, point, output);
  }
};

template <class F>
inline constexpr auto member_of = closed_form::Member<SharedOnSegment>::of<PutHybrid<F>, float, double>();

/// `const RegisterHybrid<F> register_<kernel>{"segment.<kernel>"};` at namespace scope.
template <class F>
class RegisterHybrid {
 public:
  explicit RegisterHybrid(std::string_view formula)
      : family_(hybrid_family(formula, [](Evaluation& evaluation) { set_hybrid<F>(evaluation, member_of<F>); })) {
    Algebra<F>::formula = formula;
  }

 private:
  RegisterEvaluation family_;
};

}  // namespace cageproof::fast::segment
