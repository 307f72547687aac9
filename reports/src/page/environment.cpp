// SPDX-License-Identifier: MIT
// All that may differ between runs that found the same: processes, machines, and times.
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
  page.set("settings", pairs(result.settings));
  page.set("sessions", sessions);
  set_list(page, "session_notes", notes);
  set_list(page, "advices", advices);
}

}  // namespace cageproof::reports
