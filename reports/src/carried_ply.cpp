// SPDX-License-Identifier: MIT
// PLY files whose vertices move: the header line by line, then the records of each element.
#include "cageproof/reports/carried_mesh.h"

#include "cageproof/core/input_error.h"
#include "cageproof/core/numbers/scalar_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <cstring>
#include <optional>

namespace cageproof::reports {
namespace {

constexpr std::string_view kPlyBlanks = " \t\v\f\r\n";

struct PlyProperty {
  std::size_t size, count_size;  // bytes of a number, and of a list's length, which is 0 where there is no list
  bool left_out = false;
  int axis = -1;  // of a vertex's coordinate
};

struct PlyElement {
  std::string name;
  std::size_t count;
  std::vector<PlyProperty> properties;
};

std::size_t size_of_type(std::string_view name) {
  constexpr std::array<std::pair<std::string_view, std::size_t>, 16> sizes{{{"char", 1},
                                                                            {"int8", 1},
                                                                            {"uchar", 1},
                                                                            {"uint8", 1},
                                                                            {"short", 2},
                                                                            {"int16", 2},
                                                                            {"ushort", 2},
                                                                            {"uint16", 2},
                                                                            {"int", 4},
                                                                            {"int32", 4},
                                                                            {"uint", 4},
                                                                            {"uint32", 4},
                                                                            {"float", 4},
                                                                            {"float32", 4},
                                                                            {"double", 8},
                                                                            {"float64", 8}}};
  const auto* const found = std::ranges::find(sizes, name, &std::pair<std::string_view, std::size_t>::first);
  if (found == sizes.end()) throw InputError(fmt::format("'{}' is not a PLY type", name));
  return found->second;
}

// Takes the next word, empty at the end.
std::string_view take_word(std::string_view& rest) {
  rest.remove_prefix(std::min(rest.find_first_not_of(kPlyBlanks), rest.size()));
  const std::string_view word = rest.substr(0, rest.find_first_of(kPlyBlanks));
  rest.remove_prefix(word.size());
  return word;
}

double number_of(std::string_view word) {
  const std::optional<double> x = parse_scalar<double>(word);
  if (!x || !(*x >= 0 && *x < 0x1p32)) throw InputError(fmt::format("'{}' is no count of a PLY file", word));
  return *x;
}

class PlyCopy {
 public:
  PlyCopy(std::string_view text, std::span<const Vec3<double>> vertices) : rest_(text), vertices_(vertices) {
    made_.text.reserve(text.size() + 3 * sizeof(double) * vertices.size());
  }

  CarriedMesh copy() {
    while (copy_header_line()) continue;
    for (const PlyElement& element : elements_)
      for (std::size_t i = 0; i < element.count; ++i) {
        if (is_text_) copy_text_record(element, i);
        else copy_binary_record(element, i);
      }
    return std::move(made_);
  }

