// SPDX-License-Identifier: MIT
// Checks what arrays of a VTP file state, before VTK 9.1 walks over as many blocks, or makes room for as many entries,
// be they billions.
#include "vtp_check.h"

#include "vtp_array.h"

#include <fmt/format.h>
#include <libxml/xmlreader.h>

#include <charconv>
#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace cageproof::mesh_files {
namespace {

class FileCheck {
 public:
  FileCheck(std::string_view file, const FileLine& at) : file_(file), at_(at) {}

  void run() {
    // Appended data may be bytes that are no XML. The XML reader would stop at them, blocks before it gets there.
    const std::size_t appended = file_.find("<AppendedData"), begin = file_.find('>', appended);
    std::string xml(file_.substr(0, begin == file_.npos ? begin : begin + 1));
    if (begin != file_.npos) xml += "</AppendedData></VTKFile>";
    const std::unique_ptr<xmlTextReader, void (*)(xmlTextReaderPtr)> reader(
        xmlReaderForMemory(xml.data(), static_cast<int>(xml.size()), nullptr, nullptr,
                           XML_PARSE_NONET | XML_PARSE_NOERROR | XML_PARSE_NOWARNING | XML_PARSE_HUGE),
        xmlFreeTextReader);
    while (reader && xmlTextReaderRead(reader.get()) == 1) {
      // The reader takes a thousand bytes for an element that is open.
      constexpr int kDeepest = 100;
      if (xmlTextReaderDepth(reader.get()) > kDeepest)
        at_.fail(fmt::format("elements lie within each other {} deep: this is no VTP file", kDeepest));
      read_node(*reader);
    }
    if (!appended_.empty())
      at_.fail(
          fmt::format("{} arrays are in appended data that the file does not have: it is cut off", appended_.size()));
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
    if (type == XML_READER_TYPE_TEXT && is_binary_) {
      array_.from = view(xmlTextReaderConstValue(&reader));
      check_array(array_, storage_, file_.size(), at_);
    }
    if (type == XML_READER_TYPE_TEXT && is_text_of_offsets_) check_offsets(view(xmlTextReaderConstValue(&reader)));
    if (type != XML_READER_TYPE_ELEMENT) return;
    const std::string_view name = view(xmlTextReaderConstName(&reader));
    if (name == "VTKFile")
      storage_ = {value(reader, "compressor"), value(reader, "byte_order") == "BigEndian",
                  value(reader, "header_type") == "UInt64" ? sizeof(std::uint64_t) : sizeof(std::uint32_t)};
    const std::string format = value(reader, "format");
    if (const std::string components = value(reader, "NumberOfComponents"); components.starts_with('-'))
      at_.fail(fmt::format("an array has {} components", components));
    array_ = {.type = value(reader, "type"), .is_offsets = value(reader, "Name") == "offsets"};
    is_binary_ = format == "binary";
    is_text_of_offsets_ = format == "ascii" && array_.is_offsets;
    if (format == "appended") add_appended(value(reader, "offset"));
    if (name == "AppendedData") check_appended(value(reader, "encoding") == "raw");
  }
  void check_offsets(std::string_view text) const {
    const char* const end = text.data() + text.size();
    for (const char* at = text.data(); at != end;) {
      double entry = 0;
      const auto [next, error] = std::from_chars(at, end, entry);
      if (error == std::errc()) check_end_of_cell(entry, static_cast<double>(file_.size()), file_.size(), at_);
      at = error == std::errc() ? next : at + 1;
    }
  }
  void add_appended(std::string_view text) {
    std::size_t offset = 0;
    // Writers leave room for longer numbers.
    while (text.ends_with(' ')) text.remove_suffix(1);
    while (text.starts_with(' ')) text.remove_prefix(1);
    const char* const end = text.data() + text.size();
    if (const auto [next, error] = std::from_chars(text.data(), end, offset); error != std::errc() || next != end)
      at_.fail(fmt::format("an array's offset \"{}\" is no number of bytes", text));
    appended_.emplace_back(offset, array_);
  }
  // Checks the arrays in <AppendedData>.
  void check_appended(bool is_raw) {
    const std::size_t mark = file_.find('_', file_.find('>', file_.find("<AppendedData")));
    if (mark == file_.npos) return;
    const std::size_t end = is_raw ? file_.rfind("</AppendedData>") : file_.find("</AppendedData>", mark);
    if (end == file_.npos || end < mark || file_.find("</VTKFile>", end) == file_.npos)
      at_.fail("the appended data do not end: the file is cut off");
    const std::string_view data = file_.substr(mark + 1, end - mark - 1);
    for (auto& [offset, array] : appended_) {
      if (offset >= data.size())
        at_.fail(fmt::format("an array begins at byte {} of appended data that have {}: the file is cut off or damaged",
                             offset, data.size()));
      array.from = data.substr(offset);
      array.is_raw = is_raw;
      check_array(array, storage_, file_.size(), at_);
    }
    appended_.clear();
  }

  std::string_view file_;
  const FileLine& at_;
  VtpStorage storage_;
  VtpArray array_;  // of the element that was read last
  std::vector<std::pair<std::size_t, VtpArray>> appended_;
  bool is_binary_ = false, is_text_of_offsets_ = false;
};

}  // namespace

void check_arrays(std::string_view file, const FileLine& at) { FileCheck(file, at).run(); }

}  // namespace cageproof::mesh_files
