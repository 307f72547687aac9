// SPDX-License-Identifier: MIT
#include "cageproof/core/results/partial_result.h"

#include <algorithm>
#include <limits>
#include <stdexcept>

namespace cageproof {
namespace {

// Room for all samples of the field, none there yet.
FieldPart empty_field(const FieldPart& part) {
  FieldPart whole = part;
  whole.first = 0;
  for (ImageField::Array& array : whole.image.arrays)
    array.values.assign(part.samples * array.components, std::numeric_limits<double>::quiet_NaN());
  return whole;
}

void put(const FieldPart& part, FieldPart& whole) {
  bool fits = whole.image.name == part.image.name && whole.samples == part.samples &&
              whole.image.arrays.size() == part.image.arrays.size();
  for (std::size_t a = 0; fits && a < part.image.arrays.size(); ++a) {
    const ImageField::Array& from = part.image.arrays[a];
    std::vector<double>& to = whole.image.arrays[a].values;
    const std::size_t begin = part.first * from.components;
    fits = begin <= to.size() && from.values.size() <= to.size() - begin;
    if (fits) std::ranges::copy(from.values, to.begin() + static_cast<std::ptrdiff_t>(begin));
  }
  if (!fits) throw std::invalid_argument("a part of the field '" + whole.image.name + "' does not fit");
}

}  // namespace

void PartialResult::merge(PartialResult other) {
  for (auto& [key, tally] : other.rows) {
    const auto [at, fresh] = rows.try_emplace(key, std::move(tally));
    if (!fresh) at->second.merge(tally);
  }
  fields.merge(other.fields);
  meshes.merge(other.meshes);
  errata.merge(other.errata);
  for (auto& [reason, names] : other.refused) refused[reason].merge(names);
}

void PartialResult::drop_unwanted(const PartialResult& so_far) {
  for (auto& [key, tally] : rows) {
    const auto known = so_far.rows.find(key);
    if (known == so_far.rows.end()) continue;
    WorstCases wanted;
    for (const WorstCase& c : tally.worst.cases())
      if (known->second.worst.wants(c.error, c.sample)) wanted.add(c);
    tally.worst = std::move(wanted);
  }
}

std::map<int, FieldPart> whole_fields(const PartialResult& gathered) {
  std::map<int, FieldPart> whole;
  for (const auto& [at, part] : gathered.fields) {
    const auto [field, fresh] = whole.try_emplace(at.first);
    if (fresh) field->second = empty_field(part);
    put(part, field->second);
  }
  return whole;
}

}  // namespace cageproof
