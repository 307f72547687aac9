// SPDX-License-Identifier: MIT
// OBJ: vertices, faces and polylines. Colours, texture, normals, groups and materials are passed over.
#include "mesh_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>

namespace cageproof::mesh_files {
namespace {

struct Obj {
  Mesh mesh;
  std::size_t flat_line = 0;     // of the first vertex with two coordinates
  std::size_t unknown_line = 0;  // the first one whose keyword OBJ does not have
  std::string unknown;
};

// OBJ keywords that are skipped. Points, curves and surfaces are geometry, but they are dropped, too.
constexpr std::array<std::string_view, 43> kPassedOver{
    "vt",     "vn",     "vp",  "p",    "g",     "s",        "o",        "mg",   "usemtl",     "mtllib",    "usemap",
    "maplib", "cstype", "deg", "bmat", "step",  "curv",     "curv2",    "surf", "parm",       "trim",      "hole",
    "scrv",   "sp",     "end", "con",  "bevel", "c_interp", "d_interp", "lod",  "shadow_obj", "trace_obj", "ctech",
    "stech",  "call",   "csh", "bzp",  "bsp",   "cdc",      "cdp",      "res",  "scmp",       "vc"};

// Takes the next line without its comment, together with its continuations: a backslash directly before a line's end
// continues it, except in comments. \return the number of lines taken, 0 at the end
std::size_t take_continued_line(std::string_view& rest, std::string& whole) {
  whole.clear();
  std::size_t count = 0;
  bool goes_on = true;
  for (std::string_view line; goes_on && take_line(rest, line);) {
    ++count;
    const std::string_view data = without_comment(line);
    goes_on = data.size() == line.size() && line.ends_with('\\');
    whole += goes_on ? line.substr(0, line.size() - 1) : data;
    whole += ' ';
  }
  return count;
}

[[noreturn]] void fail_flat(const FileLine& at, std::size_t count) {
  at.fail(fmt::format("a vertex has three coordinates, here are {}", count));
}

// x y; x y z; x y z w; x y z with a colour of three or four numbers.
void add_vertex(std::string_view rest, const FileLine& at, Obj& obj) {
  std::array<double, 7> numbers{};
  std::size_t count = 0;
  for (std::string_view token = take_token(rest); !token.empty(); token = take_token(rest), ++count) {
    const double x = finite_number(token, at);
    if (count < numbers.size()) numbers[count] = x;
  }
  if (count < 2) fail_flat(at, count);
  if (count == 5 || count > numbers.size())
    at.fail(fmt::format("{} numbers in a vertex: write x y z, x y z w, or x y z and a colour of 3 or 4", count));
  if (count == 2 && obj.flat_line == 0) obj.flat_line = at.line;
  Vec3<double> vertex(numbers[0], numbers[1], numbers[2]);
  if (count == 4) {
    const double w = numbers[3];
    if (w == 0) at.fail("the weight w is 0: no point in space is x/w, y/w, z/w");
    vertex /= w;
    if (!vertex.allFinite()) at.fail("a coordinate divided by the weight w is not finite");
  }
  obj.mesh.vertices.push_back(vertex);
}

// The index, from 0, of a corner i, i/j, i//k or i/j/k, of which only i matters here.
int corner_of(std::string_view token, const FileLine& at, int vertices_so_far) {
  const std::string_view digits = token.substr(0, token.find('/'));
  int index = 0;
  const auto [end, error] = std::from_chars(digits.begin(), digits.end(), index);
  if (error == std::errc::result_out_of_range) at.fail("index " + shown(digits) + " is out of range");
  if (error != std::errc{} || end != digits.end() || token.find_first_not_of("0123456789/-") != std::string_view::npos)
    at.fail(shown(token) + " is not a face's corner");
  if (index == 0) at.fail("index 0 is out of range: OBJ counts from 1");
  if (index > 0) return index - 1;
  if (index < -vertices_so_far)
    at.fail(fmt::format("index {} is out of range, {} vertices are before it", index, vertices_so_far));
  return vertices_so_far + index;
}

std::vector<int> corners_of(std::string_view rest, const FileLine& at, const Mesh& mesh) {
  std::vector<int> corners;
  for (std::string_view token = take_token(rest); !token.empty(); token = take_token(rest))
    corners.push_back(corner_of(token, at, static_cast<int>(mesh.vertices.size())));
  return corners;
}

void add_face(std::string_view rest, const FileLine& at, Mesh& mesh) {
  std::vector<int> corners = corners_of(rest, at, mesh);
  if (corners.size() < 3) at.fail(fmt::format("a face has at least three corners, here are {}", corners.size()));
  mesh.faces.push_back(std::move(corners));
  mesh.face_lines.push_back(at.line);
}

void add_polyline(std::string_view rest, const FileLine& at, Mesh& mesh) {
  const std::vector<int> vertices = corners_of(rest, at, mesh);
  if (vertices.size() < 2) at.fail(fmt::format("a polyline has at least two vertices, here are {}", vertices.size()));
  for (std::size_t k = 1; k < vertices.size(); ++k) {
    mesh.segments.push_back({vertices[k - 1], vertices[k]});
    mesh.segment_lines.push_back(at.line);
  }
}

void add_line(std::string_view line, const FileLine& at, Obj& obj) {
  const std::string_view keyword = take_token(line);
  if (keyword.empty()) return;
  if (keyword == "v") return add_vertex(line, at, obj);
  if (keyword == "f" || keyword == "fo") return add_face(line, at, obj.mesh);
  if (keyword == "l") return add_polyline(line, at, obj.mesh);
  if (keyword == "V" || keyword == "F" || keyword == "L")
    at.fail(fmt::format("{} is not an OBJ keyword; write \"{}\"", shown(keyword), lower_case(keyword)));
  if (!std::isalpha(static_cast<unsigned char>(keyword.front()))) at.fail(shown(keyword) + " is not an OBJ keyword");
  if (obj.unknown_line > 0 || std::ranges::find(kPassedOver, keyword) != kPassedOver.end()) return;
  obj.unknown_line = at.line;
  obj.unknown = shown(keyword);
}

template <class Elements>
void check_indices(const Elements& elements, const std::vector<std::size_t>& lines, std::size_t count,
                   const std::filesystem::path& path) {
  for (std::size_t e = 0; e < elements.size(); ++e)
    for (const int vertex : elements[e])
      if (static_cast<std::size_t>(vertex) >= count)
        FileLine{path, lines[e]}.fail(
            fmt::format("vertex {} is out of range, the file has {} vertices", vertex + 1, count));
}

}  // namespace

Mesh read_obj(const std::filesystem::path& path) {
  const std::string file = read_mesh_file(path);
  std::string_view text = without_mark(file);
  Obj obj;
  FileLine at{path, 1};
  std::string line;
  for (std::size_t count = 0; (count = take_continued_line(text, line)) > 0; at.line += count) add_line(line, at, obj);
  Mesh& mesh = obj.mesh;
  // Keywords that programs add of their own are passed over in files that are OBJ by what else they hold.
  if (obj.unknown_line > 0 && (mesh.vertices.empty() || (mesh.faces.empty() && mesh.segments.empty())))
    FileLine{path, obj.unknown_line}.fail(obj.unknown +
                                          " is not an OBJ keyword; vertices are \"v x y z\", faces \"f 1 2 3\"");
  if (mesh.vertices.empty()) FileLine{path}.fail("no vertices");
  // Nobody writes two coordinates but of polygons.
  const bool polygons = !mesh.segments.empty() && mesh.faces.empty();
  if (obj.flat_line > 0 && !polygons) fail_flat({path, obj.flat_line}, 2);
  check_indices(mesh.faces, mesh.face_lines, mesh.vertices.size(), path);
  check_indices(mesh.segments, mesh.segment_lines, mesh.vertices.size(), path);
  return std::move(mesh);
}

}  // namespace cageproof::mesh_files
