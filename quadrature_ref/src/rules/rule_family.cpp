// SPDX-License-Identifier: MIT
#include "rule_family.h"

#include "cageproof/core/catalogue/unknown_name.h"

#include <map>

namespace cageproof::quadrature_ref {
namespace {

template <Scalar R>
Integrand integrand_of(const Formula& row, const KernelSet& kernels, std::span<const R> parameters) {
  if (row.behaviour_of == nullptr) return {row, kernels, row.degree};
  std::vector<double> given;
  for (const R& p : parameters) given.push_back(static_cast<double>(p));
  return {row, kernels, row.behaviour(given).degree};
}

std::map<std::string, std::shared_ptr<const KernelSet>, std::less<>>& registered_kernels() {
  static std::map<std::string, std::shared_ptr<const KernelSet>, std::less<>> kernels;
  return kernels;
}

}  // namespace

const std::vector<RuleFamily>& rules_of(ElementKind kind) {
  // In the order of ElementKind.
  static const std::array<std::vector<RuleFamily>, element_kinds.size()> table{segment::families(),
                                                                               triangle::families(), quad::families()};
  return table[static_cast<std::size_t>(kind)];
}

void register_rules(ElementKind kind, std::string_view kernel, const std::shared_ptr<const KernelSet>& kernels) {
  const std::string formula = std::string(name_of(kind)) + "." + std::string(kernel);
  registered_kernels()[formula] = kernels;
  for (const RuleFamily& family : rules_of(kind)) {
    state_range(family.pattern, family.number.range);
    EvaluationRegister::instance().add(
        {formula,
         family.pattern,
         family.facts.role,
         family.standard,
         [&family, kernels, formula](std::string_view name) -> std::optional<Evaluation> {
           const auto number = family.number(name);
           const Formula* row = number ? find_formula(formula) : nullptr;
           if (row == nullptr) return std::nullopt;
           return evaluation_of(family, name, *number, *row, kernels);
         },
         {},
         family.studied});
  }
}

Evaluation evaluation_of(const RuleFamily& family, std::string_view name, int number, const Formula& row,
                         const std::shared_ptr<const KernelSet>& kernels) {
  Evaluation result(row.name, name, family.facts);
  for (const ScalarKind kind : scalar_kinds)
    with_scalar(kind, [&]<Scalar R>() {
      const RuleFunctions<R>& rule = std::get<RuleFunctions<R>>(family.functions);
      if (rule.block)
        result.set_batch<R>([&row, &rule, kernels, number](const Batch<R>& batch, const BatchOutput<R>& output) {
          rule.block(integrand_of(row, *kernels, batch.parameters), number, batch, output);
        });
      if (rule.point)
        result.set_point<R>([&row, &rule, kernels, number](const Query<R>& query, Result<R>& tensors) {
          rule.point(integrand_of(row, *kernels, query.parameters), number, query, tensors);
        });
    });
  return result;
}

std::shared_ptr<const KernelSet> kernels_of(std::string_view formula) {
  const auto found = registered_kernels().find(formula);
  return found == registered_kernels().end() ? nullptr : found->second;
}

RegisterKernel::RegisterKernel(std::string_view kernel, const std::shared_ptr<const KernelSet>& kernels) {
  for (const ElementKind kind : element_kinds)
    if (kernels->defined_in(dimension(kind))) register_rules(kind, kernel, kernels);
}

}  // namespace cageproof::quadrature_ref
