#include "fields/grids.hpp"

#include "base/file.hpp"
#include "base/platform.hpp"
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
#include <optional>
#include <stdexcept>
#include <tuple>
#include <utility>
#include <vector>

namespace matrigrate::fields {

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
      throw std::invalid_argument(fmt::format("a picture needs {0}=...: write \"{1} pixel=0.5 from=50 to=400\", the width of a pixel in um and the values of black and white",
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
    throw std::invalid_argument(fmt::format("has pixels of {:g} x {:g} um; scale it so that they are square, or state the width of a square pixel with pixel=",
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
    throw std::invalid_argument(fmt::format("direction={0:g} um: the radius around a pixel over which its direction is taken must be from {1:g} to {2:g} um, half a pixel to a hundred",
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
          "its samples are of floating point, from {:g} to {:g}: leave out from=, to=, black= and white= to take them as they are, or give all four: black= and white= are the samples that get the values from= and to=",
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
  const NamedGrid named{std::make_shared<const Grid>(read_grid(words, bytes)), words.text(file, hash)};
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
