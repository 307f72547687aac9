// SPDX-License-Identifier: MIT
#include "paraview_state.h"

#include "cageproof/reports/vtk_text.h"
#include "colours.h"
#include "palette.h"

#include <fmt/format.h>

#include <vtkNew.h>
#include <vtkXMLDataElement.h>

#include <sstream>

namespace cageproof::reports {
namespace {

using Element = vtkXMLDataElement;

// Gives every `<Element index="7"/>`, which has only an index, an empty value.
std::string with_empty_values(std::string text) {
  constexpr std::string_view start = "<Element index=\"", end = "\"/>", value = "\" value=\"\"/>";
  for (auto at = text.find(start); at != text.npos; at = text.find(start, at + 1)) {
    const auto quote = text.find('"', at + start.size());
    if (text.compare(quote, end.size(), end) == 0) text.replace(quote, end.size(), value);
  }
  return text;
}

Element& child(Element& parent, const char* name) {
  vtkNew<Element> element;
  element->SetName(name);
  parent.AddNestedElement(element);
  return *element;
}

std::string property_text(const std::string& value) { return value; }
std::string property_text(int value) { return fmt::format("{}", value); }
std::string property_text(double value) { return fmt::format("{}", value); }

// The numbers that proxies go by.
enum Id { kImage = 100, kCage, kMesh, kPoints, kColours, kOpacity, kLayout, kFirstView = 200 };

class Proxy {
 public:
  Proxy(Element& root, const char* group, const char* type, int id, int servers)
      : element_(child(root, "Proxy")), id_(id) {
    element_.SetAttribute("group", group);
    element_.SetAttribute("type", type);
    element_.SetIntAttribute("id", id);
    element_.SetIntAttribute("servers", servers);
  }
  template <class Value>
  Proxy& set(const char* name, const std::vector<Value>& values) {
    Element& property = begin(name, values.size());
    for (std::size_t i = 0; i < values.size(); ++i) {
      Element& element = child(property, "Element");
      element.SetIntAttribute("index", static_cast<int>(i));
      element.SetAttribute("value", property_text(values[i]).c_str());
    }
    return *this;
  }
  Proxy& set(const char* name, int value) { return set(name, std::vector{value}); }
  Proxy& set(const char* name, const std::string& value) { return set(name, std::vector{value}); }
  /// Other proxies; of a source that is its first output.
  Proxy& refer(const char* name, const std::vector<int>& ids) {
    Element& property = begin(name, ids.size());
    for (const int id : ids) child(property, "Proxy").SetIntAttribute("value", id);
    return *this;
  }
  Element& element() { return element_; }

 private:
  Element& begin(const char* name, std::size_t count) {
    Element& property = child(element_, "Property");
    property.SetAttribute("name", name);
    property.SetAttribute("id", fmt::format("{}.{}", id_, name).c_str());
    property.SetIntAttribute("number_of_elements", static_cast<int>(count));
    return property;
  }
  Element& element_;
  int id_;
};

// Which of a file's values a representation is coloured by.
const std::vector<std::string> colour_by(const std::string& array) { return {"", "", "", "0", array}; }

std::array<double, 3> centre_of(const ImageField& image, double& radius) {
  std::array<double, 3> centre{};
  double squares = 0;
  for (int c = 0; c < 3; ++c) {
    const double extent = image.spacing[c] * (image.points[c] - 1);
    centre[c] = image.origin[c] + extent / 2;
    squares += extent * extent / 4;
  }
  radius = std::sqrt(squares);
  return centre;
}

class State {
 public:
  State(const FieldScene& scene, const SceneFiles& files) : scene_(scene), files_(files) {
    root_->SetName("ParaView");
    state_ = &child(*root_, "ServerManagerState");
    state_->SetAttribute("version", "5.11.0");
  }

  std::string text() {
    sources();
    colours();
    for (std::size_t v = 0; v < scene_.compared.size(); ++v) view(static_cast<int>(v));
    layout();
    collections();
    links();
    std::ostringstream out;
    root_->PrintXML(out, vtkIndent());
    // VTK leaves empty attributes out, and ParaView ends at an element without its value.
    return with_empty_values(out.str());
  }

 private:
  struct Item {
    const char* collection;
    int id;
    std::string name;
  };

