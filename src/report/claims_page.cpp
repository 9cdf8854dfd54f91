#include "report/claims_page.hpp"

#include "draw/svg.hpp"
#include "report/page_parts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

namespace matrigrate::report {

namespace {

std::string_view style_of(const std::string& verdict) {
  return verdict == "holds" ? "holds" : verdict == "undecided" ? "undecided" : "fails";
}

std::string verdict_html(const ClaimSection& claim) {
  std::string text =
      fmt::format("<span class=\"{}\">{}</span>", style_of(claim.verdict), draw::svg::escape(claim.verdict));
  if (!claim.caveat.empty()) text += fmt::format(" <span class=\"caveat\">{}</span>", draw::svg::escape(claim.caveat));
  return text;
}

std::string list(std::string_view name, const std::vector<std::string>& sentences) {
  if (sentences.empty()) return {};
  std::string text = fmt::format("<dt>{}</dt>\n<dd><ul>\n", name);
  for (const std::string& sentence : sentences) text += fmt::format("<li>{}</li>\n", draw::svg::escape(sentence));
  return text + "</ul></dd>\n";
}

std::string summary_html(const std::vector<ClaimSection>& claims) {
  const auto holding = std::ranges::count(claims, std::string("holds"), &ClaimSection::verdict);
  const auto undecided = std::ranges::count(claims, std::string("undecided"), &ClaimSection::verdict);
  std::string text = fmt::format("<p>{} of {} hold{}.</p>\n", holding, claims.size(),
                                 undecided > 0 ? fmt::format(", {} undecided", undecided) : "");
  text += "<table class=\"checks claims\">\n<thead><tr>";
  for (const char* column : {"row", "claim", "published", "ours", "verdict", "why not"})
    text += fmt::format("<th scope=\"col\">{}</th>", column);
  text += "</tr></thead>\n<tbody>\n";
  const auto cell = [](std::string_view label, const std::string& html) {
    return html.empty() ? std::string("<td class=\"nothing\"></td>")
                        : fmt::format("<td data-label=\"{}\"><span>{}</span></td>", label, html);
  };
  for (std::size_t k = 0; k < claims.size(); ++k)
    text += fmt::format(
        "<tr><td><a href=\"#c{}\">{}</a> {}</td>{}{}{}{}{}</tr>\n", k + 1, draw::svg::escape(claims[k].id),
        draw::svg::escape(claims[k].kind), cell("claim", draw::svg::escape(claims[k].sentence)),
        cell("published", draw::svg::escape(claims[k].published)), cell("ours", draw::svg::escape(claims[k].brief)),
        cell("verdict", verdict_html(claims[k])), cell("why not", draw::svg::escape(claims[k].why_not)));
  return text + "</tbody>\n</table>\n";
}

std::string claim_html(const ClaimSection& claim, std::size_t number) {
  std::string text = fmt::format("<section id=\"c{}\">\n<h2>{}: {}</h2>\n<p>Verdict: {}</p>\n<dl>\n", number,
                                 draw::svg::escape(claim.id), draw::svg::escape(claim.sentence), verdict_html(claim));
  if (!claim.published.empty())
    text += fmt::format("<dt>published</dt>\n<dd>{}</dd>\n", draw::svg::escape(claim.published));
  text += list("ours; intervals are those of 95 %", claim.ours);
  text += list("conditions, each with its statistic", claim.conditions) + "</dl>\n";
  return text + figures_html(claim.figures, fmt::format("c{}", number)) + "</section>\n";
}

} // namespace

std::string claims_page(const std::string& title, const std::vector<Fact>& facts, const std::string& setting,
                        const std::vector<ClaimSection>& claims, const std::string& provenance) {
  const bool caveat = std::ranges::any_of(claims, [](const ClaimSection& claim) { return !claim.caveat.empty(); });
  std::string text = page_head(title);
  for (const Fact& fact : facts)
    text += fmt::format("<p class=\"fact\">{}: {}</p>\n", draw::svg::escape(fact.name), draw::svg::escape(fact.value));
  if (!setting.empty())
    text += fmt::format("<p{}>{}</p>\n", caveat ? " class=\"notice\"" : "", draw::svg::escape(setting));
  text += summary_html(claims);
  for (std::size_t k = 0; k < claims.size(); ++k) text += claim_html(claims[k], k + 1);
  return text + page_end(provenance);
}

} // namespace matrigrate::report
