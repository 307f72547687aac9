// SPDX-License-Identifier: MIT
#include "cageproof/reports/journal.h"

#include "cageproof/core/input_error.h"
#include "cageproof/core/whole_file.h"
#include "cageproof/reports/checked_file.h"
#include "cageproof/reports/packed_file.h"
#include "partial_result_json.h"

#include <fmt/format.h>

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <stdexcept>
#include <system_error>
#include <tuple>

namespace cageproof::reports {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view schema = "cageproof-journal";
constexpr int schema_version = 2;
// Journals before this call the recommended evaluations of triangles and segments closed_form, which is algebra today.
constexpr int schema_of_hybrids = 2;

[[noreturn]] void fail_journal(const fs::path& path, const std::string& reason) {
  throw InputError(fmt::format("cannot write {}: {}", path.string(), reason));
}

Json json_of(const Session& session) {
  Json json{{"started", session.started},
            {"seconds", json_number(session.seconds)},
            {"command_line", session.command_line},
            {"machine", session.machine}};
  for (const EvaluationTime& time : session.times)
    json["times"].push_back(Json::array({time.formula, time.evaluation, time.order, json_number(time.nanoseconds)}));
  return json;
}

Session session_of(const Json& json) {
  Session session;
  session.started = json.at("started").get<std::string>();
  session.seconds = number_of(json.at("seconds")).value_or(0);
  session.command_line = json.at("command_line").get<std::string>();
  session.machine = json.at("machine").get<std::map<std::string, std::string>>();
  if (json.contains("times"))
    for (const Json& time : json["times"])
      session.times.push_back({time.at(0).get<std::string>(), time.at(1).get<std::string>(), time.at(2).get<int>(),
                               number_of(time.at(3)).value_or(0)});
  return session;
}

std::string head(const JournalHeader& header, const std::vector<Session>& sessions) {
  Json json{{"schema", schema},
            {"schema_version", schema_version},
            {"version", header.version},
            {"options", header.options},
            {"settings", header.settings},
            {"notes", header.notes},
            {"units", header.units},
            {"shard", header.shard},
            {"shards", header.shards},
            {"shard_units", header.shard_units},
            {"environment", {{"sessions", Json::array()}}}};
  for (const Session& session : sessions) json["environment"]["sessions"].push_back(json_of(session));
  return dump(json) + "\n";
}

bool is_head(const Json& json) { return json.is_object() && json.contains("schema") && json["schema"] == schema; }

JournalHeader header_of(const Json& json) {
  if (const Json& version = json.at("schema_version");
      !version.is_number_integer() || version < 1 || version > schema_version)
    throw std::invalid_argument(
        fmt::format("a journal of schema version {}, this program reads 1 to {}", dump(version), schema_version));
  JournalHeader header;
  header.version = json.at("version").get<std::string>();
  header.options = json.at("options").get<std::map<std::string, std::string>>();
  header.settings = json.at("settings").get<std::map<std::string, std::string>>();
  header.notes = json.at("notes").get<std::vector<std::string>>();
  header.units = json.at("units").get<std::size_t>();
  header.shard = json.at("shard").get<int>();
  header.shards = json.at("shards").get<int>();
  header.shard_units = json.at("shard_units").get<std::size_t>();
  if (header.shards < 1 || header.shard < 0 || header.shard >= header.shards)
    throw std::invalid_argument("no such shard");
  return header;
}

// An older line with its recommended closed forms named as they are today. Those of quads keep their name.
Json with_hybrids(Json line) {
  if (line.contains("rows"))
    for (Json& row : line["rows"]) {
      Json& key = row.at("key");
      if (row.value("role", "") == "recommended" && key.at(2) == "closed_form" &&
          !key.at(1).get<std::string>().starts_with("quad."))
        key[2] = "hybrid";
    }
  return line;
}

// Lines after the header. Results in a line without units are those of the units of a later line.
class Reader {
 public:
  explicit Reader(Journal& journal) : journal_(journal) {}

