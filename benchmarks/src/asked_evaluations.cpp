// SPDX-License-Identifier: MIT
#include "asked_evaluations.h"

#include "cageproof/core/input_error.h"
#include "cageproof/core/catalogue/name_pattern.h"
#include "cageproof/core/catalogue/unknown_name.h"
#include "cageproof/core/coordinates/whole_evaluation.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <iterator>

namespace cageproof::benchmarks {
namespace {

// Evaluations of a family that work-precision shows when none are asked for.
const std::vector<std::string>& shown_of(const EvaluationFamily& family) {
  const bool form = family.role == Role::Recommended || family.role == Role::ClosedForm || family.role == Role::Plain ||
                    family.role == Role::Printed;
  return form ? family.standard : family.studied;
}

// Keeps those names that all formulas have in double with these derivatives, and notes those it leaves out. Names that
// were asked for one by one are not passed here.
std::vector<std::string> that_exist(std::vector<std::string> names, const std::vector<std::string_view>& formulas,
                                    int order, std::vector<std::string>& notes) {
  std::vector<std::string> left_out;
  std::erase_if(names, [&](const std::string& name) {
    bool exists = true, gives_order = true;
    for (const auto formula : formulas) {
      const auto evaluation = EvaluationRegister::instance().find(formula, name);
      exists = exists && evaluation && evaluation->supports<double>();
      gives_order = gives_order && evaluation && evaluation->max_order() >= order;
    }
    if (exists && !gives_order) left_out.push_back(name);
    return !exists || !gives_order;
  });
  if (!left_out.empty())
    notes.push_back(
        fmt::format("left out, they give no derivatives of order {}: {}", order, fmt::join(left_out, ", ")));
  return names;
}

// All evaluations of formulas that may be shown, by role in this order.
std::vector<std::string> all_shown(const std::vector<std::string_view>& formulas) {
  std::vector<std::string> names;
  for (const Role role : {Role::Scheme, Role::Rule, Role::Recommended, Role::ClosedForm, Role::Plain, Role::Printed})
    for (const EvaluationFamily* family : EvaluationRegister::instance().families(formulas.back()))
      if (family->role == role) names.insert(names.end(), shown_of(*family).begin(), shown_of(*family).end());
  return names;
}

}  // namespace

std::vector<std::vector<Evaluation>> find_all(const Subject& subject, const WorkPrecisionOptions& options) {
  if (options.evaluations.empty()) throw InputError("no evaluation to measure");
  std::vector<std::string> missing;
  std::vector<std::vector<Evaluation>> found;
  for (const std::string& name : options.evaluations) {
    auto& row = found.emplace_back();
    if (subject.has_whole(name)) continue;
    const bool exists = std::ranges::any_of(subject.formulas, [&](std::string_view formula) {
      return EvaluationRegister::instance().find(formula, name).has_value();
    });
    if (!exists) {
      missing.push_back(why_no_evaluation(subject.name, subject.formulas, name, subject.whole));
      continue;
    }
    for (const auto formula : subject.formulas) {
      auto e = EvaluationRegister::instance().find(formula, name);
      if (!e) missing.push_back(why_no_evaluation(formula, name));
      else if (!e->supports<double>()) missing.push_back(fmt::format("'{}' of {} has no double", name, formula));
      else if (e->max_order() < options.order)
        missing.push_back(fmt::format("'{}' of {} gives no derivatives of order {}", name, formula, options.order));
      else row.push_back(std::move(*e));
    }
  }
  if (!missing.empty()) throw InputError(fmt::format("{}", fmt::join(missing, "; ")));
  return found;
}

std::vector<std::string> evaluations_asked(const std::vector<std::string>& given, const Subject& subject, int order,
                                           std::vector<std::string>& notes) {
  if (given.empty()) {
    std::vector<std::string> names = that_exist(all_shown(subject.formulas), subject.formulas, order, notes);
    for (const std::string_view name : subject.whole)
      if (find_whole_evaluation(name)->role == Role::Batched) names.emplace_back(name);
    return names;
  }
  std::vector<std::string> known = all_shown(subject.formulas), chosen;
  for (const EvaluationFamily* family : EvaluationRegister::instance().families(subject.formulas.back()))
    known.insert(known.end(), family->standard.begin(), family->standard.end());
  std::vector<std::string_view> all{known.begin(), known.end()};
  all.insert(all.end(), subject.whole.begin(), subject.whole.end());
  const auto choose = [&](std::string_view name) {
    if (std::ranges::find(chosen, name) == chosen.end()) chosen.emplace_back(name);
  };
  for (const std::string& list : given)
    for (const std::string& name : names_in(list)) {
      if (!is_glob(name)) {
        choose(name);
        continue;
      }
      require_known(fmt::format("evaluation of {}", subject.name), name, all);
      std::vector<std::string> found;
      std::ranges::copy_if(known, std::back_inserter(found), [&](const auto& one) { return matches(name, one); });
      for (const std::string& one : that_exist(found, subject.formulas, order, notes)) choose(one);
      for (const std::string_view one : subject.whole)
        if (matches(name, one)) choose(one);
    }
  if (chosen.empty())
    throw InputError(
        fmt::format("no evaluation of {} that is asked for gives derivatives of order {}", subject.name, order));
  return chosen;
}

}  // namespace cageproof::benchmarks
