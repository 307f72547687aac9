// SPDX-License-Identifier: MIT
// Registers the paper's scheme, `riemann-<n>`, and its variants.
#include "instances.h"
#include "variants.h"

namespace cageproof::adaptive_qmvc {
namespace {

struct Riemann {
  PoleGuard guard;

  template <Scalar R>
  void operator()(const Batch<R>& batch, int n, const BatchOutput<R>& output) const {
    riemann_batch<R>(batch, n, guard, output);
  }
};

EvaluationFamily family_of(const SchemeVariant& variant) {
  const std::string suffix = variant.suffix;
  std::vector<std::string> standard{"riemann-4" + suffix}, studied;
  if (suffix.empty()) standard.insert(standard.end(), {"riemann-7", "riemann-10"});
  for (const char* n : {"2", "4", "10", "40", "160"}) studied.push_back(std::string("riemann-") + n + suffix);
  return counted_family("quad.mean_value", "riemann", std::move(standard), std::move(studied), variant.description,
                        Riemann{guard_of(variant)}, 0, suffix);
}

const RegisterEvaluation register_scheme{family_of(kSchemeVariants[0])},
    register_uncorrected{family_of(kSchemeVariants[1])}, register_unguarded{family_of(kSchemeVariants[2])};

}  // namespace
}  // namespace cageproof::adaptive_qmvc
