#pragma once

#include "fields/scale.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

namespace matrigrate::fields {

// Pictures as numbers. Nothing converts what is stored: no gamma, no profile of colours. Test:
// tests/unit/fields/picture_test.cpp

/// The part of a picture that is wanted, counted from 1.
struct PictureChoice {
  std::optional<std::size_t> page;    ///< of a TIFF
  std::optional<std::size_t> channel; ///< 1 red, 2 green, 3 blue of a coloured one
};

/// The stored samples of a picture; of colours 0.2126 R + 0.7152 G + 0.0722 B (the weights of BT.709).
struct Picture {
  std::size_t width = 0, height = 0;
  std::vector<double> samples;        ///< row by row, downwards; finite
  std::optional<PixelSize> pixel{};   ///< that the file states for this page
  std::optional<double> black, white; ///< the samples that are black and white; none of samples of floating point
};

/// @param bytes  the content of a PNG or TIFF file: samples of up to 16 bits, 32 bits, or floating point
/// @throws std::invalid_argument saying why it cannot be read: damaged, more than 16 million pixels, another format, or
/// a page or channel has to be chosen, or transparent pixels
Picture read_picture(std::string_view bytes, const PictureChoice& choice);

// What the formats of pictures have in common. Test: tests/unit/fields/picture_test.cpp

/// How a sample is stored.
enum class SampleType : std::uint8_t { whole_8, whole_16, whole_32, real_32, real_64 };
std::size_t bytes_of(SampleType type);

/// All samples of one page as they are stored, channel by channel of a pixel, pixel by pixel, row by row downwards.
struct Raster {
  std::size_t width = 0, height = 0, channels = 1;
  bool colour = false; ///< the first three channels are red, green and blue
  bool alpha = false;  ///< the last channel tells how opaque a pixel is
  SampleType type = SampleType::whole_8;
  double full = 255.0;              ///< the largest sample; 1 of floating point
  bool zero_is_white = false;       ///< else black
  std::optional<PixelSize> pixel{}; ///< that the file states
  std::vector<std::byte> data;      ///< width * height * channels samples in the byte order of the machine

  /// Sets the size of the data.
  /// @throws std::invalid_argument if there are no pixels, or more than 16 million, or 64 million samples
  void allocate();

  double sample(std::size_t number) const;
};

/// @throws std::invalid_argument saying why it cannot be read
Raster read_png(std::string_view bytes);

/// @param page  from 1; may be left out if there is one only
/// @throws std::invalid_argument saying why it cannot be read
Raster read_tiff(std::string_view bytes, const std::optional<std::size_t>& page);

} // namespace matrigrate::fields
