// SPDX-License-Identifier: MIT
#include "cageproof/quadrature_ref/norm_integral.h"

#include "rule_family.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace cageproof::quadrature_ref {
namespace {

// The norm of another kernel, as the first of its entries.
class NormKernel final : public Kernel<double> {
 public:
  explicit NormKernel(const Kernel<double>& kernel) : kernel_(kernel) {}
  void accumulate(std::span<const Node<double>> nodes, const KernelTask<double>& task,
                  Result<double>& sums) const override {
    Result<double> one;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      one.value.assign(sums.value.size(), 0);
      kernel_.accumulate(nodes.subspan(i, 1), task, one);
      double square = 0;
      for (const double x : one.value) square += x * x;
      sums.value[0] += std::sqrt(square);
    }
  }

 private:
  const Kernel<double>& kernel_;
};

}  // namespace

double norm_integral(const Formula& formula, const Query<double>& query) {
  const auto own = kernels_of(formula.name);
  if (!own) return std::numeric_limits<double>::quiet_NaN();
  const auto norms = std::make_shared<KernelSet>();
  norms->set<double>(formula.dim(), std::make_unique<NormKernel>(own->at<double>(formula.dim())));
  const std::vector<RuleFamily>& rules = rules_of(formula.element);
  const auto graded = std::ranges::find(rules, "near-singular-<N>", &RuleFamily::pattern);
  const RuleFamily& rule =
      graded != rules.end() ? *graded : *std::ranges::find(rules, "adaptive", &RuleFamily::pattern);
  Query<double> value = query;
  value.order = 0;
  Result<double> found;
  found.reset(formula.components(), formula.dim(), 0);
  const int points_a_panel = 16;
  evaluation_of(rule, rule.pattern, points_a_panel, formula, norms)(value, found);
  return found.value[0];
}

}  // namespace cageproof::quadrature_ref
