// SPDX-License-Identifier: MIT
// Truths kept on disk between runs. Files of the folder may be deleted at any time, and several runs may share it.
#pragma once

#include "cageproof/validation/truth.h"

#include <atomic>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>

namespace cageproof::validation {

/// A folder of truths, one file each, in one subfolder per program version. A damaged file counts as missing.
/// Safe from several threads and processes.
class TruthCache {
 public:
  /// The most that a folder holds, all versions together: older versions go first, then no more is added.
  static constexpr std::uintmax_t most_bytes = std::uintmax_t{512} << 20;

  /// Makes the version's folder. Why it cannot be made or written to; nothing where it can.
  static std::optional<std::string> why_not(const std::filesystem::path& folder, const std::string& version);

  /// \throws InputError for why_not
  /// \param version of the code that makes truths
  /// \param checked one of so many that are found there is made again, at random
  TruthCache(const std::filesystem::path& folder, const std::string& version, unsigned checked = 100);

  /// The truth that is stored for the question, or a new one, which is then stored. \throws InputError when one that is
  /// made again differs from the stored one
  Truth get(const std::string& question, const std::function<Truth()>& make);
  std::size_t taken() const { return taken_; }
  std::size_t made() const { return made_; }

 private:
  std::filesystem::path path_of(const std::string& question) const;
  void keep(const std::filesystem::path& path, const std::string& text);
  bool is_checked(const std::string& question) const;

  std::filesystem::path folder_;
  unsigned checked_;
  std::uint64_t chance_;
  std::atomic<std::uintmax_t> bytes_{0};
  std::atomic<std::size_t> taken_{0}, made_{0};
};

/// A truth as text, exactly, and back; nothing for a text that is none.
std::string text_of(const Truth& truth);
std::optional<Truth> truth_of(const std::string& text);

/// Text of everything that a truth depends on, except the program.
std::string question_of(const TruthSource& source, const Sample& sample, int order);

/// While it lives, truth_from() asks the cache first; null: none.
class CachedTruths {
 public:
  explicit CachedTruths(TruthCache* cache);
  ~CachedTruths();
  CachedTruths(const CachedTruths&) = delete;
  CachedTruths& operator=(const CachedTruths&) = delete;
};

/// The one that truth_from() is to ask, or null.
TruthCache* truth_cache();

}  // namespace cageproof::validation
