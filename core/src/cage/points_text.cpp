// SPDX-License-Identifier: MIT
// Points of text, a line each, in the columns that programs write.
#include "mesh_files.h"
#include "points_files.h"

#include "cageproof/core/numbers/scalar_text.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <optional>

namespace cageproof::mesh_files {
namespace {

using Fields = std::vector<std::string_view>;

[[noreturn]] void fail_decimal_comma(std::string_view field, const FileLine& at) {
  at.fail(shown(field) + " has a decimal comma; numbers are read with decimal points");
}

// Between semicolons, or commas, or else blanks. Names of columns may have blanks, numbers between commas none.
Fields fields_of(std::string_view line) {
  Fields fields;
  const std::size_t first = line.find_first_of(";,");
  const char separator = line.find(';') != line.npos ? ';' : first != line.npos ? ',' : ' ';
  if (separator == ' ') {
    for (auto token = take_token(line); !token.empty(); token = take_token(line)) fields.push_back(token);
    return fields;
  }
  for (bool more = true; more;) {
    const std::size_t end = line.find(separator);
    std::string_view field = line.substr(0, end);
    field.remove_prefix(std::min(field.find_first_not_of(" \t"), field.size()));
    fields.push_back(field.substr(0, field.find_last_not_of(" \t") + 1));
    more = end != line.npos;
    if (more) line.remove_prefix(end + 1);
  }
  if (fields.back().empty()) fields.pop_back();  // a separator ends the line
  return fields;
}

bool begins_as_number(std::string_view field) {
  return field.empty() || field.find_first_of("0123456789.+-") == 0 || parse_scalar<double>(field).has_value();
}

// A name of a column, in lower case and without quotes.
std::string plain(std::string_view name) {
  std::string text;
  for (const unsigned char c : name)
    if (c != '"' && c != '\'') text += static_cast<char>(std::tolower(c));
  return text;
}

class TextReader {
 public:
  TextReader(const std::filesystem::path& path, int dimension) : at_{path}, dimension_(dimension) {}

  Mesh read(std::string_view text) {
    for (std::string_view line; take_line(text, line);) {
      ++at_.line;
      line = without_comment(line);
      if (line.find_first_not_of(" \t") == line.npos) continue;
      read_line(fields_of(line), line);
      is_first_ = false;
    }
    if (count_ && *count_ != mesh_.vertices.size())
      FileLine{at_.file, count_line_}.fail(
          fmt::format("{} points are announced, {} follow", *count_, mesh_.vertices.size()));
    if (mesh_.vertices.empty()) FileLine{at_.file}.fail("no points");
    if (columns_.empty() && !are_named_in_order())
      mesh_.warnings.push_back(fmt::format("{}: the columns {} are taken for x, y{}", at_.file.string(),
                                           fmt::join(names_, ", "), names_.size() == 3 ? ", z" : ""));
    if (width_ > used())
      mesh_.warnings.push_back(
          fmt::format("{}: {} of {} columns are left out; {} are taken for x, y{}", at_.file.string(), width_ - used(),
                      width_, columns_.empty() ? "the first" : "those of these names", used() == 3 ? ", z" : ""));
    return std::move(mesh_);
  }

 private:
  // Whether names have an x, a y and a z in them, in this order: "x0, y0, z0".
  bool are_named_in_order() const {
    for (std::size_t i = 0; i < names_.size(); ++i)
      if (i >= 3 || names_[i].find("xyz"[i]) == std::string::npos) return false;
    return true;
  }

  std::size_t used() const { return columns_.empty() ? 3 : columns_.size(); }

  void read_line(const Fields& fields, std::string_view line) {
    // A column may have no name, as a table's index.
    const auto is_no_name = [](std::string_view field) { return !field.empty() && begins_as_number(field); };
    if (is_first_ && std::ranges::none_of(fields, is_no_name)) return read_names(fields);
    if (is_first_ && fields.size() == 1 && read_count(fields[0])) return;
    if (mesh_.vertices.empty()) check_names(fields, line);
    check_width(fields);
    Vec3<double> point = Vec3<double>::Zero();
    const std::size_t count = std::min(used(), fields.size());
    for (std::size_t i = 0; i < count; ++i) {
      const std::string_view field = fields[columns_.empty() ? i : columns_[i]];
      point[static_cast<int>(i)] = number(field);
      if (dimension_ == 2 && i == 2 && point[2] != 0)
        at_.fail(fmt::format("3D points for a polygon: the third number is {}, not 0", shown(field)));
    }
    mesh_.vertices.push_back(point);
  }

