#include "observe/even_times.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace matrigrate::observe {

std::string EvenTimes::text() const {
  return is_even() ? fmt::format("every {:g} s", interval)
                   : fmt::format("unevenly spaced, {:g} to {:g} s apart", least, most);
}

EvenTimes even_times(std::span<const double> times) {
  constexpr double same = 1e-3; // [s]
  EvenTimes found{.interval = 0.0, .even = times.size(), .all = times.size()};
  if (times.size() < 2) return found;
  found.interval = found.least = found.most = times[1] - times[0];
  for (std::size_t k = 1; k < times.size(); ++k) {
    found.least = std::min(found.least, times[k] - times[k - 1]);
    found.most = std::max(found.most, times[k] - times[k - 1]);
    if (std::abs(times[k] - times[0] - static_cast<double>(k) * found.interval) > same)
      found.even = std::min(found.even, k);
  }
  return found;
}

std::vector<double> times_of(std::span<const TrackRow> rows) {
  std::vector<double> times;
  for (const TrackRow& row : rows)
    if (times.empty() || row.t > times.back()) times.push_back(row.t);
  return times;
}

std::vector<double> times_of(const Film& film) {
  std::vector<double> times;
  for (const Frame& frame : film.frames) times.push_back(frame.t);
  return times;
}

} // namespace matrigrate::observe
