#include "tables/row_file.hpp"

#include "base/csv_text.hpp"
#include "tables/table.hpp"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>
#include <utility>

namespace matrigrate::store {

namespace {

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
