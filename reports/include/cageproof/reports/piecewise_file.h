// SPDX-License-Identifier: MIT
// Files that are written in pieces, because they are too large to be held in memory.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace cageproof::reports {

/// Pieces are written aside as they are made, and replace_files() renames the file into place. What is not renamed is
/// removed. A device, a pipe or an open file gets its pieces at once, in their order.
class PiecewiseFile {
 public:
  /// \throws InputError "cannot write <path>: <reason>"
  explicit PiecewiseFile(const std::filesystem::path& path);
  ~PiecewiseFile();
  PiecewiseFile(const PiecewiseFile&) = delete;
  PiecewiseFile& operator=(const PiecewiseFile&) = delete;

  /// Appends behind all earlier pieces. \throws InputError as the constructor
  void append(std::string_view bytes);
  /// Whether pieces may come in any order.
  bool takes_any_order() const;
  /// Writes a piece where it belongs; from any thread. \pre takes_any_order() \throws InputError as the constructor
  void write_at(std::uint64_t offset, std::string_view bytes);

 private:
  friend void replace_files(PiecewiseFile& pieces,
                            const std::vector<std::pair<std::filesystem::path, std::string>>& others);
  struct State;
  std::unique_ptr<State> state_;
};

/// Puts it in its place together with other files, which are written whole, as replace_files() does without it.
/// \pre nothing is written to it afterwards
void replace_files(PiecewiseFile& pieces, const std::vector<std::pair<std::filesystem::path, std::string>>& others);

}  // namespace cageproof::reports
