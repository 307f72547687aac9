// SPDX-License-Identifier: MIT
#include "cageproof/core/whole_file.h"
#include "sample_run.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <vtkCellArray.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPNGReader.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkStringArray.h>
#include <vtkXMLImageDataReader.h>
#include <vtkXMLPolyDataReader.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace cageproof::reports {
namespace {

void expect_same(vtkPointData& data, const std::vector<ImageField::Array>& arrays) {
  // Each error comes with its logarithm and a mask.
  ASSERT_EQ(data.GetNumberOfArrays(),
            static_cast<int>(arrays.size() + 2 * std::ranges::count(arrays, 1, &ImageField::Array::components)));
  for (const ImageField::Array& array : arrays) {
    vtkDataArray* read = data.GetArray(fmt::format("{} [{}]", array.name, array.unit).c_str());
    ASSERT_NE(read, nullptr) << array.name;
    ASSERT_EQ(read->GetNumberOfComponents(), array.components);
    ASSERT_EQ(read->GetNumberOfValues(), static_cast<vtkIdType>(array.values.size()));
    for (std::size_t i = 0; i < array.values.size(); ++i) {
      const double value = read->GetComponent(i / array.components, static_cast<int>(i % array.components));
      EXPECT_TRUE(value == array.values[i] || (std::isnan(value) && std::isnan(array.values[i]))) << i;
    }
  }
}

// Width and height of a PNG that VTK can read, and whether it shows more than one colour.
struct Seen {
  int width = 0, height = 0;
  bool varied = false;
};
Seen look_at(const std::filesystem::path& path) {
  vtkNew<vtkPNGReader> reader;
  reader->SetFileName(path.c_str());
  reader->Update();
  vtkImageData* image = reader->GetOutput();
  Seen seen{image->GetDimensions()[0], image->GetDimensions()[1], false};
  const double first = image->GetScalarComponentAsDouble(0, 0, 0, 0);
  for (int x = 0; x < seen.width; ++x)
    seen.varied = seen.varied || image->GetScalarComponentAsDouble(x, seen.height / 2, 0, 0) != first;
  return seen;
}

// How many pixels below the legend have the colour of what is not finite.
int red_pixels(const std::filesystem::path& path) {
  vtkNew<vtkPNGReader> reader;
  reader->SetFileName(path.c_str());
  reader->Update();
  vtkImageData* image = reader->GetOutput();
  int count = 0;
  for (int y = 0; y < image->GetDimensions()[1] - 60; ++y)
    for (int x = 0; x < image->GetDimensions()[0]; ++x)
      count +=
          image->GetScalarComponentAsDouble(x, y, 0, 0) > 200 && image->GetScalarComponentAsDouble(x, y, 0, 1) < 60;
  return count;
}

class Fields : public ::testing::Test {
 protected:
  std::filesystem::path out() const { return scratch_.path() / "report"; }
  ScratchFolder scratch_;
};

TEST_F(Fields, AnImageReadsBackAsWritten) {
  const ImageField field = sample_slice("slice", 9);
  ReportWriter writer(out());
  const FieldEntry entry = writer.write_image(field, "a slice", "relative error", ColourScale::Log10);
  writer.write({});
  writer.commit();
  EXPECT_EQ(entry.data, "fields/slice.vti");
  EXPECT_EQ(entry.unit, "1");
  double largest = 0;
  for (const double value : field.arrays[0].values)
    if (std::isfinite(value)) largest = std::max(largest, value);
  EXPECT_EQ(entry.largest, largest);
  vtkNew<vtkXMLImageDataReader> reader;
  reader->SetFileName((out() / entry.data).c_str());
  reader->Update();
  for (int k = 0; k < 3; ++k) {
    EXPECT_EQ(reader->GetOutput()->GetDimensions()[k], field.points[k]);
    EXPECT_EQ(reader->GetOutput()->GetOrigin()[k], field.origin[k]);
    EXPECT_EQ(reader->GetOutput()->GetSpacing()[k], field.spacing[k]);
  }
  expect_same(*reader->GetOutput()->GetPointData(), field.arrays);
}

// Gnuplot draws nothing that is less than a pixel wide.
TEST_F(Fields, APictureOfASliceWithoutWidthFillsItAndSaysSo) {
  for (const double flat : {1e-3, 1e-5, 1e-9})
    for (const int axis : {0, 1}) {
      ImageField field = sample_slice("slice", 9);
      field.spacing[axis] *= flat;
      field.arrays[0].values[40] = HUGE_VAL;
      ReportWriter writer(out());
      const FieldEntry entry = writer.write_image(field, "a slice", "relative error", ColourScale::Log10);
      EXPECT_EQ(writer.write({}), std::vector<std::string>()) << flat << ' ' << axis;
      writer.commit();
      // One sample of 9 x 9, of a picture of 378 x 120 pixels and more.
      EXPECT_GT(red_pixels(out() / entry.picture), 300) << flat << ' ' << axis;
    }
}

TEST_F(Fields, LogarithmsAreFlooredAndMasked) {
  ImageField field = sample_slice("slice", 9);
  field.facts = {{"evaluation", "gauss-8"}, {"seed", "7"}, {"version", "1 < 2"}};
  field.arrays[0].values[0] = 1e-30;
  field.arrays[0].values[1] = std::nan("");
  field.arrays[0].values[2] = -1e-3;
  field.arrays[0].values[3] = HUGE_VAL;
  field.arrays[0].values[4] = 0;
  ReportWriter writer(out());
  const FieldEntry entry = writer.write_image(field, "a slice", "relative error", ColourScale::Log10);
  writer.write({});
  writer.commit();
  vtkNew<vtkXMLImageDataReader> reader;
  reader->SetFileName((out() / entry.data).c_str());
  reader->Update();
  vtkPointData& points = *reader->GetOutput()->GetPointData();
  vtkDataArray* log = points.GetArray("log10 relative error");
  vtkDataArray* mask = points.GetArray("mask relative error");
  ASSERT_NE(log, nullptr);
  ASSERT_NE(mask, nullptr);
  EXPECT_EQ(log->GetComponent(0, 0), -17);
  EXPECT_TRUE(std::isnan(log->GetComponent(1, 0)));
  EXPECT_FLOAT_EQ(static_cast<float>(log->GetComponent(2, 0)), -3);
  EXPECT_GT(log->GetComponent(3, 0), 300);
  EXPECT_EQ(log->GetComponent(4, 0), -17);
  for (const auto& [sample, value] : {std::pair(0, 1), {1, 0}, {2, 1}, {3, 2}, {4, 1}})
    EXPECT_EQ(mask->GetComponent(sample, 0), value) << sample;
  for (const auto& [name, text] : field.facts) {
    auto* fact = vtkStringArray::SafeDownCast(reader->GetOutput()->GetFieldData()->GetAbstractArray(name.c_str()));
    ASSERT_NE(fact, nullptr) << name;
    EXPECT_EQ(fact->GetValue(0), text);
  }
}

TEST_F(Fields, AMeshReadsBackAsWritten) {
  const MeshField field = sample_mesh("mesh", 7);
  MeshField cloud = field;
  cloud.faces.clear();
  ReportWriter writer(out());
  const FieldEntry mesh = writer.write_mesh(field, "a mesh", "partition of unity", ColourScale::Log10);
  const FieldEntry points = writer.write_mesh(cloud, "points", "partition of unity", ColourScale::Linear);
  writer.write({});
  writer.commit();
  EXPECT_NE(mesh.data, points.data);
  for (const FieldEntry& entry : {mesh, points}) {
    vtkNew<vtkXMLPolyDataReader> reader;
    reader->SetFileName((out() / entry.data).c_str());
    reader->Update();
    vtkPolyData* read = reader->GetOutput();
    ASSERT_EQ(read->GetNumberOfPoints(), static_cast<vtkIdType>(field.vertices.size()));
    for (std::size_t i = 0; i < field.vertices.size(); ++i)
      for (int k = 0; k < 3; ++k) EXPECT_EQ(read->GetPoint(i)[k], field.vertices[i][k]);
    expect_same(*read->GetPointData(), field.arrays);
    if (entry.data == points.data) {
      EXPECT_EQ(read->GetNumberOfVerts(), read->GetNumberOfPoints());
      continue;
    }
    ASSERT_EQ(read->GetNumberOfPolys(), static_cast<vtkIdType>(field.faces.size()));
    for (std::size_t f = 0; f < field.faces.size(); ++f) {
      vtkNew<vtkIdList> ids;
      read->GetCellPoints(static_cast<vtkIdType>(f), ids);
      ASSERT_EQ(ids->GetNumberOfIds(), 4);
      for (int k = 0; k < 4; ++k) EXPECT_EQ(ids->GetId(k), field.faces[f][k]);
    }
  }
}

TEST_F(Fields, EveryPictureIsAPicture) {
  RunResult run = sample_run(2, 2);
  // A curve with one point, one with nothing finite, and one that has no positive parameter at all.
  run.curves[0].parameters = {0.5};
  run.curves[0].errors = {0};
  for (double& error : run.curves[1].errors) error = HUGE_VAL;
  run.curves.push_back(run.curves[0]);
  run.curves.back().setting = "on-nothing";
  run.curves.back().parameters = {0};
  ReportWriter writer(out());
  ImageField volume = sample_slice("volume", 4), cut = volume;
  volume.points = {4, 4, 2};
  cut.points = {1, 8, 4};
  cut.name = "it's \"cut\"\\n";
  for (double& value : cut.arrays[0].values) value = std::nan("");
  run.fields = {
      writer.write_image(volume, "a volume with $data & 'quotes'", "relative error", ColourScale::Linear),
      writer.write_image(cut, "nothing", "relative error", ColourScale::Log10),
      writer.write_image(sample_slice("gradient", 4), "gradient", "gradient", ColourScale::Log10),
      writer.write_mesh(sample_mesh("mesh", 5), "mesh", "partition of unity", ColourScale::Linear),
      writer.write_mesh({"empty", {}, {}, {{"nothing", "", 1, {}}}}, "empty", "nothing", ColourScale::Linear)};
  writer.write(run);
  writer.commit();
  int pictures = 0;
  for (const auto& entry : std::filesystem::directory_iterator(out() / "pictures")) {
    const Seen seen = look_at(entry.path());
    EXPECT_GE(seen.width, 500) << entry.path();
    EXPECT_GE(seen.height, 200) << entry.path();
    EXPECT_TRUE(seen.varied) << entry.path();
    EXPECT_LT(std::filesystem::file_size(entry.path()), 100'000u);
    ++pictures;
  }
  EXPECT_EQ(pictures, 4 + 5);
}

TEST_F(Fields, ColoursFollowTheValues) {
  ImageField field = sample_slice("rising", 6), falling = field, marked = field;
  falling.name = "falling";
  marked.name = "marked";
  std::reverse(falling.arrays[1].values.begin(), falling.arrays[1].values.end() - 3);
  marked.arrays[1].values[30] = HUGE_VAL;
  ReportWriter writer(out());
  for (const ImageField& image : {field, falling, marked})
    writer.write_image(image, "same", "gradient", ColourScale::Linear);
  writer.write({});
  writer.commit();
  const auto picture = [&](const char* name) {
    return read_file(out() / "pictures" / fmt::format("field.{}.png", name));
  };
  EXPECT_NE(picture("rising"), picture("falling"));
  EXPECT_EQ(red_pixels(out() / "pictures" / "field.rising.png"), 0);
  EXPECT_GT(red_pixels(out() / "pictures" / "field.marked.png"), 100);
}

TEST_F(Fields, ArraysMustFit) {
  ReportWriter writer(out());
  ImageField field = sample_slice("slice", 4);
  EXPECT_THROW(writer.write_image(field, "t", "no such array", ColourScale::Linear), std::invalid_argument);
  field.arrays[1].values.pop_back();
  EXPECT_THROW(writer.write_image(field, "t", "relative error", ColourScale::Linear), std::invalid_argument);
}

}  // namespace
}  // namespace cageproof::reports
