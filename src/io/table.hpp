#pragma once

#include <string>
#include <vector>

namespace matrigrate::io {

/// A table of numbers with a name and unit for each column, as in every CSV file of the program.
struct Table {
  std::vector<std::string> columns;      ///< names ending in their unit: "displacement_um", "time_s"
  std::vector<std::vector<double>> rows; ///< each as long as columns

  /// Appends a row. @throws std::invalid_argument if its length is not that of columns
  void add(std::vector<double> row);
};

/// The table as RFC 4180 text: a header line, numbers in the shortest form that reads back to the same bits, NaN empty.
std::string to_csv(const Table& table);

} // namespace matrigrate::io
