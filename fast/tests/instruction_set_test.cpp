// SPDX-License-Identifier: MIT
#include "cageproof/closed_form/batch/instruction_set.h"

#include "cageproof/core/input_error.h"

#include <gtest/gtest.h>

namespace cageproof::closed_form::batch {
namespace {

using enum InstructionSet;

std::string complaint_of(std::string_view name, InstructionSet widest) {
  try {
    named_instruction_set(name, widest);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(InstructionSets, widest_without_a_name) {
  EXPECT_EQ(named_instruction_set("", Avx512), Avx512);
  EXPECT_EQ(named_instruction_set("", Plain), Plain);
}

TEST(InstructionSets, any_of_the_machine_by_name) {
  EXPECT_EQ(named_instruction_set("plain", Avx512), Plain);
  EXPECT_EQ(named_instruction_set("avx2", Avx512), Avx2);
  EXPECT_EQ(named_instruction_set("avx2", Avx2), Avx2);
  EXPECT_EQ(named_instruction_set("avx512", Avx512), Avx512);
}

TEST(InstructionSets, refuses_what_is_none_and_what_the_machine_lacks) {
  for (const std::string_view name : {"AVX2", "avx", "avx22", "none", " "}) {
    const std::string said = complaint_of(name, Avx512);
    EXPECT_NE(said.find("CAGEPROOF_SIMD: '" + std::string(name) + "'"), std::string::npos) << said;
    EXPECT_NE(said.find("plain, avx2, avx512;"), std::string::npos) << said;
  }
  EXPECT_NE(complaint_of("avx512", Avx2).find("which has plain, avx2;"), std::string::npos);
  EXPECT_NE(complaint_of("avx2", Plain).find("which has plain;"), std::string::npos);
}

}  // namespace
}  // namespace cageproof::closed_form::batch
