#include "apps/reproduce/output.hpp"

#include "apps/study/files.hpp"
#include "apps/terminal/terminal.hpp"
#include "study_report/claim_report.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

namespace matrigrate::apps {

namespace {

Colour colour_of(study::Verdict verdict) {
  return verdict == study::Verdict::holds           ? Colour::good
         : verdict == study::Verdict::does_not_hold ? Colour::bad
                                                    : Colour::warning;
}

} // namespace

std::string reproduction_text(const std::vector<study::JudgedClaim>& rows) {
  std::string text;
  for (const study::JudgedClaim& row : rows) {
    text += fmt::format("{:<4}{}{}\n    {}\n", row.id,
                        coloured(to_string(row.finding.verdict), colour_of(row.finding.verdict), Stream::out),
                        row.caveat.empty() ? "" : fmt::format(" ({})", row.caveat), row.sentence);
    if (!row.published.empty()) text += fmt::format("    published: {}\n", row.published);
    for (const std::string& line : row.finding.ours) text += fmt::format("    ours: {}\n", line);
    for (const std::string& line : row.finding.conditions) text += fmt::format("      {}\n", line);
    if (row.second_edition)
      text += fmt::format("    by the second edition of the rules: {}\n", to_string(row.second_edition->verdict));
    if (row.in_larger_disc)
      text +=
          fmt::format("    {}\n      {}\n", study::with_larger_disc(*row.in_larger_disc), row.in_larger_disc->brief);
  }
  return text;
}

std::string reproduction_table(const std::vector<study::JudgedClaim>& rows, const study::Evidence& evidence) {
  std::string text;
  for (const auto& [name, ensemble] : evidence) text += fmt::format("{}: {}\n", name, study::ends_text(ensemble));
  return text + "\n" + claims_text(rows);
}

std::string reproduction_json(const std::vector<study::JudgedClaim>& rows, const std::string& setting,
                              bool as_published) {
  using Json = nlohmann::ordered_json;
  Json list = Json::array();
  for (const study::JudgedClaim& row : rows) list.push_back(study::claim_json(row));
  return Json{{"setting", setting}, {"as_published", as_published}, {"rows", list}}.dump(2, ' ', false,
                                                                                         Json::error_handler_t::replace)
         + "\n";
}

} // namespace matrigrate::apps
