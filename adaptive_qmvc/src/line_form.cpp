// SPDX-License-Identifier: MIT
// Registers the line form: `closed_form`, and `line-<digits>` for those who want fewer digits sooner.
#include "line_form.h"

#include <charconv>

namespace cageproof::adaptive_qmvc {
namespace {

constexpr std::string_view kFormula = "quad.mean_value";

// Digits of the integral that closed_form asks for: a little over what a double holds, and enough in multiprecision for the differences that
// yardsticks and checks take of it.
template <Scalar R>
constexpr double own_digits() {
  return std::same_as<R, Mp50> ? 36 : std::same_as<R, Mp100> ? 48 : std::same_as<R, Mp200> ? 90 : 17;
}

template <Scalar R>
void in_own_scalar(const Query<R>& query, double digits, Result<R>& result) {
  if constexpr (std::same_as<R, float>) {
    std::vector<Vec3<double>> corners;
    for (const Vec3<float>& corner : query.corners) corners.push_back(convert<double>(corner));
    Result<double> wide;
    line_weights<double>({corners, convert<double>(query.point), query.order, {}}, digits, wide);
    result.reset(4, 3, query.order);
    for (int o = 0; o <= query.order; ++o)
      for (std::size_t i = 0; i < wide.of(o).size(); ++i) result.of(o)[i] = static_cast<float>(wide.of(o)[i]);
    result.nodes = wide.nodes;
  } else {
    line_weights<R>(query, digits, result);
  }
}

Evaluation evaluation(std::string_view name, std::string description, std::optional<double> digits) {
  Evaluation made(std::string(kFormula), std::string(name), std::move(description));
  for (const ScalarKind kind : scalar_kinds)
    with_scalar(kind, [&]<Scalar R>() {
      made.set<R>([digits](const Query<R>& query, Result<R>& result) {
        in_own_scalar<R>(query, digits.value_or(own_digits<R>()), result);
      });
    });
  return made;
}

const RegisterEvaluation closed{{std::string(kFormula), "closed_form", {"closed_form"},
                                 [](std::string_view name) -> std::optional<Evaluation> {
                                   if (name != "closed_form") return std::nullopt;
                                   Evaluation made = evaluation(name, "line form: elementary along lines, Gauss-Legendre across them", std::nullopt);
                                   made.set_substitutes({"line-36", "line-46", "line-14"});
                                   return made;
                                 }}};

const RegisterEvaluation line{{std::string(kFormula), "line-<digits>", {"line-12"},
                               [](std::string_view name) -> std::optional<Evaluation> {
                                 if (!name.starts_with("line-")) return std::nullopt;
                                 const std::string_view text = name.substr(5);
                                 int digits = 0;
                                 const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), digits);
                                 if (error != std::errc() || end != text.data() + text.size() || text.starts_with('0') || digits < 2 || digits > 90)
                                   return std::nullopt;
                                 return evaluation(name, "line form to that many digits", digits);
                               }}};

}  // namespace
}  // namespace cageproof::adaptive_qmvc
