// SPDX-License-Identifier: MIT
// Files that this process is writing aside: a signal that ends the process removes them.
#pragma once

#include <filesystem>
#include <mutex>
#include <vector>

namespace cageproof::reports {

/// A file or folder that goes when a signal ends the process, as long as this lives.
class AsideNote {
 public:
  explicit AsideNote(std::filesystem::path path);
  ~AsideNote();
  AsideNote(const AsideNote&) = delete;
  AsideNote& operator=(const AsideNote&) = delete;

 private:
  std::filesystem::path path_;
};

/// Held while a file is renamed into its place: signals wait until this is done.
std::unique_lock<std::mutex> undisturbed();

/// All noted paths. \pre undisturbed() is held
std::vector<std::filesystem::path> noted_aside();

}  // namespace cageproof::reports