  Proxy proxy(const char* collection, const std::string& name, const char* group, const char* type, int id,
              int servers) {
    items_.push_back({collection, id, name});
    return {*state_, group, type, id, servers};
  }

  void sources() {
    proxy("sources", files_.image, "sources", "XMLImageDataReader", kImage, 1).set("FileName", files_.image);
    proxy("sources", files_.cage, "sources", "XMLPolyDataReader", kCage, 1).set("FileName", files_.cage);
    if (files_.mesh.empty()) return;
    proxy("sources", files_.mesh, "sources", "XMLPolyDataReader", kMesh, 1).set("FileName", files_.mesh);
    // Only vertices that were measured.
    proxy("sources", "measured vertices", "filters", "Threshold", kPoints, 1)
        .refer("Input", {kMesh})
        .set("SelectInputScalars", colour_by(mask_name(scene_.compared.front())))
        .set("ThresholdMethod", 0)
        .set("LowerThreshold", int{kHasValue})
        .set("UpperThreshold", int{kNotFinite});
  }

  void colours() {
    std::vector<double> points;
    for (std::size_t i = 0; i < kPalette.size(); ++i) {
      points.push_back(kSceneLow + (kSceneHigh - kSceneLow) * static_cast<double>(i) / (kPalette.size() - 1));
      for (const double c : rgb_of(kPalette[i])) points.push_back(c);
    }
    const auto colour = [](const char* text) {
      const auto rgb = rgb_of(text);
      return std::vector<double>(rgb.begin(), rgb.end());
    };
    proxy("piecewise_functions", "errors.PiecewiseFunction", "piecewise_functions", "PiecewiseFunction", kOpacity, 21)
        .set("Points", std::vector<double>{kSceneLow, 0, 0.5, 0, kSceneHigh, 1, 0.5, 0});
    proxy("lookup_tables", "errors.PVLookupTable", "lookup_tables", "PVLookupTable", kColours, 21)
        .set("AutomaticRescaleRangeMode", -1)
        .set("ColorSpace", 2)
        .set("RGBPoints", points)
        .set("ScalarRangeInitialized", 1)
        .set("UseAboveRangeColor", 1)
        .set("AboveRangeColor", colour(kInfiniteColour))
        .set("NanColor", colour(kMaskedColour))
        .refer("ScalarOpacityFunction", {kOpacity});
  }

  void view(int v) {
    const int first = kFirstView + 20 * v;
    int next = first + 1;
    const std::string& array = scene_.compared[v];
    const std::string label = short_name(array);
    std::vector<int> shown;
    const auto representation = [&](const char* type, int input) {
      shown.push_back(next);
      return proxy("representations", fmt::format("{}{}", type, next), "representations", type, next++, 21)
          .refer("Input", {input})
          .set("Visibility", 1);
    };
    const auto coloured = [&](Proxy one) {
      one.set("ColorArrayName", colour_by(log10_name(array))).refer("LookupTable", {kColours});
      return one;
    };
    // Across z, x and y, as ParaView numbers them.
    constexpr std::array<std::array<int, 2>, 3> planes{{{5, 2}, {6, 0}, {7, 1}}};
    for (const auto& [mode, axis] : planes)
      if (const bool flat = std::ranges::count(scene_.image.points, 1) > 0; !flat || scene_.image.points[axis] == 1)
        coloured(representation("UniformGridRepresentation", kImage))
            .set("Representation", std::string("Slice"))
            .set("SliceMode", mode)
            .set("Slice", scene_.image.points[axis] / 2);
    representation("GeometryRepresentation", kCage)
        .set("Representation", std::string("Wireframe"))
        .set("AmbientColor", std::vector<double>{0, 0, 0})
        .set("DiffuseColor", std::vector<double>{0, 0, 0})
        .set("LineWidth", 2);
    if (!files_.mesh.empty()) {
      representation("GeometryRepresentation", kMesh)
          .set("Representation", std::string("Surface"))
          .set("AmbientColor", std::vector<double>{0.8, 0.8, 0.8})
          .set("DiffuseColor", std::vector<double>{0.8, 0.8, 0.8});
      coloured(representation("UnstructuredGridRepresentation", kPoints))
          .set("Representation", std::string("Points"))
          .set("PointSize", 6);
    }
    const int text = next++;
    proxy("sources", label, "sources", "TextSource", text, 1).set("Text", label);
    shown.push_back(next);
    proxy("representations", fmt::format("TextSourceRepresentation{}", next), "representations",
          "TextSourceRepresentation", next++, 21)
        .refer("Input", {text})
        .set("Visibility", 1)
        .set("Color", std::vector<double>{0, 0, 0})
        .set("TextPropMode", 0)
        .set("WindowLocation", 4);
    double radius = 0;
    const auto centre = centre_of(scene_.image, radius);
    const bool flat = scene_.image.points[2] == 1;
    // Seen from the front, from the right and above; a slice across z straight on. All fits in a view half as wide as
    // high.
    const std::array<double, 3> towards = flat ? std::array{0.0, 0.0, 1.0} : std::array{0.542, 0.397, 0.741};
    std::vector<double> position;
    position.reserve(3);
    for (int c = 0; c < 3; ++c) position.push_back(centre[c] + 7 * radius * towards[c]);
    proxy("views", label, "views", "RenderView", first, 21)
        .set("UseColorPaletteForBackground", 0)
        .set("Background", std::vector<double>{1, 1, 1})
        .set("CenterOfRotation", std::vector<double>(centre.begin(), centre.end()))
        .set("CameraFocalPoint", std::vector<double>(centre.begin(), centre.end()))
        .set("CameraPosition", position)
        .set("CameraViewUp", std::vector<double>{0, 1, 0})
        .set("OrientationAxesVisibility", v == 0 ? 1 : 0)
        .refer("Representations", shown);
  }

