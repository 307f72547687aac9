// SPDX-License-Identifier: MIT
// Joint evaluation: several closed forms on one element, with everything that they share computed once per point.
#pragma once

#include "cageproof/closed_form/put.h"

#include "cageproof/core/catalogue/evaluation.h"

#include <array>
#include <stdexcept>

namespace cageproof::closed_form {

/// Calls `f.template operator()<O>()` with the derivative order as a constant.
template <class F>
void with_order(int order, F&& f) {
  if (order == 0) f.template operator()<0>();
  else if (order == 1) f.template operator()<1>();
  else f.template operator()<2>();
}

/// Corners as an array of them, in its own scalar.
template <class Corners, Scalar R>
Corners corners_in(std::span<const Vec3<R>> given) {
  Corners corners;
  for (std::size_t k = 0; k < corners.size(); ++k) corners[k] = convert<typename Corners::value_type::Scalar>(given[k]);
  return corners;
}

/// A formula's parameters in another scalar. \throws std::length_error for more than four
template <Scalar W>
class ParametersIn {
 public:
  template <Scalar R>
  explicit ParametersIn(std::span<const R> given) : count_(given.size()) {
    if (count_ > parameters_.size()) throw std::length_error("closed forms take at most four parameters");
    for (std::size_t i = 0; i < count_; ++i) parameters_[i] = W(given[i]);
  }
  std::span<const W> all() const { return std::span<const W>(parameters_).first(count_); }

 private:
  std::array<W, 4> parameters_;
  std::size_t count_;
};

/// Scalars as a list.
template <Scalar... R>
struct Scalars {
  /// Calls `f.template operator()<S>()` for each of them.
  template <class F>
  static void each(F&& f) {
    (f.template operator()<R>(), ...);
  }
};

/// A function that puts the tensors of one closed form up to order O at a point. `At<R, O>` has the data that formulas
/// of the element kind share there.
template <class At, Scalar R>
using PutAt = void (*)(At& at, std::span<const R> parameters, bool finite_part, std::size_t point,
                       const BatchOutput<R>& output);

/// One form in all orders, and in the scalars that it was made for, on elements whose formulas share Shared::At<R, O>:
/// what joint evaluation knows of each member.
template <class Shared>
class Member {
 public:
  template <Scalar R, int O>
  using Function = PutAt<typename Shared::template At<R, O>, R>;

  /// \tparam Form has `static void put<R, O>(...)`, a Function<R, O>, in the scalars R
  template <class Form, Scalar... R>
  static constexpr Member of() {
    Member m;
    (m.set<Form, R>(), ...);
    return m;
  }
  template <Scalar R, int O>
  Function<R, O> function() const {
    return std::get<O>(std::get<index<R>>(functions_));
  }

 private:
  template <Scalar R>
  using Orders = std::tuple<Function<R, 0>, Function<R, 1>, Function<R, 2>>;
  template <Scalar R>
  static constexpr std::size_t index = static_cast<std::size_t>(kind_of<R>());

  template <class Form, Scalar R>
  constexpr void set() {
    std::get<index<R>>(functions_) = {&Form::template put<R, 0>, &Form::template put<R, 1>, &Form::template put<R, 2>};
  }

  std::tuple<Orders<float>, Orders<double>, Orders<Mp50>, Orders<Mp100>, Orders<Mp200>> functions_{};
};

/// Runs `count` members over a batch. \param member the i-th one
template <class Shared, Scalar R, class MemberAt>
void run_members(std::size_t count, const MemberAt& member, const Batch<R>& batch,
                 std::span<const BatchOutput<R>> outputs) {
  with_order(batch.order, [&]<int O>() {
    const typename Shared::template Element<R> element(batch.corners);
    for (std::size_t p = 0; p < batch.points.size(); ++p) {
      typename Shared::template At<R, O> at(element, batch.points[p]);
      for (std::size_t m = 0; m < count; ++m)
        member(m).template function<R, O>()(at, batch.parameters, batch.finite_part, p, outputs[m]);
    }
  });
}

/// A member as Evaluation::together takes it.
template <class Shared, Scalar R>
class JointMember final : public JointForm<R> {
 public:
  /// \param member lives as long as the program
  explicit JointMember(const Member<Shared>& member) : member_(member) {}
  void together(std::span<const JointForm<R>* const> members, const Batch<R>& batch,
                std::span<const BatchOutput<R>> outputs) const override {
    const auto member = [&](std::size_t m) -> const Member<Shared>& {
      return static_cast<const JointMember*>(members[m])->member_;
    };
    run_members<Shared, R>(members.size(), member, batch, outputs);
  }

 private:
  const Member<Shared>& member_;
};

/// Gives an evaluation its functions in the scalars R. \param member lives as long as the program
template <Scalar... R, class Shared>
void set_member(Evaluation& evaluation, const Member<Shared>& member) {
  const auto set = [&]<Scalar S>() {
    evaluation.set_batch<S>([&member](const Batch<S>& batch, const BatchOutput<S>& output) {
      run_members<Shared, S>(
          1, [&](std::size_t) -> const Member<Shared>& { return member; }, batch, std::span(&output, 1));
    });
    evaluation.set_joint<S>(std::make_shared<JointMember<Shared, S>>(member));
  };
  (set.template operator()<R>(), ...);
}

}  // namespace cageproof::closed_form
