#include "fields/samples.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <stdexcept>
#include <string>

namespace matrigrate::fields {

namespace {

constexpr double relative_slack = 1e-6; // of a spacing, within which nodes lie on a grid

std::vector<std::string_view> split(std::string_view text, char at) {
  std::vector<std::string_view> parts;
  for (;;) {
    const std::size_t end = text.find(at);
    std::string_view part = text.substr(0, end);
    while (!part.empty() && (part.back() == '\r' || part.back() == ' ')) part.remove_suffix(1);
    while (!part.empty() && part.front() == ' ') part.remove_prefix(1);
    parts.push_back(part);
    if (end == std::string_view::npos) return parts;
    text.remove_prefix(end + 1);
  }
}

double number(std::string_view field, std::size_t line) {
  double value = 0.0;
  const auto [end, error] = std::from_chars(field.data(), field.data() + field.size(), value);
  if (error != std::errc() || end != field.data() + field.size() || !std::isfinite(value))
    throw std::invalid_argument(fmt::format("line {}: \"{}\" is no finite number", line, field.substr(0, 40)));
  return value;
}

/// The different coordinates, in order.
std::vector<double> levels(std::vector<double> coordinates) {
  std::ranges::sort(coordinates);
  const double extent = coordinates.back() - coordinates.front();
  const auto same = [&](double a, double b) { return b - a <= 1e-9 * std::max(extent, 1e-9); };
  coordinates.erase(std::unique(coordinates.begin(), coordinates.end(), same), coordinates.end());
  return coordinates;
}

double spacing_of(const std::vector<double>& level, const char* axis) {
  if (level.size() < 2)
    throw std::invalid_argument(fmt::format("has one value of {} only; a grid has two at least", axis));
  const double step = (level.back() - level.front()) / static_cast<double>(level.size() - 1);
  for (std::size_t k = 0; k < level.size(); ++k)
    if (std::abs(level[k] - level.front() - step * static_cast<double>(k)) > relative_slack * step)
      throw std::invalid_argument(fmt::format("is no regular grid: {} is {} where {} is expected", axis, level[k],
                                              level.front() + step * static_cast<double>(k)));
  return step;
}

} // namespace

Vec2 Samples::end() const {
  return origin + Vec2(spacing.x() * static_cast<double>(columns - 1), spacing.y() * static_cast<double>(rows - 1));
}

double Samples::at(const Vec2& x) const {
  const auto cell = [](double position, std::size_t nodes) {
    const double inside = std::clamp(position, 0.0, static_cast<double>(nodes - 1));
    const auto k = std::min(static_cast<std::size_t>(inside), nodes < 2 ? 0 : nodes - 2);
    return std::pair(k, inside - static_cast<double>(k));
  };
  const auto [i, u] = cell((x.x() - origin.x()) / spacing.x(), columns);
  const auto [j, v] = cell((x.y() - origin.y()) / spacing.y(), rows);
  const auto value = [&](std::size_t column, std::size_t row) {
    return values[std::min(row, rows - 1) * columns + std::min(column, columns - 1)];
  };
  const double low = (1.0 - u) * value(i, j) + u * value(i + 1, j);
  const double high = (1.0 - u) * value(i, j + 1) + u * value(i + 1, j + 1);
  return (1.0 - v) * low + v * high;
}

Samples samples_from_csv(std::string_view csv, std::string_view column) {
  const std::vector<std::string_view> lines = split(csv, '\n');
  const std::vector<std::string_view> header = split(lines.front(), ',');
  const auto find = [&](std::string_view name) {
    const auto found = std::ranges::find(header, name);
    if (found == header.end())
      throw std::invalid_argument(
          fmt::format("has no column {}; its header is \"{}\"", name, lines.front().substr(0, 80)));
    return static_cast<std::size_t>(found - header.begin());
  };
  const std::size_t at_x = find("x_um"), at_y = find("y_um");
  if (column.empty() && header.size() < 3) throw std::invalid_argument("has no third column");
  const std::size_t at_value = column.empty() ? 2 : find(column);
  std::vector<double> x, y, value;
  for (std::size_t k = 1; k < lines.size(); ++k) {
    if (lines[k].empty()) continue;
    const std::vector<std::string_view> fields = split(lines[k], ',');
    if (fields.size() != header.size())
      throw std::invalid_argument(
          fmt::format("line {}: has {} fields, its header {}", k + 1, fields.size(), header.size()));
    x.push_back(number(fields[at_x], k + 1));
    y.push_back(number(fields[at_y], k + 1));
    value.push_back(number(fields[at_value], k + 1));
  }
  if (x.empty()) throw std::invalid_argument("has no rows");
  const std::vector<double> columns = levels(x), rows = levels(y);
  Samples samples{.origin = {columns.front(), rows.front()},
                  .spacing = {spacing_of(columns, "x_um"), spacing_of(rows, "y_um")},
                  .columns = columns.size(),
                  .rows = rows.size(),
                  .values = std::vector<double>(columns.size() * rows.size(), std::nan(""))};
  for (std::size_t k = 0; k < x.size(); ++k) {
    const auto i = static_cast<std::size_t>(std::lround((x[k] - samples.origin.x()) / samples.spacing.x()));
    const auto j = static_cast<std::size_t>(std::lround((y[k] - samples.origin.y()) / samples.spacing.y()));
    double& node = samples.values[j * samples.columns + i];
    if (!std::isnan(node)) throw std::invalid_argument(fmt::format("has the node ({}, {}) um twice", x[k], y[k]));
    node = value[k];
  }
  if (const auto missing = std::ranges::find_if(samples.values, [](double v) { return std::isnan(v); });
      missing != samples.values.end()) {
    const auto k = static_cast<std::size_t>(missing - samples.values.begin());
    throw std::invalid_argument(
        fmt::format("has no value for the node ({}, {}) um: a grid of {} x {} nodes has {} rows, "
                    "this has {}",
                    columns[k % samples.columns], rows[k / samples.columns], samples.columns, samples.rows,
                    samples.values.size(), x.size()));
  }
  return samples;
}

} // namespace matrigrate::fields
