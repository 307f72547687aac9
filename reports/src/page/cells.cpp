// SPDX-License-Identifier: MIT
#include "digest.h"
#include "figure.h"
#include "page_data.h"
#include "page_template.h"
#include "worst_places.h"

#include <fmt/format.h>

#include <stdexcept>

namespace cageproof::reports {
namespace {

// Steps of the colour scale, in conditioned units. The first is the promise, then four, eight, twelve digits are lost.
const char* conditioned_class(double max) {
  return max <= 64 ? "e0" : max <= 1e4 ? "e1" : max <= 1e8 ? "e2" : max <= 1e12 ? "e3" : "e4";
}

}  // namespace

std::string cell_text(const ResultRow& row) { return row.samples == 0 ? "–" : figure_text(row); }

std::string unit_text(const std::string& unit) {
  if (unit == "of what is stated") return "times the error that it states itself";
  if (unit == "of the radius") return "times the enclosure's radius";
  if (unit == "units of u") return "roundings of the result (u)";
  return unit;
}

std::string cell_class(const ResultRow& row) {
  if (row.samples == 0 && row.verdict != Verdict::Broken) return "ill";
  if (row.is_ill_posed() && row.verdict != Verdict::Broken) return "ill";
  std::string css = row.unit == "conditioned"      ? conditioned_class(row.max)
                    : row.verdict == Verdict::Kept ? "e0"
                                                   : "plain";
  if (row.verdict == Verdict::Broken) css += " broken";
  if (row.verdict == Verdict::NotPromised || row.verdict == Verdict::Undecided) css += " open";
  return css;
}

std::string page_of(const RowKey& row) {
  const RowHome home = home_of(row);
  return fmt::format("{}/{}.html", home.folder, file_name(home.name));
}

std::string cell_id(const RowKey& row) {
  // The page's own subject is left out.
  const std::string& varied = row.section == RowKey::Section::Element ? row.setting : row.subject;
  std::string id = row.check;
  for (const std::string* part : {&varied, &row.evaluation, &row.scalar, &row.place})
    if (!part->empty()) id += "." + file_name(*part);
  return fmt::format("{}.{}", id, row.order);
}

Data error_cell(const ResultRow* row, const std::string& page) {
  Data data;
  data.set("any", row != nullptr);
  data.set("class", row ? cell_class(*row) : "none");
  if (!row) return data;
  data.set("text", cell_text(*row) + (row->verdict == Verdict::Broken ? " ✗" : ""));
  data.set("id", cell_id(*row));
  data.set("href", (page_of(*row) == page ? "" : page_of(*row)) + "#" + cell_id(*row));
  return data;
}

void set_list(Data& data, const std::string& name, const Data& list) {
  data.set("has_" + name, list.is_non_empty_list());
  data.set(name, list);
}

std::string anchor(std::string_view kind, std::string_view name) { return fmt::format("{}-{}", kind, file_name(name)); }

std::string duration_text(double nanoseconds) {
  const auto text = [](double x, const char* unit) {
    return fmt::format(fmt::runtime(x < 9.95 ? "{:.1f} {}" : "{:.0f} {}"), x, unit);
  };
  if (nanoseconds < 995) return fmt::format("{:.0f} ns", nanoseconds);
  return nanoseconds < 995e3 ? text(nanoseconds / 1e3, "us") : text(nanoseconds / 1e6, "ms");
}

Data common_data(const RunResult& result, const std::string& root) {
  Data data;
  data.set("style", kPageStyle);
  data.set("script", kPageScript);
  data.set("root", root);
  data.set("version", result.version);
  data.set("suite", result.suite);
  data.set("seed", fmt::format("{}", result.seed));
  return data;
}

std::string rendered(const char* text, const char* name, const Data& data) {
  kainjow::mustache::mustache sheet(text);
  if (!sheet.is_valid()) throw std::logic_error(fmt::format("{}: {}", name, sheet.error_message()));
  return sheet.render(data);
}

}  // namespace cageproof::reports
