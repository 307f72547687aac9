// SPDX-License-Identifier: MIT
// STL, text and binary. Equal corners become one vertex, and triangles of fewer than three vertices are left out.
#include "cage/mesh_files.h"

#include <fmt/format.h>

#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <unordered_map>

namespace cageproof::mesh_files {
namespace {

using StlCorner = std::array<float, 3>;

class StlMesh {
 public:
  void add(const std::array<StlCorner, 3>& corners) {
    const std::vector<int> face{vertex(corners[0]), vertex(corners[1]), vertex(corners[2])};
    if (face[0] != face[1] && face[1] != face[2] && face[2] != face[0]) mesh.faces.push_back(face);
  }
  Mesh mesh;

 private:
  int vertex(StlCorner corner) {
    for (float& x : corner) x += 0.0F;  // -0 is 0
    const auto bytes = std::bit_cast<std::array<char, sizeof corner>>(corner);
    const auto [found, is_new] =
        known_.emplace(std::string(bytes.data(), bytes.size()), static_cast<int>(mesh.vertices.size()));
    if (is_new) mesh.vertices.emplace_back(corner[0], corner[1], corner[2]);
    return found->second;
  }
  std::unordered_map<std::string, int> known_;
};

// The text form of STL has keywords in any case, and numbers between white space. Line ends matter only for names after
// "solid".
class StlText {
 public:
  StlText(std::string_view text, FileLine& at) : tokens_{text, at}, at_(at) {}
  Mesh read() {
    begin_solid(tokens_.take());
    while (is_open_) {
      const std::string word = take_word("facet");
      if (word == "facet") read_facet();
      else if (word == "endsolid") end_solid();
      else fail(word, "\"facet\" or \"endsolid\"");
    }
    return std::move(stl_.mesh);
  }

 private:
  void begin_solid(std::string_view token) {
    if (!lower_case(token).starts_with("solid")) fail(token, "\"solid\"");
    tokens_.line = {};
    is_open_ = true;
  }
  // Another one may follow.
  void end_solid() {
    tokens_.line = {};
    const std::string_view token = tokens_.take();
    if (token.empty()) is_open_ = false;
    else begin_solid(token);
  }
  void read_facet() {
    // The normal is passed over, whatever it is: "normal" and three numbers.
    std::string word = take_word("outer");
    for (int k = 0; k < 4 && word != "outer"; ++k) word = take_word("outer");
    if (word != "outer") fail(word, "\"outer loop\"");
    expect("loop");
    std::array<StlCorner, 3> corners{};
    for (StlCorner& corner : corners) {
      expect("vertex");
      for (float& x : corner) x = take_float();
    }
    expect("endloop");
    expect("endfacet");
    stl_.add(corners);
  }
  float take_float() {
    const std::string_view token = tokens_.take();
    if (token.empty()) fail(token, "a number");
    const auto x = static_cast<float>(finite_number(token, at_));
    if (!std::isfinite(x)) at_.fail(shown(token) + " is beyond single precision, which STL has");
    return x;
  }
  // In lower case; "end loop" is "endloop".
  std::string take_word(std::string_view wanted) {
    const std::string_view token = tokens_.take();
    if (token.empty()) fail(token, fmt::format("\"{}\"", wanted));
    const std::string word = lower_case(token);
    return word == "end" ? word + lower_case(tokens_.take()) : word;
  }
  void expect(std::string_view wanted) {
    const std::string word = take_word(wanted);
    if (word != wanted) fail(word, fmt::format("\"{}\"", wanted));
  }
  [[noreturn]] void fail(std::string_view token, const std::string& wanted) const {
    if (token.empty()) at_.fail("the file ends where " + wanted + " is wanted (cut off?)");
    at_.fail(fmt::format("{} where {} is wanted", shown(token), wanted));
  }

  Tokens tokens_;
  FileLine& at_;
  StlMesh stl_;
  bool is_open_ = false;
};

// 80 bytes of any kind, the number of triangles, 50 bytes each: normal, corners, two bytes of the writer's own.
Mesh read_binary_stl(std::string_view bytes, const FileLine& at) {
  static_assert(std::endian::native == std::endian::little);
  constexpr std::size_t header = 84, record = 50, normal = 12;
  if (bytes.size() < header)
    at.fail(fmt::format("{} bytes, a binary STL has at least {} (cut off?)", bytes.size(), header));
  std::uint32_t count = 0;
  std::memcpy(&count, bytes.data() + header - sizeof count, sizeof count);
  const std::size_t needed = header + record * count;
  if (bytes.size() < needed)
    at.fail(fmt::format("{} bytes, its {} triangles need {} (cut off?)", bytes.size(), count, needed));
  StlMesh stl;
  for (std::size_t i = 0; i < count; ++i) {
    std::array<StlCorner, 3> corners;
    std::memcpy(corners.data(), bytes.data() + header + record * i + normal, sizeof corners);
    for (const StlCorner& corner : corners)
      for (const float x : corner)
        if (!std::isfinite(x)) at.fail(fmt::format("triangle {}: a coordinate is not finite (counted from 0)", i));
    stl.add(corners);
  }
  if (bytes.size() > needed)
    stl.mesh.warnings.push_back(fmt::format("{}: {} bytes behind the last triangle are left out; {} triangles need {}",
                                            at.file.string(), bytes.size() - needed, count, needed));
  return std::move(stl.mesh);
}

Mesh read_stl(const std::filesystem::path& path) {
  const std::string bytes = read_mesh_file(path);
  FileLine at{path};
  // A binary file may begin with "solid", too; its count of triangles, or a byte behind it, is zero.
  const bool is_text = bytes.find('\0') == std::string::npos;
  Mesh mesh = is_text ? StlText(without_mark(bytes), at).read() : read_binary_stl(bytes, at);
  if (mesh.faces.empty()) FileLine{path}.fail("no triangles");
  return mesh;
}

const RegisterMeshReader stl{".stl", read_stl};

}  // namespace
}  // namespace cageproof::mesh_files
