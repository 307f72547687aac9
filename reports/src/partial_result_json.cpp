// SPDX-License-Identifier: MIT
#include "partial_result_json.h"

#include "older_frame.h"
#include "row_members.h"

#include <algorithm>
#include <stdexcept>

namespace cageproof::reports {
namespace {

// Reading. Members that are zero or empty are not written.

double number(const Json& json) {
  const auto value = number_of(json);
  if (!value) throw std::invalid_argument("not a number: " + dump(json));
  return *value;
}

std::uint64_t count(const Json& json) {
  if (!json.is_number_unsigned()) throw std::invalid_argument("not a count: " + dump(json));
  return json.get<std::uint64_t>();
}

int small(const Json& json) {
  const std::uint64_t value = count(json);
  if (value > 1'000'000'000) throw std::invalid_argument("too large: " + dump(json));
  return static_cast<int>(value);
}

std::uint64_t count_at(const Json& json, const char* name) { return json.contains(name) ? count(json[name]) : 0; }

std::vector<double> numbers(const Json& json) {
  std::vector<double> values;
  for (const Json& value : json) values.push_back(number(value));
  return values;
}

Vec3<double> vector(const Json& json) { return {number(json.at(0)), number(json.at(1)), number(json.at(2))}; }

const Json& list(const Json& json, const char* name) {
  static const Json none = Json::array();
  if (!json.contains(name)) return none;
  if (!json[name].is_array()) throw std::invalid_argument(std::string("not a list: ") + name);
  return json[name];
}

// Writing.

Json json_of(const std::vector<double>& values) {
  Json json = Json::array();
  for (const double value : values) json.push_back(json_number(value));
  return json;
}

Json json_of(const Vec3<double>& v) { return Json::array({json_number(v[0]), json_number(v[1]), json_number(v[2])}); }

// Histograms: most bins are empty, so that bin and count follow each other.
Json json_of(const ErrorHistogram& errors) {
  Json json = Json::array();
  for (const auto& [bin, count] : errors.filled()) {
    json.push_back(bin);
    json.push_back(count);
  }
  return json;
}

ErrorHistogram histogram_of(const Json& row) {
  std::array<std::uint64_t, ErrorHistogram::bin_count + 2> counts{};
  const Json& pairs = list(row, "counts");
  for (std::size_t i = 0; i < pairs.size(); i += 2) counts.at(count(pairs[i])) = count(pairs.at(i + 1));
  return ErrorHistogram::restored(counts, count_at(row, "nonfinite"), row.contains("max") ? number(row["max"]) : 0);
}

// Worst cases: error, parameter, sample, asked, corners, point, parameters (or where a cage stood: unit and shift);
// where a tensor was compared the relative error, and of the furthest entry index, result and truth.
Json json_of(const WorstCase& c) {
  Json corners = Json::array();
  for (const Vec3<double>& corner : c.corners) corners.push_back(json_of(corner));
  Json json = Json::array({json_number(c.error), json_number(c.parameter), c.sample, c.asked, corners, json_of(c.point),
                           json_of(c.parameters)});
  if (!c.frame.is_own()) json[6] = {{"unit", json_number(c.frame.unit)}, {"shift", json_of(c.frame.shift)}};
  if (c.furthest.index < 0) return json;
  json.push_back(json_number(c.relative));
  json.push_back(c.furthest.index);
  json.push_back(json_number(c.furthest.found));
  json.push_back(c.furthest.truth);
  return json;
}

WorstCase case_of(const Json& json, RowKey::Section section) {
  WorstCase c{number(json.at(0)), number(json.at(1)), count(json.at(2)), {}, vector(json.at(5)), {}, small(json.at(3))};
  if (const Json& varied = json.at(6); varied.is_object())
    c.frame = {vector(varied.at("shift")), number(varied.at("unit"))};
  else c.parameters = numbers(varied);
  if (section != RowKey::Section::Element) take_older_frame(c);
  for (const Json& corner : json.at(4)) c.corners.push_back(vector(corner));
  if (json.size() > 7) {
    c.relative = number(json[7]);
    c.furthest = {small(json.at(8)), number(json.at(9)), json.at(10).get<std::string>()};
  }
  return c;
}

Tally tally_of(const Json& row, RowKey::Section section) {
  Tally tally;
  static_cast<RowFigures&>(tally) = figures_of(row);
  tally.errors = histogram_of(row);
  tally.by_parameter = numbers(list(row, "relative_by_parameter"));
  for (const Json& c : list(row, "worst")) tally.worst.add(case_of(c, section));
  return tally;
}

Json json_of(int place, const FieldPart& part) {
  Json arrays = Json::array();
  for (const ImageField::Array& array : part.image.arrays)
    arrays.push_back({{"name", array.name},
                      {"unit", array.unit},
                      {"components", array.components},
                      {"linear", array.linear},
                      {"values", json_of(array.values)}});
  Json json{{"place", place}, {"name", part.image.name}, {"title", part.title}, {"shown", part.shown}};
  if (part.mesh.empty())
    json.update({{"points", part.image.points},
                 {"origin", json_of(part.image.origin)},
                 {"spacing", json_of(part.image.spacing)}});
  else json["mesh"] = part.mesh;
  json.update({{"samples", part.samples}, {"first", part.first}, {"arrays", arrays}});
  if (!part.image.facts.empty()) json["facts"] = part.image.facts;
  if (!part.cage.empty()) json["cage"] = part.cage;
  if (!part.scene.empty()) json.update({{"scene", part.scene}, {"compared", part.compared}});
  return json;
}

FieldPart field_of(const Json& json) {
  FieldPart part;
  part.title = json.at("title").get<std::string>();
  part.shown = json.at("shown").get<std::string>();
  part.image.name = json.at("name").get<std::string>();
  part.samples = count(json.at("samples"));
  part.first = count(json.at("first"));
  if (json.contains("mesh")) part.mesh = json["mesh"].get<std::string>();
  else {
    for (int c = 0; c < 3; ++c) part.image.points[c] = small(json.at("points").at(c));
    part.image.origin = vector(json.at("origin"));
    part.image.spacing = vector(json.at("spacing"));
  }
  for (const Json& array : list(json, "arrays"))
    part.image.arrays.push_back({array.at("name").get<std::string>(), array.at("unit").get<std::string>(),
                                 small(array.at("components")), numbers(array.at("values")),
                                 array.value("linear", false)});
  if (json.contains("facts")) part.image.facts = json["facts"].get<FieldFacts>();
  part.cage = json.value("cage", "");
  part.scene = json.value("scene", "");
  if (json.contains("compared")) part.compared = json["compared"].get<std::vector<std::string>>();
  return part;
}

Json json_of(const MeshField& mesh) {
  Json vertices = Json::array();
  for (const Vec3<double>& vertex : mesh.vertices) vertices.push_back(json_of(vertex));
  return {{"name", mesh.name}, {"vertices", vertices}, {"faces", mesh.faces}};
}

MeshField mesh_of(const Json& json) {
  MeshField mesh;
  mesh.name = json.at("name").get<std::string>();
  for (const Json& vertex : list(json, "vertices")) mesh.vertices.push_back(vector(vertex));
  for (const Json& face : list(json, "faces")) {
    auto& corners = mesh.faces.emplace_back();
    for (const Json& corner : face) corners.push_back(small(corner));
  }
  return mesh;
}

Json json_of(int place, const ErratumRow& row) {
  return {{"place", place},
          {"source", row.source},
          {"printed", row.printed},
          {"correct", row.correct},
          {"formula", row.formula},
          {"evaluation", row.evaluation},
          {"regime", row.regime},
          {"order", row.order},
          {"samples", row.samples},
          {"nonfinite", row.nonfinite},
          {"printed_error", json_number(row.printed_error)},
          {"corrected_error", json_number(row.corrected_error)}};
}

ErratumRow erratum_of(const Json& json) {
  const auto text = [&](const char* name) { return json.at(name).get<std::string>(); };
  ErratumRow row{text("source"), text("printed"), text("correct"), text("formula"), text("evaluation"), text("regime")};
  row.order = small(json.at("order"));
  row.samples = count(json.at("samples"));
  row.nonfinite = count(json.at("nonfinite"));
  row.printed_error = number(json.at("printed_error"));
  row.corrected_error = number(json.at("corrected_error"));
  return row;
}

}  // namespace

Json row_json(const RowKey& key, const Tally& tally) {
  Json json{{"key", key_json(key)}};
  add_figures(json, tally);
  if (tally.errors.count() > 0)
    json.update({{"max", json_number(tally.errors.max())}, {"counts", json_of(tally.errors)}});
  if (tally.errors.nonfinite() > 0) json["nonfinite"] = tally.errors.nonfinite();
  if (!tally.by_parameter.empty()) json["relative_by_parameter"] = json_of(tally.by_parameter);
  for (const WorstCase& c : tally.worst.cases()) json["worst"].push_back(json_of(c));
  return json;
}

Json partial_result_json(const PartialResult& gathered) {
  Json json = Json::object();
  for (const auto& [key, tally] : gathered.rows) json["rows"].push_back(row_json(key, tally));
  for (const auto& [at, part] : gathered.fields) json["fields"].push_back(json_of(at.first, part));
  for (const auto& [name, mesh] : gathered.meshes) json["meshes"].push_back(json_of(mesh));
  for (const auto& [place, row] : gathered.errata) json["errata"].push_back(json_of(place, row));
  for (const auto& [reason, names] : gathered.refused)
    json["refused"].push_back({{"reason", reason}, {"names", names}});
  return json;
}

PartialResult partial_result_of(const Json& json) {
  PartialResult gathered;
  for (const Json& row : list(json, "rows")) {
    const RowKey key = key_of(row.at("key"));
    if (!gathered.rows.try_emplace(key, tally_of(row, key.section)).second)
      throw std::invalid_argument("a row is there twice");
  }
  for (const Json& field : list(json, "fields")) {
    FieldPart part = field_of(field);
    gathered.fields.try_emplace({small(field.at("place")), part.first}, std::move(part));
  }
  for (const Json& mesh : list(json, "meshes")) {
    MeshField found = mesh_of(mesh);
    gathered.meshes.try_emplace(found.name, std::move(found));
  }
  for (const Json& row : list(json, "errata")) gathered.errata.try_emplace(small(row.at("place")), erratum_of(row));
  for (const Json& one : list(json, "refused"))
    for (const Json& name : one.at("names"))
      gathered.refused[one.at("reason").get<std::string>()].insert(name.get<std::string>());
  return gathered;
}

}  // namespace cageproof::reports
