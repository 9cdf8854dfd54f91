#include "draw/text_plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>

namespace matrigrate::draw {

namespace {

/// The largest finite value, or 1.
double largest(const TextPlot& plot) {
  double high = 0.0;
  for (const std::vector<double>* curve : {&plot.points, &plot.comparison})
    for (const double value : *curve)
      if (std::isfinite(value)) high = std::max(high, value);
  return high > 0.0 ? high : 1.0;
}

/// The value of a curve at a column.
double at_column(std::span<const double> values, std::size_t column, std::size_t columns) {
  return values[column * (values.size() - 1) / std::max<std::size_t>(1, columns - 1)];
}

void mark(std::vector<std::string>& rows, std::span<const double> values, double high, char sign) {
  const std::size_t columns = rows.front().size();
  for (std::size_t column = 0; column < columns; ++column) {
    const double share = at_column(values, column, columns) / high;
    if (!std::isfinite(share) || share < 0.0 || share > 1.0) continue;
    const auto last = static_cast<double>(rows.size() - 1);
    rows[rows.size() - 1 - static_cast<std::size_t>(std::lround(share * last))][column] = sign;
  }
}

} // namespace

std::string to_text(const TextPlot& plot) {
  const double high = largest(plot);
  std::vector<std::string> rows(static_cast<std::size_t>(plot.height),
                                std::string(static_cast<std::size_t>(plot.width), ' '));
  mark(rows, plot.comparison, high, '.');
  mark(rows, plot.points, high, '*');
  std::string text;
  for (std::size_t k = 0; k < rows.size(); ++k) {
    const std::string value = k == 0 ? fmt::format("{:.3g}", high) : k + 1 == rows.size() ? "0" : "";
    std::string line = fmt::format("{:>9} |{}", value, rows[k]);
    line.erase(line.find_last_not_of(' ') + 1);
    text += line + "\n";
  }
  const std::string begin = fmt::format("{} = {:.4g}", plot.x_name, plot.x_low);
  const std::string end = fmt::format("{:.4g}{}{}", plot.x_high, plot.x_unit.empty() ? "" : " ", plot.x_unit);
  return text
         + fmt::format("{:>9}  {}{:>{}}\n", "", begin, end,
                       std::max(static_cast<int>(end.size()) + 1, plot.width - static_cast<int>(begin.size())));
}

} // namespace matrigrate::draw