  // A chain of splits: the first view at the left, the others in the part to its right.
  void layout() {
    Proxy layout = proxy("layouts", "side by side", "misc", "ViewLayout", kLayout, 20);
    const int views = static_cast<int>(scene_.compared.size());
    std::vector<std::array<double, 3>> nodes((std::size_t{1} << views) - 1, {0, 0.5, 0});
    std::size_t node = 0;
    for (int v = 0; v < views; ++v) {
      const double id = kFirstView + 20 * v;
      if (v + 1 == views) {
        nodes[node] = {0, 0.5, id};
        break;
      }
      nodes[node] = {2, 1.0 / (views - v), 0};
      nodes[2 * node + 1] = {0, 0.5, id};
      node = 2 * node + 2;
    }
    Element& tree = child(layout.element(), "Layout");
    tree.SetIntAttribute("number_of_elements", static_cast<int>(nodes.size()));
    for (const auto& [direction, fraction, id] : nodes) {
      Element& item = child(tree, "Item");
      item.SetIntAttribute("direction", static_cast<int>(direction));
      item.SetAttribute("fraction", property_text(fraction).c_str());
      item.SetIntAttribute("view", static_cast<int>(id));
    }
  }

  void collections() {
    for (const char* name :
         {"sources", "lookup_tables", "piecewise_functions", "representations", "views", "layouts"}) {
      Element& collection = child(*state_, "ProxyCollection");
      collection.SetAttribute("name", name);
      for (const Item& one : items_)
        if (std::string_view(one.collection) == name) {
          Element& item = child(collection, "Item");
          item.SetIntAttribute("id", one.id);
          item.SetAttribute("name", one.name.c_str());
        }
    }
  }

  void links() {
    Element& links = child(*state_, "Links");
    for (int v = 1; v < static_cast<int>(scene_.compared.size()); ++v) {
      Element& link = child(links, "CameraLink");
      link.SetAttribute("name", fmt::format("camera {}", v).c_str());
      const int ends[] = {kFirstView, kFirstView + 20 * v};
      for (const auto& [from, to] : {std::pair(ends[0], ends[1]), std::pair(ends[1], ends[0])})
        for (const auto& [direction, id] : {std::pair("input", from), std::pair("output", to)}) {
          Element& end = child(link, "Proxy");
          end.SetAttribute("direction", direction);
          end.SetIntAttribute("id", id);
        }
    }
  }

  const FieldScene& scene_;
  const SceneFiles& files_;
  vtkNew<Element> root_;
  Element* state_;
  std::vector<Item> items_;
};

}  // namespace

std::string paraview_state(const FieldScene& scene, const SceneFiles& files) { return State(scene, files).text(); }

}  // namespace cageproof::reports
