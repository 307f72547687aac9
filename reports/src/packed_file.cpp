// SPDX-License-Identifier: MIT
#include "cageproof/reports/packed_file.h"

#include "cageproof/core/input_error.h"

#include <fmt/format.h>

#include <zlib.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>
#include <stdexcept>
#include <system_error>

namespace cageproof::reports {
namespace {

constexpr std::size_t block_size = 1 << 16;

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

// The bytes of a file, unpacked where it is packed; zlib's own reader takes whatever stands behind the packed text.
class LineFile::Bytes {
 public:
  explicit Bytes(const std::filesystem::path& path) : path_(path) {
    std::error_code ignored;
    if (std::filesystem::is_directory(path, ignored)) fail(std::generic_category().message(EISDIR));
    file_.reset(std::fopen(path.c_str(), "rb"));
    if (!file_) fail(std::generic_category().message(errno));
    // Two bytes tell a packed file, and a pipe may give one at a time.
    while (held_ < 2 && read_more()) {
    }
    packed_ = held_ >= 2 && input_[0] == '\x1f' && input_[1] == '\x8b';
    constexpr int gzip_header = 16;
    if (packed_ && inflateInit2(&stream_, MAX_WBITS + gzip_header) != Z_OK)
      throw std::runtime_error("zlib cannot begin");
  }
  ~Bytes() {
    if (packed_) inflateEnd(&stream_);
  }
  Bytes(const Bytes&) = delete;
  Bytes& operator=(const Bytes&) = delete;

  bool packed() const { return packed_; }

  // At most so many; none at the end.
  std::size_t read(char* out, std::size_t size) {
    if (!packed_) {
      if (held_ == 0) read_more();
      const std::size_t count = std::min(size, held_);
      std::copy_n(input_.data() + start_, count, out);
      drop(count);
      return count;
    }
    stream_.next_out = reinterpret_cast<Bytef*>(out);
    stream_.avail_out = static_cast<uInt>(size);
    while (stream_.avail_out > 0 && unpack()) {
    }
    return size - stream_.avail_out;
  }

 private:
  // Whether there may be more.
  bool unpack() {
    if (held_ == 0 && !read_more()) {
      if (!at_end_of_text_) fail(damaged);
      return false;
    }
    // Behind a packed text there may be another, and nothing else.
    if (at_end_of_text_ && inflateReset(&stream_) != Z_OK) fail(damaged);
    const char* const why = at_end_of_text_ ? "it is packed, and what stands behind its packed text is not" : damaged;
    stream_.next_in = reinterpret_cast<Bytef*>(input_.data() + start_);
    stream_.avail_in = static_cast<uInt>(held_);
    const int code = inflate(&stream_, Z_NO_FLUSH);
    drop(held_ - stream_.avail_in);
    if (code != Z_OK && code != Z_STREAM_END) fail(why);
    at_end_of_text_ = code == Z_STREAM_END;
    return true;
  }
  bool read_more() {
    if (held_ == 0) start_ = 0;
    const std::size_t count =
        std::fread(input_.data() + start_ + held_, 1, input_.size() - start_ - held_, file_.get());
    if (std::ferror(file_.get()) != 0) fail(std::generic_category().message(errno));
    held_ += count;
    return count > 0;
  }
  void drop(std::size_t count) {
    start_ += count;
    held_ -= count;
  }
  [[noreturn]] void fail(const std::string& reason) const {
    throw InputError(fmt::format("cannot read {}: {}", path_.string(), reason));
  }

  static constexpr const char* damaged = "it is packed, and damaged or cut off";
  struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };
  std::filesystem::path path_;
  std::unique_ptr<std::FILE, Close> file_;
  std::array<char, block_size> input_{};
  std::size_t start_ = 0, held_ = 0;  // of input_
  z_stream stream_{};
  bool packed_ = false, at_end_of_text_ = false;
};

LineFile::LineFile(const std::filesystem::path& path) : bytes_(std::make_unique<Bytes>(path)) {}

LineFile::~LineFile() = default;

bool LineFile::packed() const { return bytes_->packed(); }

void LineFile::fill() {
  rest_.erase(0, start_);
  start_ = 0;
  const std::size_t size = rest_.size();
  rest_.resize(size + block_size);
  const std::size_t count = bytes_->read(rest_.data() + size, block_size);
  rest_.resize(size + count);
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
