// SPDX-License-Identifier: MIT
// Walks a PLY file's header and body, and makes the copy of it that VTK's reader can bear.
#include "cage/mesh_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <set>

namespace cageproof::mesh_files {
namespace {

using Decode = double (*)(const char*);

template <class T>
double decode(const char* bytes) {
  T x;
  std::memcpy(&x, bytes, sizeof x);
  return static_cast<double>(x);
}

struct Type {
  std::string_view name, alias;
  std::size_t size;
  Decode decode;
  bool is_real = false;
};

constexpr std::array kTypes{
    Type{"char", "int8", 1, decode<std::int8_t>},     Type{"uchar", "uint8", 1, decode<std::uint8_t>},
    Type{"short", "int16", 2, decode<std::int16_t>},  Type{"ushort", "uint16", 2, decode<std::uint16_t>},
    Type{"int", "int32", 4, decode<std::int32_t>},    Type{"uint", "uint32", 4, decode<std::uint32_t>},
    Type{"float", "float32", 4, decode<float>, true}, Type{"double", "float64", 8, decode<double>, true}};

struct Property {
  std::string_view name;
  const Type* type;
  const Type* count_type;  // null: not a list
};

struct Element {
  std::string_view name;
  std::size_t count;
  std::vector<Property> properties;
  std::set<std::string_view> property_names = {};
};

struct Header {
  std::string_view format;
  std::vector<Element> elements;
  std::set<std::string_view> element_names = {};
};

const Type* type_named(std::string_view name, const FileLine& at) {
  const auto found = std::ranges::find_if(kTypes, [&](const Type& t) { return t.name == name || t.alias == name; });
  if (found == kTypes.end()) at.fail(shown(name) + " is not a PLY type");
  return &*found;
}

// Takes a header line's last token.
std::string_view take_last(std::string_view& line, const FileLine& at) {
  const std::string_view token = take_token(line);
  if (token.empty() || !take_token(line).empty()) at.fail("a header line has too few or too many words");
  return token;
}

Element parse_element(std::string_view line, const FileLine& at) {
  const std::string_view name = take_token(line);
  const double count = finite_number(take_last(line, at), at);
  if (!(count >= 0 && count < 0x1p31 && count == std::floor(count))) at.fail("an element's count is out of range");
  return {name, static_cast<std::size_t>(count), {}};
}

Property parse_property(std::string_view line, const FileLine& at) {
  const std::string_view first = take_token(line);
  const Type* count_type = first == "list" ? type_named(take_token(line), at) : nullptr;
  const Type* type = type_named(count_type ? take_token(line) : first, at);
  if (count_type && count_type->is_real) at.fail("a list's length is no whole number");
  return {take_last(line, at), type, count_type};
}

void add_element(Header& header, const Element& element, const FileLine& at) {
  if (!header.element_names.insert(element.name).second) at.fail("element " + shown(element.name) + " occurs twice");
  header.elements.push_back(element);
}

void add_property(Header& header, const Property& property, const FileLine& at) {
  if (header.elements.empty()) at.fail("a property before the first element");
  Element& element = header.elements.back();
  if (!element.property_names.insert(property.name).second)
    at.fail("property " + shown(property.name) + " occurs twice");
  element.properties.push_back(property);
}

Header parse_header(std::string_view& rest, FileLine& at) {
  Header header;
  for (std::string_view line; take_line(rest, line);) {
    ++at.line;
    const std::string_view keyword = take_token(line);
    if (at.line == 1) {
      if (keyword != "ply" || !take_token(line).empty())
        at.fail(fmt::format("not a PLY file: it begins with {}, not with a line \"ply\"", shown(keyword)));
    } else if (keyword == "format") {
      header.format = take_token(line);
      take_last(line, at);
    } else if (keyword == "element") {
      add_element(header, parse_element(line, at), at);
    } else if (keyword == "property") {
      add_property(header, parse_property(line, at), at);
    } else if (keyword == "end_header") {
      for (const Element& element : header.elements)
        if (element.properties.empty()) at.fail("element " + shown(element.name) + " has no properties");
      return header;
    } else if (!keyword.empty() && keyword != "comment" && keyword != "obj_info") {
      at.fail(shown(keyword) + " is not a PLY keyword");
    }
  }
  at.fail("the header has no end");
}

// The body's numbers, one after the other. In text white space separates them, whatever lines they stand in.
class Body {
 public:
  Body(std::string_view format, std::string_view rest, FileLine& at) : tokens_{rest, at}, at_(at) {
    is_text_ = format == "ascii";
    if (!is_text_ && format != "binary_little_endian" && format != "binary_big_endian")
      FileLine{at.file}.fail("unknown PLY format " + shown(format));
    is_swapped_ = (format == "binary_big_endian") != (std::endian::native == std::endian::big);
    if (!is_text_) at_.line = 0;
  }
  void begin_record(std::string_view element, std::size_t index) {
    element_ = element;
    index_ = index;
    first_line_ = 0;
  }
  double next(const Type& type) {
    if (is_text_) return finite_number(next_token(), at_);
    if (tokens_.rest.size() < type.size) fail_short();
    std::array<char, 8> bytes{};
    std::copy_n(tokens_.rest.begin(), type.size, bytes.begin());
    if (is_swapped_) std::reverse(bytes.begin(), bytes.begin() + type.size);
    tokens_.rest.remove_prefix(type.size);
    return type.decode(bytes.data());
  }
  /// Passes over a number that nobody asks for; it may be NaN.
  void skip(const Type& type) {
    if (is_text_) next_token();
    else next(type);
  }
  void end_record() {
    std::string_view behind = tokens_.line;
    if (ragged_line_ == 0 && (first_line_ != at_.line || !take_token(behind).empty())) ragged_line_ = first_line_;
  }
  /// Behind the last element. \return how many bytes a binary file has there
  std::size_t end() {
    if (!is_text_) return tokens_.rest.size();
    if (!tokens_.take().empty()) fail("more numbers than the header states");
    return 0;
  }
  /// A number too many or too few in text may be noticed lines behind it.
  [[noreturn]] void fail(const std::string& reason) const {
    at_.fail(fmt::format("{} {}: {}{}", element_, index_, reason,
                         ragged_line_ == 0 ? ""
                                           : fmt::format("; line {} is the first one with more or fewer numbers "
                                                         "than an element has",
                                                         ragged_line_)));
  }

