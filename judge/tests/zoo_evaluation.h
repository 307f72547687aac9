// SPDX-License-Identifier: MIT
// A member of the zoo as an evaluation.
#pragma once

#include "zoo.h"

#include "cageproof/core/catalogue/evaluation.h"

#include <string>

namespace cageproof::judge {

using ZooFunction = void (*)(const zoo_call*);

inline Evaluation zoo_evaluation(std::string_view formula, std::string_view name, ZooFunction function,
                                 int max_order = 1) {
  Evaluation evaluation(formula, name, {.description = "zoo", .role = Role::Foreign, .max_order = max_order});
  evaluation.set_batch<double>(
      [function, name = std::string(formula)](const Batch<double>& batch, const BatchOutput<double>& output) {
        const zoo_call call{.formula = name.c_str(),
                            .corners = batch.corners.data()->data(),
                            .parameters = batch.parameters.data(),
                            .points = batch.points.data()->data(),
                            .count = batch.points.size(),
                            .order = batch.order,
                            .values = output.tensors[0],
                            .gradients = batch.order > 0 ? output.tensors[1] : nullptr};
        function(&call);
      });
  return evaluation;
}

}  // namespace cageproof::judge
