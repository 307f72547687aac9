// SPDX-License-Identifier: MIT
// Polygons of SVG files, through libxml2. Shapes are read as they are drawn, whatever their colours: paths of straight
// edges, polygons, polylines and rectangles, moved by the transforms of all elements that they stand in, with y turned
// up. Coordinates are user units of the outermost element, whose viewBox changes none. What is hidden is left out;
// every other element that draws something, or may, is refused by name.
#include "cage/mesh_files.h"
#include "outline.h"
#include "svg_style.h"
#include "svg_text.h"

#include <fmt/format.h>
#include <libxml/parser.h>
#include <libxml/tree.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>

namespace cageproof::mesh_files {
namespace {

constexpr std::string_view kSvgNamespace = "http://www.w3.org/2000/svg";
constexpr std::array<std::string_view, 2> kContainers{"g", "a"};
// Elements that draw nothing where they stand.
constexpr std::array<std::string_view, 15> kSilent{"defs",   "title",          "desc",           "metadata", "style",
                                                   "script", "symbol",         "clipPath",       "mask",     "marker",
                                                   "filter", "linearGradient", "radialGradient", "view",     "pattern"};

// Elements that draw, but are not read, and neither are their children.
constexpr std::array<std::string_view, 6> kOtherShapes{"circle", "ellipse", "line", "image", "text", "use"};

// Properties of styles that would change what is read.
constexpr std::array<std::string_view, 7> kMoving{"transform", "-webkit-transform", "translate", "rotate",
                                                  "scale",     "offset-path",       "d"};
constexpr std::array<std::string_view, 6> kSides{"x", "y", "width", "height", "rx", "ry"};

std::string_view text_of(const xmlChar* text) { return text ? reinterpret_cast<const char*>(text) : ""; }

bool is_svg(const xmlNode& node) {
  if (!node.ns) return true;
  std::string_view name = text_of(node.ns->href);
  // libxml2 leaves entities as they are written here; Illustrator writes one.
  if (name.starts_with('&') && name.ends_with(';')) {
    const std::string entity(name.substr(1, name.size() - 2));
    const xmlEntity* found = xmlGetDocEntity(node.doc, reinterpret_cast<const xmlChar*>(entity.c_str()));
    name = found ? text_of(found->content) : "";
  }
  return name == kSvgNamespace;
}

std::optional<std::string> attribute(xmlNode& node, const char* name) {
  const std::unique_ptr<xmlChar, void (*)(void*)> value(xmlGetNoNsProp(&node, reinterpret_cast<const xmlChar*>(name)),
                                                        xmlFree);
  if (!value) return std::nullopt;
  return std::string(text_of(value.get()));
}

std::string content_of(xmlNode& node) {
  const std::unique_ptr<xmlChar, void (*)(void*)> content(xmlNodeGetContent(&node), xmlFree);
  return std::string(text_of(content.get()));
}

template <class Names>
bool is_one_of(std::string_view name, const Names& names) {
  return std::ranges::find(names, name) != names.end();
}

class SvgReader {
 public:
  SvgReader(const std::filesystem::path& path, Mesh& mesh) : path_(path), mesh_(mesh) {}

  void read(xmlNode& root) {
    if (!is_svg(root) || text_of(root.name) != "svg") fail(root, "the outermost element is not <svg>");
    add_sheets(root);
    set_sides(root);
    read_container(root, {}, true);
    if (mesh_.vertices.empty()) fail_empty();
    if (hidden_ > 0) mesh_.warnings.push_back(fmt::format("{}: left out {}", path_.string(), hidden_shapes()));
  }

 private:
  // An attribute's value, as `parse` reads it.
  template <class Parse>
  auto parsed(xmlNode& node, const char* name, const char* preset, Parse parse) {
    try {
      return parse(attribute(node, name).value_or(preset));
    } catch (const svg::Fault& fault) {
      fail(node, fmt::format("attribute {}: {}", name, fault.reason));
    }
  }

