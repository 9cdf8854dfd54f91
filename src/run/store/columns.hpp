#pragma once

#include "base/failure.hpp"
#include "store/csv.hpp"
#include "store/row_file.hpp"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <ranges>
#include <string_view>
#include <type_traits>
#include <vector>

/// The columns of a table as one list: what each is called, what it takes from a row, and where a number of it goes
/// when the table is read again. Test: tests/unit/store/run_files_test.cpp
namespace matrigrate::store {

template <class Row>
struct TableColumn {
  using Of = Row;

  std::string_view name; ///< ends in its unit
  Field (*get)(const Row&);
  void (*set)(Row&, double) = nullptr; ///< none: it follows from the others, or the table is not read
};

/// A field that counts. @throws InputOutputError if it is no number of things
template <class T>
T counted(double field) {
  if (!(field >= 0.0 && field < static_cast<double>(std::numeric_limits<T>::max())))
    throw InputOutputError("a row has no number where things are counted");
  return static_cast<T>(field);
}

template <class Row, class T>
Row row_of(T Row::*);
template <class Row, class T>
T type_of_member(T Row::*);

/// A column that is a member of its row: a number, or a number of things.
template <auto member>
constexpr auto column(std::string_view name) {
  using Row = decltype(row_of(member));
  using T = decltype(type_of_member(member));
  if constexpr (std::is_floating_point_v<T>)
    return TableColumn<Row>{name, [](const Row& row) -> Field { return row.*member; },
                            [](Row& row, double value) { row.*member = value; }};
  else if constexpr (std::is_same_v<T, bool>)
    return TableColumn<Row>{name, [](const Row& row) -> Field { return count(row.*member ? 1 : 0); },
                            [](Row& row, double value) { row.*member = value != 0.0; }};
  else
    return TableColumn<Row>{name, [](const Row& row) -> Field { return count(static_cast<std::size_t>(row.*member)); },
                            [](Row& row, double value) { row.*member = counted<T>(value); }};
}

std::vector<std::string_view> names_of(const auto& columns) {
  std::vector<std::string_view> names;
  for (const auto& one : columns) names.push_back(one.name);
  return names;
}

std::vector<Field> fields_of(const auto& columns, const auto& row) {
  std::vector<Field> fields;
  for (const auto& one : columns) fields.push_back(one.get(row));
  return fields;
}

/// @throws InputOutputError if the table has other columns
auto rows_in(const Table& table, const auto& columns) {
  if (!std::ranges::equal(table.columns, names_of(columns))) throw InputOutputError("has columns of another table");
  std::vector<typename std::ranges::range_value_t<decltype(columns)>::Of> rows(table.rows.size());
  for (std::size_t i = 0; i < rows.size(); ++i)
    for (std::size_t k = 0; k < columns.size(); ++k)
      if (columns[k].set != nullptr) columns[k].set(rows[i], table.rows[i][k]);
  return rows;
}

} // namespace matrigrate::store
