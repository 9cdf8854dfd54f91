#include "fields/picture.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <utility>

namespace matrigrate::fields {

namespace {

constexpr double reach = 3.0; // of the weights [standard deviations]

/// Numbers of a picture, row by row; outside of it those of its border.
struct Plane {
  std::size_t width, height;
  std::vector<double> values;

  double at(std::ptrdiff_t column, std::ptrdiff_t row) const {
    const auto inside = [](std::ptrdiff_t k, std::size_t n) {
      return static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(k, 0, static_cast<std::ptrdiff_t>(n) - 1));
    };
    return values[inside(row, height) * width + inside(column, width)];
  }
};

/// sums[k] += weight * values[k].
MATRIGRATE_SIMD void add_weighted(const double* values, double weight, std::size_t n, double* sums) {
  for (std::size_t k = 0; k < n; ++k) sums[k] += weight * values[k];
}

/// Costs pixels times deviation. Each pixel adds its weighted neighbours in ascending order.
Plane smoothed(Plane plane, double deviation) {
  const auto half = static_cast<std::size_t>(
      std::min(std::ceil(reach * deviation), static_cast<double>(std::max(plane.width, plane.height))));
  std::vector<double> weights;
  double sum = 0.0;
  for (std::size_t k = 0; k <= 2 * half; ++k) {
    const double z = (static_cast<double>(k) - static_cast<double>(half)) / deviation;
    weights.push_back(std::exp(-0.5 * z * z));
    sum += weights.back();
  }
  const std::size_t width = plane.width, height = plane.height;
  std::vector<double> padded(width + 2 * half), row_sums(width);
  const auto store = [&](double* to) {
    for (std::size_t k = 0; k < width; ++k) to[k] = row_sums[k] / sum;
    std::ranges::fill(row_sums, 0.0);
  };
  for (std::size_t row = 0; row < height; ++row) {
    double* values = plane.values.data() + row * width;
    for (std::size_t k = 0; k < padded.size(); ++k) padded[k] = values[std::clamp(k, half, half + width - 1) - half];
    for (std::size_t k = 0; k <= 2 * half; ++k) add_weighted(padded.data() + k, weights[k], width, row_sums.data());
    store(values);
  }
  std::vector<double> result(plane.values.size());
  for (std::size_t row = 0; row < height; ++row) {
    for (std::size_t k = 0; k <= 2 * half; ++k) {
      const std::size_t from = std::clamp(row + k, half, half + height - 1) - half;
      add_weighted(plane.values.data() + from * width, weights[k], width, row_sums.data());
    }
    store(result.data() + row * width);
  }
  plane.values = std::move(result);
  return plane;
}

/// The samples times a power of two, so that the largest is about 1: squares of their slopes are finite then.
std::vector<double> near_one(std::vector<double> samples) {
  double largest = 0.0;
  for (const double sample : samples) largest = std::max(largest, std::abs(sample));
  if (largest == 0.0) return samples;
  const int exponent = std::ilogb(largest);
  for (double& sample : samples) sample = std::scalbn(sample, -exponent);
  return samples;
}

/// Of the eigenvector of the smaller eigenvalue [degrees].
double direction(double xx, double xy, double yy) {
  const double steepest = 0.5 * std::atan2(2.0 * xy, xx - yy) * 180.0 / std::numbers::pi;
  return steepest > 0.0 ? steepest - 90.0 : steepest + 90.0;
}

} // namespace

std::vector<double> fibre_directions(const Picture& picture, double window) {
  const std::size_t width = picture.width, height = picture.height;
  if (width < 3 || height < 3) throw std::invalid_argument("is smaller than 3 x 3 pixels, and has no directions");
  const std::vector<double> samples = near_one(picture.samples);
  const Plane even = smoothed({width, height, samples}, 1.0);
  Plane xx{width, height, std::vector<double>(samples.size())}, xy = xx, yy = xx;
  double sum_xx = 0.0, sum_xy = 0.0, sum_yy = 0.0;
  for (std::size_t row = 0; row < height; ++row)
    for (std::size_t column = 0; column < width; ++column) {
      const auto i = static_cast<std::ptrdiff_t>(column), j = static_cast<std::ptrdiff_t>(row);
      const auto slope = [&](std::ptrdiff_t x, std::ptrdiff_t y) { // of fourth order, so that no direction is favoured
        return 8.0 * (even.at(i + x, j + y) - even.at(i - x, j - y)) - even.at(i + 2 * x, j + 2 * y)
               + even.at(i - 2 * x, j - 2 * y);
      };
      const double along_x = slope(1, 0), along_y = slope(0, -1);
      const std::size_t k = row * width + column;
      sum_xx += xx.values[k] = along_x * along_x;
      sum_xy += xy.values[k] = along_x * along_y;
      sum_yy += yy.values[k] = along_y * along_y;
    }
  const auto [least, largest] = std::ranges::minmax(samples);
  const double pixels = static_cast<double>(samples.size());
  const double noise = std::pow(1e-9 * std::max({std::abs(least), std::abs(largest), 1e-300}), 2);
  if (sum_xx + sum_yy <= pixels * noise) throw std::invalid_argument("is even everywhere, and has no directions");
  xx = smoothed(std::move(xx), window);
  xy = smoothed(std::move(xy), window);
  yy = smoothed(std::move(yy), window);
  std::vector<double> directions(samples.size());
  for (std::size_t k = 0; k < directions.size(); ++k)
    directions[k] = xx.values[k] + yy.values[k] > noise ? direction(xx.values[k], xy.values[k], yy.values[k])
                                                        : direction(sum_xx, sum_xy, sum_yy);
  return directions;
}

} // namespace matrigrate::fields
