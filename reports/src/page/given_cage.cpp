// SPDX-License-Identifier: MIT
#include "given_cage.h"

#include "cageproof/core/coordinates/coordinates.h"
#include "cageproof/core/catalogue/role.h"
#include "check_words.h"
#include "figure.h"
#include "gallery_page.h"
#include "page_template.h"
#include "run_names.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <limits>

namespace cageproof::reports {
namespace {

constexpr std::string_view scope_setting = "scope", cage_setting = "cage", points_place = "mesh";

// Coordinates down to so many roundings below zero may be zero: all sums of coordinates have this bound.
constexpr double roundings_of_zero = 64;

std::string setting_of(const RunResult& result, std::string_view name) {
  const auto found = result.settings.find(std::string(name));
  return found == result.settings.end() ? std::string() : found->second;
}

// A cage's name is its path; people know the file by its last part.
std::string short_cage_name(const RunResult& result) {
  const std::string cage = setting_of(result, cage_setting);
  const std::string file = std::filesystem::path(cage).filename().string();
  return file.empty() ? cage : file;
}

bool is_row_of(const ResultRow& row, const std::string& kind) {
  return row.section == RowKey::Section::Cage && row.subject == kind;
}

bool is_at_the_cage(const std::string& place) {
  return place == "inside" || place.starts_with("on-") || place.starts_with("near-");
}

bool compares_with_truth(const std::string& check) {
  return check == "cage_block_error" || check == "cage_truth" || check == "scheme_error";
}

// The evaluation that commands take: the batched one where it exists, else the recommended one. For kinds that are not
// sums it is the one that is not listed under other evaluations.
std::string evaluation_taken(const RunResult& result, const std::string& kind) {
  for (const Role role : {Role::Batched, Role::Recommended})
    for (const ResultRow& row : result.rows)
      if (is_row_of(row, kind) && row.role == name_of(role)) return row.evaluation;
  const CoordinateKind* known = find_coordinate_kind(kind);
  for (const ResultRow& row : result.rows)
    if (is_row_of(row, kind) && (known == nullptr || std::ranges::find(known->other_evaluations, row.evaluation) ==
                                                         known->other_evaluations.end()))
      return row.evaluation;
  return {};
}

std::optional<double> time_of_kind(const RunResult& result, const std::string& kind) {
  for (const Session& session : result.sessions)
    for (const EvaluationTime& time : session.times)
      if (time.formula == kind) return time.nanoseconds;
  return std::nullopt;
}

void raise(std::optional<double>& most, double error) {
  if (!most || !(error <= *most)) most = error;
}

void keep_more_telling(const ResultRow*& kept, const ResultRow& row) {
  if (kept == nullptr || more_telling(row, *kept)) kept = &row;
}

void keep_signs(const ResultRow*& kept, const ResultRow& row) {
  if (kept == nullptr || row.place == points_place) kept = &row;
}

KindInCage kind_in_cage(const RunResult& result, const std::string& name) {
  KindInCage found;
  found.kind = name;
  found.evaluation = evaluation_taken(result, name);
  found.nanoseconds = time_of_kind(result, name);
  bool linear_kept = true;
  for (const ResultRow& row : result.rows) {
    if (!is_row_of(row, name)) continue;
    found.kept += row.verdict == Verdict::Kept ? 1 : 0;
    found.broken += row.verdict == Verdict::Broken ? 1 : 0;
    found.undecided += row.verdict == Verdict::Undecided ? 1 : 0;
    if (row.evaluation != found.evaluation || row.scalar != "double" || row.order != 0) continue;
    if (compares_with_truth(row.check) && row.samples > 0) {
      const double error = row.nonfinite > 0 ? HUGE_VAL : row.max_relative;
      if (is_at_the_cage(row.place)) {
        raise(found.error_inside, error);
        found.samples_inside += row.samples;
      } else {
        const std::optional<double> before = found.error_elsewhere;
        raise(found.error_elsewhere, error);
        if (found.error_elsewhere != before) found.worst_elsewhere = row.place;
      }
    }
    if (row.check == "partition_of_unity") keep_more_telling(found.unity, row);
    if (row.check == "non_negativity" && row.samples > 0) keep_signs(found.signs, row);
    if (row.check != "linear_reproduction") continue;
    keep_more_telling(found.linear, row);
    linear_kept = linear_kept && row.verdict == Verdict::Kept;
    if (row.place == points_place) found.at_points = &row;
  }
  found.reproduces_linear = found.linear != nullptr && linear_kept;
  return found;
}

std::string digits_text(const std::optional<double>& error) {
  return error ? digits_kept(*error, "double") : "not compared";
}

std::string keeps_text(const ResultRow* row) {
  if (row == nullptr) return "not measured";
  if (row->verdict == Verdict::Kept) return "yes";
  if (row->verdict == Verdict::Broken) return "no";
  return fmt::format("not promised, {}", short_error(row->max_relative));
}

std::string signs_text(const ResultRow* row) {
  if (row == nullptr) return "–";
  if (row->nonfinite > 0) return "no, not finite";
  if (row->max <= roundings_of_zero) return "yes";
  return fmt::format("no, down to −{}", short_error(row->max_relative));
}

Data row_of_kind(const KindInCage& one, bool is_taken) {
  Data data;
  data.set("kind", breakable(one.kind));
  data.set("evaluation", one.evaluation);
  data.set("taken", is_taken);
  data.set("samples", grouped(one.samples_inside));
  data.set("digits", digits_text(one.error_inside));
  data.set("elsewhere", one.error_elsewhere
                            ? fmt::format("{} ({})", digits_text(one.error_elsewhere), one.worst_elsewhere)
                            : std::string("not compared"));
  data.set("at_points", one.at_points ? short_error(one.at_points->max_relative) : "–");
  data.set("unity", keeps_text(one.unity));
  data.set("linear", keeps_text(one.linear));
  data.set("signs", signs_text(one.signs));
  data.set("time", one.nanoseconds ? duration_text(*one.nanoseconds) : "–");
  data.set("kept", grouped(one.kept));
  data.set("broken", grouped(one.broken));
  data.set("any_broken", one.broken > 0);
  return data;
}

bool keeps_all(const KindInCage& kind) { return kind.broken == 0 && kind.undecided == 0 && kind.reproduces_linear; }

std::string advice_of(const std::vector<KindInCage>& kinds, const KindInCage* taken, bool timed) {
  if (taken != nullptr)
    return fmt::format(
        "The quickest that keeps its promises: {}. It keeps all {} of them, reproduces linear functions, "
        "and takes {} per point. It was compared with its truth at {} points inside.",
        taken->kind, grouped(taken->kept), duration_text(*taken->nanoseconds), grouped(taken->samples_inside));
  if (std::ranges::none_of(kinds, keeps_all))
    return "No kind keeps all promises and reproduces linear functions in this cage.";
  if (std::ranges::none_of(kinds, [](const KindInCage& k) { return keeps_all(k) && k.error_inside; }))
    return "None of the kinds that keep all promises and reproduce linear functions was compared with its truth in, on "
           "or next to the cage in this suite, so none is named.";
  return timed ? "None of the kinds that could be named was timed."
               : "No kind was timed in this run, so none is named as the quickest.";
}

// A field that tells something of the cage: of the kind to take where it has one, at the points given rather than in a
// slice. Fields of rounding noise tell nothing.
Data pictures_of(const RunResult& result, const std::string& kind) {
  const ShownNames names = names_of_run(result);
  const auto rank = [&](const FieldEntry& field) {
    const bool of_kind = field.title.find(fmt::format(", {} coordinates", kind)) != std::string::npos;
    return std::pair(of_kind, field.data.ends_with(".vtp"));
  };
  const FieldEntry* shown = nullptr;
  for (const FieldEntry& field : result.fields)
    if (!field.picture.empty() && !is_rounding_noise(field) && (!shown || rank(field) > rank(*shown))) shown = &field;
  Data list{Data::type::list};
  if (!shown) return list;
  Data data;
  data.set("picture", shown->picture);
  data.set("title", names.in(shown->title));
  data.set("page", shown->page);
  data.set("has_page", !shown->page.empty());
  list << data;
  return list;
}

Data undecided_rows(const RunResult& result) {
  Data list{Data::type::list};
  for (const ResultRow& row : result.rows) {
    if (row.verdict != Verdict::Undecided) continue;
    Data data;
    data.set("text", fmt::format("{} of {} by {}, {}{}, order {}", row.check, row.subject, row.evaluation, row.setting,
                                 row.place.empty() ? "" : " " + row.place, row.order));
    data.set("reason", row.reason);
    list << data;
  }
  return list;
}

}  // namespace

bool is_of_given_cage(const RunResult& result) { return !setting_of(result, scope_setting).empty(); }

std::string given_cage_verdict(const RunResult& result) {
  return fmt::format("{} for {}", verdict_line(result), short_cage_name(result));
}

std::vector<KindInCage> kinds_in_cage(const RunResult& result) {
  std::vector<KindInCage> kinds;
  for (const std::string& name : subjects(result, RowKey::Section::Cage)) kinds.push_back(kind_in_cage(result, name));
  std::erase_if(kinds, [](const KindInCage& k) { return find_coordinate_kind(k.kind) == nullptr; });
  return kinds;
}

const KindInCage* kind_to_take(const std::vector<KindInCage>& kinds) {
  constexpr double alike = 1.25;  // times closer than that differ by what else the machine did
  const auto can_be_named = [](const KindInCage& one) { return keeps_all(one) && one.error_inside && one.nanoseconds; };
  double least = std::numeric_limits<double>::infinity();
  for (const KindInCage& one : kinds)
    if (can_be_named(one)) least = std::min(least, *one.nanoseconds);
  const KindInCage* best = nullptr;
  for (const KindInCage& one : kinds)
    if (can_be_named(one) && *one.nanoseconds <= alike * least &&
        (best == nullptr || *one.error_inside < *best->error_inside))
      best = &one;
  return best;
}

void set_given_cage(Data& page, const RunResult& result) {
  page.set("of_given_cage", is_of_given_cage(result));
  if (!is_of_given_cage(result)) return;
  const std::vector<KindInCage> kinds = kinds_in_cage(result);
  const KindInCage* const taken = kind_to_take(kinds);
  const bool timed = std::ranges::any_of(kinds, [](const KindInCage& k) { return k.nanoseconds.has_value(); });
  const bool at_points = std::ranges::any_of(kinds, [](const KindInCage& k) { return k.at_points != nullptr; });
  const bool has_signs = std::ranges::any_of(kinds, [](const KindInCage& k) { return k.signs != nullptr; });
  // The one that is named comes first.
  std::vector<const KindInCage*> order;
  for (const KindInCage& one : kinds) order.insert(&one == taken ? order.begin() : order.end(), &one);
  Data rows{Data::type::list};
  for (const KindInCage* const kind : order) {
    const KindInCage& one = *kind;
    Data row = row_of_kind(one, &one == taken);
    row.set("page", page_of({RowKey::Section::Cage, "", "", "", setting_of(result, cage_setting), "", "", 0}));
    row.set("timed", timed);
    row.set("has_points", at_points);
    row.set("has_signs", has_signs);
    rows << row;
  }
  Data section;
  section.set("name", short_cage_name(result));
  section.set("points", setting_of(result, "points"));
  section.set("advice", advice_of(kinds, taken, timed));
  section.set("timed", timed);
  section.set("has_points", at_points);
  section.set("has_signs", has_signs);
  set_list(section, "kinds", rows);
  set_list(section, "pictures", pictures_of(result, taken != nullptr ? taken->kind : ""));
  set_list(section, "undecided", undecided_rows(result));
  page.set("given_cage_section", rendered(kGivenCageTemplate, "given_cage.mustache", section));
}

}  // namespace cageproof::reports
