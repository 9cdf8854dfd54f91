#include "io/table.hpp"

#include <fmt/format.h>

#include <cmath>
#include <iterator>
#include <stdexcept>
#include <string_view>
#include <utility>

namespace matrigrate::io {

namespace {

void check_length(const Table& table, const std::vector<double>& row) {
  if (row.size() != table.columns.size())
    throw std::invalid_argument(
        fmt::format("a row of {} numbers does not fit a table of {} columns", row.size(), table.columns.size()));
}

} // namespace

std::string quoted(std::string_view field) {
  if (field.find_first_of(",\"\r\n") == std::string_view::npos) return std::string(field);
  std::string out = "\"";
  for (const char c : field) {
    if (c == '"') out += '"';
    out += c;
  }
  return out + '"';
}

void Table::add(std::vector<double> row) {
  check_length(*this, row);
  rows.push_back(std::move(row));
}

std::string to_csv(const Table& table) {
  std::string out;
  for (std::size_t c = 0; c < table.columns.size(); ++c) {
    if (c > 0) out += ',';
    out += quoted(table.columns[c]);
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

} // namespace matrigrate::io
