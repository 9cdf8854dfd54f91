#include "fields/grids.hpp"

#include "base/file.hpp"
#include "base/platform.hpp"
#include "base/text.hpp"
#include "fields/file_words.hpp"
#include "fields/picture.hpp"

#include <fmt/format.h>
#include <sys/stat.h>
#include <xxhash.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <initializer_list>
#include <mutex>
#include <numbers>
#include <optional>
#include <stdexcept>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace matrigrate::fields {

namespace {

constexpr double relative_slack = 1e-6; // of a spacing, within which nodes lie on a grid

std::vector<std::string_view> split(std::string_view text, char at) {
  std::vector<std::string_view> parts;
  for (;;) {
    const std::size_t end = text.find(at);
    std::string_view part = text.substr(0, end);
    while (!part.empty() && (part.back() == '\r' || part.back() == ' ')) part.remove_suffix(1);
    while (!part.empty() && part.front() == ' ') part.remove_prefix(1);
    parts.push_back(part);
    if (end == std::string_view::npos) return parts;
    text.remove_prefix(end + 1);
  }
}

double number(std::string_view field, std::size_t line) {
  const auto value = number_in<double>(field);
  if (!value || !std::isfinite(*value))
    throw std::invalid_argument(fmt::format("line {}: \"{}\" is no finite number", line, field.substr(0, 40)));
  return *value;
}

/// The header line, without the mark of UTF-8 and the quotes that some programs write.
std::vector<std::string_view> header_of(std::string_view line) {
  if (line.starts_with("\xef\xbb\xbf")) line.remove_prefix(3);
  std::vector<std::string_view> header = split(line, ',');
  for (std::string_view& name : header)
    if (name.size() > 1 && name.front() == '"' && name.back() == '"') name = name.substr(1, name.size() - 2);
  for (const auto& [sign, name] : {std::pair(';', "semicolons"), std::pair('\t', "tabs")})
    if (header.size() == 1 && line.find(sign) != std::string_view::npos)
      throw std::invalid_argument(
          fmt::format("has {} between its columns; write commas there, and points in numbers", name));
  return header;
}

/// The different coordinates, in order.
std::vector<double> levels(std::vector<double> coordinates, const char* axis) {
  std::ranges::sort(coordinates);
  const double extent = coordinates.back() - coordinates.front();
  if (!std::isfinite(extent)) throw std::invalid_argument(fmt::format("has values of {} too far apart", axis));
  const auto same = [&](double a, double b) { return b - a <= 1e-9 * std::max(extent, 1e-9); };
  coordinates.erase(std::unique(coordinates.begin(), coordinates.end(), same), coordinates.end());
  return coordinates;
}

double spacing_of(const std::vector<double>& level, const char* axis) {
  if (level.size() < 2)
    throw std::invalid_argument(fmt::format("has only one value of {}; a grid needs at least two", axis));
  const double step = (level.back() - level.front()) / static_cast<double>(level.size() - 1);
  for (std::size_t k = 0; k < level.size(); ++k)
    if (std::abs(level[k] - level.front() - step * static_cast<double>(k)) > relative_slack * step)
      throw std::invalid_argument(fmt::format("is no regular grid: {} is {} where {} is expected", axis, level[k],
                                              level.front() + step * static_cast<double>(k)));
  return step;
}

/// Values at places, each at its node. The memory for the nodes is not asked for before there is a value for each.
Samples on_grid(const std::vector<double>& x, const std::vector<double>& y, const std::vector<double>& value) {
  const std::vector<double> columns = levels(x, "x_um"), rows = levels(y, "y_um");
  Samples samples{.origin = {columns.front(), rows.front()},
                  .spacing = {spacing_of(columns, "x_um"), spacing_of(rows, "y_um")},
                  .columns = columns.size(),
                  .rows = rows.size(),
                  .values = {}};
  std::vector<std::size_t> nodes(x.size());
  for (std::size_t k = 0; k < x.size(); ++k) {
    const auto i = static_cast<std::size_t>(std::lround((x[k] - samples.origin.x()) / samples.spacing.x()));
    const auto j = static_cast<std::size_t>(std::lround((y[k] - samples.origin.y()) / samples.spacing.y()));
    nodes[k] = j * samples.columns + i;
  }
  std::vector<std::size_t> in_order = nodes;
  std::ranges::sort(in_order);
  const auto place = [&](std::size_t node) {
    return fmt::format("the node ({}, {}) um", columns[node % samples.columns], rows[node / samples.columns]);
  };
  if (const auto twice = std::ranges::adjacent_find(in_order); twice != in_order.end())
    throw std::invalid_argument(fmt::format("has {} twice", place(*twice)));
  if (const std::size_t expected = samples.columns * samples.rows; in_order.size() != expected) {
    std::size_t missing = 0;
    while (missing < in_order.size() && in_order[missing] == missing) ++missing;
    throw std::invalid_argument(fmt::format("has no value for {}: a grid of {} x {} nodes has {} rows, this has {}",
                                            place(missing), samples.columns, samples.rows, expected, x.size()));
  }
  samples.values.resize(x.size());
  for (std::size_t k = 0; k < x.size(); ++k) samples.values[nodes[k]] = value[k];
  return samples;
}

} // namespace

