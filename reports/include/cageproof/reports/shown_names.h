// SPDX-License-Identifier: MIT
// Files' names as people say them: the last part of the path.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace cageproof::reports {

/// How the cages and meshes of one run are called where people read: by the last part of a path, or by the whole path
/// where two of them share that part. Journals, tables and summaries keep the whole name.
class ShownNames {
 public:
  explicit ShownNames(const std::vector<std::string>& names);
  /// As it is where it is none of the names.
  std::string of(const std::string& name) const;
  /// A text with each of the names in it as shown: "folder/a.obj, green coordinates" is "a.obj, green coordinates".
  std::string in(std::string_view text) const;

 private:
  std::vector<std::pair<std::string, std::string>> shown_;  ///< by name, the longest first
};

}  // namespace cageproof::reports
