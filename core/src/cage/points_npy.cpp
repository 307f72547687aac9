// SPDX-License-Identifier: MIT
// NumPy's .npy: a magic word, a version, and a dictionary of Python's that says what the bytes behind it are.
#include "mesh_files.h"
#include "points_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstring>

namespace cageproof::mesh_files {
namespace {

struct ArrayReader {
  std::string_view bytes;
  const std::filesystem::path& path;
  std::string_view name;
  std::string_view header = {}, data = {};

  [[noreturn]] void fail(const std::string& reason) const {
    FileLine{path}.fail(name.empty() ? reason : fmt::format("array {}: {}", shown(name), reason));
  }

  void take_header() {
    constexpr std::size_t before_length = 8;
    const std::size_t width = bytes.size() > 6 && bytes[6] == 1 ? 2 : 4;  // of the length, by the version
    if (bytes.size() < before_length + width || !bytes.starts_with("\x93NUMPY"))
      fail("does not begin as NumPy's arrays do (\\x93NUMPY)");
    std::size_t length = 0;
    for (std::size_t k = width; k-- > 0;) length = 256 * length + static_cast<unsigned char>(bytes[before_length + k]);
    const std::string_view rest = bytes.substr(before_length + width);
    if (rest.size() < length) fail("it ends in its header");
    header = rest.substr(0, length);
    data = rest.substr(length);
  }

  // Returns the text of the dictionary from the first character of a key's value on.
  std::string_view value(std::string_view key) const {
    const std::size_t at = header.find(fmt::format("'{}':", key));
    if (at == header.npos) fail(fmt::format("its header has no '{}'", key));
    std::string_view rest = header.substr(at + key.size() + 3);
    rest.remove_prefix(std::min(rest.find_first_not_of(' '), rest.size()));
    return rest;
  }

  std::vector<std::size_t> shape() const {
    const std::string_view text = value("shape");
    std::vector<std::size_t> found;
    const char* const end = text.data() + text.size();
    for (const char* at = text.data(); at != end && *at != ')';) {
      std::size_t count = 0;
      const auto [next, error] = std::from_chars(at, end, count);
      if (error == std::errc{}) found.push_back(count);
      at = error == std::errc{} ? next : at + 1;
    }
    return found;
  }

  template <class Number>
  double number(std::size_t k, bool swap) const {
    std::array<char, sizeof(Number)> raw;
    std::memcpy(raw.data(), data.data() + k * sizeof(Number), sizeof(Number));
    if (swap) std::ranges::reverse(raw);
    return std::bit_cast<Number>(raw);
  }
};

}  // namespace

Mesh points_of_array(std::string_view bytes, const std::filesystem::path& path, std::string_view name) {
  ArrayReader array{bytes, path, name};
  array.take_header();
  const std::string_view type = array.value("descr").substr(0, 5);  // "'<f8'"
  const bool big = type.starts_with("'>"), known_order = big || type.starts_with("'<");
  const bool is_double = type.ends_with("f8'"), is_single = type.ends_with("f4'");
  if (!known_order || (!is_double && !is_single))
    array.fail(fmt::format("its type is {}; points are float64 or float32: numpy.save(file, points.astype(float))",
                           shown(array.value("descr").substr(0, array.value("descr").find(", '")))));
  const std::vector<std::size_t> shape = array.shape();
  if (shape.size() != 2 || (shape[1] != 2 && shape[1] != 3))
    array.fail(fmt::format("its shape is ({}); points are (points, 3), in the plane also (points, 2)",
                           fmt::join(shape, ", ")));
  const std::size_t size = is_double ? sizeof(double) : sizeof(float), rows = shape[0], columns = shape[1];
  // A division, as a product may be too large.
  if (array.data.size() % (columns * size) != 0 || array.data.size() / (columns * size) != rows)
    array.fail(
        fmt::format("{} points of {} bytes are announced, {} bytes follow", rows, columns * size, array.data.size()));
  if (rows == 0) array.fail("no points");
  const bool by_columns = array.value("fortran_order").starts_with("True");
  const bool swap = big != (std::endian::native == std::endian::big);
  Mesh mesh{std::vector<Vec3<double>>(rows, Vec3<double>::Zero()), {}};
  mesh.is_flat = columns == 2;
  for (std::size_t r = 0; r < rows; ++r)
    for (std::size_t c = 0; c < columns; ++c) {
      const std::size_t k = by_columns ? c * rows + r : r * columns + c;
      mesh.vertices[r][c] = is_double ? array.number<double>(k, swap) : array.number<float>(k, swap);
      if (!std::isfinite(mesh.vertices[r][c]))
        array.fail(fmt::format("row {} (counted from 0): a coordinate is {}, not finite", r, mesh.vertices[r][c]));
    }
  return mesh;
}

Mesh read_npy(const std::filesystem::path& path) { return points_of_array(read_mesh_file(path), path); }

}  // namespace cageproof::mesh_files