Vec2 Samples::end() const {
  return origin + Vec2(spacing.x() * static_cast<double>(columns - 1), spacing.y() * static_cast<double>(rows - 1));
}

namespace {

/// Bilinear between the nodes around x.
/// @param of  what is taken of each value
template <class Of>
double between_nodes(const Samples& s, const Vec2& x, const Of& of) {
  const auto cell = [](double position, std::size_t nodes) {
    const double inside = std::clamp(position, 0.0, static_cast<double>(nodes - 1));
    const auto k = std::min(static_cast<std::size_t>(inside), nodes < 2 ? 0 : nodes - 2);
    return std::pair(k, inside - static_cast<double>(k));
  };
  const auto [i, u] = cell((x.x() - s.origin.x()) / s.spacing.x(), s.columns);
  const auto [j, v] = cell((x.y() - s.origin.y()) / s.spacing.y(), s.rows);
  const auto value = [&](std::size_t column, std::size_t row) {
    return of(s.values[std::min(row, s.rows - 1) * s.columns + std::min(column, s.columns - 1)]);
  };
  const double low = (1.0 - u) * value(i, j) + u * value(i + 1, j);
  const double high = (1.0 - u) * value(i, j + 1) + u * value(i + 1, j + 1);
  return (1.0 - v) * low + v * high;
}

} // namespace

double Samples::at(const Vec2& x) const {
  if (axes) return axis_at(x, 0.0, 1.0);
  return between_nodes(*this, x, [](double value) { return value; });
}

double Samples::axis_at(const Vec2& x, double from, double per_value) const {
  constexpr double twice = 2.0 * std::numbers::pi / 180.0; // directions without a sense repeat after 180 degrees
  const auto angle = [=](double value) { return twice * (from + per_value * value); };
  return std::atan2(between_nodes(*this, x, [&](double value) { return std::sin(angle(value)); }),
                    between_nodes(*this, x, [&](double value) { return std::cos(angle(value)); }))
         / twice;
}

Samples samples_from_csv(std::string_view csv, std::string_view column) {
  const std::vector<std::string_view> lines = split(csv, '\n');
  const std::vector<std::string_view> header = header_of(lines.front());
  const auto find = [&](std::string_view name) {
    const auto found = std::ranges::find(header, name);
    if (found == header.end())
      throw std::invalid_argument(
          fmt::format("has no column {}; its header is \"{}\"", name, lines.front().substr(0, 80)));
    if (std::ranges::count(header, name) > 1) throw std::invalid_argument(fmt::format("has two columns {}", name));
    return static_cast<std::size_t>(found - header.begin());
  };
  const std::size_t at_x = find("x_um"), at_y = find("y_um");
  if (column.empty() && header.size() < 3) throw std::invalid_argument("has no third column");
  const std::size_t at_value = column.empty() ? 2 : find(column);
  if (column.empty() && (at_x == 2 || at_y == 2))
    throw std::invalid_argument(
        fmt::format("has {} as its third column; name the column of the values with column=", header[2]));
  std::vector<double> x, y, value;
  for (std::size_t k = 1; k < lines.size(); ++k) {
    if (lines[k].empty()) continue;
    const std::vector<std::string_view> fields = split(lines[k], ',');
    if (fields.size() != header.size())
      throw std::invalid_argument(
          fmt::format("line {}: has {} fields, its header {}", k + 1, fields.size(), header.size()));
    x.push_back(number(fields[at_x], k + 1));
    y.push_back(number(fields[at_y], k + 1));
    value.push_back(number(fields[at_value], k + 1));
  }
  if (x.empty()) throw std::invalid_argument("has no rows");
  Samples samples = on_grid(x, y, value);
  samples.column = header[at_value];
  return samples;
}

