// SPDX-License-Identifier: MIT
// Small and large changes of an input, for searches.
#pragma once

#include "cageproof/core/numbers/random_stream.h"
#include "cageproof/validation/sample.h"

namespace cageproof::validation {

/// Changes a sample of a formula at random, as its name says; never out of its space. The result may be outside of what
/// a search may propose.
struct Mutation {
  std::string_view name;
  void (*apply)(const Formula& formula, Sample& sample, RandomStream& random);
};

/// All mutations.
std::span<const Mutation> mutations();

/// Applies one. Elements so small or large that the products of their lengths leave doubles' range are mutated in
/// another unit, which is exact except for denormals.
void mutate(const Mutation& mutation, const Formula& formula, Sample& sample, RandomStream& random);

}  // namespace cageproof::validation
