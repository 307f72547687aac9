// SPDX-License-Identifier: MIT
#include "cageproof/reports/mesh_text.h"

#include "cageproof/core/whole_file.h"
#include "temporary_folder.h"

#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkOBJWriter.h>
#include <vtkPLYWriter.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

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

// By a writer that knows files alone.
template <class Writer>
std::string written(const Mesh& mesh, const char* name, const auto& set) {
  vtkNew<vtkPolyData> data;
  fill(mesh, *data);
  const TemporaryFolder scratch;
  const std::string file = (scratch.path() / name).string();
  vtkNew<Writer> writer;
  writer->SetInputData(data);
  writer->SetFileName(file.c_str());
  set(*writer);
  if (!writer->Write()) throw std::runtime_error("VTK could not write a mesh");
  std::string text = read_file(file);
  if (text.empty()) throw std::runtime_error("VTK wrote no mesh");
  return text;
}

}  // namespace

std::string obj_text(const Mesh& mesh) {
  return written<vtkOBJWriter>(mesh, "mesh.obj", [](vtkOBJWriter&) {});
}

std::string ply_text(const Mesh& mesh) {
  return written<vtkPLYWriter>(mesh, "mesh.ply", [](vtkPLYWriter& writer) {
    writer.SetFileTypeToBinary();
    writer.SetDataByteOrderToLittleEndian();
  });
}

}  // namespace cageproof::reports
