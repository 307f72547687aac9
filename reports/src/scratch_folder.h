// SPDX-License-Identifier: MIT
// Folders for what is written to be read at once.
#pragma once

#include "cageproof/core/input_error.h"

#include <fmt/format.h>

#include <cerrno>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <system_error>

namespace cageproof::reports {

/// A folder of its own, which goes with what is in it.
class ScratchFolder {
 public:
  /// \throws InputError where none can be made
  ScratchFolder() {
    std::string name = (std::filesystem::temp_directory_path() / "cageproof-XXXXXX").string();
    if (!mkdtemp(name.data()))
      throw InputError(fmt::format("cannot make a folder like {}: {}", name, std::generic_category().message(errno)));
    path_ = name;
  }
  ~ScratchFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

}  // namespace cageproof::reports
