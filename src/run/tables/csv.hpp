#pragma once

#include "tables/table.hpp"

#include <cstddef>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// Reading of CSV as this program writes it (csv_line, csv_text, to_csv). Test: tests/unit/tables/tables_test.cpp
namespace matrigrate::store {

/// A table of text: a header, and rows as long as it.
struct CsvTable {
  std::vector<std::string> header;
  std::vector<std::vector<std::string>> rows;

  /// Where a column is; nothing if there is none of that name.
  std::optional<std::size_t> column(std::string_view name) const;
};

/// @throws InputOutputError naming the line, if a row is not as long as the header or a quote is not closed
CsvTable read_csv(std::string_view text);

/// The number of a field, NaN of an empty one.
/// @throws InputOutputError if it is anything else, also "nan" and "inf"
double csv_number(std::string_view field);

/// Numbers of a column of a CSV text without quoted fields before it, NaN for empty fields; empty if there is no such
/// column.
/// @throws InputOutputError naming the line and the column, if a field is no number
std::vector<double> csv_column(std::string_view text, std::string_view column);

/// Several columns, with as many numbers each.
/// @throws InputOutputError naming one that is not there, if another is
std::vector<std::vector<double>> csv_columns(std::string_view text, std::initializer_list<std::string_view> columns);

/// A CSV text of numbers alone, as to_csv writes it.
/// @throws InputOutputError as read_csv does
Table read_table(std::string_view text);

} // namespace matrigrate::store
