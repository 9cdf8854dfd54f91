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

/// The way along x over the length of the path sampled at multiples of 600 s; NaN where nothing moved.
double migration_index(const std::vector<double>& t, const std::vector<double>& x, const std::vector<double>& y) {
  double length = 0.0;
  std::size_t last = 0;
  for (std::size_t i = 1; i < t.size(); ++i) {
    if (std::abs(std::remainder(t[i], 600.0)) > 1e-6) continue;
    length += std::hypot(x[i] - x[last], y[i] - y[last]);
    last = i;
  }
  return length > 0.0 ? (x[last] - x[0]) / length : std::numeric_limits<double>::quiet_NaN();
}

} // namespace

std::array<std::string_view, 3> table_readout_names() {
  return {"share_f_adh_rel_low", "share_2_or_3_protrusions", "migration_index_x"};
}

std::array<double, 3> table_readouts(const std::filesystem::path& folder) {
  const auto column = [&](const char* file, std::string_view name) {
    return io::csv_column(read_file(folder / file, largest_table), name);
  };
  return {share(column("protrusions.csv", "f_adh_rel"), [](double f) { return f < low_relative_force; }),
          share(column("tracks.csv", "n_simultaneous"), [](double n) { return n == 2.0 || n == 3.0; }),
          column("tracks.csv", "cell").empty()
              ? migration_index(column("tracks.csv", "t_s"), column("tracks.csv", "x_um"), column("tracks.csv", "y_um"))
              : std::numeric_limits<double>::quiet_NaN()};
}

} // namespace matrigrate::study
