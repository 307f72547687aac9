// SPDX-License-Identifier: MIT
#include "written_files.h"

#include "temporary_folder.h"

#include "cageproof/reports/checked_file.h"

#include <gtest/gtest.h>

namespace cageproof::reports {
namespace {

namespace fs = std::filesystem;

fs::path folder_in(const TemporaryFolder& scratch) {
  fs::path folder = scratch.path() / "report";
  fs::create_directories(folder / "fields");
  write_file(folder / "fields/a.vti", "a");
  write_file(folder / "summary.json", "{}");
  return folder;
}

TEST(WrittenFiles, ListsFilesAndFoldersInOrder) {
  const TemporaryFolder scratch;
  EXPECT_EQ(list_of_files(folder_in(scratch)), "fields\nfields/a.vti\nsummary.json\n");
}

TEST(WrittenFiles, WhatIsNotListedIsForeign) {
  const TemporaryFolder scratch;
  const fs::path folder = folder_in(scratch);
  write_file(folder / written_files_name, list_of_files(folder));
  EXPECT_EQ(foreign_entry(folder), "");
  write_file(folder / "journal", "of a run under way");
  fs::remove(folder / "summary.json");
  EXPECT_EQ(foreign_entry(folder), "") << "what is gone is nobody's";
  for (const char* mine : {"fields/mine.vti", "mine", "fields/a.vti.bak", ".hidden"}) {
    write_file(folder / mine, "mine");
    EXPECT_EQ(foreign_entry(folder), mine);
    fs::remove(folder / mine);
  }
  fs::create_directory(folder / "fields/mine");
  EXPECT_EQ(foreign_entry(folder), "fields/mine");
}

TEST(WrittenFiles, LinksAreForeignWhateverTheyAreCalled) {
  const TemporaryFolder scratch;
  const fs::path folder = folder_in(scratch);
  write_file(folder / written_files_name, list_of_files(folder));
  fs::remove_all(folder / "fields");
  fs::create_directory_symlink("/", folder / "fields");
  EXPECT_EQ(foreign_entry(folder), "fields");
}

TEST(WrittenFiles, WithoutAListFilesInFoldersAreTakenForOurs) {
  const TemporaryFolder scratch;
  const fs::path folder = folder_in(scratch);
  EXPECT_EQ(foreign_entry(folder), "");
  fs::create_directory(folder / "fields/deeper");
  EXPECT_EQ(foreign_entry(folder), "fields/deeper");
}

}  // namespace
}  // namespace cageproof::reports
