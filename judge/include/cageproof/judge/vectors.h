// SPDX-License-Identifier: MIT
// Test vectors: inputs with their truths, for those who would rather not run anything of ours.
#pragma once

#include "cageproof/validation/sample.h"
#include "cageproof/validation/truth.h"

#include <optional>
#include <string>
#include <vector>

namespace cageproof::judge {

/// One input with its truth.
struct TestVector {
  validation::Sample sample;
  std::string regime;                ///< where the input comes from; "hunted" for a stored worst case
  std::vector<std::string> defects;  ///< known defects that fail here, by name, in the order of known_defects()
  validation::Truth truth;
  std::array<bool, 3> has{};  ///< by order: the truth exists and doubles hold it
  /// One radius per entry of a value that `certified` proved, about the truth as it is printed; empty otherwise.
  std::vector<Mp100> radius;
};

/// Samples, size and proofs of the vectors that are made.
struct VectorOptions {
  std::uint64_t seed = 1;
  int samples = 6;                ///< a regime
  std::size_t numbers = 5000;     ///< truths a formula, about: bounds the size of files
  std::size_t proof_stride = 10;  ///< `certified` is asked for each so many vectors, because it is slow
  int jobs = 0;                   ///< threads; 0: all cores
};

/// Vectors made for one formula, and what was left out.
struct VectorSet {
  const Formula* formula = nullptr;
  std::vector<TestVector> vectors;
  std::size_t candidates = 0;      ///< inputs with a truth that were tried
  std::size_t without_defect = 0;  ///< of these, inputs that no known defect fails
};

/// A conditioned error above so many roundings of double fails a vector.
inline constexpr double vector_bound = 64;

/// A deliberately wrong way to compute a formula.
struct KnownDefect {
  std::string_view name;
  std::string_view description;
  /// Its result at a sample, or nothing where the formula has no such form or the defect does not act.
  std::optional<Result<double>> (*result)(const Formula& formula, const validation::Sample& sample, int order);
};

/// All wrong forms that vectors aim at.
const std::vector<KnownDefect>& known_defects();

/// Makes the vectors of one formula from samples of all regimes, then stored worst cases, and leaves out those that no
/// defect fails. A function of the options except jobs. \throws InputError where the formula has no truth
VectorSet make_vectors(const Formula& formula, const VectorOptions& options);

/// JSON, one vector per line. \param command what made it
std::string vectors_json(const VectorSet& set, const VectorOptions& options, std::string_view version,
                         std::string_view command);

/// Values only, as lines of words: flags, hexadecimal inputs, each truth as a sum of two doubles, the denominator.
std::string vectors_text(const VectorSet& set);

/// Row-major tables of doubles for .npy, NaN where a truth is missing.
struct VectorTables {
  std::vector<double> inputs;        ///< corners, point, parameters
  std::vector<double> truths;        ///< value, gradient, Hessian: each number as a sum of two doubles
  std::vector<double> denominators;  ///< one per order
  std::size_t input_columns = 0, truth_columns = 0;
};
VectorTables vectors_tables(const VectorSet& set);

}  // namespace cageproof::judge
