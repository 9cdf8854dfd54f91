#include "fields/structure_tensor.hpp"

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

Plane smoothed(Plane plane, double deviation) {
  const auto half = static_cast<std::ptrdiff_t>(
      std::min(std::ceil(reach * deviation), static_cast<double>(std::max(plane.width, plane.height))));
  std::vector<double> weights;
  double sum = 0.0;
  for (std::ptrdiff_t k = -half; k <= half; ++k) {
    const double z = static_cast<double>(k) / deviation;
    weights.push_back(std::exp(-0.5 * z * z));
    sum += weights.back();
  }
  const auto pass = [&](bool along_rows) {
    Plane result = plane;
    for (std::size_t row = 0; row < plane.height; ++row)
      for (std::size_t column = 0; column < plane.width; ++column) {
        double mean = 0.0;
        for (std::ptrdiff_t k = -half; k <= half; ++k) {
          const auto i = static_cast<std::ptrdiff_t>(column), j = static_cast<std::ptrdiff_t>(row);
          mean += weights[static_cast<std::size_t>(k + half)] * (along_rows ? plane.at(i + k, j) : plane.at(i, j + k));
        }
        result.values[row * plane.width + column] = mean / sum;
      }
    plane = std::move(result);
  };
  pass(true);
  pass(false);
  return plane;
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
  const Plane even = smoothed({width, height, picture.samples}, 1.0);
  Plane xx{width, height, std::vector<double>(picture.samples.size())}, xy = xx, yy = xx;
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
  const auto [least, largest] = std::ranges::minmax(picture.samples);
  const double pixels = static_cast<double>(picture.samples.size());
  const double noise = std::pow(1e-9 * std::max({std::abs(least), std::abs(largest), 1e-300}), 2);
  if (sum_xx + sum_yy <= pixels * noise) throw std::invalid_argument("is even everywhere, and has no directions");
  xx = smoothed(std::move(xx), window);
  xy = smoothed(std::move(xy), window);
  yy = smoothed(std::move(yy), window);
  std::vector<double> directions(picture.samples.size());
  for (std::size_t k = 0; k < directions.size(); ++k)
    directions[k] = xx.values[k] + yy.values[k] > noise ? direction(xx.values[k], xy.values[k], yy.values[k])
                                                        : direction(sum_xx, sum_xy, sum_yy);
  return directions;
}

} // namespace matrigrate::fields
