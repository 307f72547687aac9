// SPDX-License-Identifier: MIT
#include "coordinate_description.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace cageproof::cli {
namespace {

using Json = nlohmann::ordered_json;

std::string_view data_of(const CoordinateBlock& block) {
  switch (block.reproduces) {
    case Reproduces::Vertices: return "posed vertices";
    case Reproduces::TurnedVertices: return "posed vertices, turned by a quarter counter-clockwise: (x, y) -> (-y, x)";
    case Reproduces::Normals:
      if (block.owner == Owner::Normal)
        return block.entries() > 1 ? "the map's traction where the normal is: on a triangle, or at a quad's corner; "
                                     "that of the identity "
                                     "is the outward unit normal there times normal_factor"
                                   : "the derivative of the map along the outward unit normal of a triangle, or at a "
                                     "quad's corner, times "
                                     "normal_factor";
      if (block.entries() > 1)
        return "the map's traction on the element; that of the identity is the outward unit normal times normal_factor";
      return block.owner == Owner::Corner
                 ? "the derivative of the map along the outward unit normal at the element's corner, times "
                   "normal_factor"
                 : "the derivative of the map along the element's outward unit normal, times normal_factor: the posed "
                   "unit normal times how much the element is stretched";
    case Reproduces::Nothing: break;
  }
  return "data of your own, such as Laplacians at vertices or their normal derivatives; zero gives linear maps";
}

// Formulas of a sum over elements, one for each kind of element.
Json formulas_json(const CageCoordinates& coordinates, std::size_t block) {
  Json all = Json::array();
  if (!coordinates.kind().is_sum()) return all;
  const CageElements& elements = coordinates.elements();
  for (const ElementKind kind : element_kinds) {
    bool met = false;
    for (std::size_t e = 0; e < elements.count() && !met; ++e) met = elements.type(e).kind == kind;
    const Formula* formula = met ? find_formula(kind, coordinates.kind().blocks[block].kernel) : nullptr;
    if (formula)
      all.push_back({{"name", formula->name}, {"symbol", formula->symbol}, {"definition", formula->definition}});
  }
  return all;
}

Json block_json(const CageCoordinates& coordinates, std::size_t b) {
  const CoordinateBlock& block = coordinates.blocks()[b];
  Json json = {{"label", block.label}, {"one_a", name_of(block.owner)}, {"count", block.size}};
  if (block.entries() > 1) json["matrix"] = {block.shape.rows, block.shape.columns};
  json["multiplies"] = data_of(block);
  if (block.reproduces == Reproduces::Normals) json["normal_factor"] = block.normal_factor;
  // Elements' own normals are stored with them; a kept quad has one per corner.
  if (block.owner == Owner::Normal) {
    const CageElements& elements = coordinates.elements();
    for (int i = 0; i < block.size; ++i) {
      const Vec3<double> normal = elements.normal_of(i, Owner::Normal);
      json["normals"].push_back(std::vector<double>(normal.data(), normal.data() + elements.dimension()));
    }
  }
  if (Json formulas = formulas_json(coordinates, b); !formulas.empty()) json["formulas"] = std::move(formulas);
  return json;
}

Json parameters_json(const CoordinateKind& kind, const std::vector<double>& given) {
  Json json = Json::object();
  const std::vector<KindParameter> known = parameters_of(kind);
  for (std::size_t i = 0; i < known.size(); ++i) {
    const double value = given.empty() ? known[i].preset : given[i];
    const std::string name(known[i].name);
    if (!known[i].names.empty()) json[name] = known[i].names[static_cast<std::size_t>(value)];
    else if (!std::isfinite(value)) json[name] = fmt::format("{}", value);
    else if (known[i].whole) json[name] = static_cast<long long>(value);
    else json[name] = value;
  }
  return json;
}

Json conventions_json(const CageCoordinates& coordinates) {
  const bool plane = coordinates.dimension() == 2;
  Json json = Json::object();
  json["indices"] = "counted from 0; vertices in the order of the cage's file";
  json["elements"] =
      plane ? "segments from their first vertex to their second, with the cage on their left"
      : coordinates.kind().keeps_quads
          ? "the cage's faces, quads kept as bilinear surfaces; vertices counter-clockwise seen from outside"
          : "triangles, in the order of the cage's faces, quads split in two as `triangulation` says; vertices "
            "counter-clockwise seen from outside";
  json["normals"] =
      plane ? "unit, outward: to the right of a segment"
            : "unit, outward: along (b - a) x (c - a) of a triangle a, b, c; of a quad along its area vector";
  json["signs"] =
      plane
          ? "x = xi - eta from the point eta to xi on the cage; G1 = ln r/(2 pi), G2 = r^2 (ln r - 1)/(8 pi); "
            "normal derivatives along outward normals; inside, the phi of `green` sum to 1"
          : "x = xi - eta from the point eta to xi on the cage; G1 = -1/(4 pi r), G2 = -r/(8 pi); normal "
            "derivatives along outward normals; psi = -G1 integrated is positive; inside, the phi of `green` sum to 1";
  json["derivatives"] = "by the coordinates of the point, in the unit of the cage's file; the last index changes first";
  json["on_the_cage"] = "values are the limits from inside; derivatives that do not exist are nan";
  json["apply"] =
      "f(point) = the sum over all blocks of coordinate times what the block multiplies (blocks[].multiplies); "
      "the rest cage's own vertices and normals give the point itself, where blocks reproduce it";
  if (!coordinates.kind().normalised)
    json["outside"] = "coordinates sum to zero outside the cage: what is deformed with them collapses there";
  return json;
}

std::string_view element_name(const CageElements& elements) {
  const std::string_view first = name_of(elements.type(0).kind);
  for (std::size_t e = 1; e < elements.count(); ++e)
    if (name_of(elements.type(e).kind) != first) return "triangle or quad";
  return first;
}

// An element's length or area, in a unit of its own, so that squares of lengths neither overflow nor underflow.
double measure_of(const ElementType& type, std::vector<Vec3<double>> corners) {
  const Vec3<double> origin = corners.front();
  double largest = 0;
  for (Vec3<double>& corner : corners) largest = std::max(largest, (corner -= origin).cwiseAbs().maxCoeff());
  if (!(largest > 0)) return 0;
  for (Vec3<double>& corner : corners) corner /= largest;
  const double extent = type.extent(corners).norm();
  return type.dimension == 2 ? extent * largest : extent / 2 * largest * largest;
}

}  // namespace

