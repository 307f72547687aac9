// SPDX-License-Identifier: MIT
// The report notes runs whose parts were measured differently.
#include "run/run_report.h"

#include "cageproof/validation/machine_facts.h"

#include <gtest/gtest.h>

namespace cageproof::validation {
namespace {

Session session(const char* fact, const char* value) { return {"then", 0, "", {{fact, value}}}; }

TEST(SessionNotes, name_what_parts_differ_in) {
  EXPECT_TRUE(session_notes({session(program_build, "a"), session(program_build, "a")}).empty());
  const auto builds = session_notes({session(program_build, "a"), session(program_build, "b")});
  ASSERT_EQ(builds.size(), 1u);
  EXPECT_NE(builds[0].find("measured with 2 different builds of the program (a | b)"), std::string::npos) << builds[0];
  const auto functions = session_notes({session(elementary_functions, "a"), session(elementary_functions, "b")});
  ASSERT_EQ(functions.size(), 1u);
  const auto sets = session_notes({session(instruction_set_fact, "avx2"), session(instruction_set_fact, "plain")});
  ASSERT_EQ(sets.size(), 1u);
  EXPECT_NE(sets[0].find("2 different instruction sets (avx2 | plain)"), std::string::npos) << sets[0];
  EXPECT_NE(functions[0].find("2 different elementary functions (a | b)"), std::string::npos) << functions[0];
}

}  // namespace
}  // namespace cageproof::validation
