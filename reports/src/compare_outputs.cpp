// SPDX-License-Identifier: MIT
// Files for programs that watch figures over time.
#include "cageproof/reports/compare_formats.h"

#include "compare_xml.h"
#include "json_value.h"

#include <fmt/format.h>

#include <algorithm>

namespace cageproof::reports {
namespace {

struct Badge {
  std::string label, message, colour, hex;
};

Badge badge_of(const Changes& changes) {
  const bool good = changes.broken == 0 && !changes.fails();
  Badge badge{changes.benchmarks ? "speed" : "accuracy", "", good ? "brightgreen" : "red", good ? "#4c1" : "#e05d44"};
  const std::size_t worse = changes.count(Change::Kind::Worse) + changes.count(Change::Kind::Gone);
  if (changes.broken > 0) badge.message = fmt::format("{} of {} promises broken", changes.broken, changes.promises);
  else if (worse > 0) badge.message = fmt::format("{} got worse", worse);
  else if (changes.benchmarks) badge.message = fmt::format("{} not slower", changes.compared);
  else badge.message = fmt::format("{} promises kept", changes.promises);
  return badge;
}

}  // namespace

std::string smaller_is_better_json(const Changes& changes) {
  Json json = Json::array();
  for (const TrackedFigure& figure : changes.figures) {
    // Its charts take finite numbers only; an infinite error is the largest number.
    Json entry{{"name", figure.name}, {"unit", figure.unit}, {"value", std::min(figure.value, 1e300)}};
    if (figure.spread > 0) entry["range"] = fmt::format("{:.3g}", figure.spread);
    json.push_back(std::move(entry));
  }
  return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string bencher_json(const Changes& changes) {
  Json json = Json::object();
  for (const TrackedFigure& figure : changes.figures) {
    const char* measure = figure.unit == "ns"         ? "latency"
                          : figure.unit == "promises" ? "promises-broken"
                                                      : "conditioned-error";
    const double value = std::min(figure.value, 1e300);
    Json metric{{"value", value}};
    if (figure.spread > 0) {
      metric["lower_value"] = std::max(0., value - figure.spread);
      metric["upper_value"] = value + figure.spread;
    }
    json[figure.name][measure] = std::move(metric);
  }
  return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string history_line(const Changes& changes, const std::string& commit) {
  Json figures = Json::object();
  for (const TrackedFigure& figure : changes.figures) figures[figure.name] = json_number(figure.value);
  return dump(Json{{"schema", "cageproof-history"},
                   {"schema_version", 1},
                   {"date", changes.date},
                   {"commit", commit.empty() ? changes.commit : commit},
                   {"figures", figures}}) +
         "\n";
}

std::string badge_json(const Changes& changes) {
  const Badge badge = badge_of(changes);
  return dump(Json{{"schemaVersion", 1}, {"label", badge.label}, {"message", badge.message}, {"color", badge.colour}}) +
         "\n";
}

std::string badge_svg(const Changes& changes) {
  const Badge badge = badge_of(changes);
  // Verdana at 11 pixels is about seven wide per letter; textLength makes it so where the font differs.
  const auto width = [](const std::string& text) { return 7 * static_cast<int>(text.size()); };
  const int left = width(badge.label) + 10, right = width(badge.message) + 10;
  const auto words = [](const std::string& text, int x, int length) {
    return fmt::format("<text x=\"{}\" y=\"14\" textLength=\"{}\" lengthAdjust=\"spacingAndGlyphs\">{}</text>\n", x,
                       length, xml_text(text));
  };
  return fmt::format(
             "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{}\" height=\"20\" role=\"img\">\n<title>{}: "
             "{}</title>\n"
             "<rect width=\"{}\" height=\"20\" fill=\"#555\"/>\n<rect x=\"{}\" width=\"{}\" height=\"20\" "
             "fill=\"{}\"/>\n"
             "<g fill=\"#fff\" font-family=\"Verdana,DejaVu Sans,sans-serif\" font-size=\"11\">\n",
             left + right, xml_text(badge.label), xml_text(badge.message), left, left, right, badge.hex) +
         words(badge.label, 5, width(badge.label)) + words(badge.message, left + 5, width(badge.message)) +
         "</g>\n</svg>\n";
}

}  // namespace cageproof::reports
