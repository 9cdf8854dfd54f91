#include "draw/particle_picture.hpp"

#include <Eigen/Geometry>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <span>
#include <stdexcept>
#include <string_view>

namespace matrigrate::draw {

namespace {

// The few pieces of SVG that pictures are made of. Lengths are pixels, x to the right, y down. No element carries an
// id, so that many pictures can stand in one page.

constexpr std::string_view dark = "#1f2328"; ///< text, frames
constexpr double margin = 12.0;              ///< free on all sides of a picture
constexpr double title_size = 18.0, label_size = 17.0, tick_size = 16.0;
constexpr double line_height = 1.3; ///< distance of two lines of text over their size

/// Text for the inside of an element or attribute of XML; control characters that XML forbids become spaces.
std::string escape(std::string_view text) {
  constexpr std::string_view special = "&<>\"'";
  constexpr std::array<std::string_view, 5> entities{"&amp;", "&lt;", "&gt;", "&quot;", "&#39;"};
  std::string out;
  for (const char c : text) {
    const bool forbidden = (static_cast<unsigned char>(c) < 0x20 && c != '\t' && c != '\n' && c != '\r') || c == 0x7f;
    if (const std::size_t at = special.find(c); at != std::string_view::npos)
      out += entities[at];
    else
      out += forbidden ? ' ' : c;
  }
  return out;
}

/// Rounded to a tenth of a pixel, without trailing zeros, the same in every locale: "12.5", "3", "-0.4".
std::string coordinate(double value) {
  std::string out = fmt::format("{:.1f}", value);
  if (out.ends_with(".0")) out.resize(out.size() - 2);
  return out == "-0" ? "0" : out;
}

/// A point of a path: "12.5 3".
std::string point(double x, double y) { return coordinate(x) + ' ' + coordinate(y); }

struct TextStyle {
  double size = tick_size;
  bool in_middle = false; ///< its point is that of its middle, not of its start
  bool bold = false;
  bool upward = false; ///< turned by -90 degrees about its point, read from bottom to top
};

/// A line of text with its base line at (x, y).
std::string text(double x, double y, std::string_view content, const TextStyle& style) {
  std::string out = fmt::format("<text x=\"{}\" y=\"{}\" font-size=\"{}\"", coordinate(x), coordinate(y), style.size);
  if (style.in_middle) out += " text-anchor=\"middle\"";
  if (style.bold) out += " font-weight=\"600\"";
  if (style.upward) out += fmt::format(" transform=\"rotate(-90 {})\"", point(x, y));
  return out + '>' + escape(content) + "</text>\n";
}

/// Lines of text below each other, the first one with its base line at (x, y); upward text goes on to the right.
std::string text_lines(double x, double y, const std::vector<std::string>& lines, const TextStyle& style) {
  std::string out;
  for (const auto& content : lines) {
    out += text(x, y, content, style);
    (style.upward ? x : y) += line_height * style.size;
  }
  return out;
}

/// @param paint  attributes: fill="#ffffff"
std::string rectangle(double x, double y, double width, double height, const std::string& paint) {
  return fmt::format("<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" {}/>\n", coordinate(x), coordinate(y),
                     coordinate(width), coordinate(height), paint);
}

std::string filled(std::string_view colour) { return fmt::format("fill=\"{}\"", colour); }

/// Width of a line of text in a common sans-serif font, estimated on the wide side.
double text_width(std::string_view content, double size) {
  // Bytes 10xxxxxx go on with a character of UTF-8 and take no room of their own.
  const auto goes_on = [](char c) { return (static_cast<unsigned char>(c) & 0xC0) == 0x80; };
  return 0.55 * size * static_cast<double>(std::ranges::count(content, false, goes_on));
}

/// The text cut at spaces into lines not wider than `width`; a longer word stays whole. Empty text gives no line.
std::vector<std::string> wrapped(std::string_view content, double width, double size) {
  std::vector<std::string> lines;
  for (std::size_t begin = 0; begin < content.size();) {
    const std::size_t end = std::min(content.find(' ', begin), content.size());
    const std::string_view word = content.substr(begin, end - begin);
    begin = end + 1;
    if (word.empty()) continue;
    if (!lines.empty() && text_width(lines.back(), size) + text_width(word, size) + 0.55 * size <= width)
      lines.back().append(" ").append(word);
    else
      lines.emplace_back(word);
  }
  return lines;
}

double text_height(std::size_t lines, double size) { return line_height * size * static_cast<double>(lines); }

// Values as colours, and the bar that explains them.

constexpr int colour_levels = 33;         ///< steps of the colours
constexpr double colour_bar_width = 18.0; ///< [pixel]

constexpr double slack = 1e-9; ///< share of a step by which a bound may miss its tick through rounding

/// mantissa x 10^exponent
struct RoundNumber {
  int mantissa = 1;
  int exponent = 0;
  double value() const { return mantissa * std::pow(10.0, exponent); }
};

/// The smallest of 1, 2, 5 times a power of ten that is not below `least`, which is positive.
RoundNumber round_number(double least) {
  const int exponent = static_cast<int>(std::floor(std::log10(least) + slack));
  for (const int mantissa : {1, 2, 5})
    if (mantissa * std::pow(10.0, exponent) >= least * (1.0 - slack)) return {mantissa, exponent};
  return {1, exponent + 1};
}

/// The typographic minus is as wide as a digit.
std::string with_minus(std::string_view number) {
  std::string out;
  for (const char c : number) out += c == '-' ? "\u2212" : std::string(1, c);
  return out;
}

/// A number with `decimals` decimals in units of 10^exponent.
std::string label(double value, int exponent, int decimals) {
  if (exponent == 0) return with_minus(fmt::format("{:.{}f}", value, decimals));
  if (value == 0.0) return "0";
  return with_minus(fmt::format("{:.{}f}e{}", value / std::pow(10.0, exponent), decimals, exponent));
}

struct Tick {
  double value = 0.0;
  std::string label;
};

/// Multiples of a round step in [low, high]: at most 8 of them, all labelled to the same number of digits.
std::vector<Tick> linear_ticks(double low, double high) {
  constexpr int most = 7; // steps
  const RoundNumber step = round_number((high - low) / most);
  const double first = std::ceil(low / step.value() - slack);
  const double last = std::floor(high / step.value() + slack);
  // Numbers from 0.0001 to a million are written out, others in units of the power of ten of the largest one.
  const double largest = std::max(std::abs(first), std::abs(last)) * step.value();
  const int magnitude = largest > 0.0 ? static_cast<int>(std::floor(std::log10(largest) + slack)) : step.exponent;
  const int unit = magnitude >= -4 && magnitude < 6 ? 0 : magnitude;
  const int decimals = std::clamp(unit - step.exponent, 0, 17);
  std::vector<Tick> ticks;
  for (int i = 0; i <= most + 1 && first + i <= last; ++i) {
    const double value = (first + i) * step.value() + 0.0; // no negative zero
    ticks.push_back({value, label(value, unit, decimals)});
  }
  return ticks;
}

/// The values that the ends of the colours stand for, low < high.
struct ColourScale {
  double low = 0.0, high = 1.0;

