// SPDX-License-Identifier: MIT
#include "cageproof/core/results/tally.h"

#include <algorithm>
#include <stdexcept>

namespace cageproof {

std::string_view name_of(RowKey::Section section) {
  constexpr std::array<std::string_view, sections.size()> names{"element", "cage", "deformer"};
  return names[static_cast<std::size_t>(section)];
}

void Tally::add_to_curve(std::size_t index, std::size_t count, double error) {
  by_parameter.resize(std::max(by_parameter.size(), count), -1);
  by_parameter[index] = std::max(by_parameter[index], error);
}

void Tally::merge(const Tally& other) {
  if (unit.empty()) unit = other.unit;
  if (!other.unit.empty() && unit != other.unit)
    throw std::invalid_argument("tallies in '" + unit + "' and '" + other.unit + "' do not merge");
  if (role.empty()) role = other.role;
  errors.merge(other.errors);
  worst.merge(other.worst);
  asked += other.asked;
  without_truth += other.without_truth;
  unreached += other.unreached;
  declined += other.declined;
  max_relative = std::max(max_relative, other.max_relative);
  total_loss = std::max(total_loss, other.total_loss);
  by_parameter.resize(std::max(by_parameter.size(), other.by_parameter.size()), -1);
  for (std::size_t i = 0; i < other.by_parameter.size(); ++i)
    by_parameter[i] = std::max(by_parameter[i], other.by_parameter[i]);
}

}  // namespace cageproof

std::size_t std::hash<cageproof::RowKey>::operator()(const cageproof::RowKey& key) const noexcept {
  std::size_t seed = static_cast<std::size_t>(key.section) * 3 + static_cast<std::size_t>(key.order);
  for (const std::string* part : {&key.subject, &key.evaluation, &key.scalar, &key.setting, &key.check, &key.place})
    seed = seed * 1099511628211U + std::hash<std::string>()(*part);
  return seed;
}
