// SPDX-License-Identifier: MIT
// PLY files with their vertices elsewhere: the header and what is beside places are copied, coordinates become doubles.
#include "cageproof/reports/carried_mesh.h"

#include "cageproof/core/input_error.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cstdint>

namespace cageproof::reports {
namespace {

// A property of an element: a number, or a list of these with their count before them.
struct PlyProperty {
  std::string name;
  std::string type, count_type;  // the count's: empty where it is no list
  int axis = -1;                 // 0, 1, 2 of the vertices' coordinates
  bool is_left_out = false;
};

struct PlyElement {
  std::string name;
  std::size_t count = 0;
  std::vector<PlyProperty> properties;
};

struct PlyHeader {
  std::string text;  // as it is to be written
  std::vector<PlyElement> elements;
  bool is_ascii = false, is_big_endian = false;
};

[[noreturn]] void fail_ply(const std::string& reason) { throw InputError("the PLY file " + reason); }

// The line, without its end, and the end.
std::string_view take_header_line(std::string_view& rest, std::string_view& end) {
  const std::size_t content = std::min(rest.find_first_of("\r\n"), rest.size());
  const std::size_t after = content + (rest.substr(content).starts_with("\r\n") ? 2 : content < rest.size() ? 1 : 0);
  const std::string_view line = rest.substr(0, content);
  end = rest.substr(content, after - content);
  rest.remove_prefix(after);
  return line;
}

std::vector<std::string> words_of_line(std::string_view line) {
  std::vector<std::string> words;
  for (std::size_t at = 0; (at = line.find_first_not_of(" \t", at)) != std::string_view::npos;) {
    const std::size_t end = std::min(line.find_first_of(" \t", at), line.size());
    words.emplace_back(line.substr(at, end - at));
    at = end;
  }
  return words;
}

std::size_t count_in(std::string_view token) {
  std::size_t count = 0;
  const auto [end, error] = std::from_chars(token.data(), token.data() + token.size(), count);
  if (error != std::errc() || end != token.data() + token.size()) fail_ply(fmt::format("has '{}' for a count", token));
  return count;
}

// \pre words are those of a property's line
PlyProperty property_of(const std::vector<std::string>& words, const PlyElement& element) {
  const bool list = words.size() == 5 && words[1] == "list";
  if (!list && words.size() != 3) fail_ply("has a property that is not understood");
  PlyProperty property{words.back(), list ? words[3] : words[1], list ? words[2] : "", -1, false};
  if (element.name != "vertex" || list) return property;
  constexpr std::array<std::string_view, 3> axes{"x", "y", "z"}, normal{"nx", "ny", "nz"};
  const auto axis = std::ranges::find(axes, property.name);
  if (axis != axes.end()) property.axis = static_cast<int>(axis - axes.begin());
  property.is_left_out = std::ranges::find(normal, property.name) != normal.end();
  return property;
}

// Takes the header off the text.
PlyHeader take_header(std::string_view& rest, std::vector<std::string>& left_out) {
  PlyHeader header;
  while (!rest.empty()) {
    std::string_view end;
    const std::string_view line = take_header_line(rest, end);
    const std::vector<std::string> words = words_of_line(line);
    const std::string keyword = words.empty() ? "" : words[0];
    std::string written(line);
    if (keyword == "format" && words.size() > 1) {
      header.is_ascii = words[1] == "ascii";
      header.is_big_endian = words[1] == "binary_big_endian";
    } else if (keyword == "element" && words.size() == 3) {
      header.elements.push_back({words[1], count_in(words[2]), {}});
    } else if (keyword == "property" && !header.elements.empty()) {
      const PlyProperty property = property_of(words, header.elements.back());
      header.elements.back().properties.push_back(property);
      if (property.axis >= 0) written = "property double " + property.name;
      if (property.is_left_out) {
        if (left_out.empty()) left_out.emplace_back("normals");
        continue;
      }
    }
    header.text += written;
    header.text += end;
    if (keyword == "end_header") return header;
  }
  fail_ply("has no end_header");
}

std::size_t bytes_of_type(std::string_view type) {
  constexpr std::array<std::pair<std::string_view, std::size_t>, 16> sizes{{{"char", 1},
                                                                            {"uchar", 1},
                                                                            {"int8", 1},
                                                                            {"uint8", 1},
                                                                            {"short", 2},
                                                                            {"ushort", 2},
                                                                            {"int16", 2},
                                                                            {"uint16", 2},
                                                                            {"int", 4},
                                                                            {"uint", 4},
                                                                            {"int32", 4},
                                                                            {"uint32", 4},
                                                                            {"float", 4},
                                                                            {"float32", 4},
                                                                            {"double", 8},
                                                                            {"float64", 8}}};
  for (const auto& [name, size] : sizes)
    if (name == type) return size;
  fail_ply(fmt::format("has the unknown type '{}'", type));
}

// Numbers as they stand in a body, one after the other.
class PlyBody {
 public:
  PlyBody(const PlyHeader& header, std::string_view rest) : header_(header), rest_(rest) {}

