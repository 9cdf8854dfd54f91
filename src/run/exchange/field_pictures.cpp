#include "exchange/field_pictures.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string_view>

namespace matrigrate::exchange {

namespace {

/// Particles sorted into square bins.
struct Bins {
  double width, low;
  std::size_t side;
  std::vector<std::vector<std::size_t>> of;

  Bins(const std::vector<double>& x, double spacing, double radius) : width(2.0 * spacing), low(-radius - width) {
    side = static_cast<std::size_t>(std::ceil(-2.0 * low / width)) + 1;
    of.resize(side * side);
    for (std::size_t i = 0; i < x.size() / 2; ++i) of[bin(x[2 * i + 1]) * side + bin(x[2 * i])].push_back(i);
  }

  std::size_t bin(double at) const {
    return static_cast<std::size_t>(std::clamp((at - low) / width, 0.0, static_cast<double>(side - 1)));
  }
};

/// The nearest particle in the bins around a place.
std::size_t nearest(const Bins& bins, const std::vector<double>& x, double at_x, double at_y) {
  std::size_t found = no_particle;
  double least = std::numeric_limits<double>::infinity();
  const std::size_t column = bins.bin(at_x), row = bins.bin(at_y);
  for (std::size_t j = row > 0 ? row - 1 : 0; j <= std::min(row + 1, bins.side - 1); ++j)
    for (std::size_t i = column > 0 ? column - 1 : 0; i <= std::min(column + 1, bins.side - 1); ++i)
      for (const std::size_t k : bins.of[j * bins.side + i]) {
        const double square = (x[2 * k] - at_x) * (x[2 * k] - at_x) + (x[2 * k + 1] - at_y) * (x[2 * k + 1] - at_y);
        if (square < least) {
          least = square;
          found = k;
        }
      }
  return found;
}

/// Sets the pixels inside a closed line, by where the middle lines of the rows cross it.
/// @param x  its points from `first` to `end`
void fill(const observe::Floats& x, std::size_t first, std::size_t end, const PixelGrid& grid, float value,
          std::vector<float>& to) {
  for (std::size_t row = 0; row < grid.side; ++row) {
    const double y = grid.y(row);
    std::vector<double> crossings;
    for (std::size_t i = first; i < end; ++i) {
      const std::size_t next = i + 1 < end ? i + 1 : first;
      const double y_0 = x[2 * i + 1], y_1 = x[2 * next + 1];
      if ((y_0 <= y) == (y_1 <= y)) continue;
      crossings.push_back(x[2 * i] + (y - y_0) / (y_1 - y_0) * (x[2 * next] - x[2 * i]));
    }
    std::ranges::sort(crossings);
    for (std::size_t k = 0; k + 1 < crossings.size(); k += 2)
      for (std::size_t column = 0; column < grid.side; ++column)
        if (grid.x(column) >= crossings[k] && grid.x(column) < crossings[k + 1]) to[row * grid.side + column] = value;
  }
}

std::vector<float> cells(const observe::Frame& frame, const PixelGrid& grid) {
  std::vector<float> numbers(grid.side * grid.side, 0.0F);
  std::size_t first = 0;
  float number = 1.0F;
  for (const std::size_t end : observe::outline_ends(frame.outline)) {
    fill(frame.outline.x, first, end, grid, number++, numbers);
    first = end;
  }
  return numbers;
}

} // namespace

PixelGrid PixelGrid::over(const observe::FrameHead& head, double pixel) {
  return {.pixel = pixel, .side = static_cast<std::size_t>(std::ceil(2.0 * head.radius / pixel - 1e-9))};
}

std::vector<Channel> channels(const observe::Film& film) {
  constexpr std::string_view body = "matrix/";
  std::vector<Channel> all;
  for (const auto& field : observe::float_fields()) {
    const bool there =
        std::ranges::all_of(film.frames, [&](const observe::Frame& frame) { return !field.in(frame).empty(); });
    if (!field.name.starts_with(body) || !there) continue;
    const std::string name(field.name.substr(body.size()));
    for (std::uint32_t c = 0; c < field.components; ++c)
      all.push_back({.name = field.components == 1 ? name : name + (c == 0 ? "_x" : "_y"),
                     .unit = std::string(field.unit),
                     .values = [&field, c](const observe::Frame& frame) {
                       const observe::Floats& of = field.in(frame);
                       observe::Floats values;
                       for (std::size_t i = c; i < of.size(); i += field.components) values.push_back(of[i]);
                       return values;
                     }});
  }
  for (std::size_t k = 0; k < film.head.layers.size(); ++k)
    if (!film.head.layers[k].empty())
      all.push_back({.name = std::string(observe::matrix_layers()[k].layer),
                     .unit = std::string(observe::matrix_layers()[k].layer_unit),
                     .values = [&film, k](const observe::Frame&) { return film.head.layers[k]; }});
  if (!film.head.obstacle.empty())
    all.push_back({.name = "obstacle", .unit = "1", .values = [&film](const observe::Frame&) {
                     return observe::Floats(film.head.obstacle.begin(), film.head.obstacle.end());
                   }});
  all.push_back({.name = "cell", .unit = "1", .values = {}});
  return all;
}

std::vector<std::size_t> nearest_particles(const observe::FrameHead& head, const observe::Frame& frame,
                                           const PixelGrid& grid) {
  std::vector<double> x(head.reference.size());
  for (std::size_t i = 0; i < x.size(); ++i) x[i] = double{head.reference[i]} + double{frame.matrix.displacement[i]};
  const Bins bins(x, head.spacing, head.radius);
  std::vector<std::size_t> found(grid.side * grid.side, no_particle);
  for (std::size_t row = 0; row < grid.side; ++row)
    for (std::size_t column = 0; column < grid.side; ++column)
      if (std::hypot(grid.x(column), grid.y(row)) <= head.radius)
        found[row * grid.side + column] = nearest(bins, x, grid.x(column), grid.y(row));
  return found;
}

std::vector<float> picture(const Channel& channel, const observe::Frame& frame, const PixelGrid& grid,
                           const std::vector<std::size_t>& nearest) {
  if (!channel.values) return cells(frame, grid);
  const observe::Floats values = channel.values(frame);
  std::vector<float> pixels(nearest.size(), std::numeric_limits<float>::quiet_NaN());
  for (std::size_t k = 0; k < nearest.size(); ++k)
    if (nearest[k] != no_particle) pixels[k] = values[nearest[k]];
  return pixels;
}

} // namespace matrigrate::exchange
