#include "study/table_readouts.hpp"

#include "base/file.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>

namespace matrigrate::study {

namespace {

constexpr std::size_t largest_table = std::size_t{1} << 28;

std::string_view cut(std::string_view& text, char end) {
  const std::size_t length = std::min(text.find(end), text.size());
  const std::string_view part = text.substr(0, length);
  text.remove_prefix(std::min(length + 1, text.size()));
  return part;
}

std::string_view field(std::string_view line, std::size_t index) {
  for (std::size_t i = 0; i < index; ++i) cut(line, ',');
  return cut(line, ',');
}

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

double csv_number(std::string_view field) {
  double value = std::numeric_limits<double>::quiet_NaN();
  std::from_chars(field.data(), field.data() + field.size(), value);
  return value;
}

std::vector<double> csv_column(std::string_view text, std::string_view column) {
  std::string_view header = cut(text, '\n');
  std::size_t index = 0;
  while (!header.empty() && cut(header, ',') != column) {
    ++index;
    if (header.empty()) return {};
  }
  std::vector<double> values;
  while (!text.empty()) values.push_back(csv_number(field(cut(text, '\n'), index)));
  return values;
}

std::array<std::string_view, 2> table_readout_names() { return {"share_f_adh_rel_low", "share_2_or_3_protrusions"}; }

std::array<double, 2> table_readouts(const std::filesystem::path& folder) {
  const auto column = [&](const char* file, std::string_view name) {
    return csv_column(read_file(folder / file, largest_table), name);
  };
  return {share(column("protrusions.csv", "f_adh_rel"), [](double f) { return f < low_relative_force; }),
          share(column("tracks.csv", "n_simultaneous"), [](double n) { return n == 2.0 || n == 3.0; })};
}

} // namespace matrigrate::study
