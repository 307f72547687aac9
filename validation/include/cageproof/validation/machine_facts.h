// SPDX-License-Identifier: MIT
// Facts of the machine that may change a run's figures or its times.
#pragma once

#include <map>
#include <string>

namespace cageproof::validation {

/// The key of machine_facts() whose value differs between machines on which the same program finds other last digits.
inline constexpr const char* elementary_functions = "elementary functions";

/// The key whose value is the instruction set of vectors of points (CAGEPROOF_SIMD), in which last digits may differ.
inline constexpr const char* instruction_set_fact = "instruction set";

/// The key whose value tells programs apart.
inline constexpr const char* program_build = "program's build";

/// Processor and its cores, threads that are used, commit, compiler and its flags, libraries, the elementary
/// functions that were picked, and the instruction set. \param jobs threads asked for; 0: one per core
std::map<std::string, std::string> machine_facts(int jobs = 0);

/// Which variants of log, atan2, exp ... the C library picked for this processor, and a fingerprint of what they
/// return: two processes with the same text compute the same.
std::string elementary_function_variant();

/// Now, ISO 8601, UTC.
std::string timestamp();

}  // namespace cageproof::validation
