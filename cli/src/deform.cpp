// SPDX-License-Identifier: MIT
#include "commands.h"
#include "deform_files.h"
#include "deformation_report.h"
#include "image_columns.h"
#include "local_thickness.h"
#include "on_cage.h"
#include "pose_files.h"
#include "progress.h"
#include "solved_file.h"

#include "cageproof/core/coordinates/whole_evaluation.h"
#include "cageproof/core/input_error.h"
#include "cageproof/core/catalogue/unknown_name.h"
#include "cageproof/deformation/nearest_element.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <set>

namespace cageproof::cli {

using namespace deformation;
namespace {

using Json = nlohmann::ordered_json;

// A method as the user has chosen it.
struct Chosen {
  std::string_view name;
  const ConstraintMethod* constrained;  ///< null for methods that take posed cages
  std::vector<KindParameter> known;
  std::vector<std::vector<double>> parameters;  ///< a set a map of each pose
  std::vector<std::string_view> varied;         ///< that these differ in
};

// The named method, which takes posed cages.
const DeformMethod& method_of(const DeformArguments& a) {
  const DeformMethod& named = deform_method_named(a.method);
  return a.keep_quads ? keeping_quads(named) : named;
}

Chosen chosen_by(const DeformArguments& a) {
  Chosen chosen{a.method, find_constraint_method(a.method), {}, {}, {}};
  if (a.keep_quads && chosen.constrained)
    throw InputError(fmt::format("--keep-quads: {} has no form on bilinear quads", a.method));
  if (!chosen.constrained) chosen.name = method_of(a).name;
  chosen.known = chosen.constrained ? chosen.constrained->parameters : parameters_of(method_of(a));
  if (chosen.constrained) chosen.parameters = {parameters_from(a.parameters, chosen.known, a.method)};
  else chosen.parameters = parameter_sets_from(a.parameters, chosen.known, a.method);
  for (std::size_t i = 0; i < chosen.known.size(); ++i)
    if (std::ranges::any_of(chosen.parameters, [&](const auto& set) { return set[i] != chosen.parameters[0][i]; }))
      chosen.varied.push_back(chosen.known[i].name);
  for (const std::string_view name : chosen.varied)
    if (decides_coordinates(method_of(a), name))
      throw InputError(
          fmt::format("--parameter {}: decides the coordinates of {}, and takes one value", name, a.method));
  if (chosen.constrained ? a.constraints.empty() : a.posed.empty())
    throw InputError(fmt::format("{} takes {}", a.method, chosen.constrained ? "--constraints" : "--posed"));
  if (const auto given = given_data(a); chosen.constrained && !given.empty())
    throw InputError(fmt::format("--{}: {} takes none", given[0].first, a.method));
  if (!a.solved.empty() && !holds_matrices(a.solved)) throw InputError(fmt::format("--solved {}: use .npz", a.solved));
  if (!a.energies.empty() && !chosen.constrained)
    throw InputError(fmt::format("--energies: {} has no steps", a.method));
  check_stress(a.stress, a.method, chosen.known);
  return chosen;
}

void require_order(const DeformArguments& a, int highest) {
  if (a.computed_order() <= highest) return;
  throw InputError(fmt::format("{}: {}{}{} has derivatives only up to order {}",
                               a.order > highest ? fmt::format("--order {}", a.order) : "--stress", a.method,
                               a.evaluation.empty() ? "" : " by ", a.evaluation, highest));
}

Posing posing_by(const DeformArguments& a, const Chosen& chosen, const Cage& cage,
                 const std::optional<Merging>& merging) {
  DeformOptions options{a.evaluation.empty() ? std::string(quickest) : a.evaluation, a.cage.rule(),
                        chosen.parameters.front(), chosen.varied};
  if (!chosen.constrained)
    return posed_by_cages(method_of(a), cage, std::move(options), chosen.parameters,
                          {a.posed, merging, a.cage.merge, a.strict}, a.data);
  return posed_by_constraints(*chosen.constrained, cage, options, a.constraints, [](int step, double energy) {
    remark(fmt::format("step {}: energy {:.6g}", step, energy));
  });
}

Json value_json(const KindParameter& p, double value) {
  if (!p.names.empty()) return p.names[static_cast<std::size_t>(value)];
  if (p.whole) return static_cast<long long>(value);
  if (!std::isfinite(value)) return fmt::format("{}", value);
  return value;
}

Json report_of(const DeformArguments& a, const Chosen& chosen, const CageCoordinates& coordinates,
               const DescribedMap& map) {
  Json json = {{"schema", deformation_schema}, {"schema_version", 1}};
  json["method"] = chosen.name;
  json["parameters"] = Json::object();
  for (std::size_t i = 0; i < chosen.known.size(); ++i)
    json["parameters"][std::string(chosen.known[i].name)] = value_json(chosen.known[i], map.parameters[i]);
  json["evaluation"] = coordinates.evaluation();
  json["cage"] = a.cage.file;
  json["triangulation"] = coordinates.kind().keeps_quads ? "none" : a.cage.triangulate;
  if (!std::isnan(a.cage.merge)) json["merge"] = a.cage.merge;
  if (a.on > 0) json["on"] = a.on;
  if (a.outside != "error") json["outside"] = a.outside;
  json[chosen.constrained ? "constraints" : "posed_cage"] = map.file;
  for (auto [option, file] : given_data(a)) {
    std::ranges::replace(option, '-', '_');
    json[option] = file;
  }
  // Elements with their vertices say to what the rows of these files belong.
  if (!given_data(a).empty()) {
    const CageElements& elements = coordinates.elements();
    for (std::size_t e = 0; e < elements.count(); ++e) {
      const auto vertices = elements.vertices_of(e);
      json["elements"].push_back(std::vector<int>(vertices.begin(), vertices.end()));
    }
  }
  return json;
}

// Says how points without image can be handled. \param point the first of them
std::string advice_for(const CageCoordinates& coordinates, const Cage& cage, const Vec3<double>& point) {
  std::string advice = "--outside rest leaves them where they are, --outside nan writes nan";
  if (coordinates.kind().extends) advice += ", --outside extend continues the map through the nearest face";
  const double share = NearestElements(coordinates.elements()).of(point).distance / cage.size();
  // Roundings of doubles and floats.
  if (region_of(coordinates) && share > 0 && share < 1e-6)
    advice +=
        fmt::format("; it is {:.2g} of the cage's size away, and --on {:.0e} takes such points for points on the cage",
                    share, std::max(1e-12, std::pow(10., std::ceil(std::log10(share)))));
  return advice;
}

std::vector<std::string_view> methods_that_extend() {
  std::vector<std::string_view> names;
  for (const DeformMethod& method : deform_methods())
    if (const CoordinateKind* kind = find_coordinate_kind(method.kind); kind != nullptr && kind->extends)
      names.push_back(method.name);
  return names;
}

// \throws InputError where --digits excludes another option
void require_digits_served(const DeformArguments& a, const Chosen& chosen) {
  if (a.digits == 0) return;
  if (chosen.name != "green")
    throw InputError(
        fmt::format("--digits: {} always computes all digits; leave --digits out, or take green", chosen.name));
  if (a.order > 0) throw InputError("--digits: derivatives have all digits only; --order 0 leaves them out");
  if (a.stress.asked()) throw InputError("--digits: --stress takes derivatives, which have all digits only");
  if (a.outside == "extend") throw InputError("--digits: --outside extend has all digits only");
  if (!a.evaluation.empty() && a.evaluation != "batched")
    throw InputError(fmt::format("--digits: --evaluation {} sums face by face; batched does not", a.evaluation));
}

Json digits_json(int digits, const DigitsReport& report) {
  return {{"asked", digits},
          {"degree", report.degree},
          {"points_by_faces", report.by_faces},
          {"largest_error_over_posed_size", report.error}};
}

void tell_digits(const std::vector<DigitsReport>& reports, std::size_t points) {
  for (std::size_t k = 0; k < reports.size(); ++k) {
    const std::string map = reports.size() > 1 ? fmt::format("map {}: ", k + 1) : "";
    const DigitsReport& r = reports[k];
    if (r.degree == 0) {
      remark(fmt::format("{}summed face by face, which is quicker here or the only way", map));
      continue;
    }
    remark(
        fmt::format("{}far faces are summed together, by harmonics up to degree {}: images are off by at most "
                    "{:.1e} of the posed cage's size; {} of {} points are summed face by face",
                    map, r.degree, r.error, r.by_faces, points));
  }
}

void tell_continued(const PointImages& images, double size) {
  const auto count = std::ranges::count_if(images.beyond, [](double way) { return way > 0; });
  if (count > 0)
    remark(fmt::format(
        "{} of {} points are outside, by at most {:.3g} of the cage's size, and continued through the nearest face",
        count, images.beyond.size(), std::ranges::max(images.beyond) / size));
}

// Images that can be written, by --outside. \throws InputError for the first point that has none
PointImages images_by(const DeformArguments& a, const Posing& posing, const Cage& cage, const Mesh& mesh,
                      std::vector<DigitsReport>& digits) {
  std::vector<const Posed<double>*> maps;
  maps.reserve(posing.maps.size());
  for (const DescribedMap& map : posing.maps) maps.push_back(map.map.get());
  const CageCoordinates& coordinates = *posing.coordinates;
  const bool extend = a.outside == "extend";
  if (extend && !coordinates.kind().extends)
    throw InputError(fmt::format("--outside extend: {} does not continue through faces; there is {}", a.method,
                                 fmt::join(methods_that_extend(), ", ")));
  ImageRun run{a.computed_order(), a.jobs};
  run.extend = extend;
  PointImages images = a.digits > 0 ? images_to_digits(coordinates, mesh.vertices, maps, a.digits, a.jobs,
                                                       region_of(coordinates), digits)
                                    : images_of(coordinates, mesh.vertices, maps, run, region_of(coordinates));
  if (const auto place = first_not_finite(images))
    throw InputError(fmt::format(
        "{}the image of point number {} is not finite: the pose or a parameter is beyond what the method can "
        "take",
        maps.size() > 1 ? fmt::format("map {}: ", place->map + 1) : "", place->point));
  const auto missing = std::ranges::count(images.missing, 1);
  const auto first = static_cast<std::size_t>(std::ranges::find(images.missing, 1) - images.missing.begin());
  if (missing > 0 && a.outside == "error")
    throw InputError(fmt::format(
        "{} of {} points, the first of them number {}, are outside {} or have no coordinates "
        "there; {}",
        missing, mesh.vertices.size(), first, cage.name(), advice_for(coordinates, cage, mesh.vertices[first])));
  tell_continued(images, cage.size());
  tell_digits(digits, mesh.vertices.size());
  fill_missing(images, mesh.vertices, cage.dimension(), a.outside == "rest" ? Missing::Rest : Missing::Nan);
  return images;
}

// How many pieces edges are solved in.
int pieces_of(const Chosen& chosen, const DescribedMap& map) {
  const auto found = std::ranges::find(chosen.known, "pieces", &KindParameter::name);
  return found == chosen.known.end() ? 1 : static_cast<int>(map.parameters[found - chosen.known.begin()]);
}

// The data that maps multiply layers with, for --solved. \throws InputError for methods whose maps are no such sums
std::string densities_text(const DeformArguments& a, const Posing& posing) {
  std::vector<std::vector<NamedMatrix>> maps;
  maps.reserve(posing.maps.size());
  for (const DescribedMap& map : posing.maps) maps.push_back(layer_data(*posing.coordinates, *map.map));
  if (maps.front().empty())
    throw InputError(
        fmt::format("--solved {}: images of {} are no sums of biharmonic layers; those of methods named "
                    "biharmonic_..., ahap, aaap, "
                    "tp and variational are",
                    a.solved, a.method));
  return matrices_text(maps);
}

// Each once, and of which it is said: of a map where there are several sets of parameters, else of a pose, or of the
// method, which is the same for all poses.
void print_warnings(const Json& warnings, const Chosen& chosen, const DescribedMap& map, std::string_view out,
                    bool is_only, std::set<std::string>& said) {
  for (const Json& warning : warnings) {
    const auto text = warning.get<std::string>();
    const bool of_method = std::ranges::find(map.prepared.warnings, text) != map.prepared.warnings.end();
    const bool of_one_pose = !is_only && !of_method;
    const std::string_view owner = chosen.parameters.size() > 1 ? out : of_one_pose ? std::string_view(map.file) : "";
    const std::string line = fmt::format("warning: {}{}{}\n", owner, owner.empty() ? "" : ": ", text);
    if (said.insert(line).second) fmt::print(stderr, "{}", line);
  }
}

int run(DeformArguments& a) {
  split_collection(a);
  const Chosen chosen = chosen_by(a);
  require_digits_served(a, chosen);
  check_names(a, chosen.constrained ? 1 : a.posed.size() * chosen.parameters.size());
  const auto [cage, merging] = a.cage.load_merged();
  Mesh mesh = load_points(a.points, cage.dimension());
  check_shapes(a, mesh, cage.dimension());
  const std::vector<Vec3<double>> normals = unit_normals(a.stress, mesh.vertices.size(), cage.dimension());
  // Solving takes long, so the order is checked before.
  const std::string_view kind = chosen.constrained ? chosen.constrained->kind : method_of(a).kind;
  if (!kind.empty()) require_order(a, highest_order(coordinate_kind_named(kind), cage, a.evaluation));
  const Posing posing = posing_by(a, chosen, cage, merging);
  const CageCoordinates& coordinates = *posing.coordinates;
  require_order(a, posing.max_order);
  take_onto_cage(a.on, coordinates, cage.size(), mesh.vertices, a.jobs);
  const std::string densities = a.solved.empty() ? "" : densities_text(a, posing);
  std::vector<DigitsReport> digits;
  const PointImages images = images_by(a, posing, cage, mesh, digits);
  // Everything is made before anything is written.
  PoseFiles files(a);
  std::set<std::string> said;
  Mesh deformed = mesh;
  for (std::size_t k = 0; k < posing.maps.size(); ++k) {
    const DescribedMap& map = posing.maps[k];
    deformed.vertices = vertices_of(images.maps[k], cage.dimension());
    Json json = report_of(a, chosen, coordinates, map);
    const DeformationReport& pose = map.map->report();
    const MeshMeasures measures =
        measures_of(coordinates.elements(), cage.size(), map.vertices, mesh, images, k, a.computed_order());
    json.update(deformation_json(measures, mesh.vertices.size(), cage.size(),
                                 chosen.constrained ? map.vertices : std::vector<Vec3<double>>(), cage.dimension(),
                                 map.prepared, pose));
    if (cage.dimension() == 2 && a.order > 0 && !map.vertices.empty())
      json["local_thickness"] = local_thickness(coordinates, *map.map, map.vertices, pieces_of(chosen, map));
    if (!images.beyond.empty())
      json["points_continued"] = {{"count", std::ranges::count_if(images.beyond, [](double way) { return way > 0; })},
                                  {"farthest_over_cage_size", std::ranges::max(images.beyond) / cage.size()}};
    if (!digits.empty()) json["digits"] = digits_json(a.digits, digits[k]);
    CoordinateColumns stress;
    if (a.stress.asked()) {
      const Material material = material_of(a.stress, chosen.known, map.parameters);
      stress = stress_columns(images.maps[k], cage.dimension(), material, normals);
      json["stress"] = stress_json(stress, material);
    }
    print_warnings(json["warnings"], chosen, map, files.name_of(k + 1), posing.maps.size() == 1, said);
    files.add(map.file, deformed, image_columns(images.maps[k], cage.dimension(), a.order), json);
    if (a.stress.asked()) files.add_table(a.stress.file, deformed, stress);
    if (!a.energies.empty())
      files.add(a.energies, energies_text(a, fmt::format("{}, {}", a.method, cage.name()), pose.energies));
  }
  if (!a.solved.empty()) files.add(a.solved, densities);
  files.write();
  return success;
}

std::string names_of_methods() {
  std::vector<std::string_view> names;
  for (const DeformMethod& method : deform_methods()) names.push_back(method.name);
  for (const ConstraintMethod& method : constraint_methods()) names.push_back(method.name);
  return fmt::format("{}", fmt::join(names, ", "));
}

}  // namespace

void add_deform(CommandLine& line) {
  Command command = line.command("deform", "deform a mesh by a posed cage, or by constraints");
  auto a = std::make_shared<DeformArguments>();
  Command pose = command.exactly_one_of("The pose");
  pose.option("--posed", a->posed,
              "the posed cage: a mesh, text, or an embedded cage with the cage's vertices in the same order; may be "
              "repeated")
      .taking("CAGE");
  pose.option("--constraints", a->constraints, "JSON with points and their targets, for methods without a posed cage")
      .taking("FILE");
  command.heading("Cage and points");
  a->cage.add_to(command, true);
  command
      .option("--points", a->points,
              "a mesh, .npy, .npz, or text with three numbers per line, for polygons two; - is standard input" +
                  std::string(y_of_points))
      .taking("FILE")
      .required();
  command
      .option("--outside", a->outside,
              "what becomes of points without image: an error; rest: they stay; nan; extend: they follow the nearest "
              "face (green only)")
      .one_of({"error", "rest", "nan", "extend"})
      .showing_default();
  add_on(command, a->on);
  command.flag("--strict", a->strict, "refuse a posed cage whose faces are not the cage's, instead of a warning");
  command.heading("Method");
  command.option("--method", a->method, names_of_methods()).taking("METHOD").required();
  command.flag("--keep-quads", a->keep_quads,
               "keep quads as bilinear surfaces: --method green becomes quad_green, and likewise mean_value, "
               "biharmonic_1_3 and somigliana");
  command
      .option("--parameter", a->parameters,
              "a parameter of the method; several values, NAME=VALUE,VALUE, make as many maps; `list` names all")
      .taking("NAME=VALUE");
  command
      .option("--evaluation", a->evaluation,
              "batched, or an evaluation of the coordinates' formulas; if not given, batched where it exists, "
              "otherwise the recommended one")
      .taking("EVALUATION");
  command
      .option("--digits", a->digits,
              "digits of images, relative to the posed cage's size, for green: far faces are summed together where "
              "that is quicker, and the error's bound is stated; if not given, all digits")
      .in_range(3, 12)
      .taking("N");
  command
      .option("--normal-derivatives", a->data.normal_derivatives,
              "normal derivatives in place of posed normals: text with three numbers per line, for polygons two; one "
              "line per triangle or segment, with neumann=affine and on kept quads one per corner")
      .taking("FILE");
  command
      .option("--laplacians", a->data.laplacians,
              "Laplacians for biharmonic_direct: text with one line of numbers per vertex")
      .taking("FILE");
  command
      .option("--laplacian-derivatives", a->data.laplacian_derivatives,
              "normal derivatives of the Laplacian for biharmonic_direct: text with one line of numbers per triangle "
              "or segment")
      .taking("FILE");
  command.heading("Output");
  command
      .option(
          "--out", a->out,
          ".obj, .ply, .stl, .svg, .vtp, .csv or .npy, with {n} or {n:03d} for the number of the map; or all maps "
          "in one, .pc2 or .mdd with a frame each, or NAME.pvd, which names NAME_001.vtp and so on for ParaView; one "
          ".json beside it, for all maps, says what was done")
      .taking("FILE")
      .required();
  command.option("--frame-rate", a->frame_rate, "frames per second of an .mdd file")
      .in_range(1e-3, 1e6)
      .showing_default(fmt::format("{}", usual_rate));
  command.option("--order", a->order, "0: images only; 1: also Jacobians; 2: also Hessians")
      .in_range(0, 2)
      .showing_default();
  command.option("--derivatives", a->derivatives, "file for derivatives, .csv, .npy or .vtp, if --out is a mesh")
      .taking("FILE");
  add_stress(command, a->stress);
  command.option("--energies", a->energies, ".csv or .png: the energy at every half step, for methods that iterate")
      .taking("FILE");
  command
      .option("--solved", a->solved,
              "an .npz of the densities of biharmonic methods, the factors of the four layers: V, N, L, D (maps x rows "
              "x dimension)")
      .taking("FILE");
  command.heading("Running");
  command.option("--jobs", a->jobs, "threads; 0: one per core").in_range(0, 1024).showing_default();
  add_quiet(command);
  command.example("cageproof deform --cage cube --posed posed.obj --points mesh.obj --method green --out deformed.obj");
  command.runs([a] { return run(*a); });
}

}  // namespace cageproof::cli
