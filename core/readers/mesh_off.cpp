// SPDX-License-Identifier: MIT
// OFF, as text: places of vertices, and faces. Colours, normals and texture coordinates are passed over.
#include "cage/mesh_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>

namespace cageproof::mesh_files {
namespace {

// Keywords with letters before "OFF" say that more numbers follow each vertex.
constexpr std::array<std::string_view, 9> kOffKeywords{"OFF",   "COFF",   "NOFF",   "CNOFF",  "NCOFF",
                                                       "STOFF", "STCOFF", "STNOFF", "STCNOFF"};

class OffText {
 public:
  OffText(std::string_view text, FileLine& at) : tokens_{text, at, true}, at_(at) {}

  Mesh read() {
    const std::string_view first = read_keyword();
    const int vertices = whole(first, "a number of vertices", 0);
    const int faces = whole(take("a number of faces"), "a number of faces", 0);
    tokens_.line = {};  // the number of edges, which nobody needs
    if (vertices == 0) FileLine{at_.file}.fail("no vertices");
    Mesh mesh;
    for (int v = 0; v < vertices; ++v) mesh.vertices.push_back(read_vertex(v));
    for (int f = 0; f < faces; ++f) {
      mesh.faces.push_back(read_face(f, vertices));
      mesh.face_lines.push_back(at_.line);
      tokens_.line = {};  // a colour
    }
    if (const std::string_view more = tokens_.take(); !more.empty())
      fail(fmt::format("{} behind the last of {} vertices and {} faces", shown(more), vertices, faces));
    return mesh;
  }

 private:
  // Passes over the keyword, which some files lack. \return the token behind it
  std::string_view read_keyword() {
    const std::string_view first = take("\"OFF\"");
    if (first.find_first_not_of("0123456789") == std::string_view::npos) return first;
    // ModelNet's files have the keyword and the number of vertices in one: "OFF490 518 0".
    if (first.starts_with("OFF") && first.size() > 3 && first[3] >= '0' && first[3] <= '9') return first.substr(3);
    if (std::ranges::find(kOffKeywords, first) == kOffKeywords.end())
      at_.fail(fmt::format("{} where \"OFF\" is wanted, or one of COFF, NOFF, CNOFF, STOFF", shown(first)));
    has_more_ = first != "OFF";
    const std::string_view next = take("a number of vertices");
    if (next == "BINARY") at_.fail("binary OFF; write it as text");
    return next;
  }
  Vec3<double> read_vertex(int v) {
    item_ = fmt::format("vertex {}", v);
    Vec3<double> vertex;
    for (int i = 0; i < 3; ++i) {
      vertex[i] = finite_number(take("a coordinate"), at_);
      if (i == 0) begin_ = at_.line;
    }
    if (has_more_) tokens_.line = {};
    if (ragged_ == 0 && (begin_ != at_.line || tokens_.line.find_first_not_of(" \t") != std::string_view::npos))
      ragged_ = begin_;
    return vertex;
  }
  std::vector<int> read_face(int f, int vertices) {
    item_ = fmt::format("face {}", f);
    const int size = whole(take("a number of corners"), "a number of corners", 3);
    std::vector<int> face;
    for (int k = 0; k < size; ++k) {
      face.push_back(whole(take("a corner"), "a corner", 0));
      if (face.back() >= vertices)
        fail(fmt::format("index {} is out of range, there are {} vertices", face.back(), vertices));
    }
    return face;
  }
  std::string_view take(std::string_view wanted) {
    const std::string_view token = tokens_.take();
    if (token.empty()) fail(fmt::format("the file ends where {} is wanted (cut off?)", wanted));
    return token;
  }
  int whole(std::string_view token, std::string_view wanted, int least) const {
    int x = 0;
    const auto [end, error] = std::from_chars(token.begin(), token.end(), x);
    if (error != std::errc{} || end != token.end() || x < least)
      fail(fmt::format("{} where {} is wanted, a whole number from {} on", shown(token), wanted, least));
    return x;
  }
  // A number too many or too few is noticed further on, where lines do not matter.
  [[noreturn]] void fail(const std::string& reason) const {
    at_.fail(fmt::format("{}{}{}{}", item_, item_.empty() ? "" : ": ", reason,
                         ragged_ == 0 ? "" : fmt::format("; the first line without three numbers is {}", ragged_)));
  }

  Tokens tokens_;
  FileLine& at_;
  std::string item_;
  std::size_t begin_ = 0, ragged_ = 0;
  bool has_more_ = false;
};

Mesh read_off(const std::filesystem::path& path) {
  const std::string file = read_mesh_file(path);
  FileLine at{path};
  return OffText(without_mark(file), at).read();
}

const RegisterMeshReader off{".off", read_off};

}  // namespace
}  // namespace cageproof::mesh_files
