// SPDX-License-Identifier: MIT
#include "weights_next_to_cage.h"

namespace cageproof {

// Finds evaluations in more digits of a normalised kind: its own if they keep a promise by more digits and have
// these, and the recommended ones of those that have none. \return false where others show what they lose, or take
// their time
bool WeightsNextToCage::find_evaluations() {
  for (std::size_t kind = 0; kind < sum_.evaluations.size(); ++kind) {
    if (sum_.evaluations[kind].empty()) continue;
    const Evaluation& own = sum_.evaluations[kind].front();
    const Role role = own.role();
    if (role != Role::Recommended && role != Role::ClosedForm && role != Role::Stated) return false;
    const auto recommended = EvaluationRegister::instance().with_role(own.formula().name, Role::Recommended);
    more_digits_[kind] = own.supports<Mp200>() || !recommended ? own : *recommended;
    const Evaluation& more = more_digits_[kind];
    if (!more.supports<Mp50>() || !more.supports<Mp100>() || !more.supports<Mp200>()) return false;
  }
  return true;
}

std::unique_ptr<const WeightsNextToCage> WeightsNextToCage::make(const Summands& sum) {
  std::unique_ptr<WeightsNextToCage> weights(new WeightsNextToCage(sum));
  if (!weights->find_evaluations()) return nullptr;
  return weights;
}

}  // namespace cageproof
