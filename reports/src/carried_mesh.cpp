// SPDX-License-Identifier: MIT
#include "cageproof/reports/carried_mesh.h"

#include "cageproof/core/cage/mesh_io.h"
#include "cageproof/core/input_error.h"
#include "cageproof/core/whole_file.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>

namespace cageproof::reports {
namespace {

// A line of an OBJ file, with those that a backslash joins to it.
struct ObjLine {
  std::string_view whole;                // with its end
  std::vector<std::string_view> tokens;  // without the comment
  std::string_view comment, end;
};

std::vector<std::string_view> tokens_of(std::string_view text) {
  std::vector<std::string_view> tokens;
  for (std::size_t at = 0; (at = text.find_first_not_of(" \t\r\n", at)) != std::string_view::npos;) {
    const std::size_t end = std::min(text.find_first_of(" \t\r\n", at), text.size());
    // A backslash before the end of a line joins it with the next.
    if (text.substr(at, end - at) != "\\") tokens.emplace_back(text.substr(at, end - at));
    at = end;
  }
  return tokens;
}

ObjLine take_line(std::string_view& rest) {
  std::size_t content = 0, after = 0;
  do {
    content = std::min(rest.find_first_of("\r\n", after), rest.size());
    after = content;
    if (after < rest.size()) after += rest.substr(after).starts_with("\r\n") ? 2 : 1;
  } while (content > 0 && rest[content - 1] == '\\' && after < rest.size());
  ObjLine line{rest.substr(0, after), {}, {}, rest.substr(content, after - content)};
  const std::string_view text = rest.substr(0, content);
  const std::size_t mark = std::min(text.find('#'), text.size());
  line.comment = text.substr(mark);
  line.tokens = tokens_of(text.substr(0, mark));
  rest.remove_prefix(after);
  return line;
}

void put(std::string& text, const ObjLine& line, const std::string& content) {
  text += content;
  if (!line.comment.empty()) text += fmt::format(" {}", line.comment);
  text += line.end;
}

// "1/2/3" as "1/2", and "1//3" as "1".
std::string_view without_normal(std::string_view corner) {
  const std::size_t first = corner.find('/'), second = corner.find('/', first + 1);
  if (first == std::string_view::npos || second == std::string_view::npos) return corner;
  return corner.substr(0, second == first + 1 ? first : second);
}

void add_once(std::vector<std::string>& words, std::string word) {
  if (std::ranges::find(words, word) == words.end()) words.push_back(std::move(word));
}

std::vector<std::string> beside_places_in_obj(std::string_view text) {
  constexpr std::array<std::array<std::string_view, 2>, 7> named{{{"vt", "texture coordinates"},
                                                                  {"vn", "normals"},
                                                                  {"g", "groups"},
                                                                  {"o", "objects"},
                                                                  {"s", "smoothing groups"},
                                                                  {"usemtl", "materials"},
                                                                  {"mtllib", "materials"}}};
  std::vector<std::string> found;
  while (!text.empty()) {
    const ObjLine line = take_line(text);
    if (line.tokens.empty()) continue;
    for (const auto& [keyword, words] : named)
      if (line.tokens[0] == keyword) add_once(found, std::string(words));
    if (line.tokens[0] == "v" && line.tokens.size() >= 7) add_once(found, "vertex colours");
  }
  return found;
}

std::vector<std::string> beside_places_in_ply(std::string_view text) {
  std::vector<std::string> found;
  std::string element;
  while (!text.empty()) {
    const std::vector<std::string_view> words = take_line(text).tokens;
    if (words.empty()) continue;
    if (words[0] == "end_header") break;
    if (words[0] == "element" && words.size() > 1) {
      element = words[1];
      if (element != "vertex" && element != "face") add_once(found, fmt::format("element {}", element));
    } else if (words[0] == "property" && (element == "vertex" || element == "face")) {
      constexpr std::array places{"x", "y", "z", "vertex_indices", "vertex_index"};
      if (std::ranges::find(places, words.back()) == places.end())
        add_once(found, fmt::format("property {}", words.back()));
    }
  }
  return found;
}

std::vector<std::string> beside_places_in_vtp(std::string_view text) {
  std::vector<std::string> found;
  for (std::size_t at = 0; (at = text.find("<DataArray", at)) != std::string_view::npos; ++at) {
    const std::string_view tag = text.substr(at, text.find('>', at) - at);
    constexpr std::string_view attribute = " Name=\"";
    const std::size_t name = tag.find(attribute);
    if (name == std::string_view::npos) continue;
    const std::string_view rest = tag.substr(name + attribute.size());
    const std::string_view value = rest.substr(0, rest.find('"'));
    constexpr std::array places{"Points", "connectivity", "offsets", "types"};
    if (std::ranges::find(places, value) == places.end()) add_once(found, fmt::format("array {}", value));
  }
  return found;
}

std::vector<std::string> beside_places_in_svg(std::string_view text) {
  constexpr std::array<std::array<std::string_view, 2>, 10> marks{{{" id=\"", "ids"},
                                                                   {" class=\"", "classes"},
                                                                   {" style=\"", "styles"},
                                                                   {"<style", "styles"},
                                                                   {" fill=\"", "styles"},
                                                                   {" stroke=\"", "styles"},
                                                                   {"<title", "titles"},
                                                                   {"<metadata", "metadata"},
                                                                   {" width=\"", "widths and heights"},
                                                                   {"<g", "groups"}}};
  std::vector<std::string> found;
  for (const auto& [mark, words] : marks)
    if (text.find(mark) != std::string_view::npos) add_once(found, std::string(words));
  return found;
}

// Only binary files have some.
std::vector<std::string> beside_places_in_stl(std::string_view text) {
  constexpr std::size_t header = 84, triangle = 50;
  if (text.size() < header) return {};
  std::uint32_t count = 0;
  std::memcpy(&count, text.data() + 80, sizeof count);
  // The number of triangles of a text would be that of its first letters.
  if (text.size() < header + triangle * static_cast<std::size_t>(count)) return {};
  std::vector<std::string> found;
  if (text.substr(0, 80).find_first_not_of(std::string_view(" \0", 2)) != std::string_view::npos)
    found.emplace_back("header");
  for (std::size_t k = 0; k < count; ++k)
    if (text.substr(header + triangle * (k + 1) - 2, 2) != std::string_view("\0\0", 2)) {
      found.emplace_back("attribute bytes");
      break;
    }
  return found;
}

}  // namespace

CarriedMesh obj_with_vertices(std::string_view text, std::span<const Vec3<double>> vertices) {
  CarriedMesh carried;
  carried.text.reserve(text.size() + 16 * vertices.size());
  std::size_t count = 0;
  bool has_normals = false;
  while (!text.empty()) {
    const ObjLine line = take_line(text);
    const std::string_view keyword = line.tokens.empty() ? std::string_view() : line.tokens[0];
    if (keyword == "v") {
      if (count++ >= vertices.size()) continue;
      const Vec3<double>& v = vertices[count - 1];
      // Behind x, y and z stand a weight, which images do not have, or a colour, or both.
      const std::size_t colour = line.tokens.size() >= 7 ? line.tokens.size() - 3 : line.tokens.size();
      std::string content = fmt::format("v {} {} {}", v[0], v[1], v[2]);
      for (std::size_t k = colour; k < line.tokens.size(); ++k) content += fmt::format(" {}", line.tokens[k]);
      put(carried.text, line, content);
    } else if (keyword == "vn") {
      has_normals = true;
    } else if (keyword == "f" && std::ranges::any_of(line.tokens, [](std::string_view corner) {
                 return without_normal(corner) != corner;
               })) {
      std::vector<std::string_view> corners = line.tokens;
      std::ranges::transform(corners, corners.begin(), without_normal);
      put(carried.text, line, fmt::format("{}", fmt::join(corners, " ")));
    } else {
      carried.text += line.whole;
    }
  }
  if (count != vertices.size())
    throw InputError(fmt::format("the OBJ file has {} vertices, and {} were read", count, vertices.size()));
  if (has_normals) carried.left_out.emplace_back("normals");
  return carried;
}

std::vector<std::string> beside_places(const std::filesystem::path& file) {
  const std::string extension = extension_of(file);
  if (extension == ".obj") return beside_places_in_obj(read_file(file));
  if (extension == ".ply") return beside_places_in_ply(read_file(file));
  if (extension == ".vtp") return beside_places_in_vtp(read_file(file));
  if (extension == ".svg") return beside_places_in_svg(read_file(file));
  if (extension == ".stl") return beside_places_in_stl(read_file(file));
  if ((extension == ".geojson" || extension == ".json") && read_file(file).find("\"properties\"") != std::string::npos)
    return {"properties"};
  return {};
}

}  // namespace cageproof::reports
