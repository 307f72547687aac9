// SPDX-License-Identifier: MIT
// PLY and VTP through VTK. What VTK says becomes an InputError and never reaches the terminal.
#include "cage/mesh_files.h"
#include "vtp_check.h"

#include <fmt/format.h>
#include <vtkCellArray.h>
#include <vtkLogger.h>
#include <vtkNew.h>
#include <vtkPLYReader.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkStringOutputWindow.h>
#include <vtkXMLPolyDataReader.h>

#include <algorithm>
#include <limits>
#include <new>
#include <span>

namespace cageproof::mesh_files {
namespace {

// While it lives, VTK writes into it instead of the terminal.
class VtkMessages {
 public:
  VtkMessages() : before_(vtkOutputWindow::GetInstance()), verbosity_(vtkLogger::GetCurrentVerbosityCutoff()) {
    vtkOutputWindow::SetInstance(window_);
    vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF);
  }
  ~VtkMessages() {
    vtkOutputWindow::SetInstance(before_);
    vtkLogger::SetStderrVerbosity(verbosity_);
  }
  VtkMessages(const VtkMessages&) = delete;
  VtkMessages& operator=(const VtkMessages&) = delete;
  /// The first message without VTK's source line and object address; empty when there is none.
  std::string first() {
    std::string text = window_->GetOutput();
    std::string_view rest = text, line;
    if (!take_line(rest, line) || !take_line(rest, line)) return text;
    const std::size_t address = line.find("): ");
    return std::string(address == std::string_view::npos ? line : line.substr(address + 3));
  }

 private:
  vtkNew<vtkStringOutputWindow> window_;
  vtkSmartPointer<vtkOutputWindow> before_;
  vtkLogger::Verbosity verbosity_;
};

// The vertices of a cell, indices in range. \param name of such a cell, in messages
std::span<const vtkIdType> vertices_of(vtkCellArray& cells, vtkIdType i, vtkIdType count, std::string_view name,
                                       const FileLine& at) {
  vtkIdType size = 0;
  const vtkIdType* first = nullptr;
  cells.GetCellAtId(i, size, first);
  const std::span<const vtkIdType> vertices(first, static_cast<std::size_t>(size));
  const auto wrong = std::ranges::find_if(vertices, [&](vtkIdType v) { return v < 0 || v >= count; });
  if (wrong != vertices.end())
    at.fail(
        fmt::format("{} {}: index {} is out of range, there are {} vertices (counted from 0)", name, i, *wrong, count));
  return vertices;
}

Mesh to_mesh(vtkPolyData* data, const FileLine& at) {
  Mesh mesh;
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i) {
    const Vec3<double> vertex(data->GetPoint(i));
    if (!vertex.allFinite()) at.fail(fmt::format("vertex {}: a coordinate is not finite (counted from 0)", i));
    mesh.vertices.push_back(vertex);
  }
  if (mesh.vertices.empty()) at.fail("no vertices");
  if (data->GetNumberOfStrips() > 0) at.fail("triangle strips; write them as triangles");
  const auto count = data->GetNumberOfPoints();
  vtkCellArray* cells = data->GetPolys();
  for (vtkIdType i = 0; i < cells->GetNumberOfCells(); ++i) {
    const auto corners = vertices_of(*cells, i, count, "face", at);
    mesh.faces.emplace_back(corners.begin(), corners.end());
  }
  vtkCellArray* polylines = data->GetLines();
  for (vtkIdType i = 0; i < polylines->GetNumberOfCells(); ++i) {
    const auto vertices = vertices_of(*polylines, i, count, "polyline", at);
    for (std::size_t k = 1; k < vertices.size(); ++k)
      mesh.segments.push_back({static_cast<int>(vertices[k - 1]), static_cast<int>(vertices[k])});
  }
  return mesh;
}

// `open` tells the reader what to read.
template <class Reader, class Open>
Mesh read_with(const std::filesystem::path& path, Open&& open) {
  const FileLine at{path};
  VtkMessages messages;
  vtkNew<Reader> reader;
  try {
    open(*reader);
    reader->Update();
  } catch (const std::bad_alloc&) {
    at.fail("the file states sizes that do not fit in memory");
  }
  if (const std::string message = messages.first(); !message.empty()) at.fail("VTK cannot read it: " + message);
  return to_mesh(reader->GetOutput(), at);
}

Mesh read_ply(const std::filesystem::path& path) {
  CheckedPly checked = check_ply(path, read_mesh_file(path));
  Mesh mesh{std::move(checked.vertices), {}};
  mesh.warnings = std::move(checked.warnings);
  if (checked.face_count == 0) return mesh;
  Mesh faces = read_with<vtkPLYReader>(path, [&](vtkPLYReader& reader) {
    reader.SetReadFromInputString(true);
    reader.SetInputString(checked.for_vtk);
  });
  if (faces.vertices.size() != mesh.vertices.size() || faces.faces.size() != checked.face_count)
    FileLine{path}.fail(fmt::format("VTK read {} vertices and {} faces of {} and {}", faces.vertices.size(),
                                    faces.faces.size(), mesh.vertices.size(), checked.face_count));
  mesh.faces = std::move(faces.faces);
  return mesh;
}

Mesh read_vtp(const std::filesystem::path& path) {
  const std::string file = read_mesh_file(path);
  const std::size_t size = file.size();
  if (size > static_cast<std::size_t>(std::numeric_limits<int>::max())) FileLine{path}.fail("the file is too large");
  check_arrays(file, FileLine{path});
  return read_with<vtkXMLPolyDataReader>(path, [&](vtkXMLPolyDataReader& reader) {
    reader.SetFileName(path.c_str());
    reader.UpdateInformation();
    reader.SetupUpdateExtent(0, 1, 0);
    // VTK makes room for what a file states before it looks at what there is.
    constexpr vtkIdType most = std::numeric_limits<int>::max();
    const vtkIdType points = reader.GetNumberOfPoints(), cells = reader.GetNumberOfCells();
    if (points < 0 || cells < 0 || points > most || cells > most)
      FileLine{path}.fail("the number of vertices or faces that it states is out of range");
    constexpr std::size_t bytes = 3 * sizeof(float);
    if (bytes * static_cast<std::size_t>(std::max(points, cells)) > most_unpacked(size))
      FileLine{path}.fail(
          fmt::format("{} vertices and {} cells are stated, more than its {} bytes hold", points, cells, size));
  });
}

const RegisterMeshReader ply{".ply", read_ply}, vtp{".vtp", read_vtp};

}  // namespace
}  // namespace cageproof::mesh_files
