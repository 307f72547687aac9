// SPDX-License-Identifier: MIT
#include "cageproof/reports/packed_file.h"

#include "cageproof/core/input_error.h"

#include <fmt/format.h>

#include <zlib.h>

#include <cerrno>
#include <stdexcept>
#include <system_error>

namespace cageproof::reports {
namespace {

constexpr std::size_t block_size = 1 << 16;

gzFile stream_of(void* file) { return static_cast<gzFile>(file); }

}  // namespace

struct Packer::Stream : z_stream {};

Packer::Packer() : stream_(std::make_unique<Stream>()) {
  constexpr int gzip_header = 16, memory = 9;
  if (deflateInit2(stream_.get(), Z_DEFAULT_COMPRESSION, Z_DEFLATED, MAX_WBITS + gzip_header, memory,
                   Z_DEFAULT_STRATEGY) != Z_OK)
    throw std::runtime_error("zlib cannot begin");
}

Packer::~Packer() { deflateEnd(stream_.get()); }

void Packer::deflate(std::string_view part, int flush) {
  stream_->next_in = const_cast<Bytef*>(reinterpret_cast<const Bytef*>(part.data()));  // zlib does not change it
  stream_->avail_in = static_cast<uInt>(part.size());
  int end = Z_OK;
  do {
    const std::size_t size = bytes_.size();
    bytes_.resize(size + block_size);
    stream_->next_out = reinterpret_cast<Bytef*>(bytes_.data() + size);
    stream_->avail_out = block_size;
    end = ::deflate(stream_.get(), flush);
    bytes_.resize(size + block_size - stream_->avail_out);
  } while (end == Z_OK && stream_->avail_out == 0);
  // Where all that fitted was packed already, zlib calls it a want of room.
  const bool whole = flush == Z_FINISH ? end == Z_STREAM_END : end == Z_OK || end == Z_BUF_ERROR;
  if (!whole || stream_->avail_in > 0) throw std::runtime_error("zlib could not pack a text");
}

void Packer::add(std::string_view part) {
  // zlib counts in 32 bits.
  constexpr std::size_t most = std::size_t{1} << 30;
  for (; part.size() > most; part.remove_prefix(most)) deflate(part.substr(0, most), Z_NO_FLUSH);
  if (!part.empty()) deflate(part, Z_NO_FLUSH);
}

std::string Packer::finish() {
  deflate({}, Z_FINISH);
  return std::move(bytes_);
}

std::string packed(std::string_view text) {
  Packer packer;
  packer.add(text);
  return packer.finish();
}

LineFile::LineFile(const std::filesystem::path& path) : path_(path), file_(gzopen(path.c_str(), "rb")) {
  std::error_code ignored;
  if (!file_ || std::filesystem::is_directory(path, ignored)) {
    const int reason = file_ ? EISDIR : errno;
    if (file_) gzclose(stream_of(file_));
    throw InputError(fmt::format("cannot read {}: {}", path.string(), std::generic_category().message(reason)));
  }
  gzbuffer(stream_of(file_), block_size);
}

LineFile::~LineFile() { gzclose(stream_of(file_)); }

bool LineFile::packed() const { return gzdirect(stream_of(file_)) == 0; }

void LineFile::fill() {
  rest_.erase(0, start_);
  start_ = 0;
  const std::size_t size = rest_.size();
  rest_.resize(size + block_size);
  const int count = gzread(stream_of(file_), rest_.data() + size, block_size);
  int error = Z_OK;
  gzerror(stream_of(file_), &error);
  if (count < 0 || error != Z_OK) {
    const std::string reason =
        error == Z_ERRNO ? std::generic_category().message(errno) : "it is packed, and damaged or cut off";
    throw InputError(fmt::format("cannot read {}: {}", path_.string(), reason));
  }
  rest_.resize(size + static_cast<std::size_t>(count));
  ended_ = count == 0;
}

std::optional<std::string> LineFile::next() {
  std::size_t end = rest_.find('\n', start_);
  while (end == rest_.npos && !ended_) {
    const std::size_t seen = rest_.size() - start_;
    fill();
    end = rest_.find('\n', start_ + seen);
  }
  whole_ = end != rest_.npos;
  if (!whole_ && start_ == rest_.size()) return std::nullopt;
  std::string line = rest_.substr(start_, whole_ ? end - start_ : end);
  start_ = whole_ ? end + 1 : rest_.size();
  return line;
}

std::string read_packed(const std::filesystem::path& path) {
  LineFile file(path);
  std::string text;
  while (const auto line = file.next()) text.append(*line).append(file.whole() ? "\n" : "");
  return text;
}

}  // namespace cageproof::reports
