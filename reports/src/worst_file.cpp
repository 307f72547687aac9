// SPDX-License-Identifier: MIT
#include "cageproof/reports/worst_file.h"

#include "cageproof/core/cage/cage.h"
#include "cageproof/core/catalogue/formula.h"
#include "cageproof/core/input_error.h"
#include "cageproof/core/numbers/scalar_text.h"
#include "cageproof/core/catalogue/unknown_name.h"
#include "cageproof/reports/packed_file.h"
#include "json_value.h"
#include "older_frame.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>

namespace cageproof::reports {
namespace {

Json hex(const Vec3<double>& p) { return Json::array({format_hex(p[0]), format_hex(p[1]), format_hex(p[2])}); }

// The key of a line's subject.
const char* subject_key(RowKey::Section section) {
  switch (section) {
    case RowKey::Section::Element: return "formula";
    case RowKey::Section::Cage: return "kind";
    case RowKey::Section::Deformer: break;
  }
  return "deformer";
}

std::string parameter_name(const Formula* formula, std::size_t k) {
  return formula && k < formula->parameters.size() ? std::string(formula->parameters[k].name)
                                                   : fmt::format("parameter{}", k);
}

Json json_of(const WorstLine& line) {
  const WorstCase& worst = line.worst;
  const bool element = line.section == RowKey::Section::Element;
  Json json{{subject_key(line.section), line.subject},
            {"evaluation", line.evaluation},
            {"scalar", line.scalar},
            {"regime", line.setting},
            {"check", line.check},
            {"place", line.place},
            {"order", line.order},
            {"unit", line.unit},
            {"error", json_number(worst.error)},
            {"bound", line.bound ? json_number(*line.bound) : Json()},
            {"parameter", json_number(worst.parameter)},
            {"sample", worst.sample},
            {"flags", line.flags},
            {"element", Json::array()},
            {"point", hex(worst.point)},
            {"parameters", Json::object()}};
  for (const Vec3<double>& corner : worst.corners) json["element"].push_back(hex(corner));
  const Formula* formula = element ? find_formula(line.subject) : nullptr;
  for (std::size_t k = 0; k < worst.parameters.size(); ++k)
    json["parameters"][parameter_name(formula, k)] = format_hex(worst.parameters[k]);
  if (!worst.frame.is_own())
    json["frame"] = {{"unit", format_hex(worst.frame.unit)}, {"shift", hex(worst.frame.shift)}};
  if (worst.asked != 2) json["asked"] = worst.asked;
  if (worst.furthest.index >= 0) {
    json["relative"] = json_number(worst.relative);
    json["furthest"] = {
        {"entry", worst.furthest.index}, {"found", json_number(worst.furthest.found)}, {"truth", worst.furthest.truth}};
  }
  if (!line.triangulation.empty()) json["triangulation"] = line.triangulation;
  if (!line.cage_content.empty()) json["cage_content"] = line.cage_content;
  if (!line.provenance.empty()) json["provenance"] = line.provenance;
  return json;
}

// One line of the file, with its place for error messages.
class LineReader {
 public:
  LineReader(const std::string& text, std::string where) : where_(std::move(where)) {
    try {
      json_ = Json::parse(text);
    } catch (const Json::parse_error& error) {
      fail(fmt::format("malformed JSON at column {}", error.byte));
    } catch (const Json::exception&) {
      fail("malformed JSON: a number out of range");
    }
    if (!json_.is_object()) fail("not a JSON object");
  }

