// SPDX-License-Identifier: MIT
#include "deformed_figure.h"

#include "figure_measures.h"
#include "plane_notes.h"

#include "cageproof/core/cage/enclosed.h"
#include "cageproof/core/input_error.h"
#include "cageproof/core/catalogue/named_parameters.h"
#include "cageproof/deformation/point_images.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

namespace cageproof::validation {
namespace {

using deformation::Posed;

// From there on a coordinate is shown as negative: more than the picture's rounding, and than what harmonic coordinates
// err by.
constexpr double negative_from = 0.01;

// A map of a panel, and the owner of its coordinates.
struct PanelMap {
  std::shared_ptr<const void> owner;
  const CageCoordinates* coordinates = nullptr;
  std::unique_ptr<const Posed<double>> posed;
};

std::vector<double> values_in(const PanelPlan& panel, const std::vector<KindParameter>& known) {
  return parameter_values(parameter_texts(panel.parameters), known, {panel.method});
}

class DeformedFigure final : public PaperFigure {
 public:
  explicit DeformedFigure(DeformedPlan plan) : plan_(std::move(plan)) {
    for (const SheetPlan& sheet : plan_.sheets)
      for (const PanelPlan& panel : sheet.panels)
        if (!panel.method.empty()) {
          if (!panel.compared_with.empty() && beside(sheet, panel) == nullptr)
            throw std::invalid_argument("no panel " + panel.compared_with);
          group_of(panel).push_back({&sheet, &panel});
        }
  }

  std::string name() const override { return plan_.name; }
  int parts() const override { return static_cast<int>(groups_.size()); }

  FigureFindings part(int part, int jobs) const override {
    const auto& shown = groups_[part].shown;
    std::vector<PanelMap> maps;
    maps.reserve(shown.size());
    Prepared prepared;
    for (const Shown& one : shown) maps.push_back(map_of(*one.panel, prepared));
    const auto& points = plan_.mesh.mesh.vertices;
    std::vector<const Posed<double>*> posed;
    posed.reserve(maps.size());
    for (const PanelMap& map : maps) posed.push_back(map.posed.get());
    const CageCoordinates& coordinates = *maps.front().coordinates;
    const auto images = deformation::images_of(coordinates, points, posed, {.jobs = jobs, .block = 64}, std::nullopt);
    const std::vector<Vec3<double>> places = angle_points(plan_);
    const auto derivatives =
        places.empty() ? deformation::PointImages{}
                       : deformation::images_of(coordinates, places, posed, {.order = 1, .jobs = jobs}, std::nullopt);
    FigureFindings found;
    for (std::size_t k = 0; k < shown.size(); ++k) {
      std::vector<Vec3<double>> vertices = deformation::vertices_of(images.maps[k], coordinates.dimension());
      for (const Vec3<double>& image : vertices)
        if (!image.allFinite())
          throw InputError(fmt::format("{}, {}: an image is not finite", plan_.name, shown[k].panel->title));
      const std::string key = key_of(*shown[k].sheet, *shown[k].panel);
      found[key].vertices = std::move(vertices);
      if (shown[k].panel->posed.empty()) {
        // A map without a posed cage is shown in its cage at rest; in the plane without a cage.
        std::vector<Vec3<double>> cage = maps[k].posed->vertices();
        if (cage.empty() && plan_.cage->dimension() == 3) cage = cage_of(*shown[k].panel).vertices();
        found[key + cage_suffix].vertices = std::move(cage);
      }
      if (!places.empty()) found[key + derivatives_suffix].vertices = columns_of(derivatives.maps[k]);
    }
    for (auto& [key, mesh] : found) mesh.name = key;
    return found;
  }

  bool is_in(const FigureFindings& found) const override {
    return std::ranges::all_of(groups_, [&](const Group& group) {
      return std::ranges::all_of(group.shown, [&](const Shown& one) {
        const std::string key = key_of(*one.sheet, *one.panel);
        const bool has_cage = !one.panel->posed.empty() ||
                              has(found, key + cage_suffix, cage_of(*one.panel).vertices().size()) ||
                              (plan_.cage->dimension() == 2 && has(found, key + cage_suffix, 0));
        const std::size_t places = angle_points(plan_).size();
        return has(found, key, plan_.mesh.mesh.vertices.size()) && has_cage &&
               (places == 0 || has(found, key + derivatives_suffix, 2 * places));
      });
    });
  }

  std::vector<reports::FigureSheet> sheets(const FigureFindings& found) const override {
    std::vector<reports::FigureSheet> all;
    all.reserve(plan_.sheets.size());
    for (const SheetPlan& plan : plan_.sheets) {
      reports::FigureSheet sheet{.name = plan.name,
                                 .heading = plan.heading,
                                 .source = plan.source,
                                 .text = plan.text,
                                 .columns = plan.columns,
                                 .view = plan.view,
                                 .panels = {}};
      for (const PanelPlan& panel : plan.panels) sheet.panels.push_back(drawn(plan, panel, found));
      all.push_back(std::move(sheet));
    }
    return all;
  }

