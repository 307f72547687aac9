// SPDX-License-Identifier: MIT
// The table of what units of work took of the processor.
#include "run/timings.h"

#include "cageproof/core/input_error.h"
#include "cageproof/core/whole_file.h"

#include <gtest/gtest.h>

namespace cageproof::validation {
namespace {

std::filesystem::path path_of(const char* name) { return std::filesystem::path(testing::TempDir()) / name; }

TEST(timings, have_a_line_a_unit_and_the_costliest_first) {
  const std::filesystem::path path = path_of("timings.csv");
  Timings timings(path);
  timings.add("triangle.solid_angle, far", 3, 0.25);
  timings.add("cube, green, ", 0, 2);
  timings.add("triangle.solid_angle, far", 0, 0.5);
  timings.write();
  EXPECT_EQ(read_file(path),
            "seconds,measurement,block\n"
            "2.0000,\"cube, green, \",0\n"
            "0.5000,\"triangle.solid_angle, far\",0\n"
            "0.2500,\"triangle.solid_angle, far\",3\n");
}

TEST(timings, that_cannot_be_written_are_refused_before_anything_is_measured) {
  const std::filesystem::path path = path_of("no such folder") / "timings.csv";
  try {
    const Timings timings(path);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find(path.string()), std::string::npos) << error.what();
  }
}

TEST(timings, are_of_the_processor_and_not_of_the_clock) {
  const double start = thread_seconds();
  double sum = 0;
  while (thread_seconds() - start < 0.01)
    for (int i = 1; i < 1000; ++i) sum += 1.0 / i;
  EXPECT_GT(sum, 0);
  EXPECT_LT(thread_seconds() - start, 1);
}

}  // namespace
}  // namespace cageproof::validation