  void add_sheets(xmlNode& node) {
    if (node.type != XML_ELEMENT_NODE) return;
    if (text_of(node.name) == "style" && is_svg(node)) {
      try {
        sheets_.add(content_of(node), {kMoving.begin(), kMoving.end()});
      } catch (const svg::Fault& fault) {
        fail(node, fault.reason);
      }
    }
    for (xmlNode* child = node.children; child; child = child->next) add_sheets(*child);
  }

  std::optional<std::string> style_value(xmlNode& node, const char* property) const {
    const svg::Selected element{std::string(text_of(node.name)), attribute(node, "id").value_or(""),
                                attribute(node, "class").value_or("")};
    return sheets_.value_of(property, element, attribute(node, "style").value_or(""), attribute(node, property));
  }
  bool is_displayed(xmlNode& node) const { return style_value(node, "display") != "none"; }
  bool is_visible(xmlNode& node, bool outer) const {
    const std::string value = style_value(node, "visibility").value_or("");
    return value == "visible" || value == "initial" || (outer && value != "hidden" && value != "collapse");
  }

  // How many shapes the element is, or holds.
  static std::size_t shapes_in(xmlNode& node) {
    if (node.type != XML_ELEMENT_NODE || !is_svg(node)) return 0;
    const std::string_view name = text_of(node.name);
    if (shape_named(name) || is_one_of(name, kOtherShapes)) return 1;
    std::size_t count = 0;
    for (xmlNode* child = node.children; child; child = child->next) count += shapes_in(*child);
    return count;
  }
  void leave_out(xmlNode& node) {
    const std::size_t count = shapes_in(node);
    if (hidden_ == 0 && count > 0) first_hidden_ = fmt::format("{} in line {}", element_name(node), line_of(node));
    hidden_ += count;
  }
  std::string hidden_shapes() const {
    return fmt::format("{} shape{} that display or visibility hides (the first: {})", hidden_, hidden_ == 1 ? "" : "s",
                       first_hidden_);
  }
  [[noreturn]] void fail_empty() const {
    std::string but;
    if (hidden_ > 0) but = fmt::format("; left out: {}", hidden_shapes());
    if (defined_ > 0)
      but += fmt::format("{} {} in elements that draw nothing, as defs, symbol and clipPath",
                         but.empty() ? "; left out:" : ",", defined_);
    FileLine{path_}.fail("no path, polygon, polyline or rect in it that is drawn" + but);
  }

  // A container that is displayed.
  void read_container(xmlNode& parent, const svg::Transform& outer, bool outer_visible) {
    if (!is_displayed(parent)) return leave_out(parent);
    const svg::Transform transform = transform_of(parent, outer);
    const bool visible = is_visible(parent, outer_visible);
    for (xmlNode* node = parent.children; node; node = node->next) {
      if (node->type == XML_ENTITY_REF_NODE) fail(*node, "an entity in place of elements is not read");
      if (node->type == XML_ELEMENT_NODE && is_svg(*node)) read_element(*node, transform, visible);
    }
  }

  void read_element(xmlNode& node, const svg::Transform& outer, bool outer_visible) {
    const std::string_view name = text_of(node.name);
    if (is_one_of(name, kSilent)) {
      defined_ += shapes_in(node);
      return;
    }
    if (is_one_of(name, kContainers)) return read_container(node, outer, outer_visible);
    const auto read_shape = shape_named(name);
    // Children of other elements may be visible all the same.
    const bool is_alone = read_shape || (is_one_of(name, kOtherShapes) && name != "use" && name != "text");
    if (!is_displayed(node) || (is_alone && !is_visible(node, outer_visible))) return leave_out(node);
    if (!read_shape) fail(node, "is not read; polygons are path, polygon, polyline and rect, in svg, g and a");
    check_children(node);
    (this->*read_shape)(node, transform_of(node, outer));
  }
  // A shape may contain descriptions, but no animations.
  void check_children(xmlNode& shape) {
    for (xmlNode* node = shape.children; node; node = node->next)
      if (node->type == XML_ELEMENT_NODE && is_svg(*node) && !is_one_of(text_of(node->name), kSilent))
        fail(*node, fmt::format("is not read in a {}", text_of(shape.name)));
  }

