// SPDX-License-Identifier: MIT
// Every file of the fuzzer's corpus, and what once failed, is read or refused, in time.
#include "../fuzz/read_input.h"

#include "support.h"

#include <chrono>

namespace cageproof {
namespace {

#if defined(__has_feature)
#if __has_feature(address_sanitizer)
#define CAGEPROOF_IS_SANITIZED
#endif
#endif
#ifdef CAGEPROOF_IS_SANITIZED
constexpr std::chrono::seconds kMostTime{10};
#else
constexpr std::chrono::seconds kMostTime{2};
#endif

// Folders of the corpus are named after the formats, the files by what is in them.
TEST(reader_corpus, is_read_or_refused) {
  const testing_support::TemporaryFolder folder;
  int count = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(CAGEPROOF_FUZZ_CORPUS)) {
    if (!entry.is_regular_file()) continue;
    ++count;
    const std::string format = entry.path().parent_path().filename().string();
    SCOPED_TRACE(format + "/" + entry.path().filename().string());
    const auto path = std::filesystem::path(folder.path()) / ("input." + format);
    std::filesystem::copy_file(entry.path(), path, std::filesystem::copy_options::overwrite_existing);
    const auto start = std::chrono::steady_clock::now();
    EXPECT_NO_THROW(fuzzing::read_input(path));
    EXPECT_LT(std::chrono::steady_clock::now() - start, kMostTime);
  }
  EXPECT_GT(count, 40);
}

}  // namespace
}  // namespace cageproof
