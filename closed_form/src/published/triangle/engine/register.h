// SPDX-License-Identifier: MIT
// Turns a printed form of [T24] into entries of the register: as it is after the errata, and with a misprint kept.
#pragma once

#include "cageproof/closed_form/put.h"
#include "instances.h"

#include "cageproof/core/catalogue/evaluation.h"

#include <algorithm>
#include <array>
#include <initializer_list>
#include <string>

namespace cageproof::closed_form::published {

CAGEPROOF_PUBLISHED_SCALARS(extern)

/// The scalar that printed forms compute in: R itself, since they are here to show what their cancellation costs. Those
/// in 50 and 100 digits compute in 200, which saves two fifths of the time to compile.
template <Scalar R>
using Computed = std::conditional_t<is_multiprecision<R>, Mp200, R>;

/// The family of one printed form. \param form `form(frame, order, parameters, misprint)` is a Jet at the frame's point
/// for every scalar \param standard whether verification runs it \param max_order the highest derivative that it gives
template <class Form>
EvaluationFamily printed_family(std::string_view formula, std::string_view name, std::string description, bool standard,
                                Misprint misprint, Form form, int max_order = 2) {
  const EvaluationFacts facts{
      .description = std::move(description), .role = Role::Printed, .cost = CostClass::Direct, .max_order = max_order};
  return single_family(formula, name, facts, standard, [form, misprint](Evaluation& evaluation) {
    for (const ScalarKind kind : scalar_kinds)
      with_scalar(kind, [&]<Scalar R>() {
        evaluation.set_batch<R>([form, misprint](const Batch<R>& batch, const BatchOutput<R>& output) {
          using W = Computed<R>;
          const Triangle<W> t{convert<W>(batch.corners[0]), convert<W>(batch.corners[1]), convert<W>(batch.corners[2])};
          std::array<W, 2> parameters;
          std::ranges::copy(batch.parameters, parameters.begin());
          for (std::size_t p = 0; p < batch.points.size(); ++p) {
            const Frame<W> frame(t, convert<W>(batch.points[p]));
            put(narrowed<R>(form(frame, batch.order, std::span<const W>(parameters), misprint)), batch.order, p,
                output);
          }
        });
      });
  });
}

/// One way to read a printed form: as it is after the errata (`published`, of the standard set), or with a misprint
/// kept.
struct Reading {
  Misprint misprint;
  std::string_view description;
};

/// `const RegisterPrinted <kernel>_forms{"triangle.<kernel>", {readings...}, form};` at namespace scope of the form's
/// .cpp. \param form, max_order: as printed_family's
struct RegisterPrinted {
  template <class Form>
  RegisterPrinted(std::string_view formula, std::initializer_list<Reading> readings, Form form, int max_order = 2) {
    for (const Reading& reading : readings)
      RegisterEvaluation(printed_family(formula, evaluation_name(reading.misprint), std::string(reading.description),
                                        reading.misprint == Misprint::None, reading.misprint, form, max_order));
  }
};

}  // namespace cageproof::closed_form::published