  using Shape = void (SvgReader::*)(xmlNode&, const svg::Transform&);
  static Shape shape_named(std::string_view name) {
    if (name == "path") return &SvgReader::read_path;
    if (name == "polygon") return &SvgReader::read_polygon;
    if (name == "polyline") return &SvgReader::read_polyline;
    if (name == "rect") return &SvgReader::read_rectangle;
    return nullptr;
  }

  void read_path(xmlNode& node, const svg::Transform& transform) {
    for (const auto& subpath : parsed(node, "d", "", svg::parse_path))
      add(node, subpath.points, subpath.closed, transform);
  }
  void read_polygon(xmlNode& node, const svg::Transform& transform) {
    add(node, parsed(node, "points", "", svg::parse_points), true, transform);
  }
  void read_polyline(xmlNode& node, const svg::Transform& transform) {
    add(node, parsed(node, "points", "", svg::parse_points), false, transform);
  }
  void read_rectangle(xmlNode& node, const svg::Transform& transform) {
    const auto length = [&](const char* name, const std::optional<svg::Rational>& whole) {
      return parsed(node, name, "0", [&](const std::string& text) { return svg::parse_length(text, whole); });
    };
    for (const auto& [rounded, whole] : {std::pair{"rx", width_}, {"ry", height_}})
      if (attribute(node, rounded) != "auto" && length(rounded, whole) != 0)
        fail(node, fmt::format("its corners are round ({}): a polygon's edges are straight", rounded));
    const svg::Rational left = length("x", width_), top = length("y", height_);
    const svg::Rational right = left + length("width", width_), bottom = top + length("height", height_);
    add(node, {{left, top}, {left, bottom}, {right, bottom}, {right, top}}, true, transform);
  }

  // The lengths that percentages are parts of: the viewBox, or the size of the drawing.
  void set_sides(xmlNode& root) {
    if (attribute(root, "viewBox")) {
      const auto numbers = parsed(root, "viewBox", "", svg::parse_points);
      if (numbers.size() != 2) fail(root, "attribute viewBox: not four numbers");
      width_ = numbers[1].x;
      height_ = numbers[1].y;
      return;
    }
    for (const auto& [name, side] : {std::pair{"width", &width_}, {"height", &height_}}) try {
        if (const auto text = attribute(root, name)) *side = svg::parse_length(*text, std::nullopt);
      } catch (const svg::Fault&) {  // it is not known, which matters where a percentage is met
      }
  }

  void add(xmlNode& node, const std::vector<svg::Point>& points, bool closed, const svg::Transform& transform) {
    std::vector<OutlineVertex> outline;
    outline.reserve(points.size());
    // Exact products take their time.
    constexpr std::size_t most_bits = 400'000'000;
    moved_bits_ += points.size() * transform.bits();
    if (moved_bits_ > most_bits)
      fail(node, "so many points under so many transforms take too long; apply these in the program that wrote it");
    for (const svg::Point& p : points) {
      const svg::Point moved = transform(p);
      // SVG's y points down. A sum, so that no zero is negative.
      const Vec3<double> at(exact::rounded(moved.x) + 0.0, exact::rounded(svg::Rational(-moved.y)) + 0.0, 0);
      if (!at.allFinite()) fail(node, "a coordinate is beyond the range of double");
      outline.push_back({at, line_of(node)});
    }
    add_outline(std::move(outline), closed, mesh_);
  }

