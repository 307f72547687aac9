// SPDX-License-Identifier: MIT
// A scene's state for ParaView: XML that names files and arrays which are there, and proxies which it defines.
#include "cageproof/core/whole_file.h"
#include "cageproof/reports/field_scene.h"
#include "sample_run.h"

#include <gtest/gtest.h>

#include <vtkDataArray.h>
#include <vtkDataSet.h>
#include <vtkFieldData.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkStringArray.h>
#include <vtkXMLDataElement.h>
#include <vtkXMLImageDataReader.h>
#include <vtkXMLPolyDataReader.h>
#include <vtkXMLUtilities.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <set>

namespace cageproof::reports {
namespace {

using Element = vtkXMLDataElement;

FieldScene sample_scene(bool with_mesh) {
  FieldScene scene;
  scene.title = "a <scene> & \"more\"";
  scene.explanation = "what is compared";
  scene.compared = {"gauss-8: relative error", "closed_form: relative error"};
  scene.image = sample_slice("scene", 4);
  scene.image.facts = {{"cage", "a & b"}, {"seed", "7"}};
  const ImageField::Array errors = scene.image.arrays[0];
  scene.image.arrays = {errors, errors};
  for (int k = 0; k < 2; ++k) scene.image.arrays[k].name = scene.compared[k];
  scene.image.arrays[0].values[0] = 1e-30;
  scene.image.arrays.push_back(errors);
  scene.image.arrays.back().name = "inside";
  scene.image.arrays.back().linear = true;
  scene.cage = {"cage", {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}, {}};
  if (!with_mesh) return scene;
  scene.mesh = sample_mesh("mesh", 5);
  scene.mesh.facts = scene.image.facts;
  scene.mesh.arrays.push_back(scene.mesh.arrays[0]);
  for (int k = 0; k < 2; ++k) scene.mesh.arrays[k].name = scene.compared[k];
  return scene;
}

void visit(Element& element, const std::function<void(Element&)>& take) {
  take(element);
  for (int k = 0; k < element.GetNumberOfNestedElements(); ++k) visit(*element.GetNestedElement(k), take);
}

std::string attribute(Element& element, const char* name) {
  const char* value = element.GetAttribute(name);
  return value == nullptr ? "" : value;
}

bool has_name(const Element& element, const char* name) {
  return std::string_view(const_cast<Element&>(element).GetName()) == name;
}

// The values of a proxy's property.
std::vector<std::string> values_of(Element& proxy, const char* property) {
  std::vector<std::string> values;
  visit(proxy, [&](Element& element) {
    if (!has_name(element, "Property") || attribute(element, "name") != property) return;
    visit(element, [&](Element& one) {
      if (has_name(one, "Element")) values.push_back(attribute(one, "value"));
    });
  });
  return values;
}

template <class Reader>
vtkSmartPointer<vtkDataSet> read(const std::filesystem::path& path) {
  vtkNew<Reader> reader;
  reader->SetFileName(path.c_str());
  reader->Update();
  return reader->GetOutput();
}

class ParaviewState : public ::testing::TestWithParam<bool> {
 protected:
  void SetUp() override {
    ReportWriter writer(scratch_.path() / "report", ReportWriter::Kind::Field);
    entry_ = writer.write_scene(sample_scene(GetParam())).front();
    writer.write({});
    writer.commit();
    state_ = vtkSmartPointer<Element>::Take(vtkXMLUtilities::ReadElementFromFile(path(entry_.state).c_str()));
    ASSERT_NE(state_, nullptr) << "no well-formed XML";
  }
  std::filesystem::path path(const std::string& name) const { return scratch_.path() / "report" / name; }
  std::filesystem::path beside(const std::string& name) const { return path(entry_.state).parent_path() / name; }
  std::vector<Element*> proxies(const char* type) const {
    std::vector<Element*> found;
    visit(*state_, [&](Element& element) {
      if (has_name(element, "Proxy") && attribute(element, "type") == type) found.push_back(&element);
    });
    return found;
  }

