#include "draw/particle_picture.hpp"

#include "draw/colour_bar.hpp"
#include "draw/svg.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <stdexcept>

namespace matrigrate::draw {

namespace {

constexpr double bar_gap = 20.0;           ///< between the particles and the colour bar [pixel]
constexpr double scale_room = 40.0;        ///< below the particles, for the scale bar [pixel]
constexpr double overlap = 1.08;           ///< side of the square of a particle over its size
constexpr double overlap_of_missing = 1.7; ///< the same of one without a value, over that of the others
constexpr std::string_view missing = "#b8b8b8";

bool finite(const Vec2& a) { return std::isfinite(a.x()) && std::isfinite(a.y()); }

void check(const ParticlePicture& p, int width) {
  const std::size_t n = p.position.size();
  if (p.value.size() != n)
    throw std::invalid_argument(fmt::format("a picture has {} particles and {} values", n, p.value.size()));
  if (!(p.particle_size > 0.0) || !std::isfinite(p.particle_size))
    throw std::invalid_argument(fmt::format("particles of a picture have the size {} um", p.particle_size));
  if ((p.value_min != 0.0 || p.value_max != 0.0) && !(p.value_min < p.value_max))
    throw std::invalid_argument(fmt::format("a colour bar from {} to {} is empty", p.value_min, p.value_max));
  if (width < 240) throw std::invalid_argument(fmt::format("a picture {} pixels wide is too small", width));
}

/// Box around all particles [um].
struct Extent {
  Vec2 low = Vec2::Constant(std::numeric_limits<double>::infinity());
  Vec2 high = -low;

  void include(const Vec2& a) {
    if (!finite(a)) return;
    low = low.cwiseMin(a);
    high = high.cwiseMax(a);
  }
};

Extent extent(const ParticlePicture& p) {
  const Vec2 half = Vec2::Constant(0.5 * p.particle_size);
  Extent e;
  for (const Vec2& x : p.position) {
    e.include(x - half);
    e.include(x + half);
  }
  if (!(e.low.x() < e.high.x())) e = {Vec2(-half), half};
  return e;
}

ColourScale scale_of(const ParticlePicture& p) {
  if (p.value_min != 0.0 || p.value_max != 0.0) return {p.value_min, p.value_max};
  std::vector<double> values;
  std::ranges::copy_if(p.value, std::back_inserter(values), drawable);
  return fitted_scale(values);
}

/// From um to pixels, the same in both directions.
struct Projection {
  Vec2 low = Vec2::Zero(); ///< lower left corner of the box of the particles [um]
  double left = 0.0, bottom = 0.0;
  double scale = 1.0; ///< [pixel/um]

  Vec2 at(const Vec2& a) const { return {left + scale * (a.x() - low.x()), bottom - scale * (a.y() - low.y())}; }
};

/// Particles are squares that overlap a little, so that no ground is seen between those of a lattice; those without a
/// value, as fluid that has drifted apart, are larger and lie below. A square is a line of no length with square ends,
/// which takes a third of the bytes of a rectangle.
std::string dots(const ParticlePicture& p, const ColourScale& scale, const Projection& projection) {
  std::array<std::string, colour_levels + 1> path; // missing values first
  for (std::size_t i = 0; i < p.position.size(); ++i) {
    if (!finite(p.position[i])) continue;
    const Vec2 a = projection.at(p.position[i]);
    const int level = scale.level(p.value[i]);
    path[level < 0 ? 0 : 1 + static_cast<std::size_t>(level)] += 'M' + svg::point(a.x(), a.y()) + "h0";
  }
  const double side = overlap * p.particle_size * projection.scale;
  std::string out = fmt::format("<g fill=\"none\" stroke-linecap=\"square\" stroke-width=\"{:.2f}\">\n", side);
  for (int level = -1; const std::string& data : path) {
    if (!data.empty())
      out += level < 0 ? fmt::format("<path stroke=\"{}\" d=\"{}\" stroke-width=\"{:.2f}\"/>\n", missing, data,
                                     overlap_of_missing * side)
                       : fmt::format("<path stroke=\"{}\" d=\"{}\"/>\n", level_colour(level), data);
    ++level;
  }
  return out + "</g>\n";
}

/// A closed curve, dark with a light edge.
std::string outline(const std::vector<Vec2>& points, const Projection& projection) {
  std::string path;
  for (const Vec2& x : points) {
    const Vec2 a = projection.at(x);
    path += (path.empty() ? 'M' : 'L') + svg::point(a.x(), a.y());
  }
  if (path.empty()) return path;
  return fmt::format("<path fill=\"none\" stroke=\"#ffffff\" stroke-width=\"3.4\" d=\"{0}Z\"/>\n"
                     "<path fill=\"none\" stroke=\"{1}\" stroke-width=\"1.6\" d=\"{0}Z\"/>\n",
                     path, svg::dark);
}

std::string scale_bar(double um, const Projection& projection, double y) {
  const double length = um * projection.scale;
  return svg::rectangle(projection.left, y, length, 5.0, svg::dark)
         + svg::text(projection.left + length + 8.0, y + 8.5, fmt::format("{} µm", um), {});
}

} // namespace

std::string to_svg(const ParticlePicture& p, int width) {
  check(p, width);
  const Extent box = extent(p);
  const Vec2 size = box.high - box.low;
  const ColourScale values = scale_of(p);
  const double labels = values.label_width();
  const auto title = svg::wrapped(p.title, width - 2.0 * svg::margin, 1.05 * svg::title_size);
  const double top = 1.5 * svg::margin + svg::text_height(title.size(), svg::title_size);

  // The lines of the label go upward beside the bar, so their number depends on its height and the other way round: a
  // first guess of the height decides.
  const double room_without_label = width - 2.0 * svg::margin - bar_gap - colour_bar_width - 9.0 - labels;
  const auto height_for = [&](double room) { return std::clamp(room * size.y() / size.x(), 140.0, 1.2 * width); };
  const auto label = svg::wrapped(p.value_label, 0.9 * height_for(room_without_label), svg::label_size);
  const double room = room_without_label - svg::text_height(label.size(), svg::label_size) - 4.0;
  const double height = height_for(room);

  Projection projection;
  projection.low = box.low;
  projection.scale = std::min(room / size.x(), height / size.y());
  projection.left = svg::margin + 0.5 * (room - projection.scale * size.x());
  projection.bottom = top + 0.5 * (height + projection.scale * size.y());

  const svg::TextStyle heading{.size = svg::title_size, .bold = true};
  const svg::TextStyle upward{.size = svg::label_size, .anchor = svg::Anchor::middle, .upward = true};
  const double bar_left = svg::margin + room + bar_gap;
  std::string body = svg::text_lines(svg::margin, svg::margin + svg::title_size - 3.0, title, heading);
  body += dots(p, values, projection);
  for (const std::vector<Vec2>& points : p.outlines) body += outline(points, projection);
  body += colour_bar(values, bar_left, top, height);
  body += svg::text_lines(bar_left + colour_bar_width + 9.0 + labels + svg::label_size + 4.0, top + 0.5 * height, label,
                          upward);
  body += scale_bar(round_step(0.1 * room / projection.scale), projection, top + height + 0.4 * scale_room);
  if (p.position.empty())
    body += svg::text(svg::margin + 0.5 * room, top + 0.5 * height, "no particles to draw",
                      {.anchor = svg::Anchor::middle});
  return svg::document(width, top + height + scale_room + 0.5 * svg::margin, p.title, body);
}

} // namespace matrigrate::draw
