// SPDX-License-Identifier: MIT
// The limits of memory, and refusals of tables that would not fit.
#include "cageproof/core/memory.h"

#include "support.h"

#include <sys/resource.h>

namespace cageproof {
namespace {

// Sanitizers take more addresses than any limit leaves, and end where they get none.
TEST(memory, is_limited_by_ulimit) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  GTEST_SKIP() << "a sanitizer's own addresses are limited, too";
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
  GTEST_SKIP() << "a sanitizer's own addresses are limited, too";
#endif
#endif
  const std::uint64_t all = usable_memory();
  EXPECT_GT(all, 100'000'000U);
  rlimit before{};
  ASSERT_EQ(::getrlimit(RLIMIT_AS, &before), 0);
  const rlimit half{all / 2, before.rlim_max};
  ASSERT_EQ(::setrlimit(RLIMIT_AS, &half), 0);
  const std::uint64_t found = usable_memory();
  ASSERT_EQ(::setrlimit(RLIMIT_AS, &before), 0);
  EXPECT_EQ(found, all / 2);
  EXPECT_EQ(usable_memory(), all);
}

TEST(memory, sizes_have_three_digits) {
  EXPECT_EQ(size_text(0), "0 bytes");
  EXPECT_EQ(size_text(999), "999 bytes");
  EXPECT_EQ(size_text(1000), "1.00 KB");
  EXPECT_EQ(size_text(43'711'488), "43.7 MB");
  EXPECT_EQ(size_text(999'600), "1.00 MB");
  EXPECT_EQ(size_text(113.04e9), "113 GB");
  EXPECT_EQ(size_text(2e24), "2000000 EB");
}

TEST(memory, of_more_than_half_is_refused_with_sizes_and_advice) {
  const double half = static_cast<double>(usable_memory()) / 2;
  require_memory(half, "a table", "ask for less");
  const std::string said =
      testing_support::input_error_of([&] { require_memory(1e18, "a table of 5 x 7 numbers", "ask for less"); });
  testing_support::expect_parts(said, {"a table of 5 x 7 numbers", "1.00 EB", size_text(half), "ask for less"});
  testing_support::input_error_of([&] { require_memory(1.001 * half, "a table", "ask for less"); });
}

}  // namespace
}  // namespace cageproof
