// SPDX-License-Identifier: MIT
#include "cageproof/reports/mesh_text.h"

#include "cageproof/core/whole_file.h"
#include "temporary_folder.h"

#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkOBJWriter.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include <fmt/format.h>

#include <bit>
#include <cstdint>
#include <stdexcept>

namespace cageproof::reports {
namespace {

void fill(const Mesh& mesh, vtkPolyData& data) {
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (const Vec3<double>& vertex : mesh.vertices) points->InsertNextPoint(vertex.data());
  data.SetPoints(points);
  vtkNew<vtkCellArray> faces, lines;
  for (const auto& face : mesh.faces) {
    faces->InsertNextCell(static_cast<int>(face.size()));
    for (const int v : face) faces->InsertCellPoint(v);
  }
  for (const auto& segment : mesh.segments) {
    lines->InsertNextCell(2);
    for (const int v : segment) lines->InsertCellPoint(v);
  }
  if (!mesh.faces.empty()) data.SetPolys(faces);
  if (!mesh.segments.empty()) data.SetLines(lines);
}

}  // namespace

std::string obj_text(const Mesh& mesh) {
  vtkNew<vtkPolyData> data;
  fill(mesh, *data);
  const TemporaryFolder scratch;
  // VTK's writer knows files only.
  const std::string file = (scratch.path() / "mesh.obj").string();
  vtkNew<vtkOBJWriter> writer;
  writer->SetInputData(data);
  writer->SetFileName(file.c_str());
  if (!writer->Write()) throw std::runtime_error("VTK could not write a mesh");
  std::string text = read_file(file);
  if (text.empty()) throw std::runtime_error("VTK wrote no mesh");
  return text;
}

std::string ply_text(const Mesh& mesh) {
  static_assert(std::endian::native == std::endian::little);
  std::string text = fmt::format(
      "ply\nformat binary_little_endian 1.0\nelement vertex {}\nproperty double x\nproperty double y\n"
      "property double z\n",
      mesh.vertices.size());
  if (!mesh.faces.empty())
    text += fmt::format("element face {}\nproperty list uchar int vertex_indices\n", mesh.faces.size());
  if (!mesh.segments.empty())
    text += fmt::format("element edge {}\nproperty int vertex1\nproperty int vertex2\n", mesh.segments.size());
  text += "end_header\n";
  const auto append = [&](const auto& x) { text.append(reinterpret_cast<const char*>(&x), sizeof x); };
  for (const Vec3<double>& vertex : mesh.vertices)
    for (const double x : vertex) append(x);
  for (const auto& face : mesh.faces) {
    append(static_cast<std::uint8_t>(face.size()));
    for (const std::int32_t v : face) append(v);
  }
  for (const auto& segment : mesh.segments)
    for (const std::int32_t v : segment) append(v);
  return text;
}

}  // namespace cageproof::reports
