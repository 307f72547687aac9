// SPDX-License-Identifier: MIT
#include "cageproof/adaptive_qmvc/counted_rule.h"

#include <map>
#include <memory>
#include <mutex>

template <>
const cageproof::GaussLegendre<cageproof::closed_form::Counted>&
cageproof::gauss_legendre<cageproof::closed_form::Counted>(int n) {
  using closed_form::Counted;
  static std::mutex mutex;
  static std::map<int, std::unique_ptr<GaussLegendre<Counted>>> rules;
  const std::scoped_lock lock(mutex);
  auto& rule = rules[n];
  if (rule) return *rule;
  rule = std::make_unique<GaussLegendre<Counted>>();
  const auto& rounded = gauss_legendre<double>(n);
  const auto& exact = gauss_legendre<Mp200>(n);
  rule->nodes.reserve(n);
  rule->weights.reserve(n);
  for (int i = 0; i < n; ++i) {
    rule->nodes.emplace_back(rounded.nodes[i], exact.nodes[i]);
    rule->weights.emplace_back(rounded.weights[i], exact.weights[i]);
  }
  return *rule;
}
