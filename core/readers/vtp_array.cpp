// SPDX-License-Identifier: MIT
#include "vtp_array.h"

#include <fmt/format.h>
#include <vtkDataCompressor.h>
#include <vtkLZ4DataCompressor.h>
#include <vtkLZMADataCompressor.h>
#include <vtkSmartPointer.h>
#include <vtkZLibDataCompressor.h>

#include <algorithm>
#include <array>

namespace cageproof::mesh_files {
namespace {

constexpr int kNone = -1;

// The digits of base64 by character.
constexpr std::array<int, 256> kDigits = [] {
  constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::array<int, 256> all{};
  all.fill(kNone);
  for (std::size_t i = 0; i < digits.size(); ++i) all[static_cast<unsigned char>(digits[i])] = static_cast<int>(i);
  return all;
}();

int digit_of(char c) { return kDigits[static_cast<unsigned char>(c)]; }

// Bytes of base64 from a digit on, at most as many as asked for.
std::string decoded(std::string_view text, std::size_t first_digit, std::size_t count) {
  std::string bytes;
  unsigned bits = 0;
  int length = 0;
  std::size_t digits = 0;
  for (const char c : text) {
    if (bytes.size() == count) break;
    const int digit = digit_of(c);
    // Groups of four count as such where they end with '='.
    if (digit == kNone && c != '=') continue;
    if (digits++ < first_digit || c == '=') continue;
    bits = (bits << 6 | static_cast<unsigned>(digit)) & 0xffffffU;
    length += 6;
    if (length < 8) continue;
    length -= 8;
    bytes += static_cast<char>(bits >> length & 0xffU);
  }
  return bytes;
}

// Digits of base64 that so many bytes take.
std::size_t digits_of(std::size_t bytes) { return (bytes + 2) / 3 * 4; }

class ArrayCheck {
 public:
  ArrayCheck(const VtpArray& array, const VtpStorage& storage, std::size_t file_size, const FileLine& at)
      : array_(array), storage_(storage), file_size_(file_size), at_(at) {}

  void run() const {
    if (storage_.compressor.empty()) check_plain();
    else check_compressed();
  }

