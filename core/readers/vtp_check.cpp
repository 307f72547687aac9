// SPDX-License-Identifier: MIT
// Checks what compressed arrays and offsets of a VTP file state, before VTK 9.1 walks over as many blocks, or makes
// room for as many entries, be they billions.
#include "vtp_check.h"

#include "cage/mesh_files.h"

#include <fmt/format.h>
#include <libxml/xmlreader.h>

#include <charconv>
#include <cstdint>
#include <memory>

namespace cageproof::mesh_files {
namespace {

// The first bytes of base64, at most as many as asked for.
std::string decoded(std::string_view text, std::size_t count) {
  constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string bytes;
  unsigned bits = 0;
  int length = 0;
  for (const char c : text) {
    const std::size_t digit = digits.find(c);
    if (digit == digits.npos) continue;
    bits = (bits << 6 | static_cast<unsigned>(digit)) & 0xffffffU;
    length += 6;
    if (length < 8) continue;
    length -= 8;
    bytes += static_cast<char>(bits >> length & 0xffU);
    if (bytes.size() == count) break;
  }
  return bytes;
}

class BlockCheck {
 public:
  BlockCheck(std::string_view file, const FileLine& at) : file_(file), at_(at) {}

  void run() {
    const std::unique_ptr<xmlTextReader, void (*)(xmlTextReaderPtr)> reader(
        xmlReaderForMemory(file_.data(), static_cast<int>(file_.size()), nullptr, nullptr,
                           XML_PARSE_NONET | XML_PARSE_NOERROR | XML_PARSE_NOWARNING | XML_PARSE_HUGE),
        xmlFreeTextReader);
    while (reader && xmlTextReaderRead(reader.get()) == 1) read_node(*reader);
  }

 private:
  static std::string value(xmlTextReader& reader, const char* name) {
    const std::unique_ptr<xmlChar, void (*)(void*)> text(
        xmlTextReaderGetAttribute(&reader, reinterpret_cast<const xmlChar*>(name)), xmlFree);
    return text ? reinterpret_cast<const char*>(text.get()) : "";
  }
  static std::string_view view(const xmlChar* text) { return text ? reinterpret_cast<const char*>(text) : ""; }

  void read_node(xmlTextReader& reader) {
    const int type = xmlTextReaderNodeType(&reader);
    if (type == XML_READER_TYPE_TEXT && is_binary_) check(decoded(view(xmlTextReaderConstValue(&reader)), 2 * width_));
    if (type == XML_READER_TYPE_TEXT && is_offsets_) check_offsets(view(xmlTextReaderConstValue(&reader)));
    if (type != XML_READER_TYPE_ELEMENT) return;
    const std::string_view name = view(xmlTextReaderConstName(&reader));
    if (name == "VTKFile") {
      is_compressed_ = !value(reader, "compressor").empty();
      is_big_ = value(reader, "byte_order") == "BigEndian";
      width_ = value(reader, "header_type") == "UInt64" ? sizeof(std::uint64_t) : sizeof(std::uint32_t);
    }
    const std::string format = value(reader, "format");
    is_binary_ = format == "binary";
    is_offsets_ = format == "ascii" && value(reader, "Name") == "offsets";
    if (format == "appended") add_offset(value(reader, "offset"));
    if (name == "AppendedData") check_appended(value(reader, "encoding") == "raw");
  }
  // Ends of cells in the array of their vertices, for which VTK makes room before it looks at what there is.
  void check_offsets(std::string_view text) const {
    const char* const end = text.data() + text.size();
    for (const char* at = text.data(); at != end;) {
      double entries = 0;
      const auto [next, error] = std::from_chars(at, end, entries);
      if (error == std::errc() && entries > static_cast<double>(file_.size()))
        at_.fail(fmt::format("an array of offsets ends a cell at entry {}, more than the file's {} bytes hold", entries,
                             file_.size()));
      at = error == std::errc() ? next : at + 1;
    }
  }
  void add_offset(std::string_view text) {
    std::size_t offset = 0;
    std::from_chars(text.data(), text.data() + text.size(), offset);
    offsets_.push_back(offset);
  }
  // Checks the arrays in <AppendedData>. They are found in the file's bytes, because raw ones are not XML.
  void check_appended(bool is_raw) const {
    const std::size_t tag = file_.find("<AppendedData"), mark = file_.find('_', file_.find('>', tag));
    if (tag == file_.npos || mark == file_.npos) return;
    const std::string_view data = file_.substr(mark + 1);
    for (const std::size_t offset : offsets_) {
      if (offset >= data.size()) continue;
      const std::string_view from = data.substr(offset);
      check(is_raw ? std::string(from.substr(0, 2 * width_)) : decoded(from, 2 * width_));
    }
  }
  // How many blocks there are, and of how many bytes each is when it is unpacked.
  void check(const std::string& header) const {
    if (!is_compressed_ || header.size() < 2 * width_) return;
    const double blocks = word(header, 0), size = word(header, width_);
    if (blocks > static_cast<double>(file_.size()) || blocks * size > static_cast<double>(most_unpacked(file_.size())))
      at_.fail(fmt::format("a compressed array states {} blocks of {} bytes, more than the file's {} bytes hold",
                           blocks, size, file_.size()));
  }
  double word(std::string_view bytes, std::size_t begin) const {
    double number = 0;
    for (std::size_t k = 0; k < width_; ++k)
      number = 256 * number + static_cast<unsigned char>(bytes[begin + (is_big_ ? k : width_ - 1 - k)]);
    return number;
  }

  std::string_view file_;
  const FileLine& at_;
  std::vector<std::size_t> offsets_;
  std::size_t width_ = sizeof(std::uint32_t);
  bool is_compressed_ = false, is_big_ = false, is_binary_ = false, is_offsets_ = false;
};

}  // namespace

void check_blocks(std::string_view file, const FileLine& at) { BlockCheck(file, at).run(); }

}  // namespace cageproof::mesh_files