  bool has(const char* key) const { return json_.contains(key); }
  const Json& at(const char* key) const {
    if (!has(key)) fail(fmt::format("missing key \"{}\"", key));
    return json_[key];
  }
  void require_known(const std::vector<std::string_view>& keys) const {
    for (const auto& [key, value] : json_.items())
      if (std::ranges::find(keys, key) == keys.end()) {
        const std::string_view nearest = nearest_name(key, keys);
        fail(fmt::format("unknown key \"{}\"; {}known: {}", key,
                         nearest.empty() ? "" : fmt::format("did you mean \"{}\"? ", nearest), fmt::join(keys, ", ")));
      }
  }
  std::string text(const char* key) const {
    if (!at(key).is_string()) fail(fmt::format("\"{}\" is not a string", key));
    return at(key).get<std::string>();
  }
  double number(const char* key) const {
    const auto value = number_of(at(key));
    if (!value) fail(fmt::format("\"{}\" is not a number", key));
    return *value;
  }
  std::uint64_t count(const char* key) const {
    if (!at(key).is_number_unsigned()) fail(fmt::format("\"{}\" is not a count", key));
    return at(key).get<std::uint64_t>();
  }
  const Json& array(const char* key) const {
    if (!at(key).is_array()) fail(fmt::format("\"{}\" is not an array", key));
    return at(key);
  }
  double exact(const Json& json, const char* key) const {
    const auto value = json.is_string() ? parse_scalar<double>(json.get<std::string>()) : number_of(json);
    if (!value) fail(fmt::format("\"{}\" holds {}, which is no number", key, dump(json)));
    return *value;
  }
  Vec3<double> vector(const Json& json, const char* key) const {
    if (!json.is_array() || json.size() != 3) fail(fmt::format("\"{}\" is not made of three coordinates", key));
    return {exact(json[0], key), exact(json[1], key), exact(json[2], key)};
  }
  [[noreturn]] void fail(const std::string& reason) const { throw InputError(where_ + ": " + reason); }

