#include "target.hpp"

#include "base/failure.hpp"
#include "tables/table.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <optional>
#include <string_view>
#include <vector>

namespace {

bool same(double a, double b) { return a == b || (std::isnan(a) && std::isnan(b)); }

/// Numbers that are written must be read back.
void require_kept(const matrigrate::store::Table& table) {
  const matrigrate::store::Table again = matrigrate::store::read_table(to_csv(table));
  if (again.rows.size() != table.rows.size()) std::abort();
  for (std::size_t r = 0; r < table.rows.size(); ++r)
    if (!std::ranges::equal(again.rows[r], table.rows[r], same)) std::abort();
}

/// Nothing if a field of the column is no number.
std::optional<std::vector<double>> column_of(std::string_view text, std::string_view name) {
  try {
    return matrigrate::store::csv_column(text, name);
  } catch (const matrigrate::InputOutputError&) {
    return std::nullopt;
  }
}

} // namespace

/// A table from anywhere: it is refused, or each row has a field for each name of its header, and its numbers can be
/// written and read again. Single columns are read from any text or refused; there are as many numbers of each as of
/// the others.
int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace matrigrate::store;
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  const auto first = column_of(text, text.substr(0, std::min(text.find_first_of(",\n"), text.size())));
  for (const char* name : {"t_s", "x_um", "id"}) {
    const auto column = column_of(text, name);
    if (first && column && !column->empty() && column->size() != first->size()) std::abort();
  }
  try {
    const CsvTable table = read_csv(text);
    for (const std::vector<std::string>& row : table.rows)
      if (row.size() != table.header.size()) std::abort();
    require_kept(read_table(text));
  } catch (const matrigrate::InputOutputError&) { // refused
  }
  return 0;
}
