// SPDX-License-Identifier: MIT
// The order in which a report has its rows: that of the lists which the names are from, unknown names last.
#include "run/report_order.h"

#include "cageproof/core/coordinates/coordinates.h"
#include "cageproof/core/cage/embedded_cages.h"
#include "cageproof/core/catalogue/formula.h"
#include "cageproof/validation/check.h"
#include "deformers/deformer_checks.h"
#include "cageproof/validation/regime.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace cageproof::validation {
namespace {

using Section = RowKey::Section;

// Rows come out in this order, whatever order they came in.
void expect_order(const std::vector<RowKey>& keys) {
  std::vector<ResultRow> rows(keys.size());
  for (std::size_t i = 0; i < keys.size(); ++i) {
    static_cast<RowKey&>(rows[i]) = keys[keys.size() - 1 - i];
    rows[i].samples = keys.size() - 1 - i;
  }
  for (int turn = 0; turn < 2; ++turn) {
    sort_for_report(rows);
    ASSERT_EQ(rows.size(), keys.size());
    for (std::size_t i = 0; i < keys.size(); ++i) {
      EXPECT_EQ(static_cast<const RowKey&>(rows[i]), keys[i]) << i;
      EXPECT_EQ(rows[i].samples, i) << "a row keeps its figures";
    }
    std::ranges::rotate(rows, rows.begin() + 1);
  }
}

RowKey element(std::string_view formula, std::string_view regime, std::string_view check, const char* evaluation,
               const char* scalar, int order) {
  return {Section::Element,    std::string(formula), evaluation, scalar,
          std::string(regime), std::string(check),   "",         order};
}

RowKey in_cage(std::string_view kind, std::string_view cage, const char* check, const char* place) {
  return {Section::Cage, std::string(kind), "closed_form", "double", std::string(cage), check, place, 0};
}

TEST(report_order, of_elements_is_formula_regime_check_evaluation_scalar_order) {
  const auto formula = [](int i) { return std::next(catalogue().begin(), i)->name; };
  const std::string_view first = formula(0), second = formula(1), none = "a formula of nobody's";
  const auto& checked = checks();
  ASSERT_GT(checked.size(), 1u);
  const std::string check = std::string(checked.front()->name()), later = std::string(checked.back()->name());
  const std::string regime = std::string(regimes().front().name), rim = std::string(regimes()[1].name);
  const auto names = EvaluationRegister::instance().standard(first);
  ASSERT_GT(names.size(), 1u);
  const char *lead = names[0].c_str(), *other = names[1].c_str();
  expect_order({element(first, regime, check, lead, "float", 2), element(first, regime, check, lead, "double", 0),
                element(first, regime, check, lead, "double", 1), element(first, regime, check, lead, "a scalar", 0),
                element(first, regime, check, other, "double", 0), element(first, regime, check, "a rule", "double", 0),
                element(first, regime, later, lead, "double", 0), element(first, regime, "a check", lead, "double", 0),
                element(first, rim, check, lead, "double", 0), element(first, "a regime", check, lead, "double", 0),
                element(second, regime, check, lead, "double", 0), element(none, regime, check, lead, "double", 0),
                in_cage("a kind", "a cage", "a check", "")});
}

TEST(report_order, of_cages_is_cage_mesh_last_kind_check_place) {
  const auto embedded = embedded_cage_names(), extreme = extreme_cage_names();
  ASSERT_GT(embedded.size(), 1u);
  const auto& kinds = coordinate_kinds();
  const std::string_view kind = kinds.front().name, last = kinds.back().name, summed = catalogue().begin()->name;
  const std::string_view second = std::next(catalogue().begin())->name;
  expect_order({in_cage(kind, embedded[0], "b", "outside"), in_cage(kind, embedded[0], "c", "inside"),
                in_cage(kind, embedded[0], "c", "outside"), in_cage(last, embedded[0], "a", "inside"),
                in_cage(summed, embedded[0], "a", "inside"), in_cage(second, embedded[0], "a", "inside"),
                in_cage("0 kind of nobody's", embedded[0], "a", "inside"), in_cage(kind, embedded[0], "a", "mesh"),
                in_cage(last, embedded[0], "a", "mesh"), in_cage(kind, embedded[1], "a", "inside"),
                in_cage(kind, extreme.front(), "a", "inside"), in_cage(kind, "0.obj", "a", "inside"),
                in_cage(kind, "1.obj", "a", "inside")});
}

TEST(report_order, of_deformers_is_cage_method_variant) {
  const auto& methods = deformation::deform_methods();
  const auto method = std::ranges::find_if(methods, [](const auto& m) { return variants_of(m).size() > 1; });
  ASSERT_NE(method, methods.end());
  const auto variants = variants_of(*method);
  const auto row = [](std::string_view name, std::string_view variant, std::string_view cage) {
    return RowKey{Section::Deformer, std::string(name), std::string(variant), "double", std::string(cage), "a", "", 0};
  };
  const auto cages = embedded_cage_names();
  std::vector<RowKey> keys;
  keys.reserve(variants.size() + methods.size() + 3);
  for (const auto& variant : variants) keys.push_back(row(method->name, variant.name, cages[0]));
  keys.push_back(row(method->name, "0", cages[0]));
  for (auto next = std::next(method); next != methods.end(); ++next) keys.push_back(row(next->name, "z", cages[0]));
  keys.push_back(row("0", "", cages[0]));
  keys.push_back(row(methods.front().name, "", cages[1]));
  keys.insert(keys.begin(), in_cage("z", "z", "z", "mesh"));
  expect_order(keys);
}

}  // namespace
}  // namespace cageproof::validation
