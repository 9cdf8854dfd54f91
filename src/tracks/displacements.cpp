#include "tracks/read_tracks.hpp"

#include <cmath>
#include <limits>

namespace matrigrate::tracks {

Displacements displacements(const Track& track, std::size_t longest) {
  Displacements found{.squares = std::vector<double>(longest, 0.0), .pairs = std::vector<double>(longest, 0.0)};
  for (std::size_t i = 0; i < track.k.size(); ++i)
    for (std::size_t j = i + 1; j < track.k.size() && track.k[j] - track.k[i] <= longest; ++j) {
      const double dx = track.x[j] - track.x[i], dy = track.y[j] - track.y[i];
      const std::size_t lag = track.k[j] - track.k[i];
      found.squares[lag - 1] += dx * dx + dy * dy;
      found.pairs[lag - 1] += 1.0;
    }
  return found;
}

double log_slope(std::span<const double> x, std::span<const double> y, std::size_t least) {
  double n = 0.0, sx = 0.0, sy = 0.0, xx = 0.0, xy = 0.0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (!(y[i] > 0.0)) continue;
    const double a = std::log(x[i]), b = std::log(y[i]);
    n += 1.0;
    sx += a;
    sy += b;
    xx += a * a;
    xy += a * b;
  }
  return n < static_cast<double>(least) ? std::numeric_limits<double>::quiet_NaN()
                                        : (n * xy - sx * sy) / (n * xx - sx * sx);
}

} // namespace matrigrate::tracks