reports::DescribedCage described_cage(const CageCoordinates& coordinates, const Cage& cage, Triangulation rule) {
  const CageElements& elements = coordinates.elements();
  reports::DescribedCage described;
  described.dimension = elements.dimension();
  described.vertices = elements.vertices();
  for (const int f : cage.parts(coordinates.kind().keeps_quads, rule).face_of)
    described.faces.push_back(cage.face_number(static_cast<std::size_t>(f)));
  described.normals = elements.normals();
  for (std::size_t e = 0; e < elements.count(); ++e) {
    const auto vertices = elements.vertices_of(e);
    described.elements.emplace_back(vertices.begin(), vertices.end());
    described.measures.push_back(measure_of(elements.type(e), elements.corners(e)));
  }
  return described;
}

Json description_of(const CageCoordinates& coordinates, const CoordinateColumns& table, const DescribedRun& run) {
  const CoordinateKind& kind = coordinates.kind();
  const CageElements& elements = coordinates.elements();
  Json json = {{"schema", coordinates_schema}, {"schema_version", 1}, {"cageproof", CAGEPROOF_VERSION}};
  json["kind"] = kind.name;
  json["source"] = kind.source;
  json["parameters"] = parameters_json(kind, run.parameters);
  json["evaluation"] = coordinates.evaluation();
  json["order"] = run.order;
  json["cage"] = run.cage_file;
  json["points"] = run.points_file;
  if (!run.data_file.empty()) json["data"] = run.data_file;
  if (!std::isnan(run.merge)) json["merge"] = run.merge;
  if (run.on > 0) json["on"] = run.on;
  json["dimension"] = elements.dimension();
  json["element"] = element_name(elements);
  json["triangulation"] = kind.keeps_quads ? "none" : run.triangulation;
  json["conventions"] = conventions_json(coordinates);
  json["blocks"] = Json::array();
  for (std::size_t b = 0; b < coordinates.blocks().size(); ++b) json["blocks"].push_back(block_json(coordinates, b));
  json["arrays"] = Json::array();
  std::size_t first = 0;
  for (const CoordinateColumns::Group& group : table.groups) {
    json["arrays"].push_back(
        {{"name", group.array}, {"first_column", first}, {"columns", group.columns}, {"shape", group.shape}});
    first += group.columns;
  }
  return json;
}

Json geometry_json(const reports::DescribedCage& cage) {
  const auto rows = [&](const std::vector<Vec3<double>>& vectors) {
    Json json = Json::array();
    for (const Vec3<double>& v : vectors) json.push_back(std::vector<double>(v.data(), v.data() + cage.dimension));
    return json;
  };
  Json json = Json::object();
  json["cage_vertices"] = rows(cage.vertices);
  json["elements"] = cage.elements;
  json["element_faces"] = cage.faces;
  json["element_normals"] = rows(cage.normals);
  json[cage.dimension == 2 ? "element_lengths" : "element_areas"] = cage.measures;
  return json;
}

}  // namespace cageproof::cli
