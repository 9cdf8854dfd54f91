#include "study/table_readouts.hpp"

#include "base/file.hpp"
#include "store/csv.hpp"

#include <cmath>
#include <limits>

namespace matrigrate::study {

namespace {

constexpr std::size_t largest_table = std::size_t{1} << 28;

/// Share of the finite values that fulfil a condition.
template <class Condition>
double share(const std::vector<double>& values, const Condition& condition) {
  std::size_t of = 0;
  std::size_t n = 0;
  for (const double value : values) {
    if (!std::isfinite(value)) continue;
    ++of;
    n += condition(value) ? 1 : 0;
  }
  return of == 0 ? std::numeric_limits<double>::quiet_NaN() : static_cast<double>(n) / static_cast<double>(of);
}

} // namespace

std::array<std::string_view, 2> table_readout_names() { return {"share_f_adh_rel_low", "share_2_or_3_protrusions"}; }

std::array<double, 2> table_readouts(const std::filesystem::path& folder) {
  const auto column = [&](const char* file, std::string_view name) {
    return io::csv_column(read_file(folder / file, largest_table), name);
  };
  return {share(column("protrusions.csv", "f_adh_rel"), [](double f) { return f < low_relative_force; }),
          share(column("tracks.csv", "n_simultaneous"), [](double n) { return n == 2.0 || n == 3.0; })};
}

} // namespace matrigrate::study