  ScratchFolder scratch_;
  FieldEntry entry_;
  vtkSmartPointer<Element> state_;
};

TEST_P(ParaviewState, NamesFilesThatAreBesideIt) {
  EXPECT_TRUE(has_name(*state_, "ParaView"));
  std::set<std::string> files;
  for (const char* reader : {"XMLImageDataReader", "XMLPolyDataReader"})
    for (Element* proxy : proxies(reader))
      for (const std::string& file : values_of(*proxy, "FileName")) {
        EXPECT_TRUE(std::filesystem::is_regular_file(beside(file))) << file;
        EXPECT_TRUE(files.insert(file).second) << file;
      }
  EXPECT_EQ(files.size(), GetParam() ? 3u : 2u);
  EXPECT_TRUE(files.contains(std::filesystem::path(entry_.data).filename().string()));
}

TEST_P(ParaviewState, ColoursByArraysThatAreThere) {
  const FieldScene scene = sample_scene(GetParam());
  vtkSmartPointer<vtkDataSet> image;
  std::map<std::string, vtkSmartPointer<vtkDataSet>> by_id;
  for (Element* proxy : proxies("XMLImageDataReader"))
    by_id[attribute(*proxy, "id")] = image = read<vtkXMLImageDataReader>(beside(values_of(*proxy, "FileName")[0]));
  for (Element* proxy : proxies("XMLPolyDataReader"))
    by_id[attribute(*proxy, "id")] = read<vtkXMLPolyDataReader>(beside(values_of(*proxy, "FileName")[0]));
  const auto input_of = [](Element& proxy) {
    std::string id;
    visit(proxy, [&](Element& property) {
      if (has_name(property, "Property") && attribute(property, "name") == "Input")
        id = attribute(*property.GetNestedElement(0), "value");
    });
    return id;
  };
  for (Element* filter : proxies("Threshold")) {
    const auto& mesh = by_id[attribute(*filter, "id")] = by_id.at(input_of(*filter));
    EXPECT_NE(mesh->GetPointData()->GetArray(values_of(*filter, "SelectInputScalars").at(4).c_str()), nullptr);
  }
  std::set<std::string> shown;
  for (const char* type : {"UniformGridRepresentation", "UnstructuredGridRepresentation"})
    for (Element* proxy : proxies(type)) {
      const std::vector<std::string> colour = values_of(*proxy, "ColorArrayName");
      ASSERT_EQ(colour.size(), 5u);
      EXPECT_NE(by_id.at(input_of(*proxy))->GetPointData()->GetArray(colour[4].c_str()), nullptr) << colour[4];
      shown.insert(colour[4]);
    }
  std::set<std::string> expected;
  for (const std::string& array : scene.compared) expected.insert("log10 " + array);
  EXPECT_EQ(shown, expected);
  EXPECT_EQ(proxies("RenderView").size(), scene.compared.size());
}

TEST_P(ParaviewState, RefersToProxiesThatItDefines) {
  std::set<std::string> defined, listed, asked;
  visit(*state_, [&](Element& element) {
    if (has_name(element, "Proxy") && !attribute(element, "type").empty())
      EXPECT_TRUE(defined.insert(attribute(element, "id")).second) << attribute(element, "id");
    else if (has_name(element, "Proxy")) asked.insert(attribute(element, "id") + attribute(element, "value"));
    else if (has_name(element, "Item") && !attribute(element, "view").empty() && attribute(element, "view") != "0")
      asked.insert(attribute(element, "view"));
    else if (has_name(element, "Item") && !attribute(element, "id").empty()) listed.insert(attribute(element, "id"));
  });
  EXPECT_EQ(listed, defined);
  for (const std::string& id : asked) EXPECT_TRUE(defined.contains(id)) << id;
}

// A view, and its colour on the page, have the name of the evaluation whose errors they show.
TEST_P(ParaviewState, NamesWhatIsCompared) {
  std::vector<std::string> labels;
  for (Element* proxy : proxies("TextSource")) labels.push_back(values_of(*proxy, "Text").at(0));
  EXPECT_EQ(labels, (std::vector<std::string>{"gauss-8", "closed_form"}));
  EXPECT_NE(read_file(path(entry_.page)).find("\"compared\":[\"gauss-8\",\"closed_form\"]"), std::string::npos);
  EXPECT_EQ(short_name("plugin:mine: relative error"), "plugin:mine");
  EXPECT_EQ(short_name("mine: error: relative"), "mine");
  EXPECT_EQ(short_name("inside"), "inside");
}

// The page that opens in a browser shows the first scene, and says so of no other.
TEST_P(ParaviewState, HasAPageForTheFirstSceneOnly) {
  ReportWriter writer(scratch_.path() / "two", ReportWriter::Kind::Field);
  FieldScene scene = sample_scene(GetParam());
  scene.title = "first scene";
  for (const FieldEntry& entry : writer.write_scene(scene)) EXPECT_EQ(entry.page, "field.html");
  scene.title = "second scene";
  for (const FieldEntry& entry : writer.write_scene(scene)) EXPECT_EQ(entry.page, "");
  writer.write({});
  writer.commit();
  const std::string page = read_file(scratch_.path() / "two/field.html");
  EXPECT_NE(page.find("first scene"), std::string::npos);
  EXPECT_EQ(page.find("second scene"), std::string::npos);
}

// ParaView ends at an element without its value. VTK's reader drops empty ones, so the text is what counts.
TEST_P(ParaviewState, GivesEveryElementAValue) {
  const std::string text = read_file(path(entry_.state));
  int elements = 0;
  for (auto at = text.find("<Element "); at != text.npos; at = text.find("<Element ", at + 1), ++elements) {
    const std::string element = text.substr(at, text.find("/>", at) - at);
    EXPECT_NE(element.find(" value=\""), element.npos) << element;
  }
  EXPECT_GT(elements, 50);
  visit(*state_, [&](Element& element) {
    if (!has_name(element, "Property")) return;
    EXPECT_EQ(attribute(element, "number_of_elements"), std::to_string(element.GetNumberOfNestedElements()));
  });
}

// The volume that a scene's state opens says what it is, and floors and masks what it is coloured by.
TEST_P(ParaviewState, OpensWhatSaysWhatItIs) {
  const FieldScene scene = sample_scene(GetParam());
  const auto image = read<vtkXMLImageDataReader>(path(entry_.data));
  for (const auto& [name, text] : scene.image.facts) {
    auto* fact = vtkStringArray::SafeDownCast(image->GetFieldData()->GetAbstractArray(name.c_str()));
    ASSERT_NE(fact, nullptr) << name;
    EXPECT_EQ(fact->GetValue(0), text);
  }
  for (Element* proxy : proxies("XMLPolyDataReader")) {
    const std::string file = values_of(*proxy, "FileName")[0];
    const auto surface = read<vtkXMLPolyDataReader>(beside(file));
    for (const auto& [name, text] : scene.image.facts)
      EXPECT_NE(surface->GetFieldData()->GetAbstractArray(name.c_str()), nullptr) << file << " lacks " << name;
  }
  EXPECT_EQ(image->GetPointData()->GetArray("log10 inside"), nullptr);
  for (const std::string& array : scene.compared) {
    vtkDataArray* log = image->GetPointData()->GetArray(("log10 " + array).c_str());
    vtkDataArray* mask = image->GetPointData()->GetArray(("mask " + array).c_str());
    ASSERT_TRUE(log != nullptr && mask != nullptr) << array;
    const std::vector<double>& errors = scene.image.arrays[array == scene.compared[0] ? 0 : 1].values;
    for (std::size_t i = 0; i < errors.size(); ++i) {
      const double shown = log->GetComponent(static_cast<vtkIdType>(i), 0);
      EXPECT_EQ(std::isnan(shown), std::isnan(errors[i])) << i;
      EXPECT_EQ(mask->GetComponent(static_cast<vtkIdType>(i), 0), std::isnan(errors[i])   ? 0
                                                                  : std::isinf(errors[i]) ? 2
                                                                                          : 1)
          << i;
      if (!std::isfinite(errors[i])) continue;
      EXPECT_FLOAT_EQ(static_cast<float>(shown), errors[i] < 1e-17 ? -17 : static_cast<float>(std::log10(errors[i])))
          << i;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(WithAndWithoutAMesh, ParaviewState, ::testing::Bool());

}  // namespace
}  // namespace cageproof::reports
