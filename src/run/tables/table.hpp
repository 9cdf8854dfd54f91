#pragma once

#include <string>
#include <string_view>
#include <utility>
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

  /// The rows that share a value of the first column, in the order in which these values first occur.
  std::vector<std::pair<double, Table>> by_first_column() const;
};

/// The table as RFC 4180 text, but with the line ends of Unix: a header line, numbers in the shortest form that reads
/// back to the same bits, NaN as an empty field, infinities as inf and -inf. The same bytes in every locale.
/// @throws std::invalid_argument if a row is not as long as columns
std::string to_csv(const Table& table);

} // namespace matrigrate::store
