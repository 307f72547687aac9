// SPDX-License-Identifier: MIT
#include "../conversions.h"
#include "../potentials.h"
#include "guard.h"

#include "cageproof/core/cage/embedded_cages.h"
#include "cageproof/deformation/deformer.h"

#include <fmt/format.h>

#include <algorithm>

namespace cageproof::library::c {
namespace {

std::string lines_about(const std::string& of) {
  std::string text;
  const auto add = [&](std::string_view name) { text += fmt::format("{}{}", text.empty() ? "" : "\n", name); };
  if (of == "kinds")
    for (const CoordinateKind& kind : coordinate_kinds()) add(kind.name);
  else if (of == "methods")
    for (const deformation::DeformMethod& method : deformation::deform_methods()) add(method.name);
  else if (of == "formulas")
    for (const Formula& formula : catalogue()) add(formula.name);
  else if (of == "cages")
    for (const auto& name : embedded_cage_names()) add(name);
  else
    for (const std::string& name : EvaluationRegister::instance().standard(formula_named(of).name)) add(name);
  return text;
}

// A request with all that was checked of it.
struct Asked {
  explicit Asked(const cageproof_request* request) {
    require(request, "request");
    require(request->formula, "formula");
    const Options options = options_of(request->options, request->option_count);
    if (!options.evaluation.empty() || options.digits != 0 || options.flip_inward || options.allow_invalid_quads ||
        options.triangulation != Options().triangulation)
      throw InputError("options of a formula are threads and its parameters; the evaluation is the request's own");
    of.emplace(request->formula, request->evaluation != nullptr ? request->evaluation : "", options.parameters);
    if (request->side < CAGEPROOF_INSIDE || request->side > CAGEPROOF_MEAN)
      throw InputError(
          fmt::format("side: {} is none of CAGEPROOF_INSIDE, CAGEPROOF_OUTSIDE, CAGEPROOF_MEAN", request->side));
    order = request->order;
    side = static_cast<Side>(request->side);
    threads = options.threads;
  }
  ElementRequest request() const { return {*of, order, side, threads}; }

  std::optional<ElementFormula> of;
  int order = 0, threads = 0;
  Side side = Side::Inside;
};

TensorSpans spans_of(const cageproof_tensors* results) {
  require(results, "results");
  constexpr std::array names{"values", "gradients", "hessians"};
  TensorSpans spans;
  for (std::size_t o = 0; o < 3; ++o) spans[o] = span_of(results->data[o], results->size[o], names[o]);
  return spans;
}

}  // namespace
}  // namespace cageproof::library::c

extern "C" {

using namespace cageproof::library;
using cageproof::InputError;

const char* cageproof_version(void) {
  static const std::string text = version();
  return text.c_str();
}

int cageproof_list(const char* of, char* text, size_t size, size_t* needed) {
  return c::guarded([&] {
    c::require(of, "of");
    const std::string lines = c::lines_about(of);
    if (needed != nullptr) *needed = lines.size() + 1;
    if (text == nullptr) return;
    if (size <= lines.size())
      throw InputError(fmt::format("text: room for {} characters, not {}", size, lines.size() + 1));
    std::ranges::copy(lines, text);
    text[lines.size()] = '\0';
  });
}

int cageproof_formula_of(const char* name, cageproof_formula* shape) {
  return c::guarded([&] {
    c::require(name, "formula");
    c::require(shape, "shape");
    const cageproof::Formula& f = cageproof::formula_named(name);
    *shape = {f.dim(), f.corners(), f.tensors(), f.shape.rows, f.shape.columns};
  });
}

int cageproof_evaluate(const cageproof_request* request, const double* elements, size_t elements_size,
                       const double* points, size_t points_size, const cageproof_tensors* results) {
  return c::guarded([&] {
    const c::Asked asked(request);
    evaluate_pairs(asked.request(), c::span_of(elements, elements_size, "elements"),
                   c::span_of(points, points_size, "points"), c::spans_of(results));
  });
}

int cageproof_potentials(const cageproof_request* request, const double* elements, size_t elements_size,
                         const double* points, size_t points_size, const cageproof_tensors* results) {
  return c::guarded([&] {
    const c::Asked asked(request);
    evaluate_all(asked.request(), c::span_of(elements, elements_size, "elements"),
                 c::span_of(points, points_size, "points"), c::spans_of(results));
  });
}

int cageproof_potentials_apply(const cageproof_request* request, const double* elements, size_t elements_size,
                               const double* densities, size_t densities_size, int sets, const double* points,
                               size_t points_size, const cageproof_tensors* results) {
  return c::guarded([&] {
    const c::Asked asked(request);
    apply_all(asked.request(), c::span_of(elements, elements_size, "elements"),
              c::span_of(densities, densities_size, "densities"), sets, c::span_of(points, points_size, "points"),
              c::spans_of(results));
  });
}
}
