// SPDX-License-Identifier: MIT
#include "run/report_order.h"

#include "cageproof/core/coordinates/coordinates.h"
#include "cageproof/core/cage/embedded_cages.h"
#include "cageproof/validation/check.h"
#include "deformers/deformer_checks.h"
#include "cageproof/validation/regime.h"

#include <algorithm>
#include <numeric>
#include <tuple>

namespace cageproof::validation {
namespace {

// A name's place in a list, or the list's length; then the name itself.
using Rank = std::pair<std::size_t, std::string>;

template <class Range, class Name>
Rank rank_in(const Range& range, const std::string& name, Name name_of_item) {
  std::size_t place = 0;
  for (const auto& item : range) {
    if (name_of_item(item) == name) break;
    ++place;
  }
  return {place, name};
}

class Order {
 public:
  auto key(const RowKey& row) {
    const bool element = row.section == RowKey::Section::Element;
    // Rows of one cage are listed together, those of a mesh in it last; so are rows of one formula.
    const Rank cage = element ? Rank() : rank_in(cages_, row.setting, std::identity());
    return std::tuple(row.section, cage, row.place == "mesh", subject(row), element ? regime(row) : Rank(),
                      element ? check(row) : Rank(), evaluation(row), scalar(row), row.check, row.place, row.order);
  }

 private:
  static Rank subject(const RowKey& row) {
    auto formula = rank_in(catalogue(), row.subject, [](const Formula& f) { return f.name; });
    if (row.section == RowKey::Section::Element) return formula;
    if (row.section == RowKey::Section::Deformer)
      return rank_in(deformation::deform_methods(), row.subject, [](const auto& method) { return method.name; });
    const auto& kinds = coordinate_kinds();
    auto kind = rank_in(kinds, row.subject, [](const CoordinateKind& k) { return k.name; });
    return kind.first < kinds.size() ? kind : Rank{kinds.size() + formula.first, row.subject};
  }
  static Rank regime(const RowKey& row) {
    return rank_in(regimes(), row.setting, [](const Regime& r) { return r.name; });
  }
  static Rank check(const RowKey& row) {
    return rank_in(checks(), row.check, [](const auto& c) { return c->name(); });
  }
  static Rank scalar(const RowKey& row) {
    return rank_in(scalar_kinds, row.scalar, [](ScalarKind kind) { return name_of(kind); });
  }
  // The one whose evaluations a kind's rows are ordered by: of the element with the most corners.
  static std::string_view leading_formula(const CoordinateKind& kind) {
    std::string_view leading;
    for (const SummedBlock& block : kind.blocks)
      for (const ElementKind element : element_kinds)
        if (const Formula* formula = find_formula(element, block.kernel); formula && &block == &kind.blocks.front())
          leading = formula->name;
    return leading;
  }
  Rank evaluation(const RowKey& row) {
    if (row.section == RowKey::Section::Deformer) return variant(row);
    const auto [at, fresh] = evaluations_.try_emplace(row.subject);
    if (fresh) {
      const CoordinateKind* kind = find_coordinate_kind(row.subject);
      at->second =
          EvaluationRegister::instance().standard(kind ? leading_formula(*kind) : std::string_view(row.subject));
    }
    return rank_in(at->second, row.evaluation, std::identity());
  }

  static Rank variant(const RowKey& row) {
    const auto& methods = deformation::deform_methods();
    const auto method = std::ranges::find(methods, row.subject, &deformation::DeformMethod::name);
    if (method == methods.end()) return {0, row.evaluation};
    return rank_in(variants_of(*method), row.evaluation, [](const auto& v) -> const std::string& { return v.name; });
  }

  static std::vector<std::string_view> cages() {
    std::vector<std::string_view> names = embedded_cage_names();
    const auto extreme = extreme_cage_names();
    names.insert(names.end(), extreme.begin(), extreme.end());
    return names;
  }

  std::vector<std::string_view> cages_ = cages();
  std::map<std::string, std::vector<std::string>> evaluations_;
};

}  // namespace

void sort_for_report(std::vector<ResultRow>& rows) {
  Order order;
  std::vector<std::pair<decltype(order.key(RowKey())), std::size_t>> keys;
  for (std::size_t i = 0; i < rows.size(); ++i) keys.emplace_back(order.key(rows[i]), i);
  std::ranges::sort(keys);
  std::vector<ResultRow> sorted;
  sorted.reserve(rows.size());
  for (const auto& [key, i] : keys) sorted.push_back(std::move(rows[i]));
  rows = std::move(sorted);
}

}  // namespace cageproof::validation