Samples samples_from_picture(const Picture& picture, double pixel, const Vec2& centre, double zero, double one) {
  const std::size_t width = picture.width, height = picture.height;
  Samples samples{.origin =
                      centre - 0.5 * pixel * Vec2(static_cast<double>(width) - 1.0, static_cast<double>(height) - 1.0),
                  .spacing = {pixel, pixel},
                  .columns = width,
                  .rows = height,
                  .values = std::vector<double>(picture.samples.size())};
  for (std::size_t row = 0; row < height; ++row)
    for (std::size_t column = 0; column < width; ++column)
      samples.values[row * width + column] =
          (picture.samples[(height - 1 - row) * width + column] - zero) / (one - zero);
  return samples;
}

namespace {

constexpr std::size_t max_file_bytes = std::size_t{1} << 28U;
constexpr std::size_t kept_grids = 8, kept_values = std::size_t{1} << 25U;

/// Changes whenever a file does.
using Version = std::tuple<dev_t, ino_t, off_t, std::array<std::int64_t, 4>>;

std::optional<Version> version_of(const std::filesystem::path& file) {
  struct stat status {};
  if (::stat(file.c_str(), &status) != 0) return std::nullopt;
  return Version(status.st_dev, status.st_ino, status.st_size, platform::times_of(status));
}

void require(const FileWords& words, std::initializer_list<const char*> keys) {
  for (const char* needed : keys)
    if (!words.options.contains(needed))
      throw std::invalid_argument(fmt::format("a picture needs {0}=...: write \"{1} pixel=0.5 from=50 to=400\", the "
                                              "width of a pixel in um and the values of black and white",
                                              needed, words.name.string()));
}

/// The width of a pixel: as the text says, else as the file states it [um].
double pixel_of(const FileWords& words, const Picture& picture) {
  const std::optional<double> given = words.number("pixel");
  if (given && *given <= 0.0) throw std::invalid_argument("pixel must be above 0 um");
  if (given) return *given;
  if (!picture.pixel) require(words, {"pixel"});
  const auto [width, height] = *picture.pixel;
  if (std::abs(width - height) > 1e-3 * std::max(width, height))
    throw std::invalid_argument(fmt::format("has pixels of {:g} x {:g} um; scale it so that they are square, or state "
                                            "the width of a square pixel with pixel=",
                                            width, height));
  return width;
}

/// The sample that has a share of all below it, straight between neighbours.
double percentile(std::vector<double> samples, double share) {
  const double at = share * static_cast<double>(samples.size() - 1);
  const auto below = samples.begin() + static_cast<std::ptrdiff_t>(at);
  std::nth_element(samples.begin(), below, samples.end());
  const auto above = std::min_element(below + 1, samples.end());
  return above == samples.end() ? *below : *below + (at - std::floor(at)) * (*above - *below);
}

/// The sample that black= or white= names, as a number or as a percentile.
std::optional<double> sample_of(const FileWords& words, const char* key, const Picture& picture) {
  const auto amount = words.amount(key);
  if (!amount) return std::nullopt;
  return amount->percent ? percentile(picture.samples, amount->value) : amount->value;
}

/// Directions of fibres, by the structure tensor.
Grid direction_grid(const FileWords& words, Picture picture, double pixel, const Vec2& centre) {
  for (const char* key : {"from", "to", "black", "white"})
    if (words.options.contains(key))
      throw std::invalid_argument(fmt::format("direction= gives degrees, and takes no {}=", key));
  const double window = *words.number("direction");
  if (window < 0.5 * pixel || window > 100.0 * pixel)
    throw std::invalid_argument(fmt::format("direction={0:g} um: the radius around a pixel over which its direction is "
                                            "taken must be from {1:g} to {2:g} um, half a pixel to a hundred",
                                            window, 0.5 * pixel, 100.0 * pixel));
  picture.samples = fibre_directions(picture, window / pixel);
  Grid grid{samples_from_picture(picture, pixel, centre, 0.0, 1.0)};
  grid.samples.axes = true;
  return grid;
}

Grid picture_grid(const FileWords& words, std::string_view bytes) {
  const Vec2 centre(words.number("x").value_or(0.0), words.number("y").value_or(0.0));
  const auto from = words.number("from"), to = words.number("to");
  const Picture picture = read_picture(bytes, {.page = words.count("page"), .channel = words.count("channel")});
  const double pixel = pixel_of(words, picture);
  if (words.options.contains("direction")) return direction_grid(words, picture, pixel, centre);
  auto black = sample_of(words, "black", picture), white = sample_of(words, "white", picture);
  if (picture.black) {
    require(words, {"from", "to"});
  } else {
    if (!from && !to && !black && !white) return {samples_from_picture(picture, pixel, centre, 0.0, 1.0), 0.0, 1.0};
    if (!from || !to || !black || !white) {
      const auto [least, largest] = std::ranges::minmax(picture.samples);
      throw std::invalid_argument(fmt::format(
          "its samples are of floating point, from {:g} to {:g}: leave out from=, to=, black= and white= to take them "
          "as they are, or give all four: black= and white= are the samples that get the values from= and to=",
          least, largest));
    }
  }
  if (!black) black = picture.black;
  if (!white) white = picture.white;
  if (*black == *white) throw std::invalid_argument("black= and white= must be different");
  return {samples_from_picture(picture, pixel, centre, *black, *white), *from, *to};
}

Grid read_grid(const FileWords& words, std::string_view bytes) {
  try {
    if (words.picture()) return picture_grid(words, bytes);
    return {samples_from_csv(bytes, words.word("column"))};
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(fmt::format("{}: {}", words.name.string(), error.what()));
  }
}

} // namespace