  /// \param version the journal's schema version
  void take(const Json& line, int version) {
    if (version < schema_of_hybrids) return take(with_hybrids(line), schema_version);
    if (line.contains("session")) journal_.sessions.push_back(session_of(line["session"]));
    PartialResult found = partial_result_of(line);
    open_ = open_ || !found.rows.empty() || !found.fields.empty() || !found.meshes.empty() || !found.errata.empty() ||
            !found.refused.empty();
    journal_.gathered.merge(std::move(found));
    if (line.contains("seconds") && !journal_.sessions.empty()) {
      double& seconds = journal_.sessions.back().seconds;
      seconds = std::max(seconds, number_of(line["seconds"]).value_or(0));
    }
    if (!line.contains("units")) return;
    for (const Json& range : line["units"]) take_units(range.at(0).get<std::size_t>(), range.at(1).get<std::size_t>());
    open_ = false;
  }
  /// Whether results have been read whose units have not.
  bool open() const { return open_; }

 private:
  void take_units(std::size_t first, std::size_t last) {
    for (std::size_t unit = first; unit <= last; ++unit) {
      if (unit >= journal_.done.size()) throw std::invalid_argument(fmt::format("there is no unit {}", unit));
      if (journal_.done[unit]) throw std::invalid_argument(fmt::format("unit {} is there twice", unit));
      journal_.done[unit] = true;
    }
  }
  Journal& journal_;
  bool open_ = false;
};

void require_file(const fs::path& path) {
  std::error_code ignored;
  if (!fs::is_regular_file(path, ignored)) throw InputError(fmt::format("cannot read {}: no journal", path.string()));
}

}  // namespace

std::optional<JournalHeader> find_journal_header(const fs::path& path) {
  std::error_code ignored;
  if (!fs::is_regular_file(path, ignored)) return std::nullopt;
  try {
    LineFile file(path);
    const auto line = file.next();
    if (!line || !file.whole()) return std::nullopt;
    const Json json = Json::parse(*line, nullptr, false);
    if (!is_head(json)) return std::nullopt;
    return header_of(json);
  } catch (const std::exception&) {
    return std::nullopt;
  }
}

Journal read_journal(const fs::path& path) {
  require_file(path);
  LineFile file(path);
  Journal journal;
  Reader reader(journal);
  std::optional<std::string> following = file.next();
  int version = schema_version;
  for (int number = 1; following; ++number) {
    // Each line is written at once with its end: one without is torn.
    if (!file.whole()) break;
    const std::string line = std::move(*following);
    following = file.next();
    const auto bad = [&](const std::string& reason) {
      throw InputError(fmt::format("{}:{}: {}", path.string(), number, reason));
    };
    const Json json = Json::parse(line, nullptr, false);
    if (number == 1 && !is_head(json)) bad("not the journal of a verification");
    if (json.is_discarded() && !following) break;
    if (!json.is_object()) bad("malformed");
    try {
      if (number > 1) {
        reader.take(json, version);
        continue;
      }
      journal.header = header_of(json);
      version = json["schema_version"].get<int>();
      for (const Json& session : json.at("environment").at("sessions")) journal.sessions.push_back(session_of(session));
      journal.done.resize(journal.header.units);
    } catch (const Json::exception& error) {
      bad("malformed");
    } catch (const std::invalid_argument& error) {
      bad(error.what());
    }
  }
  if (journal.done.empty() && journal.sessions.empty())
    throw InputError(path.string() + ": not the journal of a verification");
  if (reader.open()) throw InputError(path.string() + ": the journal is cut off");
  return journal;
}

std::string journal_head(const JournalHeader& header, const Session& session) { return head(header, {session}); }

