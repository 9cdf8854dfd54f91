#pragma once

#include "base/file.hpp"

#include <cstdint>
#include <filesystem>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace matrigrate::store {

/// A table of numbers with a name and unit for each column, as in every CSV file of the program.
struct Table {
  std::vector<std::string> columns;      ///< names ending in their unit: "displacement_um", "time_s"
  std::vector<std::vector<double>> rows; ///< each as long as columns

  /// Appends a row. @throws std::invalid_argument if its length is not that of columns
  void add(std::vector<double> row);

  /// The numbers of a column. @throws InputOutputError naming the column, if there is none of that name
  std::vector<double> column(std::string_view name) const;
};

/// The table as RFC 4180 text, but with the line ends of Unix: a header line, numbers in the shortest form that reads
/// back to the same bits, NaN as an empty field, infinities as inf and -inf. The same bytes in every locale.
/// @throws std::invalid_argument if a row is not as long as columns
std::string to_csv(const Table& table);

// A CSV file that grows by a row at a time, for runs that may be ended at any moment.
// Test: tests/unit/tables/run_files_test.cpp

/// A field of a row: a number in the shortest form that reads back to the same bits (NaN: empty), or a word.
using Field = std::variant<double, std::uint64_t, std::string_view>;

/// A number of things, as a field.
inline Field count(std::size_t n) { return std::uint64_t{n}; }

/// A line of CSV with its end; words as csv_text (base/text.hpp) writes them.
std::string csv_line(const std::vector<Field>& fields);

class RowFile {
public:
  /// Makes the file anew with the text there is already; it is replaced as a whole or not at all.
  /// @param columns  names ending in their unit
  /// @param text     of the whole file; empty: the header is added. Rows are added to it, too, so it outlives this
  /// @throws InputOutputError naming the path and the reason
  RowFile(std::filesystem::path path, const std::vector<std::string_view>& columns, std::string& text);

  /// Appends a row and hands it to the system at once; a row that does not fit on the disk is taken back, so that the
  /// file always has whole lines.
  /// @throws InputOutputError naming the path and the reason
  /// @throws std::invalid_argument if the number of fields is not that of the columns
  void add(const std::vector<Field>& fields);

  /// Waits until all rows are on the disk, which a checkpoint that counts on them needs.
  /// @throws InputOutputError naming the path and the reason
  void flush() const { m_file.flush(); }

private:
  std::string m_name; ///< for messages
  std::size_t m_columns;
  std::string* m_text;
  GrowingFile m_file;
};

// Reading of CSV as this program writes it (csv_line, csv_text, to_csv). Test: tests/unit/tables/tables_test.cpp

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
