// SPDX-License-Identifier: MIT
#include "field_page.h"

#include "cageproof/reports/packed_file.h"
#include "cageproof/reports/vtk_text.h"
#include "base64.h"
#include "colours.h"
#include "field_page_template.h"
#include "page/page_data.h"
#include "palette.h"

#include <nlohmann/json.hpp>

#include <stdexcept>

namespace cageproof::reports {
namespace {

using Json = nlohmann::json;

template <class T>
std::string base64_of(const std::vector<T>& values) {
  return base64({reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T)});
}

std::string coordinates(const std::vector<Vec3<double>>& points) {
  std::vector<float> numbers;
  for (const Vec3<double>& p : points)
    for (int c = 0; c < 3; ++c) numbers.push_back(static_cast<float>(p[c]));
  return base64_of(numbers);
}

// As VTK lists cells: the number of corners, then these.
template <class Cells>
std::string cells(const Cells& all) {
  std::vector<std::uint32_t> numbers;
  for (const auto& cell : all) {
    numbers.push_back(static_cast<std::uint32_t>(cell.size()));
    for (const int v : cell) numbers.push_back(static_cast<std::uint32_t>(v));
  }
  return base64_of(numbers);
}

Json logarithms(const std::vector<ImageField::Array>& arrays, const std::vector<std::string>& compared,
                std::size_t samples) {
  Json all = Json::array();
  for (const std::string& name : compared) {
    std::vector<float> numbers;
    for (const double value : array_named(arrays, name, samples).values)
      numbers.push_back(static_cast<float>(floored_log10(value)));
    all.push_back(base64_of(numbers));
  }
  return all;
}

Json scene_json(const FieldScene& scene, const std::string& picture) {
  Json palette = Json::array(), compared = Json::array();
  for (const char* colour : kPalette) palette.push_back(rgb_of(colour));
  for (const std::string& name : scene.compared) compared.push_back(short_name(name));
  const ImageField& image = scene.image;
  const std::size_t samples = static_cast<std::size_t>(image.points[0]) * image.points[1] * image.points[2];
  const auto three = [](const Vec3<double>& v) { return Json{v[0], v[1], v[2]}; };
  const MeshField cage = geometry_of(scene.cage);
  Json json{
      {"compared", compared},
      {"range", {kSceneLow, kSceneHigh}},
      {"palette", palette},
      {"masked", rgb_of(kMaskedColour)},
      {"infinite", rgb_of(kInfiniteColour)},
      {"picture", picture},
      {"image",
       {{"points", image.points},
        {"origin", three(image.origin)},
        {"spacing", three(image.spacing)},
        {"values", logarithms(image.arrays, scene.compared, samples)}}},
      {"cage",
       {{"vertices", coordinates(cage.vertices)}, {"faces", cells(cage.faces)}, {"edges", cells(cage.segments)}}}};
  const MeshField& mesh = scene.mesh;
  if (mesh.vertices.empty()) json["mesh"] = nullptr;
  else
    json["mesh"] = {{"vertices", coordinates(mesh.vertices)},
                    {"faces", cells(mesh.faces)},
                    {"values", logarithms(mesh.arrays, scene.compared, mesh.vertices.size())}};
  return json;
}

// Inside an element script nothing ends it but its end tag.
std::string for_script(std::string text) {
  for (auto at = text.find("</"); at != std::string::npos; at = text.find("</", at + 3)) text.replace(at, 2, "<\\/");
  return text;
}

}  // namespace

std::string field_page(const FieldScene& scene, const std::string& picture, const std::vector<std::string>& files) {
  Data data, compared{Data::type::list}, facts{Data::type::list}, names{Data::type::list};
  for (std::size_t i = 0; i < scene.compared.size(); ++i) {
    Data one;
    one.set("index", std::to_string(i));
    one.set("name", short_name(scene.compared[i]));
    compared << one;
  }
  for (const auto& [key, value] : scene.image.facts) {
    Data one;
    one.set("key", key);
    one.set("value", value);
    facts << one;
  }
  for (const std::string& file : files) names << Data(file);
  data.set("title", scene.title);
  data.set("explanation", scene.explanation);
  data.set("compared", compared);
  data.set("facts", facts);
  data.set("files", names);
  data.set("has_mesh", !scene.mesh.vertices.empty());
  data.set("picture", picture);
  data.set("legend", "relative error");
  data.set("top", "1");
  data.set("masked_colour", kMaskedColour);
  data.set("infinite_colour", kInfiniteColour);
  data.set("data", for_script(scene_json(scene, picture).dump()));
  data.set("style", kFieldStyle);
  data.set("script", kFieldScript);
  data.set("vtk_version", kVtkJsVersion);
  data.set("vtk_licence", kVtkJsLicence);
  data.set("vtk", base64(packed(kVtkJs)));
  kainjow::mustache::mustache sheet(kFieldTemplate);
  if (!sheet.is_valid()) throw std::logic_error("field.mustache: " + sheet.error_message());
  return sheet.render(data);
}

}  // namespace cageproof::reports
