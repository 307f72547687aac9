// SPDX-License-Identifier: MIT
#include "gauss_nodes.h"

#include <arb_hypgeom.h>

#include <map>
#include <mutex>

namespace cageproof::quadrature_ref::certified {

std::shared_ptr<const HalfRule> half_rule(int n, slong bits) {
  static std::mutex mutex;
  static std::map<std::pair<int, slong>, std::shared_ptr<const HalfRule>> known;
  {
    const std::scoped_lock lock(mutex);
    if (const auto found = known.find({n, bits}); found != known.end()) return found->second;
  }
  // Outside the lock: two threads may compute the same rule, and find the same numbers.
  auto rule = std::make_shared<HalfRule>();
  rule->nodes.resize(n / 2);
  rule->weights.resize(n / 2);
  for (int k = 0; k < n / 2; ++k)
    arb_hypgeom_legendre_p_ui_root(rule->nodes[k].raw(), rule->weights[k].raw(), static_cast<ulong>(n),
                                   static_cast<ulong>(k), bits);
  const std::scoped_lock lock(mutex);
  return known.emplace(std::pair(n, bits), std::move(rule)).first->second;
}

}  // namespace cageproof::quadrature_ref::certified
