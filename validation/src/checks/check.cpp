// SPDX-License-Identifier: MIT
#include "checks/check_makers.h"

#include <algorithm>

namespace cageproof::validation {

const std::vector<std::unique_ptr<Check>>& checks() {
  static const CheckList all = [] {
    CheckList list;
    add_truth_checks(list);
    add_digits_check(list);
    add_enclosure_check(list);
    add_limit_check(list);
    add_symmetry_checks(list);
    add_identity_checks(list);
    add_side_relation_check(list);
    return list;
  }();
  return all;
}

const Check* find_check(std::string_view name) {
  const auto found = std::ranges::find_if(checks(), [&](const auto& check) { return check->name() == name; });
  return found == checks().end() ? nullptr : found->get();
}

std::vector<std::string_view> check_names() {
  std::vector<std::string_view> names;
  for (const auto& check : checks()) names.push_back(check->name());
  return names;
}

}  // namespace cageproof::validation
