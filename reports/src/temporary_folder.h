// SPDX-License-Identifier: MIT
// Temporary folders for files that are written and read at once.
#pragma once

#include "aside.h"
#include "aside_notes.h"

#include "cageproof/core/input_error.h"

#include <fmt/format.h>

#include <sys/stat.h>

#include <cerrno>
#include <filesystem>
#include <memory>
#include <string>
#include <system_error>

namespace cageproof::reports {

/// A folder of its own, removed with its contents. Making one also removes the folders of killed processes.
class TemporaryFolder {
 public:
  /// \throws InputError where none can be made
  TemporaryFolder() {
    const std::filesystem::path like = std::filesystem::temp_directory_path() / "cageproof";
    remove_leftovers(like);
    for (int n = 0; path_.empty(); ++n) {
      const auto lock = undisturbed();
      const std::filesystem::path candidate = aside(like, n);
      if (::mkdir(candidate.c_str(), S_IRWXU) == 0) path_ = candidate;
      else if (errno != EEXIST)
        throw InputError(fmt::format("cannot make {}: {}", candidate.string(), std::generic_category().message(errno)));
      if (!path_.empty()) note_ = std::make_unique<AsideNote>(path_);
    }
  }
  ~TemporaryFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
  std::unique_ptr<AsideNote> note_;
};

}  // namespace cageproof::reports