 private:
  // LF, CRLF or CR ends it. \return false behind the last line
  bool copy_header_line() {
    if (rest_.empty()) throw InputError("the PLY file's header has no end");
    const std::size_t length = std::min(rest_.find_first_of("\r\n"), rest_.size());
    end_ = rest_.substr(length, rest_.substr(length).starts_with("\r\n") ? 2 : 1);
    std::string_view line = rest_.substr(0, length);
    const std::string_view whole = rest_.substr(0, length + end_.size());
    rest_.remove_prefix(whole.size());
    const std::string_view keyword = take_word(line);
    if (keyword == "format") {
      const std::string_view format = take_word(line);
      is_text_ = format == "ascii";
      is_swapped_ = (format == "binary_big_endian") != (std::endian::native == std::endian::big);
    } else if (keyword == "element") {
      begin_element(line);
    } else if (keyword == "property" && !elements_.empty()) {
      copy_property(line, whole);
      return true;
    }
    made_.text += whole;
    return keyword != "end_header";
  }
  void begin_element(std::string_view line) {
    const std::string_view name = take_word(line);
    // "8" and "8.0" are numbers of elements.
    elements_.push_back({std::string(name), static_cast<std::size_t>(number_of(take_word(line))), {}});
    if (name == "vertex" && elements_.back().count != vertices_.size())
      throw InputError(
          fmt::format("the PLY file has {} vertices, and {} were read", elements_.back().count, vertices_.size()));
  }
  void copy_property(std::string_view line, std::string_view whole) {
    PlyElement& element = elements_.back();
    const std::string_view first = take_word(line);
    const bool is_list = first == "list";
    const std::size_t count_size = is_list ? size_of_type(take_word(line)) : 0;
    const std::size_t size = size_of_type(is_list ? take_word(line) : first);
    const std::string_view name = take_word(line);
    PlyProperty property{size, count_size};
    if (!is_list && element.name == "vertex" && name.size() == 1)
      property.axis = static_cast<int>(std::string_view("xyz").find(name));
    property.left_out = !is_list && (element.name == "vertex" || element.name == "face") && element.count > 0 &&
                        (name == "nx" || name == "ny" || name == "nz");
    element.properties.push_back(property);
    if (property.left_out) made_.left_out = {"normals"};
    else if (property.axis < 0 || first == "float64") made_.text += whole;
    else made_.text += fmt::format("property double {}{}", name, end_);
  }

  // Words between blanks, in whatever lines they stand; one line per record is written.
  void copy_text_record(const PlyElement& element, std::size_t index) {
    std::string_view gap;
    for (const PlyProperty& property : element.properties) {
      std::string_view word = next_word(element, index);
      if (property.left_out) continue;
      made_.text += gap;
      gap = " ";
      if (property.axis >= 0) {
        made_.text += fmt::format("{}", vertices_[index][property.axis]);
        continue;
      }
      made_.text += word;
      if (property.count_size == 0) continue;
      for (double left = number_of(word); left >= 1; --left) {
        made_.text += ' ';
        made_.text += next_word(element, index);
      }
    }
    made_.text += end_;
  }
  std::string_view next_word(const PlyElement& element, std::size_t index) {
    const std::string_view word = take_word(rest_);
    if (word.empty()) fail_short(element, index);
    return word;
  }

  void copy_binary_record(const PlyElement& element, std::size_t index) {
    for (const PlyProperty& property : element.properties) {
      std::size_t size = property.size;
      if (property.count_size > 0) size = property.count_size + property.size * length_at(property, element, index);
      if (size > rest_.size()) fail_short(element, index);
      if (property.axis >= 0) append(vertices_[index][property.axis]);
      else if (!property.left_out) made_.text += rest_.substr(0, size);
      rest_.remove_prefix(size);
    }
  }
  std::size_t length_at(const PlyProperty& property, const PlyElement& element, std::size_t index) const {
    if (property.count_size > rest_.size()) fail_short(element, index);
    std::uint64_t length = 0;
    std::array<char, sizeof length> bytes{};
    std::copy_n(rest_.begin(), property.count_size, bytes.begin());
    if (is_swapped_) std::reverse(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(property.count_size));
    static_assert(std::endian::native == std::endian::little);
    std::memcpy(&length, bytes.data(), sizeof length);
    return length;
  }
  void append(double x) {
    auto bytes = std::bit_cast<std::array<char, sizeof x>>(x);
    if (is_swapped_) std::ranges::reverse(bytes);
    made_.text.append(bytes.data(), bytes.size());
  }
  [[noreturn]] static void fail_short(const PlyElement& element, std::size_t index) {
    throw InputError(fmt::format("the PLY file ends within {} {} (counted from 0)", element.name, index));
  }

  std::string_view rest_, end_;  // end_ of the header's last line
  std::span<const Vec3<double>> vertices_;
  CarriedMesh made_;
  std::vector<PlyElement> elements_;
  bool is_text_ = false, is_swapped_ = false;
};

}  // namespace

CarriedMesh ply_with_vertices(std::string_view text, std::span<const Vec3<double>> vertices) {
  return PlyCopy(text, vertices).copy();
}

}  // namespace cageproof::reports
