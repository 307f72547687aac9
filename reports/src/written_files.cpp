// SPDX-License-Identifier: MIT
#include "written_files.h"

#include "cageproof/core/input_error.h"
#include "cageproof/core/whole_file.h"
#include "cageproof/reports/journal.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <set>

namespace cageproof::reports {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const fs::path& folder, const std::error_code& error) {
  throw InputError(fmt::format("cannot read {}: {}", folder.string(), error.message()));
}

// Everything below a folder; links are not followed.
std::vector<fs::directory_entry> entries_of(const fs::path& folder) {
  std::error_code error;
  std::vector<fs::directory_entry> entries;
  auto at = fs::recursive_directory_iterator(folder, error);
  for (; !error && at != fs::recursive_directory_iterator(); at.increment(error)) entries.push_back(*at);
  if (error) fail(folder, error);
  return entries;
}

std::string name_in(const fs::path& folder, const fs::directory_entry& entry) {
  return entry.path().lexically_relative(folder).generic_string();
}

// The files on the list and the folders that they are in.
std::set<std::string, std::less<>> known_in(const std::string& list) {
  std::set<std::string, std::less<>> known{written_files_name, std::string(journal_file)};
  for (const std::string_view name : verdict_files) known.insert(earlier_file(name));
  for (std::size_t start = 0; start < list.size();) {
    const std::size_t end = std::min(list.find('\n', start), list.size());
    for (fs::path path = list.substr(start, end - start); !path.empty(); path = path.parent_path())
      known.insert(path.generic_string());
    start = end + 1;
  }
  return known;
}

}  // namespace

std::string list_of_files(const fs::path& folder) {
  std::set<std::string> names;
  // Folders too: an empty one was made as well.
  for (const fs::directory_entry& entry : entries_of(folder)) names.insert(name_in(folder, entry));
  std::string list;
  for (const std::string& name : names) list += name + "\n";
  return list;
}

std::string foreign_entry(const fs::path& folder) {
  std::error_code ignored;
  const fs::path list = folder / written_files_name;
  const bool listed = fs::is_regular_file(list, ignored);
  const auto known = known_in(listed ? read_file(list) : std::string());
  for (const fs::directory_entry& entry : entries_of(folder)) {
    std::string name = name_in(folder, entry);
    if (entry.is_symlink(ignored)) return name;
    const bool deep = entry.is_directory(ignored) && name.find('/') != name.npos;
    if (listed ? !known.contains(name) : deep) return name;
  }
  return {};
}

}  // namespace cageproof::reports
