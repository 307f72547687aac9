// SPDX-License-Identifier: MIT
// Foreign code as evaluations.
#include "cageproof/core/catalogue/name_pattern.h"
#include "cageproof/core/input_error.h"
#include "cageproof/judge/foreign.h"
#include "cageproof/judge/foreign_code.h"

#include <fmt/format.h>

#include <limits>

namespace cageproof::judge {
namespace {

template <Scalar R>
void add_numbers(std::vector<double>& numbers, const Vec3<R>& point, int dim) {
  for (int c = 0; c < dim; ++c) numbers.push_back(static_cast<double>(point[c]));
}

template <Scalar R>
Asked asked_of(const Batch<R>& batch, int dim) {
  Asked asked;
  asked.count = batch.points.size();
  for (const Vec3<R>& corner : batch.corners) add_numbers(asked.corners, corner, dim);
  for (const Vec3<R>& point : batch.points) add_numbers(asked.points, point, dim);
  for (const R& p : batch.parameters) asked.parameters.push_back(static_cast<double>(p));
  return asked;
}

// A result that was not given is none; where the code declined it says so.
template <Scalar R>
void evaluate(ForeignCode& code, const Formula& formula, const Batch<R>& batch, const BatchOutput<R>& output) {
  const Asked asked = asked_of(batch, formula.dim());
  const Answer answer = code.ask({&formula, batch.order, std::is_same_v<R, float>}, {&asked, 1}).front();
  std::vector<R> tensor;
  std::size_t size = static_cast<std::size_t>(formula.components());
  for (int o = 0; o <= batch.order; ++o, size *= static_cast<std::size_t>(formula.dim()))
    for (std::size_t p = 0; p < asked.count; ++p) {
      tensor.assign(size, std::numeric_limits<R>::quiet_NaN());
      if (answer.status == Answer::Status::Given)
        for (std::size_t i = 0; i < size; ++i) tensor[i] = static_cast<R>(answer.tensors[o][p * size + i]);
      output.put(p, o, std::span<const R>(tensor));
    }
  Statement statement;
  statement.converged = answer.status != Answer::Status::Declined;
  for (std::size_t p = 0; p < asked.count; ++p) output.state(p, statement);
}

template <Scalar R>
void fill(Evaluation& evaluation, const std::shared_ptr<ForeignCode>& code, const Formula& formula) {
  evaluation.set_batch<R>([code, &formula](const Batch<R>& batch, const BatchOutput<R>& output) {
    evaluate<R>(*code, formula, batch, output);
  });
}

}  // namespace

std::vector<std::string> register_foreign_code(const std::shared_ptr<ForeignCode>& code, const std::string& name,
                                               const std::string& formulas) {
  std::vector<std::string_view> known;
  for (const Formula& formula : catalogue()) known.push_back(formula.name);
  require_known("formula", formulas, known);
  if (formulas == "*" && !code->says_formulas())
    throw InputError(
        fmt::format("{} does not say which formulas it has (docs/judge.md): name them with --formula", name));
  std::vector<std::string> registered;
  for (const Formula& formula : catalogue()) {
    if (!matches(formulas, formula.name)) continue;
    const int order = code->order_of(formula);
    if (order < 0) continue;
    const bool has_float = code->order_of(formula, true) >= order;
    add_foreign(formula.name, name, order, [code, &formula, has_float](Evaluation& evaluation) {
      fill<double>(evaluation, code, formula);
      if (has_float) fill<float>(evaluation, code, formula);
    });
    registered.emplace_back(formula.name);
  }
  if (registered.empty())
    throw InputError(fmt::format("{} ({}) has no formula of '{}'{}", name, code->what(), formulas,
                                 code->says_formulas() ? "" : ": it answers none of them with numbers"));
  return registered;
}

}  // namespace cageproof::judge