  /// Step of the colours; -1 if the value is not finite.
  int level(double value) const {
    if (!std::isfinite(value)) return -1;
    const double share = std::clamp((value - low) / (high - low), 0.0, 1.0);
    return std::min(static_cast<int>(share * colour_levels), colour_levels - 1);
  }
  std::vector<Tick> ticks() const { return linear_ticks(low, high); }
  /// Of the widest tick label [pixel].
  double label_width() const {
    double width = 0.0;
    for (const Tick& tick : ticks()) width = std::max(width, text_width(tick.label, tick_size));
    return width;
  }
};

/// From the smallest to the largest value; [0, 1] where there are none.
ColourScale fitted_scale(std::span<const double> values) {
  if (values.empty()) return {};
  const auto [low, high] = std::ranges::minmax(values);
  if (high - low > std::max(1e-12 * std::abs(low), 1e-150)) return {low, high};
  const double half = std::abs(low) <= 1e-150 ? 1.0 : 0.1 * std::abs(low); // a neighbourhood with legible ticks
  return {low - half, high + half};
}

/// Viridis, dark blue to yellow: its lightness rises evenly, for people with any kind of colour vision.
/// @param level  not -1   @return "#rrggbb"
std::string colour(int level) {
  // Anchors at equal distances; the colours between them are interpolated linearly.
  constexpr std::array<unsigned, 10> viridis{0x440154, 0x482878, 0x3e4989, 0x31688e, 0x26828e,
                                             0x1f9e89, 0x35b779, 0x6ece58, 0xb5de2b, 0xfde725};
  const double place = (level + 0.5) / colour_levels * static_cast<double>(viridis.size() - 1);
  const auto below = std::min(static_cast<std::size_t>(place), viridis.size() - 2);
  const double t = place - static_cast<double>(below);
  const auto mix = [&](unsigned shift) {
    const auto part = [&](unsigned rgb) { return static_cast<double>(rgb >> shift & 0xffU); };
    return std::lround(part(viridis[below]) + t * (part(viridis[below + 1]) - part(viridis[below])));
  };
  return fmt::format("#{:02x}{:02x}{:02x}", mix(16), mix(8), mix(0));
}

/// The bar with its numbers at the right.
std::string colour_bar(const ColourScale& scale, double left, double top, double height) {
  const double bottom = top + height;
  const double step = height / colour_levels;
  std::string out;
  for (int level = 0; level < colour_levels; ++level) // each step reaches half a pixel under the next: no gap shows
    out += rectangle(left, bottom - (level + 1) * step, colour_bar_width, step + (level > 0 ? 0.5 : 0.0),
                     filled(colour(level)));
  out += rectangle(left, top, colour_bar_width, height, fmt::format("fill=\"none\" stroke=\"{}\"", dark));
  for (const Tick& t : scale.ticks()) {
    const double right = left + colour_bar_width;
    const double y = bottom - (t.value - scale.low) / (scale.high - scale.low) * height;
    out += fmt::format("<path d=\"M{}L{}\" stroke=\"{}\" stroke-width=\"1\"/>\n", point(right, y),
                       point(right + 5.0, y), dark);
    out += text(right + 9.0, y + 5.5, t.label, {});
  }
  return out;
}

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
Eigen::AlignedBox2d extent(const ParticlePicture& p) {
  const Vec2 half = Vec2::Constant(0.5 * p.particle_size);
  Eigen::AlignedBox2d box;
  for (const Vec2& x : p.position)
    if (finite(x)) box.extend(x - half).extend(x + half);
  return box.isEmpty() ? Eigen::AlignedBox2d(-half, half) : box;
}

ColourScale scale_of(const ParticlePicture& p) {
  if (p.value_min != 0.0 || p.value_max != 0.0) return {p.value_min, p.value_max};
  std::vector<double> values;
  // finite, and not so large that differences overflow
  std::ranges::copy_if(p.value, std::back_inserter(values), [](double value) { return std::abs(value) < 1e150; });
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
    path[level < 0 ? 0 : 1 + static_cast<std::size_t>(level)] += 'M' + point(a.x(), a.y()) + "h0";
  }
  const double side = overlap * p.particle_size * projection.scale;
  std::string out = fmt::format("<g fill=\"none\" stroke-linecap=\"square\" stroke-width=\"{:.2f}\">\n", side);
  for (int level = -1; const std::string& data : path) {
    if (!data.empty())
      out += level < 0 ? fmt::format("<path stroke=\"{}\" d=\"{}\" stroke-width=\"{:.2f}\"/>\n", missing, data,
                                     overlap_of_missing * side)
                       : fmt::format("<path stroke=\"{}\" d=\"{}\"/>\n", colour(level), data);
    ++level;
  }
  return out + "</g>\n";
}

/// A closed curve, dark with a light edge.
std::string outline(const std::vector<Vec2>& points, const Projection& projection) {
  std::string path;
  for (const Vec2& x : points) {
    const Vec2 a = projection.at(x);
    path += (path.empty() ? 'M' : 'L') + point(a.x(), a.y());
  }
  if (path.empty()) return path;
  return fmt::format("<path fill=\"none\" stroke=\"#ffffff\" stroke-width=\"3.4\" d=\"{0}Z\"/>\n"
                     "<path fill=\"none\" stroke=\"{1}\" stroke-width=\"1.6\" d=\"{0}Z\"/>\n",
                     path, dark);
}

std::string scale_bar(double um, const Projection& projection, double y) {
  const double length = um * projection.scale;
  return rectangle(projection.left, y, length, 5.0, filled(dark))
         + text(projection.left + length + 8.0, y + 8.5, fmt::format("{} µm", um), {});
}

} // namespace

