#pragma once

#include "fields/scale.hpp"

#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

/// Pictures as numbers. Nothing converts what is stored: no gamma, no profile of colours. Test:
/// tests/unit/fields/picture_test.cpp
namespace matrigrate::fields {

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

} // namespace matrigrate::fields
