// SPDX-License-Identifier: MIT
// CGAL's Side_of_triangle_mesh for `cageproof judge --kind inside` (docs/judged.md): a program of its own that answers
// lines, since CGAL's headers are under the GPL, and with them what is built of this file.
//   c++ -O2 -DNDEBUG [-DDOUBLES] cgal_side.cpp -o cgal_side -lgmp
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Side_of_triangle_mesh.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/version.h>

#include <nlohmann/json.hpp>

#include <iostream>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

using Json = nlohmann::json;
// With -DDOUBLES predicates are computed in doubles, as in programs that choose the simpler kernel.
#ifdef DOUBLES
using Kernel = CGAL::Simple_cartesian<double>;
constexpr const char* kKernel = "Simple_cartesian<double>";
#else
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
constexpr const char* kKernel = "Exact_predicates_inexact_constructions_kernel";
#endif
using Surface = CGAL::Surface_mesh<Kernel::Point_3>;

Kernel::Point_3 point_of(const Json& p) { return {p[0].get<double>(), p[1].get<double>(), p[2].get<double>()}; }

Json answer(const Json& question) {
  if (question.contains("describe"))
    return {{"formulas", Json::object()},
            {"about", std::string("Side_of_triangle_mesh, CGAL " CGAL_VERSION_STR ", ") + kKernel}};
  if (question.at("kind") != "inside") throw std::runtime_error("inside only");
  if (question.at("vertices")[0].size() != 3) throw std::runtime_error("triangles in space only");
  Surface surface;
  std::vector<Surface::Vertex_index> at;
  for (const Json& vertex : question.at("vertices")) at.push_back(surface.add_vertex(point_of(vertex)));
  for (const Json& face : question.at("faces"))
    if (surface.add_face(at.at(face[0].get<std::size_t>()), at.at(face[1].get<std::size_t>()),
                         at.at(face[2].get<std::size_t>())) == Surface::null_face())
      throw std::runtime_error("no manifold");
  const CGAL::Side_of_triangle_mesh<Surface, Kernel> side(surface);
  Json all = Json::array();
  for (const Json& point : question.at("points")) {
    const CGAL::Bounded_side found = side(point_of(point));
    all.push_back(found == CGAL::ON_BOUNDED_SIDE ? 1 : found == CGAL::ON_BOUNDARY ? 0 : -1);
  }
  return {{"coordinates", all}};
}

}  // namespace

int main() {
  for (std::string line; std::getline(std::cin, line);) {
    try {
      std::cout << answer(Json::parse(line)) << std::endl;
    } catch (const std::exception& error) {
      std::cout << Json{{"error", error.what()}} << std::endl;
    }
  }
}