/// What was read of a file.
struct Grids::Kept {
  std::filesystem::path file;
  std::optional<Version> version; ///< before it was read
  std::string hash;
  NamedGrid of;
};

Grids::Grids() = default;
Grids::~Grids() = default;

/// The first that fits.
template <class Fits>
std::optional<Grids::Kept> Grids::kept(const Fits& fits) {
  const std::scoped_lock lock(m_mutex);
  const auto found = std::ranges::find_if(m_kept, fits);
  return found == m_kept.end() ? std::nullopt : std::optional(*found);
}

NamedGrid Grids::of(const FileWords& words, const std::filesystem::path& folder) {
  const std::filesystem::path file = std::filesystem::absolute(folder / words.name).lexically_normal();
  const std::optional<Version> version = version_of(file);
  const auto same = kept([&](const Kept& one) { return one.file == file && one.version && one.version == version; });
  std::string hash = same ? same->hash : "", bytes;
  const auto read = [&] {
    bytes = read_file(file, max_file_bytes);
    hash = fmt::format("{:016x}", XXH3_64bits(bytes.data(), bytes.size()));
  };
  if (hash.empty()) read();
  if (const std::string given = words.word("hash"); !given.empty() && given != hash)
    throw std::invalid_argument(
        fmt::format("{} has changed: its fingerprint is {}, and was {}", file.string(), hash, given));
  const std::string text = words.text(file, hash);
  if (const auto known = kept([&](const Kept& one) { return one.of.text == text; })) return known->of;
  if (bytes.empty()) read();
  NamedGrid named{std::make_shared<const Grid>(read_grid(words, bytes)), words.text(file, hash)};
  const std::scoped_lock lock(m_mutex);
  std::erase_if(m_kept, [&](const Kept& other) { return other.of.text == named.text; });
  m_kept.insert(m_kept.begin(), {file, version, hash, named});
  std::size_t number = 0, values = 0;
  while (number < std::min(m_kept.size(), kept_grids) && values <= kept_values)
    values += m_kept[number++].of.grid->samples.values.size();
  if (values > kept_values && number > 1) --number;
  m_kept.resize(number);
  return named;
}

} // namespace matrigrate::fields
