// SPDX-License-Identifier: MIT
// Long texts of a report are packed: gzip's format, which zcat and most programs read.
#pragma once

#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

namespace cageproof::reports {

/// Packs a text that comes in parts, into a gzip file's bytes: the same for the same text.
class Packer {
 public:
  Packer();
  ~Packer();
  Packer(const Packer&) = delete;
  Packer& operator=(const Packer&) = delete;

  void add(std::string_view part);
  /// The bytes of all parts. \pre nothing is added later, and it is called once
  std::string finish();

 private:
  void deflate(std::string_view part, int flush);
  struct Stream;
  std::unique_ptr<Stream> stream_;
  std::string bytes_;
};

/// The text as a gzip file's bytes.
std::string packed(std::string_view text);

/// Reads a file line by line, be it packed or not.
class LineFile {
 public:
  /// \throws InputError when it cannot be read
  explicit LineFile(const std::filesystem::path& path);
  ~LineFile();
  LineFile(const LineFile&) = delete;
  LineFile& operator=(const LineFile&) = delete;

  /// The next line without its end; nothing at the file's end.
  /// \throws InputError when a packed file is damaged or cut off, or goes on with what is not packed
  std::optional<std::string> next();
  /// Whether the latest line has an end: the last one of a file may have none.
  bool whole() const { return whole_; }
  /// Whether the file is packed.
  bool packed() const;

 private:
  void fill();
  class Bytes;
  std::unique_ptr<Bytes> bytes_;
  std::string rest_;
  std::size_t start_ = 0;
  bool ended_ = false, whole_ = true;
};

/// Reads a whole file and unpacks it, where it is packed. \throws InputError as LineFile
std::string read_packed(const std::filesystem::path& path);

}  // namespace cageproof::reports
