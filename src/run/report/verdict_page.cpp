#include "report/verdict_page.hpp"

#include <fmt/format.h>

#include <array>
#include <stdexcept>
#include <string_view>

namespace matrigrate::report {

namespace {

using Json = nlohmann::ordered_json; // NaN is written as null

Json statement_json(const Statement& s) {
  Json details = Json::array();
  for (const Sentences& one : s.details)
    if (!one.list.empty()) details.push_back({{"name", one.name}, {"sentences", one.list}});
  Json plots = Json::array();
  for (const Plot& plot : s.plots) plots.push_back(plot_json(plot));
  Json pictures = Json::array();
  for (const draw::Picture& p : s.pictures)
    pictures.push_back({{"name", p.name}, {"caption", p.caption}, {"svg", p.svg}});
  return {{"id", s.id},         {"kind", s.kind},           {"sentence", s.sentence}, {"verdict", to_string(s.verdict)},
          {"caveat", s.caveat}, {"published", s.published}, {"brief", s.brief},       {"why_not", s.why_not},
          {"checks", s.checks}, {"claims", s.claims},       {"details", details},     {"studies", s.studies},
          {"plots", plots},     {"pictures", pictures}};
}

} // namespace

std::string to_string(Verdict verdict) {
  constexpr std::array names{"holds", "in direction", "does not hold", "undecided"};
  return names.at(static_cast<std::size_t>(verdict));
}

Json plot_json(const Plot& plot) {
  constexpr std::array<std::string_view, 3> marks{"line", "dashed", "points"};
  Json series = Json::array();
  int next = 0;
  for (const Series& s : plot.series) {
    if (s.x.size() != s.y.size())
      throw std::invalid_argument(
          fmt::format("series '{}' of a plot has {} x and {} y", s.label, s.x.size(), s.y.size()));
    series.push_back({{"label", s.label},
                      {"x", s.x},
                      {"y", s.y},
                      {"mark", marks.at(static_cast<std::size_t>(s.mark))},
                      {"colour", s.colour >= 0 ? s.colour : next++}});
  }
  return {{"name", plot.name},       {"title", plot.title}, {"caption", plot.caption}, {"x_label", plot.x_label},
          {"y_label", plot.y_label}, {"log_x", plot.log_x}, {"log_y", plot.log_y},     {"series", series}};
}

Json verdict_data(const VerdictReport& report) {
  Json statements = Json::array();
  for (const Statement& statement : report.statements) statements.push_back(statement_json(statement));
  return {{"format", "matrigrate-verdicts"}, {"version", 1},
          {"title", report.title},           {"facts", report.facts},
          {"setting", report.setting},       {"statements", statements},
          {"studies", report.studies},       {"provenance", report.provenance},
          {"citation", citation()}};
}

} // namespace matrigrate::report
