#include "fields/picture.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <cstring>
#include <stdexcept>
#include <string>

namespace matrigrate::fields {

namespace {

constexpr std::size_t max_pixels = 16'000'000;
constexpr std::size_t max_samples = 4 * max_pixels;

// Of red, green and blue. As whole numbers they give a grey picture that is stored in colours its very samples.
constexpr std::array<double, 3> weights{2126.0, 7152.0, 722.0};
constexpr double sum_of_weights = 10000.0;

bool is_tiff(std::string_view bytes) {
  using namespace std::string_view_literals;
  return bytes.starts_with("II*\0"sv) || bytes.starts_with("MM\0*"sv) || bytes.starts_with("II+\0"sv)
         || bytes.starts_with("MM\0+"sv);
}

Raster read_raster(std::string_view bytes, const std::optional<std::size_t>& page) {
  if (is_tiff(bytes)) return read_tiff(bytes, page);
  if (!bytes.starts_with("\x89PNG"))
    throw std::invalid_argument(fmt::format("is neither PNG nor TIFF{}, whatever its name says",
                                            bytes.starts_with("\xff\xd8\xff") ? " but JPEG" : ""));
  if (page && *page > 1) throw std::invalid_argument(fmt::format("has no page {}: a PNG has one", *page));
  return read_png(bytes);
}

template <class Number>
double number_at(const std::vector<std::byte>& data, std::size_t number) {
  Number value{};
  std::memcpy(&value, data.data() + number * sizeof(Number), sizeof(Number));
  return static_cast<double>(value);
}

void require_opaque(const Raster& raster) {
  for (std::size_t k = raster.channels - 1; k < raster.width * raster.height * raster.channels; k += raster.channels)
    if (raster.sample(k) != raster.full)
      throw std::invalid_argument(
          fmt::format("has transparent pixels, whose values are undefined: save it without transparency, or take the "
                      "samples of one channel with channel=1 to channel={}",
                      raster.channels));
}

/// The one channel that is taken; none for the mean of the colours.
/// @throws std::invalid_argument if there is no such channel, or one has to be chosen
std::optional<std::size_t> channel_of(const Raster& raster, const std::optional<std::size_t>& choice) {
  if (choice) {
    if (*choice > raster.channels)
      throw std::invalid_argument(fmt::format("has no channel {}: it has {}", *choice, raster.channels));
    return *choice - 1;
  }
  const std::size_t shown = raster.colour ? 3 : 1;
  if (raster.channels != shown + (raster.alpha ? 1 : 0))
    throw std::invalid_argument(
        fmt::format("has {0} channels: choose one with channel=1 to channel={0}", raster.channels));
  if (raster.alpha) require_opaque(raster);
  return raster.colour ? std::nullopt : std::optional<std::size_t>(0);
}

} // namespace

std::size_t bytes_of(SampleType type) {
  constexpr std::array<std::size_t, 5> bytes{1, 2, 4, 4, 8};
  return bytes.at(static_cast<std::size_t>(type));
}

void Raster::allocate() {
  if (width == 0 || height == 0 || width > max_pixels / height)
    throw std::invalid_argument(
        fmt::format("is a picture of {} x {} pixels; allowed are 1 to 16 million", width, height));
  if (channels > max_samples / (width * height))
    throw std::invalid_argument(
        fmt::format("has {} channels of {} x {} pixels; allowed are 64 million samples", channels, width, height));
  data.resize(width * height * channels * bytes_of(type));
}

double Raster::sample(std::size_t number) const {
  switch (type) {
  case SampleType::whole_8:
    return number_at<std::uint8_t>(data, number);
  case SampleType::whole_16:
    return number_at<std::uint16_t>(data, number);
  case SampleType::whole_32:
    return number_at<std::uint32_t>(data, number);
  case SampleType::real_32:
    return number_at<float>(data, number);
  case SampleType::real_64:
    break;
  }
  return number_at<double>(data, number);
}

Picture read_picture(std::string_view bytes, const PictureChoice& choice) {
  const Raster raster = read_raster(bytes, choice.page);
  const std::optional<std::size_t> channel = channel_of(raster, choice.channel);
  Picture picture{
      .width = raster.width, .height = raster.height, .samples = {}, .pixel = raster.pixel, .black = {}, .white = {}};
  picture.samples.resize(raster.width * raster.height);
  for (std::size_t k = 0; k < picture.samples.size(); ++k) {
    const std::size_t first = k * raster.channels;
    double& sample = picture.samples[k];
    if (channel)
      sample = raster.sample(first + *channel);
    else
      sample = (weights[0] * raster.sample(first) + weights[1] * raster.sample(first + 1)
                + weights[2] * raster.sample(first + 2))
               / sum_of_weights;
    if (!std::isfinite(sample))
      throw std::invalid_argument(
          fmt::format("has no finite number in the pixel of column {} and row {}, counted from 1 at the upper left",
                      k % raster.width + 1, k / raster.width + 1));
  }
  if (raster.type == SampleType::real_32 || raster.type == SampleType::real_64) return picture;
  picture.black = raster.zero_is_white ? raster.full : 0.0;
  picture.white = raster.zero_is_white ? 0.0 : raster.full;
  return picture;
}

} // namespace matrigrate::fields
