#include "store/row_file.hpp"

#include "store/table.hpp"

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

std::string checked_line(const std::string& name, std::size_t columns, const std::vector<Field>& fields) {
  if (fields.size() != columns)
    throw std::invalid_argument(fmt::format("{}: a row of {} fields for {} columns", name, fields.size(), columns));
  return csv_line(fields);
}

std::string content(const std::string& name, const std::vector<std::string_view>& columns,
                    const std::vector<std::vector<Field>>& rows) {
  std::string text = csv_line({columns.begin(), columns.end()});
  for (const std::vector<Field>& fields : rows) text += checked_line(name, columns.size(), fields);
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

RowFile::RowFile(std::filesystem::path path, const std::vector<std::string_view>& columns,
                 const std::vector<std::vector<Field>>& rows)
    : m_name(path.string()), m_columns(columns.size()), m_file(std::move(path), content(m_name, columns, rows)) {}

void RowFile::add(const std::vector<Field>& fields) { m_file.append(checked_line(m_name, m_columns, fields)); }

} // namespace matrigrate::store
