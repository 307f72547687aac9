// SPDX-License-Identifier: MIT
#include "aside_notes.h"

#include <set>

namespace cageproof::reports {
namespace {

struct Notes {
  std::mutex steps, list;
  std::multiset<std::filesystem::path> paths;
};

// Never destroyed, because the thread that waits for signals may outlive static objects.
Notes& notes() {
  static Notes& all = *new Notes;
  return all;
}

}  // namespace

AsideNote::AsideNote(std::filesystem::path path) : path_(std::move(path)) {
  const std::scoped_lock lock(notes().list);
  notes().paths.insert(path_);
}

AsideNote::~AsideNote() {
  const std::scoped_lock lock(notes().list);
  notes().paths.erase(notes().paths.find(path_));
}

std::unique_lock<std::mutex> undisturbed() { return std::unique_lock(notes().steps); }

std::vector<std::filesystem::path> noted_aside() {
  const std::scoped_lock lock(notes().list);
  return {notes().paths.begin(), notes().paths.end()};
}

}  // namespace cageproof::reports
