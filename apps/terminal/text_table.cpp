#include "apps/terminal/text_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace matrigrate::apps {

std::string number_text(double value) { return std::isnan(value) ? "-" : fmt::format("{:.3g}", value); }

std::string interval_text(const statistics::Interval& i) {
  return std::isfinite(i.low) && std::isfinite(i.high) ? fmt::format("{:.3g} to {:.3g}", i.low, i.high) : "-";
}

std::string aligned(const std::vector<std::vector<std::string>>& rows, std::size_t words) {
  std::vector<std::size_t> width(rows.front().size(), 0);
  for (const auto& row : rows)
    for (std::size_t c = 0; c < row.size(); ++c) width[c] = std::max(width[c], row[c].size());
  std::string text;
  for (const auto& row : rows) {
    std::string line;
    for (std::size_t c = 0; c < row.size(); ++c)
      line += c < words ? fmt::format("  {:<{}}", row[c], width[c]) : fmt::format("  {:>{}}", row[c], width[c]);
    text += line.erase(line.find_last_not_of(' ') + 1) + "\n";
  }
  return text;
}

} // namespace matrigrate::apps