std::string to_svg(const ParticlePicture& p, int width) {
  check(p, width);
  const Eigen::AlignedBox2d box = extent(p);
  const Vec2 size = box.sizes();
  const ColourScale values = scale_of(p);
  const double labels = values.label_width();
  const auto title = wrapped(p.title, width - 2.0 * margin, 1.05 * title_size);
  const double top = 1.5 * margin + text_height(title.size(), title_size);

  // The lines of the label go upward beside the bar, so their number depends on its height and the other way round: a
  // first guess of the height decides.
  const double room_without_label = width - 2.0 * margin - bar_gap - colour_bar_width - 9.0 - labels;
  const auto height_for = [&](double room) { return std::clamp(room * size.y() / size.x(), 140.0, 1.2 * width); };
  const auto label = wrapped(p.value_label, 0.9 * height_for(room_without_label), label_size);
  const double room = room_without_label - text_height(label.size(), label_size) - 4.0;
  const double height = height_for(room);

  Projection projection;
  projection.low = box.min();
  projection.scale = std::min(room / size.x(), height / size.y());
  projection.left = margin + 0.5 * (room - projection.scale * size.x());
  projection.bottom = top + 0.5 * (height + projection.scale * size.y());

  const TextStyle heading{.size = title_size, .bold = true};
  const TextStyle upward{.size = label_size, .in_middle = true, .upward = true};
  const double bar_left = margin + room + bar_gap;
  std::string body = text_lines(margin, margin + title_size - 3.0, title, heading);
  body += dots(p, values, projection);
  for (const std::vector<Vec2>& points : p.outlines) body += outline(points, projection);
  body += colour_bar(values, bar_left, top, height);
  body += text_lines(bar_left + colour_bar_width + 9.0 + labels + label_size + 4.0, top + 0.5 * height, label, upward);
  body += scale_bar(round_number(0.1 * room / projection.scale).value(), projection, top + height + 0.4 * scale_room);
  if (p.position.empty())
    body += text(margin + 0.5 * room, top + 0.5 * height, "no particles to draw", {.in_middle = true});
  const std::string w = coordinate(width), h = coordinate(top + height + scale_room + 0.5 * margin);
  return fmt::format("<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1}\" viewBox=\"0 0 {0} {1}\" "
                     "role=\"img\" "
                     "aria-label=\"{2}\" font-family=\"Helvetica, Arial, 'DejaVu Sans', sans-serif\" fill=\"{3}\">\n",
                     w, h, escape(p.title), dark)
         + rectangle(0, 0, width, top + height + scale_room + 0.5 * margin, filled("#ffffff")) + body + "</svg>\n";
}

} // namespace matrigrate::draw
