#pragma once

#include "base/file.hpp"

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

/// A CSV file that grows by a row at a time, for runs that may be ended at any moment.
/// Test: tests/unit/store/run_files_test.cpp
namespace matrigrate::store {

/// A field of a row: a number in the shortest form that reads back to the same bits (NaN: empty), or a word.
using Field = std::variant<double, std::uint64_t, std::string_view>;

/// A number of things, as a field.
inline Field count(std::size_t n) { return std::uint64_t{n}; }

/// A line of CSV with its end; words as csv_text (store/table.hpp) writes them.
std::string csv_line(const std::vector<Field>& fields);

class RowFile {
public:
  /// Writes the header and the rows so far; an older file is replaced as a whole or not at all.
  /// @param columns  names ending in their unit
  /// @throws InputOutputError naming the path and the reason
  /// @throws std::invalid_argument if the number of fields of a row is not that of the columns
  RowFile(std::filesystem::path path, const std::vector<std::string_view>& columns,
          const std::vector<std::vector<Field>>& rows = {});

  /// Appends a row and hands it to the system at once; a row that does not fit on the disk is taken back, so that the
  /// file always has whole lines.
  /// @throws InputOutputError naming the path and the reason
  /// @throws std::invalid_argument if the number of fields is not that of the columns
  void add(const std::vector<Field>& fields);

private:
  std::string m_name; ///< for messages
  std::size_t m_columns;
  GrowingFile m_file;
};

} // namespace matrigrate::store