  svg::Transform transform_of(xmlNode& node, const svg::Transform& outer) {
    check_style(node);
    if (attribute(node, "transform-origin")) fail(node, "transform-origin is not read; use a rotation about a point");
    svg::Transform all = outer.after(parsed(node, "transform", "", svg::parse_transform));
    if (all.bits() > svg::Transform::kMostBits) fail(node, svg::Transform::kTooMany);
    return all;
  }
  // Shapes and transforms of a style would be lost.
  void check_style(xmlNode& node) {
    for (const svg::Declaration& d : svg::parse_declarations(attribute(node, "style").value_or("")))
      if (is_one_of(d.property, kMoving) || (text_of(node.name) == "rect" && is_one_of(d.property, kSides)))
        fail(node, fmt::format("a style with {} is not read; write it as an attribute", d.property));
  }

  static std::size_t line_of(const xmlNode& node) {
    return static_cast<std::size_t>(std::max(0L, xmlGetLineNo(&node)));
  }

  static std::string element_name(xmlNode& node) {
    const std::optional<std::string> id = node.type == XML_ELEMENT_NODE ? attribute(node, "id") : std::nullopt;
    return fmt::format("<{}{}>", text_of(node.name), id ? " id=" + shown(*id) : "");
  }
  [[noreturn]] void fail(xmlNode& node, const std::string& reason) const {
    FileLine{path_, line_of(node)}.fail(fmt::format("{}: {}", element_name(node), reason));
  }

  const std::filesystem::path& path_;
  Mesh& mesh_;
  svg::StyleSheets sheets_;
  std::optional<svg::Rational> width_, height_;
  std::size_t hidden_ = 0, defined_ = 0;  // shapes that are left out
  std::string first_hidden_;
  std::size_t moved_bits_ = 0;  // of transforms, over all points
};

// Text is put in place of each entity, so that entities within entities make gigabytes of a small file.
void check_entities(const xmlDoc& document, const FileLine& at) {
  constexpr std::size_t longest = 200;
  const xmlNode* node = document.intSubset ? document.intSubset->children : nullptr;
  for (; node; node = node->next) {
    if (node->type != XML_ENTITY_DECL) continue;
    const std::string_view content = text_of(reinterpret_cast<const xmlEntity*>(node)->content);
    if (content.size() > longest || content.find('&') != content.npos)
      at.fail(fmt::format("entity {} is longer than {} characters, or holds another one; write its text in its place",
                          shown(text_of(node->name)), longest));
  }
}

Mesh read_svg(const std::filesystem::path& path) {
  const std::string text = read_mesh_file(path);
  if (text.size() > static_cast<std::size_t>(std::numeric_limits<int>::max()))
    FileLine{path}.fail("the file is too large");
  const std::unique_ptr<xmlParserCtxt, void (*)(xmlParserCtxtPtr)> parser(xmlNewParserCtxt(), xmlFreeParserCtxt);
  const std::unique_ptr<xmlDoc, void (*)(xmlDocPtr)> document(
      xmlCtxtReadMemory(parser.get(), text.data(), static_cast<int>(text.size()), nullptr, nullptr,
                        XML_PARSE_NONET | XML_PARSE_NOERROR | XML_PARSE_NOWARNING | XML_PARSE_BIG_LINES),
      xmlFreeDoc);
  if (!document) {
    const xmlError* error = xmlCtxtGetLastError(parser.get());
    std::string_view rest = error && error->message ? error->message : "", message = "not XML";
    take_line(rest, message);
    FileLine{path, error ? static_cast<std::size_t>(std::max(0, error->line)) : 0}.fail(
        fmt::format("libxml2 cannot read it: {}", message));
  }
  Mesh mesh;
  check_entities(*document, FileLine{path});
  if (xmlNode* root = xmlDocGetRootElement(document.get())) SvgReader(path, mesh).read(*root);
  return mesh;
}

const RegisterMeshReader svg_reader{".svg", read_svg};

}  // namespace
}  // namespace cageproof::mesh_files