 private:
  static constexpr const char* cage_suffix = ".cage";
  static constexpr const char* derivatives_suffix = ".derivatives";
  struct Shown {
    const SheetPlan* sheet;
    const PanelPlan* panel;
  };
  struct Group {
    std::string key;
    std::vector<Shown> shown;
  };

  static bool has(const FigureFindings& found, const std::string& key, std::size_t vertices) {
    const auto at = found.find(key);
    return at != found.end() && at->second.vertices.size() == vertices;
  }

  static std::string key_of(const SheetPlan& sheet, const PanelPlan& panel) {
    return fmt::format("figure/{}/{}", sheet.name, panel.file);
  }

  // The panel that one is compared with, or null.
  static const PanelPlan* beside(const SheetPlan& sheet, const PanelPlan& panel) {
    const auto other = std::ranges::find(sheet.panels, panel.compared_with, &PanelPlan::file);
    return other != sheet.panels.end() && !other->method.empty() ? &*other : nullptr;
  }

  // Two columns of the Jacobian a point: derivatives by x and by y.
  static std::vector<Vec3<double>> columns_of(const deformation::Images<double>& images) {
    const std::vector<double>& jacobians = images.tensors[1];
    std::vector<Vec3<double>> columns;
    for (std::size_t at = 0; at + 4 <= jacobians.size(); at += 4)
      for (std::size_t axis = 0; axis < 2; ++axis)
        columns.emplace_back(jacobians[at + axis], jacobians[at + 2 + axis], 0);
    return columns;
  }

  const Cage& cage_of(const PanelPlan& panel) const { return panel.cage ? *panel.cage : *plan_.cage; }

  // Panels of one cage and kind of coordinates with the same parameters.
  std::vector<Shown>& group_of(const PanelPlan& panel) {
    std::string key;
    if (const auto* constrained = deformation::find_constraint_method(panel.method)) {
      values_in(panel, constrained->parameters);
      key = fmt::format("{} {}", panel.method, groups_.size());
    } else {
      const auto& method = deformation::deform_method_named(panel.method);
      const auto known = parameters_of(method);
      const auto values = values_in(panel, known);
      key = fmt::format("{} {} {}", cage_of(panel).name(), method.kind, panel.evaluation);
      const auto of_kind = parameters_of(coordinate_kind_named(method.kind));
      for (std::size_t i = 0; i < known.size(); ++i)
        if (decides_coordinates(method, known[i].name) ||
            std::ranges::find(of_kind, known[i].name, &KindParameter::name) != of_kind.end())
          key += fmt::format(" {}={}", known[i].name, values[i]);
    }
    const auto found = std::ranges::find(groups_, key, &Group::key);
    return found != groups_.end() ? found->shown : groups_.emplace_back(key, std::vector<Shown>()).shown;
  }

  // Prepared once for all poses of a method with the same parameters.
  using Prepared = std::map<std::string, std::shared_ptr<const deformation::Deformer<double>>>;
  PanelMap map_of(const PanelPlan& panel, Prepared& prepared) const {
    if (const auto* constrained = deformation::find_constraint_method(panel.method)) {
      const auto deformer = deformation::prepare_constrained(
          *constrained, cage_of(panel), panel.constraints,
          {.evaluation = panel.evaluation, .parameters = values_in(panel, constrained->parameters)});
      auto map = deformer->pose();
      if (const std::string& why = map->report().unsolved; !why.empty()) throw InputError(why);
      return {deformer, &deformer->coordinates(), std::move(map)};
    }
    auto& deformer = prepared[fmt::format("{} {} {}", cage_of(panel).name(), panel.method, parameters_text(panel))];
    if (!deformer) {
      const auto& method = deformation::deform_method_named(panel.method);
      deformer = deformation::prepare_deformer<double>(
          method, cage_of(panel),
          {.evaluation = panel.evaluation, .parameters = values_in(panel, parameters_of(method))});
    }
    return {deformer, &deformer->coordinates(), deformer->pose({panel.posed, panel.normal_derivatives})};
  }

  static std::string parameters_text(const PanelPlan& panel) {
    return fmt::format("{}", fmt::join(parameter_texts(panel.parameters), " "));
  }