 private:
  std::string_view next_token() {
    const std::string_view token = tokens_.take();
    if (token.empty()) fail_short();
    if (first_line_ == 0) first_line_ = at_.line;
    return token;
  }
  [[noreturn]] void fail_short() const { fail("the file ends, it has fewer numbers than the header states"); }

  Tokens tokens_;
  std::string_view element_;
  std::size_t index_ = 0;
  std::size_t first_line_ = 0, ragged_line_ = 0;  // of the record, and of the first one that is not one line
  FileLine& at_;
  bool is_text_ = false, is_swapped_ = false;
};

bool is_corner_list(const Property& property) {
  return property.count_type && (property.name == "vertex_indices" || property.name == "vertex_index");
}

double list_length(Body& body, const Property& property) {
  const double length = body.next(*property.count_type);
  if (!(length >= 0)) body.fail(fmt::format("a list of length {}", length));
  return length;
}

template <class T>
void append(std::string& bytes, T x) {
  const auto raw = std::bit_cast<std::array<char, sizeof x>>(x);
  bytes.append(raw.data(), raw.size());
}

// Reads a face's corners into the copy for VTK.
void copy_corners(Body& body, const Property& property, std::size_t vertex_count, std::string& for_vtk) {
  constexpr double most = 255;  // VTK's reader counts in one byte
  const double length = list_length(body, property);
  if (!(length >= 3 && length <= most)) body.fail(fmt::format("{} corners; faces have 3 to {}", length, most));
  append(for_vtk, static_cast<std::uint8_t>(length));
  for (int k = 0; k < static_cast<int>(length); ++k) {
    const double x = body.next(*property.type);
    if (!(x >= 0 && x < static_cast<double>(vertex_count) && x == std::floor(x)))
      body.fail(fmt::format("index {} is out of range, there are {} vertices", x, vertex_count));
    append(for_vtk, static_cast<std::int32_t>(x));
  }
}

void pass_over(Body& body, const Property& property) {
  const double length = property.count_type ? list_length(body, property) : 1;
  for (double k = 0; k < length; ++k) body.skip(*property.type);
}

struct Layout {
  std::size_t vertex_count = 0, face_count = 0;
  const Property* corners = nullptr;  // null: a point set
};

Layout layout_of(const Header& header, const std::filesystem::path& path) {
  Layout layout;
  for (const Element& element : header.elements) {
    if (element.name == "vertex") {
      layout.vertex_count = element.count;
      for (const std::string_view axis : {"x", "y", "z"})
        if (std::ranges::none_of(element.properties,
                                 [&](const Property& p) { return p.name == axis && !p.count_type; }))
          FileLine{path}.fail(fmt::format("vertices have no coordinate \"{}\"", axis));
    } else if (element.name == "face" && element.count > 0) {
      const auto corners = std::ranges::find_if(element.properties, is_corner_list);
      if (corners == element.properties.end()) FileLine{path}.fail("faces have no list \"vertex_indices\"");
      layout.corners = &*corners;
      layout.face_count = element.count;
    } else if (element.name.starts_with("tristrip") && element.count > 0) {
      FileLine{path}.fail("triangle strips; write them as triangles");
    }
  }
  if (layout.vertex_count == 0) FileLine{path}.fail("no vertices");
  return layout;
}

std::string header_for_vtk(const Layout& layout) {
  static_assert(std::endian::native == std::endian::little);
  return fmt::format(
      "ply\nformat binary_little_endian 1.0\nelement vertex {}\nproperty float x\nproperty float y\n"
      "property float z\nelement face {}\nproperty list uchar int vertex_indices\nend_header\n",
      layout.vertex_count, layout.face_count);
}

}  // namespace

CheckedPly check_ply(const std::filesystem::path& path, std::string_view text) {
  FileLine at{path};
  const Header header = parse_header(text, at);
  const Layout layout = layout_of(header, path);
  CheckedPly checked;
  checked.face_count = layout.face_count;
  std::string faces;
  Body body(header.format, text, at);
  for (const Element& element : header.elements) {
    const bool is_vertex = element.name == "vertex";
    for (std::size_t i = 0; i < element.count; ++i) {
      body.begin_record(element.name, i);
      Vec3<double> vertex = Vec3<double>::Zero();
      for (const Property& property : element.properties) {
        const std::size_t axis =
            property.name.size() == 1 ? std::string_view("xyz").find(property.name) : std::string_view::npos;
        if (&property == layout.corners) copy_corners(body, property, layout.vertex_count, faces);
        else if (is_vertex && axis != std::string_view::npos) vertex[axis] = body.next(*property.type);
        else pass_over(body, property);
      }
      body.end_record();
      if (!is_vertex) continue;
      if (!vertex.allFinite()) body.fail("a coordinate is not finite");
      checked.vertices.push_back(vertex);
    }
  }
  if (const std::size_t left = body.end(); left > 0)
    checked.warnings.push_back(fmt::format("{}: {} bytes behind the last element are left out", path.string(), left));
  constexpr std::size_t bytes_a_vertex = 3 * sizeof(float);
  checked.for_vtk = header_for_vtk(layout) + std::string(bytes_a_vertex * layout.vertex_count, '\0') + faces;
  return checked;
}

}  // namespace cageproof::mesh_files
