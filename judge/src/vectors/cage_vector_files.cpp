// SPDX-License-Identifier: MIT
#include "cageproof/judge/cage_vectors.h"
#include "vectors/texts.h"

#include <fmt/ranges.h>

#include <span>

namespace cageproof::judge {
namespace {

std::span<const int> corners_of(const Face& face) {
  return std::span(face.vertices).first(static_cast<std::size_t>(face.size()));
}

}  // namespace

std::string cage_vectors_json(const CageVectorSet& set, const VectorOptions& options, std::string_view version,
                              std::string_view command) {
  const int dimension = set.question.dimension;
  std::vector<std::string> vertices, faces, blocks, defects, vectors;
  for (const Vec3<double>& vertex : set.question.vertices) vertices.push_back(point_json(vertex, dimension));
  for (const Face& face : set.question.faces) faces.push_back(fmt::format("[{}]", fmt::join(corners_of(face), ",")));
  for (const CoordinateBlock& block : set.blocks)
    blocks.push_back(fmt::format(R"({{"label":"{}","size":{}}})", block.label, block.size));
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
  std::string text = fmt::format("{}.{} {} {} {} {}", set.kind->name, set.cage, set.vectors.size(), dimension,
                                 set.question.vertices.size(), set.question.faces.size());
  for (const CoordinateBlock& block : set.blocks) text += fmt::format(" {}", block.size);
  text += "\nvertices";
  for (const Vec3<double>& vertex : set.question.vertices)
    for (int k = 0; k < dimension; ++k) text += ' ' + format_hex(vertex[k]);
  text += "\nfaces";
  for (const Face& face : set.question.faces) text += fmt::format(" {}", fmt::join(corners_of(face), " "));
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

}  // namespace cageproof::judge
