// SPDX-License-Identifier: MIT
// CGAL's Mean_value_coordinates_2 for `cageproof judge --kind mean_value --dimension 2` (docs/judged.md): a program of
// its own that answers lines, since CGAL's headers are under the GPL, and with them what is built of this file.
//   c++ -O2 -DNDEBUG cgal_mean_value.cpp -o cgal_mean_value -lgmp
#include <CGAL/Barycentric_coordinates_2/Mean_value_coordinates_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/version.h>

#include <nlohmann/json.hpp>

#include <cmath>
#include <cstdio>
#include <iostream>
#include <iterator>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

using Json = nlohmann::json;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Polygon = std::vector<Kernel::Point_2>;
using Coordinates = CGAL::Barycentric_coordinates::Mean_value_coordinates_2<Polygon, Kernel>;
using Policy = CGAL::Barycentric_coordinates::Computation_policy_2;

// The vertices in the polygon's order. CGAL's polygons have no holes.
std::vector<std::size_t> around(const Json& segments) {
  std::vector<std::size_t> next(segments.size()), order;
  for (const Json& segment : segments) next.at(segment[0].get<std::size_t>()) = segment[1].get<std::size_t>();
  std::size_t at = 0;
  do {
    order.push_back(at);
    at = next.at(at);
  } while (at != 0 && order.size() < segments.size());
  if (at != 0 || order.size() != segments.size()) throw std::runtime_error("a polygon without holes only");
  return order;
}

Kernel::Point_2 point_of(const Json& point) { return {point[0].get<double>(), point[1].get<double>()}; }

std::string text_of(double x) {
  char text[32] = "\"nan\"";
  if (std::isfinite(x)) std::snprintf(text, sizeof text, "%.17g", x);
  return text;
}

std::string answer(const Json& question, Policy policy) {
  if (question.contains("describe"))
    return R"({"formulas":{},"float":false,"about":"Mean_value_coordinates_2, CGAL )" CGAL_VERSION_STR R"("})";
  if (question.at("kind") != "mean_value") throw std::runtime_error("mean_value only");
  const std::vector<std::size_t> order = around(question.at("faces"));
  Polygon polygon;
  for (const std::size_t v : order) polygon.push_back(point_of(question.at("vertices")[v]));
  Coordinates coordinates(polygon, policy);
  std::string text = "{\"coordinates\":[";
  for (const Json& point : question.at("points")) {
    std::vector<double> found;
    coordinates(point_of(point), std::back_inserter(found));
    std::vector<double> ours(order.size());
    for (std::size_t k = 0; k < order.size(); ++k) ours[order[k]] = found.at(k);
    text += text.back() == ']' ? ",[" : "[";
    for (std::size_t k = 0; k < ours.size(); ++k) text += (k > 0 ? "," : "") + text_of(ours[k]);
    text += ']';
  }
  return text + "]}";
}

}  // namespace

// Usage: cgal_mean_value [fast]: without the word, by its default policy, PRECISE_WITH_EDGE_CASES.
int main(int argc, char** argv) {
  const Policy policy =
      argc > 1 && std::string(argv[1]) == "fast" ? Policy::FAST_WITH_EDGE_CASES : Policy::PRECISE_WITH_EDGE_CASES;
  for (std::string line; std::getline(std::cin, line);) {
    try {
      std::cout << answer(Json::parse(line), policy) << std::endl;
    } catch (const std::exception& error) {
      std::cout << Json{{"error", error.what()}}.dump() << std::endl;
    }
  }
}
