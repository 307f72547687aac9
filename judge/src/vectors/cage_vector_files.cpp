// SPDX-License-Identifier: MIT
#include "cageproof/judge/cage_vectors.h"
#include "vectors/texts.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <span>

namespace cageproof::judge {
namespace {

std::span<const int> corners_of(const Face& face) {
  return std::span(face.vertices).first(static_cast<std::size_t>(face.size()));
}

// Corners of the largest face.
std::size_t most_corners(const CageVectorSet& set) {
  std::size_t most = 0;
  for (const Face& face : set.question.faces) most = std::max(most, corners_of(face).size());
  return most;
}

}  // namespace

std::string cage_vectors_json(const CageVectorSet& set, const VectorOptions& options, std::string_view version,
                              std::string_view command) {
  const int dimension = set.question.dimension;
  std::vector<std::string> vertices, faces, blocks, defects, vectors;
  for (const Vec3<double>& vertex : set.question.vertices) vertices.push_back(point_json(vertex, dimension));
  for (const Face& face : set.question.faces) faces.push_back(fmt::format("[{}]", fmt::join(corners_of(face), ",")));
  for (const CoordinateBlock& block : set.blocks)
    blocks.push_back(fmt::format(R"({{"label":"{}","size":{}}})", block.label, block.size * block.entries()));
  for (const CageDefect& defect : cage_defects())
    defects.push_back(fmt::format("\"{}\":{}", defect.name, json_text(defect.description)));
  for (const CageVector& v : set.vectors)
    vectors.push_back(fmt::format(R"({{"point":{},"regime":"{}","defects":["{}"],"value":{},"denominators":{}}})",
                                  point_json(v.point, dimension), v.regime, fmt::join(v.defects, "\",\""),
                                  decimals(v.value, 40), decimals(v.denominators, 20)));
  return fmt::format(
      "{{\"format\":\"cageproof cage vectors 1\",\"version\":{},\"command\":{},\"kind\":\"{}\",\"cage\":\"{}\",\n"
      "\"vertices\":[{}],\n\"faces\":[{}],\n\"blocks\":[{}],\"seed\":{},\"unit\":\"{}\",\"bound\":{},"
      "\"candidates\":{},\"without_truth\":{},\"without_defect\":{},\n\"defects\":{{{}}},\n\"vectors\":[\n{}\n]}}\n",
      json_text(version), json_text(command), set.kind->name, set.cage, fmt::join(vertices, ","), fmt::join(faces, ","),
      fmt::join(blocks, ","), options.seed, format_hex(unit_roundoff<double>()), vector_bound, set.candidates,
      set.without_truth, set.without_defect, fmt::join(defects, ","), fmt::join(vectors, ",\n"));
}

std::string cage_vectors_text(const CageVectorSet& set) {
  const int dimension = set.question.dimension;
  const std::size_t corners = most_corners(set);
  std::string text = fmt::format("{}.{} {} {} {} {} {}", set.kind->name, set.cage, set.vectors.size(), dimension,
                                 corners, set.question.vertices.size(), set.question.faces.size());
  for (const CoordinateBlock& block : set.blocks) text += fmt::format(" {}", block.size * block.entries());
  text += "\nvertices";
  for (const Vec3<double>& vertex : set.question.vertices)
    for (int k = 0; k < dimension; ++k) text += ' ' + format_hex(vertex[k]);
  text += "\nfaces";
  for (const Face& face : set.question.faces)
    text += fmt::format(" {}", fmt::join(std::span(face.vertices).first(corners), " "));
  text += '\n';
  for (const CageVector& v : set.vectors) {
    text += fmt::format("{}", fmt::join(v.defects, ","));
    for (int k = 0; k < dimension; ++k) text += ' ' + format_hex(v.point[k]);
    for (const Mp100& x : v.value)
      for (const double part : split(x)) text += ' ' + format_hex(part);
    for (const Mp100& x : v.denominators) text += ' ' + format_hex(static_cast<double>(x));
    text += '\n';
  }
  return text;
}

CageVectorTables cage_vectors_tables(const CageVectorSet& set) {
  const auto dimension = static_cast<std::size_t>(set.question.dimension);
  CageVectorTables tables{.dimension = dimension, .corners = most_corners(set)};
  for (const Vec3<double>& vertex : set.question.vertices)
    tables.vertices.insert(tables.vertices.end(), vertex.data(), vertex.data() + dimension);
  for (const Face& face : set.question.faces)
    tables.faces.insert(tables.faces.end(), face.vertices.begin(),
                        face.vertices.begin() + static_cast<std::ptrdiff_t>(tables.corners));
  for (const CoordinateBlock& block : set.blocks)
    tables.coordinates += static_cast<std::size_t>(block.size) * static_cast<std::size_t>(block.entries());
  for (const CageVector& v : set.vectors) {
    tables.points.insert(tables.points.end(), v.point.data(), v.point.data() + dimension);
    for (const Mp100& x : v.value) {
      const auto parts = split(x);
      tables.truths.insert(tables.truths.end(), parts.begin(), parts.end());
    }
    for (const Mp100& x : v.denominators) tables.denominators.push_back(static_cast<double>(x));
  }
  return tables;
}

}  // namespace cageproof::judge