  // Columns that are named x, y, z are these wherever they stand.
  void read_names(const Fields& fields) {
    for (const std::string_view field : fields) names_.push_back(plain(field));
    for (const char* name : {"x", "y", "z"})
      if (const auto found = std::ranges::find(names_, name); found != names_.end())
        columns_.push_back(static_cast<std::size_t>(found - names_.begin()));
    const auto has = [&](const char* name) { return std::ranges::find(names_, name) != names_.end(); };
    if (!has("x") || !has("y") || (dimension_ == 3 && !has("z"))) columns_.clear();
  }
  // Checks the first line's names before the first point. A title's words are not names.
  void check_names(const Fields& fields, std::string_view line) {
    const std::size_t count = fields.size();
    const std::string wanted = dimension_ == 3 ? "x, y, z" : "x, y";
    if (columns_.empty() && names_.size() != count) names_.clear();
    if (columns_.empty() && !names_.empty() && count > 3)
      at_.fail(fmt::format("{} columns, and the header names none of them {}; name these, or leave out the others",
                           count, wanted));
    if (columns_.empty() && count > 3 && line.find(',') != line.npos && line.find_first_of(".eExX") == line.npos)
      at_.fail(
          fmt::format("{} whole numbers between commas: decimal commas are not read, write points; if these are "
                      "columns, name {} in a header line",
                      count, wanted));
  }

  bool read_count(std::string_view field) {
    std::size_t count = 0;
    const auto [end, error] = std::from_chars(field.data(), field.data() + field.size(), count);
    if (error != std::errc{} || end != field.data() + field.size()) return false;
    count_ = count;
    count_line_ = at_.line;
    return true;
  }

  void check_width(const Fields& fields) {
    const std::size_t count = fields.size();
    if (count < 2 || (count == 2 && dimension_ == 3)) {
      for (const std::string_view field : fields) number(field);
      at_.fail(
          fmt::format("a point has {} coordinates, here are {} numbers", dimension_ == 3 ? "three" : "two", count));
    }
    const std::size_t expected = columns_.empty() ? width_ : names_.size();
    // In the plane, third numbers may be left out.
    const bool few = std::max(count, expected) <= 3 && columns_.empty();
    if (expected != 0 && count != expected && !few)
      at_.fail(fmt::format("{} numbers, {} {}", count, columns_.empty() ? "the first point has" : "the header names",
                           expected));
    width_ = std::max(width_, count);
  }

  double number(std::string_view field) const {
    if (field.empty()) at_.fail("an empty field");
    if (field.find(',') != field.npos) fail_decimal_comma(field, at_);
    if (field.find_first_of(" \t") != field.npos)
      at_.fail(
          fmt::format("{} is a field with a blank in it, between commas or semicolons; separate by one of them, or "
                      "blanks only; decimal commas are not read",
                      shown(field)));
    return finite_number(field, at_);
  }

  FileLine at_;
  int dimension_;
  Mesh mesh_;
  bool is_first_ = true;
  std::vector<std::string> names_;
  std::vector<std::size_t> columns_;  // of x, y and z, where they are named
  std::optional<std::size_t> count_;
  std::size_t count_line_ = 0, width_ = 0;
};

// A mesh format that a text without a suffix may have, and its suffix; nothing if the text has points.
struct MeshFormat {
  std::string_view first, name, suffix;
};
std::optional<MeshFormat> mesh_format_of(std::string_view text) {
  constexpr std::array<MeshFormat, 14> formats{{{"ply", "PLY", ".ply"},
                                                {"OFF", "OFF", ".off"},
                                                {"COFF", "OFF", ".off"},
                                                {"NOFF", "OFF", ".off"},
                                                {"STOFF", "OFF", ".off"},
                                                {"solid", "STL", ".stl"},
                                                {"v", "OBJ", ".obj"},
                                                {"o", "OBJ", ".obj"},
                                                {"g", "OBJ", ".obj"},
                                                {"mtllib", "OBJ", ".obj"},
                                                {"<?xml", "XML", ".svg or .vtp"},
                                                {"<svg", "SVG", ".svg"},
                                                {"<VTKFile", "VTP", ".vtp"},
                                                {"{", "JSON", ".geojson"}}};
  std::string_view line;
  while (take_line(text, line)) {
    line = without_comment(line);
    const std::string_view word = take_token(line);
    if (word.empty()) continue;
    const bool opens = word[0] == '<' || word[0] == '{';
    for (const MeshFormat& format : formats)
      if (opens ? word.starts_with(format.first) : word == format.first) return format;
    break;
  }
  return std::nullopt;
}

}  // namespace

bool is_text_of_points(const std::filesystem::path& path) {
  constexpr std::array<std::string_view, 6> extensions{".csv", ".tsv", ".xyz", ".pts", ".txt", ""};
  return std::ranges::find(extensions, extension_of(path)) != extensions.end();
}

Mesh read_text_points(const std::filesystem::path& path, int dimension) {
  const std::string file = read_mesh_file(path);
  if (file.starts_with("\x93NUMPY")) return points_of_array(file, path);
  if (file.starts_with("PK\x03\x04"))
    FileLine{path}.fail("a ZIP file; arrays of NumPy's in one are read from .npz files");
  if (const auto format = path.has_extension() ? std::nullopt : mesh_format_of(without_mark(file)))
    FileLine{path}.fail(
        fmt::format("a file in {} format, by its first word, where text with a point per line is read; "
                    "meshes are read from files whose names say the format: {}",
                    format->name, format->suffix));
  return TextReader(path, dimension).read(without_mark(file));
}

}  // namespace cageproof::mesh_files
