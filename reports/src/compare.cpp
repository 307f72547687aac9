// SPDX-License-Identifier: MIT
#include "cageproof/reports/compare.h"

#include "compare_rows.h"

#include "cageproof/core/input_error.h"
#include "cageproof/core/whole_file.h"
#include "cageproof/reports/summary.h"
#include "row_members.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <compare>
#include <set>

namespace cageproof::reports {
namespace {

// Members of one list of summary.json: those that identify an entry, and its figures.
struct List {
  const char *name, *entry;
  std::vector<const char*> key, figures;
};

std::vector<const char*> names_of(std::initializer_list<RowMember::Kind> kinds) {
  std::vector<const char*> names;
  for (const RowMember& member : row_members())
    if (std::ranges::find(kinds, member.kind) != kinds.end()) names.push_back(member.name);
  return names;
}

const std::array lists{
    List{"rows", "row", names_of({RowMember::Kind::Key}), names_of({RowMember::Kind::Figure, RowMember::Kind::Count})},
    List{"curves",
         "curve",
         {"subject", "evaluation", "scalar", "regime", "check", "order"},
         {"parameter_name", "parameters", "relative_errors"}},
    List{"fields", "field", {"title"}, {"unit", "largest"}},
    List{"errata",
         "erratum",
         {"source", "printed", "formula", "evaluation", "regime", "order"},
         {"correct", "measured", "samples", "printed_nonfinite", "printed_error", "corrected_error"}}};

int version_of(const Json& summary, std::string_view name) {
  const auto version = summary.find("schema_version");
  if (version == summary.end()) return 1;
  if (!version->is_number_integer())
    throw InputError(fmt::format("{}: schema_version {} is not a whole number", name, dump(*version)));
  return version->get<int>();
}

bool is_list_of_objects(const Json& json) {
  return json.is_array() && std::ranges::all_of(json, [](const Json& entry) { return entry.is_object(); });
}

// Counts of other bins are no counts of the same errors. \param age as differences has it
void require_same_bins(const Json& before, const Json& after, std::strong_ordering age, std::string_view old_name,
                       std::string_view new_name) {
  constexpr const char* bins = "histogram_bins";
  if ((age < 0 && !before.contains(bins)) || (age > 0 && !after.contains(bins))) return;
  if (before.contains(bins) == after.contains(bins) && (!before.contains(bins) || before[bins] == after[bins])) return;
  const auto text = [&](const Json& summary) { return summary.contains(bins) ? dump(summary[bins]) : "none"; };
  throw InputError(fmt::format("the histograms of {} and {} have other bins, and cannot be compared: {}, {}", old_name,
                               new_name, text(before), text(after)));
}

Json parsed(std::string_view text, std::string_view name) {
  Json json = Json::parse(text, nullptr, false);
  const bool summary = json.is_object() && json.contains("schema") && json["schema"] == "cageproof-summary";
  if (!summary || !json.contains("rows"))
    throw InputError(fmt::format("{}: not the summary.json of a verification report", name));
  if (const int version = version_of(json, name); version < 1 || version > summary_schema_version)
    throw InputError(
        fmt::format("{}: schema_version {} is unknown, this program reads 1 to {}; a newer one may read it", name,
                    version, summary_schema_version));
  for (const List& list : lists)
    if (json.contains(list.name) && !is_list_of_objects(json[list.name]))
      throw InputError(fmt::format("{}: \"{}\" is not a list of objects", name, list.name));
  return json;
}

std::string text_of(const Json& json) {
  if (json.is_string()) return json.get<std::string>();
  const std::string text = dump(json);
  return text.size() > 40 ? "..." : text;
}

std::string renamed_word(const Json& entry, const char* member, const Renamed& renamed) {
  std::string word = text_of(entry[member]);
  constexpr std::array names{"subject", "formula", "evaluation", "regime", "check"};
  if (std::ranges::find(names, std::string_view(member)) == names.end()) return word;
  for (const char* owner : {"subject", "formula"}) {
    if (!entry.contains(owner)) continue;
    if (const auto found = renamed.find(fmt::format("{}/{}", text_of(entry[owner]), word)); found != renamed.end())
      return found->second;
  }
  const auto found = renamed.find(word);
  return found == renamed.end() ? word : found->second;
}

// Schemas before this call the recommended evaluations of triangles and segments closed_form, and have no algebra
// kept by more digits, which took over that name.
constexpr int schema_of_hybrids = 4;

// The old summary with each entry of a recommended `closed_form` named `hybrid` where the new one has that. \return how
// many
std::size_t name_hybrids(Json& before, const Json& after) {
  const auto name_of = [](const Json& entry, const List& list, std::string_view evaluation) {
    std::string name;
    for (const char* member : list.key)
      if (entry.contains(member))
        name.append(" ").append(std::string_view(member) == "evaluation" ? evaluation : text_of(entry[member]));
    return name;
  };
  std::size_t count = 0;
  for (const List& list : lists) {
    if (!before.contains(list.name) || !after.contains(list.name)) continue;
    std::set<std::string> known;
    for (const Json& entry : after[list.name])
      if (entry.value("evaluation", "") == "hybrid") known.insert(name_of(entry, list, "hybrid"));
    for (Json& entry : before[list.name])
      if (entry.value("evaluation", "") == "closed_form" && known.contains(name_of(entry, list, "hybrid"))) {
        entry["evaluation"] = "hybrid";
        ++count;
      }
  }
  return count;
}

// The entries of a list by their subjects, in words.
std::map<std::string, const Json*> entries(const Json& summary, const List& list, const Renamed& renamed) {
  std::map<std::string, const Json*> found;
  if (!summary.contains(list.name)) return found;
  for (const Json& entry : summary[list.name]) {
    std::string name = fmt::format("{}:", list.entry);
    for (const char* member : list.key)
      if (entry.contains(member) && entry[member] != "") name.append(" ").append(renamed_word(entry, member, renamed));
    // A report may show one title twice.
    std::string unique = name;
    for (int n = 2; !found.try_emplace(unique, &entry).second; ++n) unique = fmt::format("{} ({})", name, n);
  }
  return found;
}

// Leaves out members that the earlier schema does not know. \param age of the first's schema against the second's
std::string differences(const Json& before, const Json& after, const List& list, std::strong_ordering age) {
  std::string text;
  for (const char* figure : list.figures) {
    if ((age < 0 && !before.contains(figure)) || (age > 0 && !after.contains(figure))) continue;
    const Json a = before.contains(figure) ? before[figure] : Json(),
               b = after.contains(figure) ? after[figure] : Json();
    if (a != b) text.append(fmt::format("{} {} {} -> {}", text.empty() ? "" : ",", figure, text_of(a), text_of(b)));
  }
  return text;
}

}  // namespace

Renamed read_renamed(const std::filesystem::path& path) {
  const Json json = Json::parse(read_file(path), nullptr, false);
  Renamed renamed;
  if (!json.is_object()) throw InputError(fmt::format("{}: not a JSON object", path.string()));
  for (const auto& [name, value] : json.items()) {
    if (!value.is_string())
      throw InputError(fmt::format("{}: the new name of \"{}\" is not a string", path.string(), name));
    renamed[name] = value.get<std::string>();
  }
  return renamed;
}

std::vector<std::string> differing_settings(const Json& before, const Json& after) {
  const auto settings_of = [](const Json& summary) {
    std::map<std::string, std::string> found;
    const auto put = [&](const std::string& name, const Json& value) {
      found[name] = value.is_string() ? value.get<std::string>() : dump(value);
    };
    for (const char* name : {"suite", "seed"})
      if (summary.contains(name)) put(name, summary[name]);
    if (const auto all = summary.find("settings"); all != summary.end() && all->is_object())
      for (const auto& [name, value] : all->items())
        // They belong to the program: no option of a run decides them.
        if (name != "stored worst cases") put(name, value);
    return found;
  };
  std::map<std::string, std::string> a = settings_of(before), b = settings_of(after);
  std::vector<std::string> texts;
  texts.reserve(a.size() + b.size());
  for (const auto& [name, value] : a) b.try_emplace(name, "none");
  for (const auto& [name, value] : b) {
    const std::string& old = a.try_emplace(name, "none").first->second;
    if (old != value) texts.push_back(fmt::format("{} {} -> {}", name, old, value));
  }
  return texts;
}

MatchedRows::MatchedRows(std::string_view old_text, std::string_view new_text, const Renamed& renamed,
                         std::string_view old_name, std::string_view new_name)
    : before(parsed(old_text, old_name)), after(parsed(new_text, new_name)) {
  if (version_of(before, old_name) < schema_of_hybrids && version_of(after, new_name) >= schema_of_hybrids)
    taken_for_hybrid = name_hybrids(before, after);
  old_rows = entries(before, lists[0], renamed);
  new_rows = entries(after, lists[0], {});
}

Differences compare_summaries(std::string_view old_text, std::string_view new_text, const Renamed& renamed,
                              std::string_view old_name, std::string_view new_name) {
  Json before = parsed(old_text, old_name);
  const Json after = parsed(new_text, new_name);
  const int old_version = version_of(before, old_name), new_version = version_of(after, new_name);
  const std::strong_ordering age = old_version <=> new_version;
  require_same_bins(before, after, age, old_name, new_name);
  Differences result;
  result.settings = differing_settings(before, after);
  if (old_version < schema_of_hybrids && new_version >= schema_of_hybrids)
    result.taken_for_hybrid = name_hybrids(before, after);
  for (const List& list : lists) {
    const auto old_entries = entries(before, list, renamed), new_entries = entries(after, list, {});
    for (const auto& [name, entry] : old_entries) {
      const auto other = new_entries.find(name);
      if (other == new_entries.end()) {
        result.gone.push_back(name);
        continue;
      }
      const std::string text = differences(*entry, *other->second, list, age);
      if (text.empty()) ++result.equal;
      else result.differing.push_back(fmt::format("{}:{}", name, text));
    }
    for (const auto& [name, entry] : new_entries)
      if (!old_entries.contains(name)) result.added.push_back(name);
  }
  return result;
}

}  // namespace cageproof::reports
