// SPDX-License-Identifier: MIT
// Facts that may differ between runs with the same findings: processes, machines, and times.
#include "advice.h"
#include "page_data.h"

#include <fmt/format.h>

namespace cageproof::reports {
namespace {

Data pairs(const std::map<std::string, std::string>& map) {
  Data list{Data::type::list};
  for (const auto& [key, value] : map) {
    Data data;
    data.set("key", key);
    data.set("value", value);
    list << data;
  }
  return list;
}

// "2026-11-27 07:32 UTC", of "2026-11-27T07:32:51Z".
std::string minute_of(const std::string& started) {
  if (started.size() < 16 || started[10] != 'T') return started;
  return started.substr(0, 10) + " " + started.substr(11, 5) + " UTC";
}

// When the run was started, how often it was taken up again, and by which program.
std::string when_text(const std::vector<Session>& sessions) {
  double seconds = 0;
  for (const Session& session : sessions) seconds += session.seconds;
  std::string text = fmt::format("Started {}, took {:.0f} s", minute_of(sessions.front().started), seconds);
  if (sessions.size() > 1) text += fmt::format(" in {} sessions", sessions.size());
  const auto& machine = sessions.front().machine;
  if (const auto commit = machine.find("commit"); commit != machine.end() && !commit->second.empty())
    text += ", commit " + commit->second.substr(0, 12);
  return text + ".";
}

}  // namespace

void set_environment(Data& page, const RunResult& result) {
  Data sessions{Data::type::list}, notes{Data::type::list}, advices{Data::type::list};
  for (const Session& session : result.sessions) {
    Data data;
    data.set("command_line", session.command_line);
    data.set("started", session.started);
    data.set("seconds", fmt::format("{:.1f}", session.seconds));
    data.set("machine", pairs(session.machine));
    sessions << data;
  }
  for (const std::string& note : result.session_notes) notes << Data(note);
  for (const std::string& formula : subjects(result, ResultRow::Section::Element)) {
    const std::string text = advice(result, formula);
    if (text.empty()) continue;
    Data data;
    data.set("formula", formula);
    data.set("page", page_of({RowKey::Section::Element, formula, "", "", "", "", "", 0}));
    data.set("text", text);
    advices << data;
  }
  if (!result.sessions.empty()) page.set("ran_when", when_text(result.sessions));
  page.set("settings", pairs(result.settings));
  page.set("sessions", sessions);
  set_list(page, "session_notes", notes);
  set_list(page, "advices", advices);
}

}  // namespace cageproof::reports
