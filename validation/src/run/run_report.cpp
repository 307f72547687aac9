// SPDX-License-Identifier: MIT
#include "run/run_report.h"

#include "cageproof/core/input_error.h"
#include "cageproof/reports/report_writer.h"
#include "cageproof/reports/run_folder.h"
#include "cageproof/reports/shown_names.h"
#include "cageproof/reports/summary.h"
#include "cageproof/reports/worst_file.h"
#include "cageproof/validation/compared_fields.h"
#include "cageproof/validation/machine_facts.h"
#include "cageproof/validation/paper_figures.h"
#include "promises/verdicts.h"
#include "cageproof/validation/verify.h"

#include <fmt/format.h>
#ifdef __GLIBC__
#include <malloc.h>
#endif

#include <algorithm>
#include <set>

namespace cageproof::validation {
namespace {

// Returns memory to the system that threads have freed in small pieces. A run holds most memory while it writes: the
// findings, and the buffers of the writer.
void return_free_memory() {
#ifdef __GLIBC__
  malloc_trim(0);
#endif
}

using reports::Journal;

reports::ColourScale scale_of(const FieldPart& part) {
  for (const ImageField::Array& array : part.image.arrays)
    if (array.name == part.shown && array.linear) return reports::ColourScale::Linear;
  return reports::ColourScale::Log10;
}

MeshField mesh_field(const FieldPart& part, const PartialResult& gathered) {
  const auto mesh = gathered.meshes.find(part.mesh);
  if (mesh == gathered.meshes.end()) throw InputError(fmt::format("the journal has no mesh '{}'", part.mesh));
  MeshField field = mesh->second;
  field.name = part.image.name;
  field.arrays = part.image.arrays;
  field.facts = part.image.facts;
  return field;
}

// Titles of pictures have the names that people read; the entry keeps the whole one.
FieldEntry write_field(reports::ReportWriter& writer, const FieldPart& part, const PartialResult& gathered,
                       const reports::ShownNames& names) {
  const auto cage = gathered.meshes.find(part.cage);
  const MeshField* outline = cage == gathered.meshes.end() ? nullptr : &cage->second;
  const std::string title = names.in(part.title);
  FieldEntry entry = part.mesh.empty()
                         ? writer.write_image(part.image, title, part.shown, scale_of(part), std::nullopt, outline)
                         : writer.write_mesh(mesh_field(part, gathered), title, part.shown, scale_of(part));
  entry.title = part.title;
  return entry;
}

// The parts of one scene: an image, and maybe a mesh.
std::vector<FieldEntry> write_scene(reports::ReportWriter& writer, const std::vector<const FieldPart*>& parts,
                                    const PartialResult& gathered, const reports::ShownNames& names) {
  reports::FieldScene scene;
  std::string title;
  for (const FieldPart* part : parts) {
    if (!part->mesh.empty()) {
      scene.mesh = mesh_field(*part, gathered);
      continue;
    }
    const auto cage = gathered.meshes.find(part->cage);
    if (cage == gathered.meshes.end()) throw InputError(fmt::format("the journal has no mesh '{}'", part->cage));
    title = part->title;
    scene.title = names.in(title);
    scene.explanation = scene_explanation;
    scene.compared = part->compared;
    scene.image = part->image;
    scene.cage = cage->second;
  }
  std::vector<FieldEntry> entries = writer.write_scene(scene);
  for (FieldEntry& entry : entries) entry.title.replace(0, scene.title.size(), title);
  return entries;
}

std::map<int, FieldPart> fields_with_facts(const Journal& journal) {
  std::map<int, FieldPart> fields = whole_fields(journal.gathered);
  for (auto& [place, part] : fields) {
    part.image.facts["version"] = journal.header.version;
    part.image.facts["seed"] = journal.header.options.at("seed");
    part.image.facts["suite"] = journal.header.options.at("suite");
  }
  return fields;
}

std::string setting_of(const Journal& journal, const std::string& name) {
  const auto found = journal.header.settings.find(name);
  return found == journal.header.settings.end() ? std::string() : found->second;
}

void require_finished(const Journal& journal, const std::filesystem::path& folder) {
  if (const auto reason = unfinished(journal, folder)) throw InputError(*reason);
}

}  // namespace

std::optional<std::string> unfinished(const Journal& journal, const std::filesystem::path& folder) {
  const auto& header = journal.header;
  if (journal.units_done() == header.shard_units) return std::nullopt;
  return fmt::format(
      "{}: {} is not finished, {} of its {} units of work are done; `cageproof verify --resume {}` goes on with it",
      folder.string(), header.shards > 1 ? fmt::format("shard {}/{}", header.shard, header.shards) : "the run",
      journal.units_done(), header.shard_units, folder.string());
}

std::vector<std::string> notes_on_refusals(const PartialResult& gathered) {
  std::vector<std::string> notes;
  notes.reserve(gathered.refused.size());
  for (const auto& [reason, names] : gathered.refused)
    notes.push_back(fmt::format("not judged, {}: {}", reason, fmt::join(names, "; ")));
  return notes;
}

std::vector<std::string> session_notes(const std::vector<Session>& sessions) {
  std::vector<std::string> notes;
  const auto compare = [&](const char* fact, const char* many, const char* meaning) {
    std::set<std::string> values;
    for (const Session& session : sessions)
      if (const auto found = session.machine.find(fact); found != session.machine.end()) values.insert(found->second);
    if (values.size() > 1)
      notes.push_back(fmt::format("the run's parts were measured with {} different {} ({}): {}", values.size(), many,
                                  fmt::join(values, " | "), meaning));
  };
  compare(elementary_functions, "elementary functions",
          "the C library picks them by processor; last digits may differ from those of a run on one kind");
  compare(instruction_set_fact, "instruction sets", "last digits may differ from those of a run with one set");
  compare(program_build, "builds of the program", "figures of different programs may stand side by side");
  return notes;
}

std::string difference_of_runs(const reports::JournalHeader& before, const reports::JournalHeader& now) {
  std::vector<std::string> differences;
  const auto compare = [&](const std::string& what, const std::string& a, const std::string& b) {
    const auto shown = [](const std::string& text) { return text.empty() ? std::string("none") : text; };
    if (a != b) differences.push_back(fmt::format("{} {}, now {}", what, shown(a), shown(b)));
  };
  compare("version", before.version, now.version);
  std::map<std::string, std::string> names = before.options;
  names.insert(now.options.begin(), now.options.end());
  const auto value = [](const reports::JournalHeader& header, const std::string& name) {
    const auto found = header.options.find(name);
    return found == header.options.end() ? std::string() : found->second;
  };
  for (const auto& [name, any] : names)
    if (name != work_option) compare(name, value(before, name), value(now, name));
  // Other options are other work; alone it tells that one program takes them otherwise than another.
  if (differences.empty()) compare(work_option, value(before, work_option), value(now, work_option));
  compare("number of shards", fmt::format("{}", before.shards), fmt::format("{}", now.shards));
  return fmt::format("{}", fmt::join(differences, "; "));
}

// Fewer where the user asked for fewer than the suite has.
Samples samples_of(const reports::JournalHeader& header) {
  const auto suite = std::ranges::find(suites(), header.options.at("suite"), &Suite::name);
  return suite != suites().end() && std::stoi(header.options.at("samples")) >= suite->samples ? Samples::All
                                                                                              : Samples::Fewer;
}

RunResult result_of(Journal& journal) {
  RunResult result;
  result.version = journal.header.version;
  result.suite = journal.header.options.at("suite");
  result.seed = std::stoull(journal.header.options.at("seed"));
  result.settings = journal.header.settings;
  if (const auto content = journal.header.options.find(reports::cage_content_setting);
      content != journal.header.options.end())
    result.settings.insert(*content);
  result.sessions = journal.sessions;
  result.session_notes = session_notes(journal.sessions);
  Judged found = judged(std::move(journal.gathered.rows), samples_of(journal.header));
  result.rows = std::move(found.rows);
  result.curves = std::move(found.curves);
  result.notes = std::move(found.notes);
  result.notes.insert(result.notes.end(), journal.header.notes.begin(), journal.header.notes.end());
  for (std::string& note : notes_on_refusals(journal.gathered)) result.notes.push_back(std::move(note));
  for (const auto& [place, row] : journal.gathered.errata) result.errata.push_back(row);
  return result;
}

RunResult write_report(const std::filesystem::path& out, Journal journal) {
  return_free_memory();
  reports::ReportWriter writer(out);
  writer.write_journal(journal);
  return_free_memory();
  RunResult result = result_of(journal);
  return_free_memory();
  const std::map<int, FieldPart> fields = fields_with_facts(journal);
  const reports::ShownNames names({setting_of(journal, "cage"), setting_of(journal, "points")});
  std::map<std::string, std::vector<const FieldPart*>> scenes;
  for (const auto& [place, part] : fields)
    if (!part.scene.empty()) scenes[part.scene].push_back(&part);
  for (const auto& [place, part] : fields) {
    if (part.scene.empty()) result.fields.push_back(write_field(writer, part, journal.gathered, names));
    else if (scenes[part.scene].front() == &part)
      for (FieldEntry& entry : write_scene(writer, scenes[part.scene], journal.gathered, names))
        result.fields.push_back(std::move(entry));
  }
  for (reports::FigureSheet& sheet : sheets_of_run(journal.gathered.meshes)) writer.write_figure(std::move(sheet));
  for (std::string& note : writer.write(result)) result.session_notes.push_back(std::move(note));
  writer.commit();
  return result;
}

RunResult report_again(const std::filesystem::path& folder) {
  Journal journal = reports::read_journal(reports::journal_in(folder));
  if (journal.header.shards > 1)
    throw InputError(fmt::format("{}: shard {}/{} of a run; `cageproof merge` makes one report of all shards",
                                 folder.string(), journal.header.shard, journal.header.shards));
  require_finished(journal, folder);
  return write_report(folder, std::move(journal));
}

RunResult merge_shards(const std::vector<std::filesystem::path>& parts, const std::filesystem::path& out) {
  Journal whole;
  std::map<int, std::string> taken;
  for (const std::filesystem::path& part : parts) {
    Journal journal = reports::read_journal(reports::journal_in(part));
    if (taken.empty()) whole.header = journal.header;
    const auto difference = difference_of_runs(whole.header, journal.header);
    if (!difference.empty())
      throw InputError(
          fmt::format("{} and {} are of different runs: {}", parts.front().string(), part.string(), difference));
    const auto [at, fresh] = taken.try_emplace(journal.header.shard, part.string());
    if (!fresh)
      throw InputError(fmt::format("{} and {} are both shard {}/{}", at->second, part.string(), journal.header.shard,
                                   journal.header.shards));
    require_finished(journal, part);
    whole.done.resize(journal.done.size());
    for (std::size_t unit = 0; unit < journal.done.size(); ++unit) {
      if (journal.done[unit] && whole.done[unit])
        throw InputError(fmt::format("{}: unit {} is in another shard too", part.string(), unit));
      whole.done[unit] = whole.done[unit] || journal.done[unit];
    }
    whole.gathered.merge(std::move(journal.gathered));
    whole.sessions.insert(whole.sessions.end(), journal.sessions.begin(), journal.sessions.end());
  }
  std::vector<std::string> missing;
  for (int shard = 0; shard < whole.header.shards; ++shard)
    if (!taken.contains(shard)) missing.push_back(fmt::format("{}/{}", shard, whole.header.shards));
  if (!missing.empty()) throw InputError(fmt::format("missing: shard {}", fmt::join(missing, ", ")));
  whole.header.shard = 0;
  whole.header.shards = 1;
  whole.header.shard_units = whole.header.units;
  require_finished(whole, out);
  return write_report(out, std::move(whole));
}

std::string summary_of_journal(const std::filesystem::path& journal) {
  Journal read = reports::read_journal(journal);
  RunResult result = result_of(read);
  for (const auto& [place, part] : whole_fields(read.gathered))
    result.fields.push_back(reports::unwritten_entry(part.image.arrays, part.title, part.shown, scale_of(part)));
  return reports::summary_json(result);
}

}  // namespace cageproof::validation
