#include "tables/table.hpp"

#include "base/failure.hpp"
#include "base/text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>

namespace matrigrate::store {

namespace {

void check_length(const Table& table, const std::vector<double>& row) {
  if (row.size() != table.columns.size())
    throw std::invalid_argument(
        fmt::format("a row of {} numbers does not fit a table of {} columns", row.size(), table.columns.size()));
}

struct Text {
  std::string operator()(double value) const { return std::isnan(value) ? std::string() : fmt::format("{}", value); }
  std::string operator()(std::uint64_t value) const { return fmt::format("{}", value); }
  std::string operator()(std::string_view value) const { return csv_text(value); }
};

/// The text, which begins with the header.
std::string& begun(std::string& text, const std::vector<std::string_view>& columns) {
  if (text.empty()) text = csv_line({columns.begin(), columns.end()});
  return text;
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

std::string to_csv(const Table& table) {
  std::string out = csv_line({table.columns.begin(), table.columns.end()});
  for (const auto& row : table.rows) {
    check_length(table, row);
    // An empty line would be skipped by most readers, so a lone missing number is written as an empty quoted field.
    const bool empty = row.size() == 1 && std::isnan(row[0]);
    out += empty ? "\"\"\n" : csv_line({row.begin(), row.end()});
  }
  return out;
}

std::string csv_line(const std::vector<Field>& fields) {
  std::string line;
  for (std::size_t i = 0; i < fields.size(); ++i) {
    if (i > 0) line += ',';
    line += std::visit(Text{}, fields[i]);
  }
  return line + '\n';
}

RowFile::RowFile(std::filesystem::path path, const std::vector<std::string_view>& columns, std::string& text)
    : m_name(path.string()), m_columns(columns.size()), m_text(&text), m_file(std::move(path), begun(text, columns)) {}

void RowFile::add(const std::vector<Field>& fields) {
  if (fields.size() != m_columns)
    throw std::invalid_argument(fmt::format("{}: a row of {} fields for {} columns", m_name, fields.size(), m_columns));
  const std::string line = csv_line(fields);
  m_file.append(line);
  *m_text += line;
}

} // namespace matrigrate::store
