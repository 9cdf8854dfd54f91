#include "tables/table.hpp"

#include "base/csv_text.hpp"
#include "base/failure.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <stdexcept>
#include <string_view>
#include <utility>

namespace matrigrate::store {

namespace {

void check_length(const Table& table, const std::vector<double>& row) {
  if (row.size() != table.columns.size())
    throw std::invalid_argument(
        fmt::format("a row of {} numbers does not fit a table of {} columns", row.size(), table.columns.size()));
}

} // namespace

void Table::add(std::vector<double> row) {
  check_length(*this, row);
  rows.push_back(std::move(row));
}

std::vector<double> Table::column(std::string_view name) const {
  const auto found = std::ranges::find(columns, name);
  if (found == columns.end()) throw InputOutputError(fmt::format("the table has no column {}", name));
  const auto index = static_cast<std::size_t>(found - columns.begin());
  std::vector<double> values;
  for (const auto& row : rows) values.push_back(row[index]);
  return values;
}

std::vector<std::pair<double, Table>> Table::by_first_column() const {
  std::vector<std::pair<double, Table>> groups;
  for (const auto& row : rows) {
    auto group = std::ranges::find(groups, row.front(), &std::pair<double, Table>::first);
    if (group == groups.end())
      group = groups.insert(groups.end(), {row.front(), Table{.columns = columns, .rows = {}}});
    group->second.rows.push_back(row);
  }
  return groups;
}

std::string to_csv(const Table& table) {
  std::string out;
  for (std::size_t c = 0; c < table.columns.size(); ++c) {
    if (c > 0) out += ',';
    out += csv_text(table.columns[c]);
  }
  out += '\n';
  for (const auto& row : table.rows) {
    check_length(table, row);
    // An empty line would be skipped by most readers, so a lone missing number is written as an empty quoted field.
    if (row.size() == 1 && std::isnan(row[0])) out += "\"\"";
    for (std::size_t c = 0; c < row.size(); ++c) {
      if (c > 0) out += ',';
      if (!std::isnan(row[c])) fmt::format_to(std::back_inserter(out), "{}", row[c]);
    }
    out += '\n';
  }
  return out;
}

} // namespace matrigrate::store
