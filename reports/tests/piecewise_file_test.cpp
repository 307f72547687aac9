// SPDX-License-Identifier: MIT
// Files that are written in pieces: whole in their place, or not there.
#include "cageproof/reports/checked_file.h"
#include "cageproof/reports/piecewise_file.h"

#include "cageproof/core/input_error.h"
#include "cageproof/core/whole_file.h"
#include "small_disk.h"
#include "sample_run.h"

#include <gtest/gtest.h>

#include <unistd.h>

#include <algorithm>
#include <array>
#include <iterator>

namespace cageproof::reports {
namespace {

namespace fs = std::filesystem;

std::ptrdiff_t entries_in(const fs::path& folder) {
  return std::distance(fs::directory_iterator(folder), fs::directory_iterator());
}

TEST(PiecewiseFile, stands_in_its_place_when_it_is_whole) {
  const ScratchFolder scratch;
  const fs::path file = scratch.path() / "table.npy", beside = scratch.path() / "table.json";
  replace_file(file, "the old one");
  {
    PiecewiseFile pieces(file);
    ASSERT_TRUE(pieces.takes_any_order());
    pieces.append("head");
    pieces.write_at(8, "last");
    pieces.write_at(4, "then");
    EXPECT_EQ(read_file(file), "the old one");
    replace_files(pieces, {{beside, "{}"}});
  }
  EXPECT_EQ(read_file(file), "headthenlast");
  EXPECT_EQ(read_file(beside), "{}");
  EXPECT_EQ(entries_in(scratch.path()), 2);
}

TEST(PiecewiseFile, that_is_given_up_leaves_nothing) {
  const ScratchFolder scratch;
  const fs::path file = scratch.path() / "table.npy";
  { PiecewiseFile(file).append("half of it"); }
  EXPECT_EQ(entries_in(scratch.path()), 0);
}

TEST(PiecewiseFile, is_not_replaced_where_another_cannot_be_written) {
  const ScratchFolder scratch;
  const fs::path file = scratch.path() / "table.npy";
  for (const fs::path& other : {scratch.path() / "nowhere" / "table.json", file}) {
    PiecewiseFile pieces(file);
    pieces.append("whole");
    EXPECT_THROW(replace_files(pieces, {{other, "{}"}}), InputError) << other;
  }
  EXPECT_EQ(entries_in(scratch.path()), 0);
  EXPECT_THROW(PiecewiseFile(scratch.path() / "nowhere" / "table.npy"), InputError);
}

TEST(PiecewiseFile, says_when_the_disk_is_full) {
  const ScratchFolder scratch;
  const fs::path file = scratch.path() / "table.npy";
  {
    PiecewiseFile pieces(file);
    const SmallDisk disk(1000);
    pieces.append(std::string(900, 'x'));
    EXPECT_THROW(pieces.append(std::string(200, 'x')), InputError);
    EXPECT_THROW(pieces.write_at(990, std::string(20, 'x')), InputError);
  }
  EXPECT_EQ(entries_in(scratch.path()), 0);
}

TEST(PiecewiseFile, gives_a_pipe_its_pieces_in_order) {
  const ScratchFolder scratch;
  std::array<int, 2> ends{};
  ASSERT_EQ(::pipe(ends.data()), 0);
  {
    PiecewiseFile pieces("/dev/fd/" + std::to_string(ends[1]));
    EXPECT_FALSE(pieces.takes_any_order());
    pieces.append("one ");
    pieces.append("two");
    replace_files(pieces, {{scratch.path() / "beside.json", "{}"}});
  }
  std::array<char, 16> bytes{};
  EXPECT_EQ(::read(ends[0], bytes.data(), bytes.size()), 7);
  EXPECT_EQ(std::string(bytes.data()), "one two");
  EXPECT_EQ(read_file(scratch.path() / "beside.json"), "{}");
  for (const int end : ends) ::close(end);
}

}  // namespace
}  // namespace cageproof::reports