void put_journal(const Journal& journal, const std::function<void(std::string_view)>& put) {
  put(head(journal.header, journal.sessions));
  // Rows that were measured at the same inputs stand together, which packs to two thirds.
  std::vector<const std::pair<const RowKey, Tally>*> rows;
  rows.reserve(journal.gathered.rows.size());
  for (const auto& row : journal.gathered.rows) rows.push_back(&row);
  std::ranges::stable_sort(rows, {}, [](const auto* row) {
    const RowKey& key = row->first;
    return std::tie(key.section, key.subject, key.setting, key.scalar, key.check, key.place);
  });
  for (const auto* row : rows) put(dump(Json{{"rows", Json::array({row_json(row->first, row->second)})}}) + "\n");
  // One at a time: as JSON a field takes several times its room.
  const auto put_one = [&](auto PartialResult::*member, auto key, auto value) {
    PartialResult one;
    (one.*member).emplace(std::move(key), std::move(value));
    put(dump(partial_result_json(one)) + "\n");
  };
  for (auto& [place, field] : whole_fields(journal.gathered))
    put_one(&PartialResult::fields, std::pair(place, std::size_t{0}), std::move(field));
  for (const auto& [name, mesh] : journal.gathered.meshes) put_one(&PartialResult::meshes, name, mesh);
  for (const auto& [place, erratum] : journal.gathered.errata) put_one(&PartialResult::errata, place, erratum);
  for (const auto& [reason, names] : journal.gathered.refused) put_one(&PartialResult::refused, reason, names);
  Json units = Json::array();
  if (journal.header.units > 0) units.push_back(Json::array({std::size_t{0}, journal.header.units - 1}));
  put(dump(Json{{"units", units}}) + "\n");
}

std::string journal_text(const Journal& journal) {
  std::string text;
  put_journal(journal, [&](std::string_view line) { text += line; });
  return text;
}

namespace {

// A file that only this process writes to.
int locked_file(const fs::path& path) {
  const int file = ::open(path.c_str(), O_RDWR | O_APPEND | O_CLOEXEC);
  if (file < 0) fail_journal(path, std::generic_category().message(errno));
  int locked = 0;
  do locked = ::flock(file, LOCK_EX | LOCK_NB);
  while (locked != 0 && errno == EINTR);
  if (locked == 0) return file;
  const int reason = errno;
  ::close(file);
  if (reason == EWOULDBLOCK) throw InputError(fmt::format("{}: another process is writing to it", path.string()));
  fail_journal(path, fmt::format("it cannot be locked against a second process that writes to it ({}); choose a folder "
                                 "on a file system that has locks",
                                 std::generic_category().message(reason)));
}

}  // namespace

JournalWriter::JournalWriter(const fs::path& path) : path_(path), file_(locked_file(path)) {
  if (LineFile(path_).packed()) {
    // A finished journal is packed. Lines can be added only to its text, which takes its place in one step.
    ::close(file_);
    replace_file(path_, read_packed(path_));
    file_ = locked_file(path_);
  }
  // The end of the last line that is whole.
  const std::string text = read_file(path_);
  std::size_t end = text.rfind('\n') + 1;
  if (end > 0) {
    const std::size_t before = end < 2 ? std::string::npos : text.rfind('\n', end - 2);
    const std::size_t start = before == std::string::npos ? 0 : before + 1;
    if (Json::parse(text.substr(start, end - start), nullptr, false).is_discarded()) end = start;
  }
  if (end < text.size() && ::ftruncate(file_, static_cast<off_t>(end)) != 0) {
    const int reason = errno;
    ::close(file_);
    fail_journal(path_, std::generic_category().message(reason));
  }
}

JournalWriter::~JournalWriter() { ::close(file_); }

void JournalWriter::append(const std::string& line) {
  const std::scoped_lock lock(mutex_);
  // After a torn line nothing may follow: torn, the last line can be told and dropped.
  if (failed_) fail_journal(path_, "an earlier line could not be written");
  const ssize_t written = ::write(file_, line.data(), line.size());
  if (written == static_cast<ssize_t>(line.size())) return;
  failed_ = true;
  fail_journal(path_, std::generic_category().message(written < 0 ? errno : ENOSPC));
}

void JournalWriter::add_session(const Session& session) { append(dump(Json{{"session", json_of(session)}}) + "\n"); }

void JournalWriter::add(std::size_t unit, const PartialResult& found, double seconds) {
  Json line{{"units", Json::array({Json::array({unit, unit})})}, {"seconds", json_number(seconds)}};
  line.update(partial_result_json(found));
  append(dump(line) + "\n");
}

}  // namespace cageproof::reports
