// SPDX-License-Identifier: MIT
// VTK's vtkMeanValueCoordinatesInterpolator in polyhedra with quads, for `cageproof judge --kind spherical_mean_value`
// (docs/judged.md): a program that answers lines. Where all faces are triangles VTK takes other code.
//   c++ -O2 $(...) vtk_polygons.cpp -o vtk_polygons
#include <vtkCellArray.h>
#include <vtkMeanValueCoordinatesInterpolator.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkVersion.h>

#include <nlohmann/json.hpp>

#include <cmath>
#include <iostream>
#include <stdexcept>
#include <vector>

namespace {

using Json = nlohmann::json;

Json answer(const Json& question) {
  if (question.contains("describe"))
    return {{"formulas", Json::object()}, {"about", "vtkMeanValueCoordinatesInterpolator, VTK " VTK_VERSION}};
  if (question.at("kind") != "spherical_mean_value") throw std::runtime_error("spherical_mean_value only");
  vtkNew<vtkPoints> corners;
  corners->SetDataTypeToDouble();
  for (const Json& vertex : question.at("vertices"))
    corners->InsertNextPoint(vertex[0].get<double>(), vertex[1].get<double>(), vertex[2].get<double>());
  vtkNew<vtkCellArray> polygons;
  for (const Json& face : question.at("faces")) {
    const auto corner = face.get<std::vector<vtkIdType>>();
    polygons->InsertNextCell(static_cast<vtkIdType>(corner.size()), corner.data());
  }
  Json all = Json::array();
  for (const Json& point : question.at("points")) {
    std::vector<double> weights(static_cast<std::size_t>(corners->GetNumberOfPoints()));
    const auto x = point.get<std::vector<double>>();
    vtkMeanValueCoordinatesInterpolator::ComputeInterpolationWeights(x.data(), corners, polygons, weights.data());
    Json row = Json::array();
    for (const double w : weights) row.push_back(std::isfinite(w) ? Json(w) : Json("nan"));
    all.push_back(row);
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
