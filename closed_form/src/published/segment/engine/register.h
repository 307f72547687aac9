// SPDX-License-Identifier: MIT
// Turns a printed form of [W12] into entries of the register: as it is after the errata, and with a misprint kept.
#pragma once

#include "published/segment/engine/edge.h"
#include "cageproof/core/catalogue/evaluation.h"

#include <initializer_list>
#include <string>

namespace cageproof::closed_form::published {

/// One way to read a printed form of the plane: as it is after the errata, or with a misprint kept.
struct PlaneReading {
  Misprint misprint;
  std::string_view description;
};

/// `const RegisterPlaneForm <kernel>_forms{"segment.<kernel>", {readings...}, form};` at namespace scope of the form's
/// .cpp. The paper takes derivatives by differences, so forms have only values. \param form `form(edge, misprint)`: the
/// numbers of the value, for every scalar
struct RegisterPlaneForm {
  template <class Form>
  RegisterPlaneForm(std::string_view formula, std::initializer_list<PlaneReading> readings, Form form) {
    for (const PlaneReading& reading : readings)
      RegisterEvaluation(single_family(
          formula, evaluation_name(reading.misprint),
          {.description = std::string(reading.description),
           .role = Role::Printed,
           .cost = CostClass::Direct,
           .max_order = 0},
          reading.misprint == Misprint::None,
          [misprint = reading.misprint, form](Evaluation& evaluation) { set(evaluation, misprint, form); }));
  }

 private:
  // Multiprecision results are computed in 200 digits, so that cancellation shows only in float and double.
  template <class Form>
  static void set(Evaluation& evaluation, Misprint misprint, Form form) {
    for (const ScalarKind kind : scalar_kinds)
      with_scalar(kind, [&]<Scalar R>() {
        evaluation.set_batch<R>([form, misprint](const Batch<R>& batch, const BatchOutput<R>& output) {
          using W = std::conditional_t<is_multiprecision<R>, Mp200, R>;
          const Segment<W> segment{convert<W>(batch.corners[0]), convert<W>(batch.corners[1])};
          for (std::size_t p = 0; p < batch.points.size(); ++p) {
            const auto found = form(PlaneEdge<W>(segment, convert<W>(batch.points[p])), misprint);
            std::array<R, std::tuple_size_v<std::decay_t<decltype(found)>>> value;
            for (std::size_t i = 0; i < value.size(); ++i) value[i] = static_cast<R>(found[i]);
            output.put(p, 0, value);
          }
        });
      });
  }
};

}  // namespace cageproof::closed_form::published