 private:
  // Bytes behind `skipped` ones, which in base64 are a text of their own.
  std::string part(std::size_t skipped, std::size_t count) const {
    if (!array_.is_raw) return decoded(array_.from, digits_of(skipped), count);
    return skipped > array_.from.size() ? "" : std::string(array_.from.substr(skipped, count));
  }
  // How many bytes there are behind `skipped`, at most.
  double present(std::size_t skipped) const {
    const double all =
        array_.is_raw
            ? static_cast<double>(array_.from.size())
            : static_cast<double>(std::ranges::count_if(array_.from, [](char c) { return digit_of(c) != kNone; })) * 3 /
                  4;
    return all - static_cast<double>(skipped);
  }
  // The array's size is more than there is.
  [[noreturn]] void fail_cut(double stated, double there) const {
    at_.fail(fmt::format("an array states {:.0f} bytes, and {:.0f} are there: the file is cut off or damaged", stated,
                         std::max(there, 0.)));
  }
  double word(std::string_view bytes, std::size_t begin, std::size_t width, bool is_signed = false) const {
    double number = 0;
    for (std::size_t k = 0; k < width; ++k) {
      const auto byte = static_cast<unsigned char>(bytes[begin + (storage_.is_big ? k : width - 1 - k)]);
      number = 256 * number + (is_signed && k == 0 ? static_cast<signed char>(byte) : byte);
    }
    return number;
  }
  void check_plain() const {
    const std::size_t width = storage_.width;
    const std::string header = part(0, width);
    if (header.size() < width) fail_cut(static_cast<double>(width), static_cast<double>(header.size()));
    const double stated = word(header, 0, width);
    if (stated > present(width)) fail_cut(stated, present(width));
    if (array_.is_offsets)
      check_offsets(part(0, width + static_cast<std::size_t>(stated)).substr(width), static_cast<double>(file_size_));
  }
  // The number of blocks, the size of each and of the last one when unpacked, then the packed size of each.
  void check_compressed() const {
    const std::size_t width = storage_.width;
    const std::string sizes = part(0, 3 * width);
    if (sizes.empty()) fail_cut(static_cast<double>(width), 0);
    if (sizes.size() < width || word(sizes, 0, width) == 0) return;  // an empty array has its number of blocks only
    if (sizes.size() < 3 * width) fail_cut(static_cast<double>(3 * width), static_cast<double>(sizes.size()));
    const double blocks = word(sizes, 0, width), size = word(sizes, width, width), last = word(sizes, 2 * width, width);
    const auto most = static_cast<double>(most_unpacked(file_size_));
    if (blocks > static_cast<double>(file_size_) || blocks * size > most)
      at_.fail(fmt::format("a compressed array states {} blocks of {} bytes, more than the file's {} bytes hold",
                           blocks, size, file_size_));
    const std::size_t head = width * (3 + static_cast<std::size_t>(blocks));
    const std::string header = part(0, head);
    if (header.size() < head) fail_cut(static_cast<double>(head), static_cast<double>(header.size()));
    double stated = 0;
    for (std::size_t b = 3 * width; b < head; b += width) stated += word(header, b, width);
    if (stated > present(head)) fail_cut(stated, present(head));
    if (array_.is_offsets && last <= size) check_blocks_of_offsets(header, head, size, last);
  }
  void check_blocks_of_offsets(const std::string& header, std::size_t head, double size, double last) const {
    const auto compressor = made();
    if (!compressor) return;
    const std::size_t width = storage_.width;
    std::string packed = part(head, array_.from.size());
    for (std::size_t b = 3 * width, begin = 0; b < head; b += width) {
      const auto length = static_cast<std::size_t>(word(header, b, width));
      const auto whole = static_cast<std::size_t>(b + width == head && last > 0 ? last : size);
      std::string bytes(whole, '\0');
      const auto got = compressor->Uncompress(reinterpret_cast<const unsigned char*>(packed.data()) + begin, length,
                                              reinterpret_cast<unsigned char*>(bytes.data()), whole);
      if (got != whole) at_.fail("a block of a compressed array does not unpack to its size: the file is damaged");
      check_offsets(bytes, static_cast<double>(most_unpacked(file_size_)));
      begin += length;
    }
  }
  vtkSmartPointer<vtkDataCompressor> made() const {
    if (storage_.compressor == "vtkZLibDataCompressor") return vtkSmartPointer<vtkZLibDataCompressor>::New();
    if (storage_.compressor == "vtkLZ4DataCompressor") return vtkSmartPointer<vtkLZ4DataCompressor>::New();
    if (storage_.compressor == "vtkLZMADataCompressor") return vtkSmartPointer<vtkLZMADataCompressor>::New();
    return nullptr;  // VTK refuses it
  }
  void check_offsets(std::string_view bytes, double most) const {
    const std::size_t digits = array_.type.find_first_of("0123456789");
    if (digits == array_.type.npos || array_.type.starts_with("Float")) return;
    const std::string bits = array_.type.substr(digits);
    const std::size_t width = bits == "8" ? 1 : bits == "16" ? 2 : bits == "32" ? 4 : 8;
    for (std::size_t b = 0; b + width <= bytes.size(); b += width)
      check_end_of_cell(word(bytes, b, width, array_.type.starts_with("Int")), most, file_size_, at_);
  }

  const VtpArray& array_;
  const VtpStorage& storage_;
  std::size_t file_size_;
  const FileLine& at_;
};

}  // namespace

void check_array(const VtpArray& array, const VtpStorage& storage, std::size_t file_size, const FileLine& at) {
  ArrayCheck(array, storage, file_size, at).run();
}

void check_end_of_cell(double entry, double most, std::size_t file_size, const FileLine& at) {
  if (entry > most)
    at.fail(fmt::format("an array of offsets ends a cell at entry {:.0f}, more than the file's {} bytes hold", entry,
                        file_size));
}

}  // namespace cageproof::mesh_files
