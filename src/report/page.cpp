#include "report/page.hpp"

#include "draw/svg.hpp"
#include "report/page_parts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <stdexcept>

namespace matrigrate::report {

namespace {

constexpr std::array<std::string_view, 6> check_columns{"quantity",  "measured",           "expected",
                                                        "tolerance", "why this tolerance", "verdict"};

std::string badge(bool holds) {
  return fmt::format("<span class=\"{}\">{}</span>", holds ? "holds" : "fails", verdict(holds));
}

std::string check_table(const PageSection& section) {
  if (section.check_rows.empty()) return "<p>No checks.</p>\n";
  std::string out = "<table class=\"checks\">\n<thead><tr>";
  for (const auto& column : check_columns) out += fmt::format("<th scope=\"col\">{}</th>", column);
  out += "</tr></thead>\n<tbody>\n";
  for (const auto& row : section.check_rows) {
    if (row.size() != check_columns.size())
      throw std::invalid_argument(fmt::format("a check of '{}' has {} fields", section.title, row.size()));
    out += "<tr>";
    for (std::size_t c = 0; c < row.size(); ++c) {
      const bool last = c + 1 == row.size();
      const bool known = last && (row[c] == verdict(true) || row[c] == verdict(false));
      out += fmt::format("<td data-label=\"{}\"{}><span>{}</span></td>", check_columns[c],
                         last ? " class=\"verdict\"" : "",
                         known ? badge(row[c] == verdict(true)) : draw::svg::escape(row[c]));
    }
    out += "</tr>\n";
  }
  return out + "</tbody>\n</table>\n";
}

std::string section_html(const PageSection& section, std::size_t number) {
  std::string out = fmt::format("<section id=\"s{}\">\n<h2>{}</h2>\n", number, draw::svg::escape(section.title));
  out += fmt::format("<p>{}</p>\n<p>Verdict: {}</p>\n", draw::svg::escape(section.summary), badge(section.holds));
  out += check_table(section);
  if (!section.remarks.empty()) {
    out += "<ul>\n";
    for (const auto& remark : section.remarks) out += fmt::format("<li>{}</li>\n", draw::svg::escape(remark));
    out += "</ul>\n";
  }
  return out + figures_html(section.figures, fmt::format("s{}", number)) + "</section>\n";
}

std::string summary_html(const std::vector<PageSection>& sections) {
  const auto holding =
      std::count_if(sections.begin(), sections.end(), [](const PageSection& section) { return section.holds; });
  std::string out = fmt::format("<p>{} of {} hold.</p>\n", holding, sections.size());
  out += "<table class=\"overview\">\n<thead><tr><th scope=\"col\">case</th><th scope=\"col\">what it verifies</th>"
         "<th scope=\"col\">verdict</th></tr></thead>\n<tbody>\n";
  for (std::size_t s = 0; s < sections.size(); ++s)
    out += fmt::format("<tr><td><a href=\"#s{}\">{}</a></td><td>{}</td><td class=\"verdict\">{}</td></tr>\n", s + 1,
                       draw::svg::escape(sections[s].title), draw::svg::escape(sections[s].summary),
                       badge(sections[s].holds));
  return out + "</tbody>\n</table>\n";
}

} // namespace

std::string verdict(bool holds) { return holds ? "holds" : "does not hold"; }

std::string page(const std::string& title, const std::vector<PageSection>& sections, const std::string& provenance) {
  std::string out = page_head(title) + summary_html(sections);
  for (std::size_t s = 0; s < sections.size(); ++s) out += section_html(sections[s], s + 1);
  return out + page_end(provenance);
}

} // namespace matrigrate::report
