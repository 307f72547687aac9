// SPDX-License-Identifier: MIT
// Makers of the checks, one file per kind.
#pragma once

#include "cageproof/validation/check.h"
#include "cageproof/validation/promise.h"

#include <limits>

namespace cageproof::validation {

using CheckList = std::vector<std::unique_ptr<Check>>;

void add_truth_checks(CheckList& list);         // truth, relative, integral, stated_error
void add_digits_check(CheckList& list);         // digits
void add_enclosure_check(CheckList& list);      // enclosure
void add_limit_check(CheckList& list);          // limit
void add_symmetry_checks(CheckList& list);      // scaling, rigid_motion, corner_permutation, orientation_flip
void add_identity_checks(CheckList& list);      // laplacian, subdivision, gradient_by_differences, face_jump
void add_side_relation_check(CheckList& list);  // side_relation

/// Within a check, `Role` is the check's own.
inline bool is_recommended(const Evaluation& evaluation) { return evaluation.role() == Role::Recommended; }

/// Whether the evaluation stands for the integral in multiprecision: the closed form, or, where a formula has none, the
/// recommended evaluation.
inline bool stands_for_truth(const Evaluation& evaluation) {
  const Role role = evaluation.role();
  if (role != Role::Recommended) return role == Role::ClosedForm;
  return !EvaluationRegister::instance().with_role(evaluation.formula().name, Role::ClosedForm);
}

/// Properties are asked of evaluations to rely on, where `truth` is promised: elsewhere they would only repeat how
/// wrong an evaluation is.
inline bool truth_is_promised(const Formula& formula, const Evaluation& evaluation, ScalarKind scalar,
                              std::string_view regime) {
  if (!is_recommended(evaluation) && evaluation.role() != Role::Stated) return false;
  for (int order = 0; order < 3; ++order)
    if (promise_for({"truth", formula.name, evaluation.name(), name_of(scalar), regime, order}).bound) return true;
  return false;
}

/// u of a scalar as a multiprecision number.
inline Mp100 roundoff_of(ScalarKind scalar) {
  return with_scalar(scalar, []<Scalar R>() { return Mp100(unit_roundoff<R>()); });
}

/// The finding of an order whose truth does not exist, or was not reached, or of an error to be filled in.
inline Finding finding_for(const Truth& truth, int order) {
  using Status = Finding::Status;
  Finding finding;
  finding.status = truth.exists[order] ? Status::Measured : truth.required[order] ? Status::Unreached : Status::NoTruth;
  return finding;
}

/// The findings, up to an order, at a sample that is no input.
inline std::array<Finding, 3> without_truth(int order) {
  std::array<Finding, 3> findings;
  for (int o = 0; o <= order; ++o) findings[o].status = Finding::Status::NoTruth;
  return findings;
}

/// Whether a tensor of this size has all of R's digits: it is within R's range, and not next to R's smallest numbers.
template <Scalar R>
bool representable(const Mp100& size) {
  if constexpr (is_multiprecision<R>) return true;
  else return size == 0 || (size < std::numeric_limits<R>::max() / 16 && size > std::numeric_limits<R>::min() * 16);
}

/// As finding_for(), of a relation between results in double: where the truth leaves their normal range, there is
/// nothing to relate.
inline Finding relation_finding_for(const Truth& truth, int order) {
  Finding finding = finding_for(truth, order);
  if (finding.status == Finding::Status::Measured && !representable<double>(truth.norm[order]))
    finding.status = Finding::Status::NoTruth;
  return finding;
}

/// Norm of a difference over a denominator; infinite where either is not finite or where only the denominator is zero.
template <Scalar R>
double ratio_of_difference(const std::vector<R>& a, const std::vector<R>& b, const Mp100& denominator) {
  std::vector<Mp100> wide(a.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    // In the operands' own precision: the difference may be below 100 digits of either.
    if constexpr (is_multiprecision<R>) wide[i] = Mp100(R(a[i] - b[i]));
    else wide[i] = Mp100(a[i]) - Mp100(b[i]);
  }
  const Mp100 error = norm(wide);
  if (error == 0) return 0;
  if (!isfinite(error) || denominator == 0) return std::numeric_limits<double>::infinity();
  return static_cast<double>(Mp100(error / denominator));
}

}  // namespace cageproof::validation