  reports::FigurePanel drawn(const SheetPlan& sheet, const PanelPlan& plan, const FigureFindings& found) const {
    const Mesh& rest = plan_.mesh.mesh;
    const bool flat = plan_.cage->dimension() == 2;
    reports::FigurePanel panel;
    panel.title = plan.title;
    panel.file = plan.file;
    panel.flat = flat;
    panel.tones = plan_.mesh.tones;
    panel.cage = plan.posed.empty() ? cage_of(plan).vertices() : plan.posed;
    panel.data.vertices = rest.vertices;
    panel.data.faces = rest.faces;
    panel.data.segments = rest.segments;
    panel.data.name = plan.file;
    for (const Face& face : cage_of(plan).parts(!plan.shows_diagonals, Triangulation::Shortest).elements)
      panel.cage_faces.emplace_back(face.vertices.begin(), face.vertices.begin() + face.size());
    panel.facts = {{"cage", cage_of(plan).name()}};
    if (plan.method.empty()) {
      for (const auto& position : plan.constraints.positions) panel.marks.push_back(position.at);
      return panel;
    }
    const std::string key = key_of(sheet, plan);
    panel.data.vertices = found.at(key).vertices;
    if (plan.posed.empty()) panel.cage = found.at(key + cage_suffix).vertices;
    if (panel.cage.empty()) panel.cage_faces.clear();
    for (const auto& position : plan.constraints.positions) panel.marks.push_back(position.to);
    panel.facts.insert(panel.facts.begin(), {{"method", plan.method}, {"parameters", parameters_text(plan)}});
    if (!plan.evaluation.empty()) panel.facts.emplace_back("evaluation", plan.evaluation);
    measure(panel, rest);
    const std::vector<Vec3<double>>* const other =
        plan.compared_with.empty() ? nullptr : &found.at(key_of(sheet, *beside(sheet, plan))).vertices;
    if (!flat) {
      measure_more(panel, plan, other);
      return panel;
    }
    PlaneFindings plane;
    if (!plan_.angles.empty()) plane.derivatives = &found.at(key + derivatives_suffix).vertices;
    plane.compared = other;
    add_plane_measures(plan_, plan, plane, panel);
    return panel;
  }

  void measure(reports::FigurePanel& panel, const Mesh& rest) const {
    const bool flat = panel.flat;
    const double size = plan_.cage->size();
    // Segments are drawn, and hold nothing.
    const std::vector<std::array<int, 2>> none;
    const Connectivity connectivity{rest.faces, none, plan_.cage->dimension()};
    const ContentUnit unit{.simplices = flat ? 2 : 6};
    double largest = 0, sum = 0;
    std::vector<double> displacement;
    for (std::size_t p = 0; p < rest.vertices.size(); ++p) {
      const Vec3<double> step = panel.data.vertices[p] - rest.vertices[p];
      largest = std::max(largest, step.norm());
      sum += step.norm();
      displacement.insert(displacement.end(), step.begin(), step.end());
    }
    panel.data.arrays.push_back({"displacement", "unit of the cage", 3, std::move(displacement)});
    const double ratio =
        content_of(connectivity, panel.data.vertices, unit).value / content_of(connectivity, rest.vertices, unit).value;
    // An open mesh has no volume.
    const bool has_content = flat || is_closed(connectivity);
    const std::string content = has_content ? fmt::format("{} × {:.3f}, ", flat ? "area" : "volume", ratio) : "";
    if (has_content) panel.measured.emplace_back(flat ? "area ratio" : "volume ratio", ratio);
    panel.measured.emplace_back("largest displacement over cage size", largest / size);
    panel.measured.emplace_back("mean displacement over cage size",
                                sum / (size * static_cast<double>(rest.vertices.size())));
    panel.note = fmt::format("{}moved up to {:.3f}", content, largest / size);
    if (!plan_.is_symmetric) return;
    const double off = asymmetry(rest.vertices, panel.data.vertices) / size;
    panel.measured.emplace_back("asymmetry over cage size", off);
    panel.note = fmt::format("{}asymmetry {:.1e}", content, off);
  }

  // Measures that plans ask for; the note states them in place of the displacement.
  void measure_more(reports::FigurePanel& panel, const PanelPlan& plan, const std::vector<Vec3<double>>* other) const {
    const Mesh& rest = plan_.mesh.mesh;
    std::vector<std::string> notes;
    const auto add = [&](const char* name, double value, std::string note) {
      panel.measured.emplace_back(name, value);
      notes.push_back(std::move(note));
    };
    if (other != nullptr) {
      const double off = largest_distance(panel.data.vertices, *other) / plan_.cage->size();
      panel.facts.emplace_back("compared with", plan.compared_with);
      add("largest distance over cage size", off, fmt::format("off by {:.1e}", off));
    }
    if (plan_.measures_turns) {
      const double turn = added_turn(rest.faces, rest.vertices, panel.data.vertices);
      add("sharpest turn that is added in degrees", turn, fmt::format("turns by {:.0f}°", turn));
    }
    if (plan.step) {
      const std::vector<double> shares = shares_of_step(rest.vertices, panel.data.vertices, *plan.step);
      const double least = *std::ranges::min_element(shares);
      add("least coordinate of moved vertices", least, fmt::format("least coordinate {:.1e}", least));
      for (std::size_t f = 0; f < rest.faces.size(); ++f)
        panel.tones[f] =
            static_cast<char>(std::ranges::any_of(rest.faces[f], [&](int v) { return shares[v] < -negative_from; }));
      panel.data.arrays.push_back({"moved_vertices", "", 1, shares});
    }
    if (!notes.empty()) panel.note = fmt::format("{}", fmt::join(notes, ", "));
  }

  DeformedPlan plan_;
  std::vector<Group> groups_;
};

}  // namespace

std::unique_ptr<const PaperFigure> deformed_figure(DeformedPlan plan) {
  return std::make_unique<DeformedFigure>(std::move(plan));
}

}  // namespace cageproof::validation