 private:
  std::string where_;
  Json json_;
};

void read_subject(const LineReader& in, WorstLine& line) {
  line.section = in.has("kind")       ? RowKey::Section::Cage
                 : in.has("deformer") ? RowKey::Section::Deformer
                                      : RowKey::Section::Element;
  if (line.section == RowKey::Section::Element && !in.has("formula"))
    in.fail("missing key \"formula\", or \"kind\", or \"deformer\"");
  line.subject = in.text(subject_key(line.section));
}

void read_parameters(const LineReader& in, WorstLine& line) {
  const Json& json = in.at("parameters");
  if (!json.is_object()) in.fail("\"parameters\" is not an object");
  const Formula* formula = line.section == RowKey::Section::Element ? find_formula(line.subject) : nullptr;
  // By name where names are known, else in the order of the line.
  const std::size_t known = formula ? formula->parameters.size() : 0;
  for (std::size_t k = 0; k < known && !json.empty(); ++k) {
    const std::string name = parameter_name(formula, k);
    if (!json.contains(name)) in.fail(fmt::format("\"parameters\" lacks \"{}\"", name));
    line.worst.parameters.push_back(in.exact(json[name], "parameters"));
  }
  if (known == 0)
    for (const Json& value : json) line.worst.parameters.push_back(in.exact(value, "parameters"));
}

// Where a cage stood; older files have it as four parameters without names.
void read_frame(const LineReader& in, WorstLine& line) {
  if (line.section == RowKey::Section::Element) return;
  if (in.has("frame")) {
    const Json& json = in.at("frame");
    if (!json.is_object() || json.size() != 2 || !json.contains("unit") || !json.contains("shift"))
      in.fail("\"frame\" is not an object of \"unit\" and \"shift\"");
    line.worst.frame = {in.vector(json["shift"], "frame"), in.exact(json["unit"], "frame")};
  } else {
    take_older_frame(line.worst);
  }
  const CageFrame& frame = line.worst.frame;
  if (!std::isfinite(frame.unit) || frame.unit <= 0 || !frame.shift.allFinite())
    in.fail("\"frame\" has a unit that is not above zero, or a number that is not finite");
}

std::string read_triangulation(const LineReader& in) {
  std::string rule = in.text("triangulation");
  const std::vector<std::string_view> known{name_of(Triangulation::Shortest), name_of(Triangulation::Fan)};
  if (std::ranges::find(known, rule) == known.end()) in.fail(unknown_name("triangulation", rule, known).what());
  return rule;
}

// The keys of a line about such a subject; a remark is whatever a reader of the file notes.
std::vector<std::string_view> keys_of(RowKey::Section section) {
  constexpr std::array others{"evaluation", "scalar",        "regime",       "check",      "place",  "order",
                              "unit",       "error",         "bound",        "parameter",  "sample", "flags",
                              "point",      "element",       "parameters",   "frame",      "asked",  "relative",
                              "furthest",   "triangulation", "cage_content", "provenance", "remark"};
  std::vector<std::string_view> keys{subject_key(section)};
  keys.insert(keys.end(), others.begin(), others.end());
  return keys;
}

WorstLine read_line(const LineReader& in) {
  WorstLine line;
  read_subject(in, line);
  in.require_known(keys_of(line.section));
  line.evaluation = in.text("evaluation");
  line.scalar = in.text("scalar");
  line.setting = in.text("regime");
  line.check = in.text("check");
  line.place = in.text("place");
  const std::uint64_t order = in.count("order");
  if (order > 2) in.fail("\"order\" is not 0, 1 or 2");
  line.order = static_cast<int>(order);
  line.unit = in.text("unit");
  line.worst.error = in.number("error");
  if (!in.at("bound").is_null()) line.bound = in.number("bound");
  line.worst.parameter = in.number("parameter");
  line.worst.sample = in.count("sample");
  for (const Json& flag : in.array("flags")) {
    if (!flag.is_string()) in.fail("\"flags\" holds something that is not a string");
    line.flags.push_back(flag.get<std::string>());
  }
  const Json& corners = in.array("element");
  if (corners.size() > 4 || corners.size() == 1) in.fail("\"element\" does not have two, three or four corners");
  for (const Json& corner : corners) line.worst.corners.push_back(in.vector(corner, "element"));
  line.worst.point = in.vector(in.at("point"), "point");
  read_parameters(in, line);
  read_frame(in, line);
  if (in.has("triangulation")) line.triangulation = read_triangulation(in);
  if (in.has("cage_content")) line.cage_content = in.text("cage_content");
  if (in.has("provenance")) line.provenance = in.text("provenance");
  if (in.has("asked")) {
    const std::uint64_t asked = in.count("asked");
    if (asked > 2 || asked < order) in.fail("\"asked\" is not between \"order\" and 2");
    line.worst.asked = static_cast<int>(asked);
  }
  return line;
}

}  // namespace

WorstLine worst_line_of(const ResultRow& row, const WorstCase& worst, const RunResult& result) {
  WorstLine line{row, row.unit, row.bound, {}, {}, {}, {}, 0, worst};
  for (const std::string& flag : {row.section == RowKey::Section::Element ? row.setting : std::string(), row.place})
    if (!flag.empty()) line.flags.push_back(flag);
  const auto cage = result.settings.find("cage"), content = result.settings.find(cage_content_setting);
  if (row.section != RowKey::Section::Element && content != result.settings.end() && cage != result.settings.end() &&
      cage->second == row.setting)
    line.cage_content = content->second;
  if (const auto rule = result.settings.find("triangulation"); rule != result.settings.end())
    line.triangulation = rule->second;
  return line;
}

std::string worst_line(const WorstLine& line) { return dump(json_of(line)); }

std::string worst_lines(const RunResult& result) {
  std::string lines;
  for (const ResultRow& row : result.rows)
    for (const WorstCase& worst : row.worst) lines += worst_line(worst_line_of(row, worst, result)) + "\n";
  return lines;
}

std::vector<WorstLine> parse_worst(std::string_view text, std::string_view name) {
  std::istringstream stream{std::string(text)};
  std::vector<WorstLine> lines;
  std::string line;
  for (int number = 1; std::getline(stream, line); ++number) {
    if (line.find_first_not_of(" \t\r") == line.npos) continue;
    lines.push_back(read_line(LineReader(line, fmt::format("{}:{}", name, number))));
    lines.back().number = number;
  }
  return lines;
}

std::vector<WorstLine> read_worst(const std::filesystem::path& path) {
  std::vector<WorstLine> lines = parse_worst(read_packed(path), path.string());
  if (lines.empty()) throw InputError(fmt::format("{}: holds no worst cases", path.string()));
  return lines;
}

}  // namespace cageproof::reports
