// SPDX-License-Identifier: MIT
// The main function of every test program. Exit code 77, which CTest lists as skipped, says that all tests asked for
// were skipped; a filter that matches no test is an error, because a suite that has been renamed would pass else.
#include <gtest/gtest.h>

#include <cstdio>

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  constexpr int skipped = 77;
  const int failed = RUN_ALL_TESTS();
  const testing::UnitTest& run = *testing::UnitTest::GetInstance();
  if (GTEST_FLAG_GET(list_tests)) return failed;
  if (run.test_to_run_count() == 0) {
    std::fprintf(stderr, "no test matches the filter '%s'\n", GTEST_FLAG_GET(filter).c_str());
    return 1;
  }
  return failed == 0 && run.successful_test_count() == 0 && run.skipped_test_count() > 0 ? skipped : failed;
}