  // The next number as it stands: a token, or bytes.
  std::string_view take(std::string_view type) {
    if (!header_.is_ascii) return take_bytes(bytes_of_type(type));
    const std::size_t at = rest_.find_first_not_of(" \t\r\n\v\f");
    if (at == std::string_view::npos) fail_ply("ends early");
    rest_.remove_prefix(at);
    return take_bytes(std::min(rest_.find_first_of(" \t\r\n\v\f"), rest_.size()));
  }

  std::size_t count_of(std::string_view number) const {
    if (header_.is_ascii) return count_in(number);
    std::uint64_t count = 0;
    for (std::size_t i = 0; i < number.size(); ++i) {
      const std::size_t place = header_.is_big_endian ? i : number.size() - 1 - i;
      count = count << 8 | static_cast<unsigned char>(number[place]);
    }
    return count;
  }

  void put(std::string& text, std::string_view number, bool& is_first) const {
    if (header_.is_ascii && !is_first) text += ' ';
    is_first = false;
    text += number;
  }

  std::string number_of(double value) const {
    if (header_.is_ascii) return fmt::format("{}", value);
    auto bytes = std::bit_cast<std::array<char, sizeof(double)>>(value);
    if (header_.is_big_endian != (std::endian::native == std::endian::big)) std::ranges::reverse(bytes);
    return {bytes.data(), bytes.size()};
  }

 private:
  std::string_view take_bytes(std::size_t size) {
    if (size > rest_.size()) fail_ply("ends early");
    const std::string_view taken = rest_.substr(0, size);
    rest_.remove_prefix(size);
    return taken;
  }

  const PlyHeader& header_;
  std::string_view rest_;
};

// One element with what is in the body, at another place where it is a vertex that has one.
void put_element(std::string& text, PlyBody& body, const PlyElement& element, const Vec3<double>* place) {
  bool is_first = true;
  for (const PlyProperty& property : element.properties) {
    if (!property.count_type.empty()) {
      const std::string_view number = body.take(property.count_type);
      body.put(text, number, is_first);
      for (std::size_t left = body.count_of(number); left > 0; --left)
        body.put(text, body.take(property.type), is_first);
      continue;
    }
    const std::string_view number = body.take(property.type);
    if (property.is_left_out) continue;
    if (property.axis >= 0 && place != nullptr) body.put(text, body.number_of((*place)[property.axis]), is_first);
    else body.put(text, number, is_first);
  }
}

}  // namespace

CarriedMesh ply_with_vertices(std::string_view text, std::span<const Vec3<double>> vertices) {
  CarriedMesh carried;
  const PlyHeader header = take_header(text, carried.left_out);
  carried.text = header.text;
  carried.text.reserve(header.text.size() + text.size() + 16 * vertices.size());
  PlyBody body(header, text);
  std::size_t count = 0;
  for (const PlyElement& element : header.elements) {
    const bool is_vertex = element.name == "vertex";
    if (is_vertex) count += element.count;
    if (is_vertex && element.count != vertices.size()) break;
    for (std::size_t k = 0; k < element.count; ++k) {
      put_element(carried.text, body, element, is_vertex ? &vertices[k] : nullptr);
      if (header.is_ascii) carried.text += '\n';
    }
  }
  if (count != vertices.size())
    throw InputError(fmt::format("the PLY file has {} vertices, and {} were read", count, vertices.size()));
  return carried;
}

}  // namespace cageproof::reports
