#include "tables/table.hpp"

#include "base/failure.hpp"
#include "base/text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
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

namespace {

std::string_view cut(std::string_view& text, char end) {
  const std::size_t length = std::min(text.find(end), text.size());
  const std::string_view part = text.substr(0, length);
  text.remove_prefix(std::min(length + 1, text.size()));
  return part;
}

/// Takes a field and the comma behind it off the front of the text; the end of a line stays.
std::string take_field(std::string_view& text, std::size_t line) {
  std::string field;
  if (!text.starts_with('"')) {
    field = text.substr(0, std::min(text.find_first_of(",\n"), text.size()));
    text.remove_prefix(field.size());
    if (field.ends_with('\r') && !text.starts_with(',')) field.pop_back(); // a line may end with both
    return field;
  }
  for (text.remove_prefix(1);; text.remove_prefix(1)) {
    const std::size_t quote = text.find('"');
    if (quote == std::string_view::npos) throw InputOutputError(fmt::format("line {}: a quote is not closed", line));
    field += text.substr(0, quote);
    text.remove_prefix(quote + 1);
    if (!text.starts_with('"')) return field;
    field += '"'; // doubled
  }
}

double number_at(std::string_view field, std::size_t line, std::string_view column) {
  try {
    return csv_number(field);
  } catch (const InputOutputError& error) {
    throw InputOutputError(fmt::format("line {}, column {}: {}", line, column, error.what()));
  }
}

} // namespace

std::optional<std::size_t> CsvTable::column(std::string_view name) const {
  const auto found = std::ranges::find(header, name);
  if (found == header.end()) return {};
  return static_cast<std::size_t>(found - header.begin());
}

CsvTable read_csv(std::string_view text) {
  constexpr std::string_view mark = "\xef\xbb\xbf"; // of UTF-8, as spreadsheets put it in front
  if (text.starts_with(mark)) text.remove_prefix(mark.size());
  CsvTable table;
  for (std::size_t line = 1; !text.empty(); ++line) {
    std::vector<std::string> fields{take_field(text, line)};
    while (text.starts_with(',')) {
      text.remove_prefix(1);
      fields.push_back(take_field(text, line));
    }
    if (text.starts_with("\r\n")) text.remove_prefix(1);
    if (!text.empty() && text.front() != '\n')
      throw InputOutputError(fmt::format("line {}: a quoted field goes on after its quote", line));
    text.remove_prefix(std::min<std::size_t>(1, text.size()));
    if (line == 1)
      table.header = std::move(fields);
    else if (fields.size() == table.header.size())
      table.rows.push_back(std::move(fields));
    else
      throw InputOutputError(
          fmt::format("line {}: has {} fields, its header {}", line, fields.size(), table.header.size()));
  }
  return table;
}

double csv_number(std::string_view field) {
  double value = std::numeric_limits<double>::quiet_NaN();
  if (field.empty()) return value;
  const char* end = field.data() + field.size();
  const auto read = std::from_chars(field.data(), end, value);
  if (read.ec != std::errc() || read.ptr != end || !std::isfinite(value))
    throw InputOutputError(fmt::format("\"{}\" is no number", field.substr(0, 40)));
  return value;
}

Table read_table(std::string_view text) {
  const CsvTable read = read_csv(text);
  Table table{.columns = read.header, .rows = {}};
  for (const std::vector<std::string>& fields : read.rows) {
    table.rows.emplace_back();
    for (std::size_t k = 0; k < fields.size(); ++k)
      table.rows.back().push_back(number_at(fields[k], table.rows.size() + 1, table.columns[k]));
  }
  return table;
}

std::vector<double> csv_column(std::string_view text, std::string_view column) {
  std::string_view header = cut(text, '\n');
  std::size_t index = 0;
  while (!header.empty() && cut(header, ',') != column) {
    ++index;
    if (header.empty()) return {};
  }
  std::vector<double> values;
  while (!text.empty()) {
    std::string_view line = cut(text, '\n');
    for (std::size_t i = 0; i < index; ++i) cut(line, ',');
    values.push_back(number_at(cut(line, ','), values.size() + 2, column));
  }
  return values;
}

std::vector<std::vector<double>> csv_columns(std::string_view text, std::initializer_list<std::string_view> columns) {
  std::vector<std::vector<double>> all;
  std::size_t rows = 0;
  for (const std::string_view column : columns)
    rows = std::max(rows, all.emplace_back(csv_column(text, column)).size());
  for (std::size_t i = 0; i < all.size(); ++i)
    if (all[i].size() != rows) throw InputOutputError(fmt::format("has no column {}", columns.begin()[i]));
  return all;
}

} // namespace matrigrate::store
