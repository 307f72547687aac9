// SPDX-License-Identifier: MIT
// The checks that compare with the truth.
#include "checks/check_makers.h"

#include "cageproof/validation/hunt.h"

#include <algorithm>
#include <cmath>

namespace cageproof::validation {
namespace {

/// The finding of one order of an evaluation's tensors, whose error is to be filled in where it is measured. Where the
/// truth has entries that are infinite or have no limit, evaluations that are made to know it are compared entry by
/// entry; rules and printed forms are not asked. Where it has no limit at all there is nothing to measure, unless the
/// evaluation gives one.
template <Scalar R>
Finding finding_of(const Result<R>& f, const Truth& truth, const Evaluation& evaluation, int order) {
  Finding finding = finding_for(truth, order);
  const Role role = evaluation.role();
  const bool knows_limits = role == Role::Recommended || role == Role::ClosedForm || role == Role::Stated;
  if (finding.status != Finding::Status::NoTruth || !truth.partial[order] || !knows_limits) return finding;
  const auto no_limit = [](const auto& x) {
    using std::isnan;
    return static_cast<bool>(isnan(x));
  };
  if (!std::ranges::all_of(truth.tensors.of(order), no_limit) || !std::ranges::all_of(f.of(order), no_limit))
    finding.status = Finding::Status::Measured;
  return finding;
}

/// Whether a tensor that is asked for is exactly zero. An evaluation states its digits, and whether they suffice, for
/// all tensors asked for together, and no relative statement can be made of that one.
bool has_zero(const Truth& truth, int order) {
  for (int o = 0; o <= order; ++o)
    if (truth.exists[o] && truth.norm[o] == 0) return true;
  return false;
}

/// Whether an evaluation that states its error does so in a scalar that people compute in.
bool is_stated_in(ScalarKind scalar, const Evaluation& evaluation) {
  return (scalar == ScalarKind::Double || scalar == ScalarKind::Float) && evaluation.role() == Role::Stated;
}

/// An evaluation against the truth, in conditioned units.
class TruthCheck final : public Check {
 public:
  std::string_view name() const override { return "truth"; }
  Use use() const override { return Use::Truth; }
  std::string_view description() const override { return "against the truth, in units of rounding times conditioning"; }
  bool applies(const Formula&, const Evaluation& evaluation, ScalarKind scalar, std::string_view) const override {
    // In multiprecision the closed form is the truth's own source: `integral` is its check. Float is asked
    // for where people compute in it.
    const Role role = evaluation.role();
    if (role == Role::Integral) return false;
    return scalar == ScalarKind::Double || is_stated_in(scalar, evaluation) ||
           (scalar == ScalarKind::Float &&
            (role == Role::Recommended || role == Role::ClosedForm || role == Role::Plain || role == Role::Printed));
  }
  std::array<Finding, 3> measure(const CheckInput& in) const override {
    if (!is_finite(in.sample)) return without_truth(in.order);
    return with_scalar(in.scalar, [&]<Scalar R>() {
      const Result<R>& f = in.result<R>();
      const Mp100 u = roundoff_of(in.scalar);
      std::array<Finding, 3> findings;
      for (int o = 0; o <= in.order; ++o) {
        findings[o] = finding_of(f, in.truth, in.evaluation, o);
        if (findings[o].status != Finding::Status::Measured) continue;
        if (!f.converged && !has_zero(in.truth, in.order)) findings[o].status = Finding::Status::Declined;
        findings[o].error = conditioned_error(f, in.truth, o, u);
        findings[o].relative = relative_error(f, in.truth, o);
        findings[o].total_loss = score_of_total_loss(in.truth, o, u);
        findings[o].entry = furthest_entry(f, in.truth, o);
        findings[o].found = static_cast<double>(f.of(o)[static_cast<std::size_t>(findings[o].entry)]);
      }
      return findings;
    });
  }
};

/// An evaluation that promises its digits whatever the conditioning, against the truth.
class RelativeCheck final : public Check {
 public:
  std::string_view name() const override { return "relative"; }
  std::string_view unit() const override { return "units of u"; }
  std::string_view description() const override { return "plain relative error, norm-wise, in units of rounding"; }
  bool applies(const Formula&, const Evaluation& evaluation, ScalarKind scalar, std::string_view) const override {
    return is_stated_in(scalar, evaluation);
  }
  std::array<Finding, 3> measure(const CheckInput& in) const override {
    if (!is_finite(in.sample)) return without_truth(in.order);
    return with_scalar(in.scalar, [&]<Scalar R>() {
      const Result<R>& f = in.result<R>();
      std::array<Finding, 3> findings;
      for (int o = 0; o <= in.order; ++o) {
        findings[o] = finding_of(f, in.truth, in.evaluation, o);
        if (findings[o].status != Finding::Status::Measured) continue;
        findings[o].relative = relative_error(f, in.truth, o);
        findings[o].error = findings[o].relative / static_cast<double>(unit_roundoff<R>());
      }
      return findings;
    });
  }
};

/// The closed form in multiprecision against the integral of the kernel, which proves that it can stand for the truth.
/// Where the integral does not exist, no sample has a truth, and nothing measured counts.
class IntegralCheck final : public Check {
 public:
  std::string_view name() const override { return "integral"; }
  Use use() const override { return Use::Gate; }
  std::string_view unit() const override { return "relative"; }
  std::string_view description() const override {
    return "what stands for the truth in multiprecision against the multiprecision integral of the kernel";
  }
  bool applies(const Formula&, const Evaluation& evaluation, ScalarKind scalar, std::string_view) const override {
    return stands_for_truth(evaluation) && scalar == ScalarKind::Digits100;
  }
  std::array<Finding, 3> measure(const CheckInput& in) const override {
    std::array<Finding, 3> findings;
    const auto integral = EvaluationRegister::instance().with_role(in.formula.name, Role::Integral);
    if (!integral) {
      for (int o = 0; o <= in.order; ++o) findings[o].status = Finding::Status::NoTruth;
      return findings;
    }
    const Result<Mp100>& closed = in.result<Mp100>();
    const Result<Mp50> truth = evaluate<Mp50>(*integral, in.sample, in.order);
    for (int o = 0; o <= in.order; ++o) {
      std::vector<Mp100> reference;
      bool limit = true;
      reference.reserve(truth.of(o).size());
      for (const Mp50& x : truth.of(o)) {
        reference.emplace_back(x);
        limit = limit && !isnan(x);
      }
      // An integral that stops short of its digits declines; one that finds no limit where there is one does not.
      const auto missing = !in.truth.required[o] ? Finding::Status::NoTruth
                           : truth.converged     ? Finding::Status::Unreached
                                                 : Finding::Status::Declined;
      findings[o].status = truth.converged && limit ? Finding::Status::Measured : missing;
      // Where the integral has no limit the closed form must not invent one.
      bool finite = true;
      for (const Mp100& x : closed.of(o)) finite = finite && isfinite(x);
      if (truth.converged && !limit && finite) {
        findings[o].status = Finding::Status::Measured;
        findings[o].error = std::numeric_limits<double>::infinity();
        continue;
      }
      if (findings[o].status == Finding::Status::Measured)
        findings[o].relative = findings[o].error = ratio_of_difference(closed.of(o), reference, norm(reference));
    }
    return findings;
  }
};

// Whether a tensor is so small next to what a rounding of the input changes that 200 digits cannot tell it from a zero
// of the function close by: over the centre of an equilateral triangle, 1e-250 next to a Hessian's zero.
bool is_next_to_zero(const Truth& truth, int order) {
  static const Mp100 small("1e-130");
  for (int o = 0; o <= order; ++o)
    if (truth.exists[o] && truth.norm[o] < small * truth.conditioned[o]) return true;
  return false;
}

// Whether a tensor of an order up to this one is so small that R's numbers lie further apart there than its last
// digits: one statement is made of all orders, and one of a single rounding may have no digit.
template <Scalar R>
bool has_subnormal(const Truth& truth, int order) {
  for (int o = 0; o <= order; ++o)
    if (truth.exists[o] && truth.norm[o] < 1 && !representable<R>(truth.norm[o])) return true;
  return false;
}

/// An evaluation that states how wrong it may be must be right about it.
class StatedErrorCheck final : public Check {
 public:
  std::string_view name() const override { return "stated_error"; }
  std::string_view unit() const override { return "of what is stated"; }
  std::string_view description() const override {
    return "error over the evaluation's own statement of it: above one the statement is false";
  }
  bool applies(const Formula&, const Evaluation& evaluation, ScalarKind scalar, std::string_view) const override {
    return is_stated_in(scalar, evaluation) || (evaluation.states_error() && scalar == ScalarKind::Double);
  }
  std::array<Finding, 3> measure(const CheckInput& in) const override {
    if (!is_finite(in.sample)) return without_truth(in.order);
    return with_scalar(in.scalar, [&]<Scalar R>() {
      const Result<R>& f = in.result<R>();
      std::array<Finding, 3> findings;
      for (int o = 0; o <= in.order; ++o) {
        // Beside infinite entries there is no norm for a statement to be relative to.
        findings[o] = finding_for(in.truth, o);
        if (findings[o].status != Finding::Status::Measured) continue;
        // No digit stated: it says that it could not, where it owes a statement.
        const bool owed = in.truth.required[o] && !has_zero(in.truth, in.order) &&
                          !is_next_to_zero(in.truth, in.order) && !has_subnormal<R>(in.truth, in.order);
        if (!(f.stated_digits > 0)) findings[o].status = owed ? Finding::Status::Declined : Finding::Status::NoTruth;
        // A relative statement says nothing about truths that the scalar cannot hold, or about a zero that is met.
        if (!representable<R>(in.truth.norm[o])) findings[o].status = Finding::Status::NoTruth;
        const double relative = relative_error(f, in.truth, o);
        if (in.truth.norm[o] == 0 && relative == 0) findings[o].status = Finding::Status::NoTruth;
        if (findings[o].status != Finding::Status::Measured) continue;
        findings[o].relative = relative;
        findings[o].error = error_over_digits(f, in.truth, o, f.stated_digits);
      }
      return findings;
    });
  }
};

}  // namespace

void add_truth_checks(CheckList& list) {
  list.push_back(std::make_unique<TruthCheck>());
  list.push_back(std::make_unique<RelativeCheck>());
  list.push_back(std::make_unique<IntegralCheck>());
  list.push_back(std::make_unique<StatedErrorCheck>());
}

}  // namespace cageproof::validation
