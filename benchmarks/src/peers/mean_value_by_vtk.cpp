// SPDX-License-Identifier: MIT
#include "peers.h"

#include <vtkCellArray.h>
#include <vtkDoubleArray.h>
#include <vtkIdList.h>
#include <vtkMeanValueCoordinatesInterpolator.h>
#include <vtkNew.h>
#include <vtkPoints.h>

namespace cageproof::benchmarks {

PeerFill mean_value_by_vtk(const CageElements& elements) {
  const auto points_of_cage = vtkSmartPointer<vtkPoints>::New();
  points_of_cage->SetDataTypeToDouble();
  for (const Vec3<double>& v : elements.vertices()) points_of_cage->InsertNextPoint(v.data());
  const auto triangles = vtkSmartPointer<vtkIdList>::New();
  for (std::size_t t = 0; t < elements.count(); ++t)
    for (const int v : elements.vertices_of(t)) triangles->InsertNextId(v);
  return [points_of_cage, triangles, count = elements.vertices().size()](std::span<const Vec3<double>> points,
                                                                         std::span<double> values) {
    for (std::size_t p = 0; p < points.size(); ++p)
      vtkMeanValueCoordinatesInterpolator::ComputeInterpolationWeights(points[p].data(), points_of_cage, triangles,
                                                                       values.data() + p * count);
  };
}

}  // namespace cageproof::benchmarks
