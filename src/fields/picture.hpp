#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace matrigrate::fields {

// Pictures as numbers. Nothing converts what is stored: no gamma, no profile of colours. Test:
// tests/unit/fields/picture_test.cpp

/// Sides of a pixel [um].
struct PixelSize {
  double width = 0.0, height = 0.0;

  bool operator==(const PixelSize&) const = default;
};

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

/// The direction along which a picture changes least around each pixel: that of the eigenvector of the smaller
/// eigenvalue of the structure tensor, the mean of (grad s)(grad s)^T weighted by a normal distribution around the
/// pixel. Slopes are differences of fourth order of the picture smoothed over one pixel.
/// @param window  standard deviation of the weights, > 0 [pixel]
/// @return degrees from the x axis, in (-90, 90], y upwards, row by row downwards; where the picture is even, the
/// direction of the whole picture
/// @throws std::invalid_argument if all of the picture is even, or it is smaller than 3 x 3 pixels
std::vector<double> fibre_directions(const Picture& picture, double window);

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

/// What a TIFF says of the scale of a page.
struct StatedScale {
  std::string description;                       ///< of its first page: OME-XML, or what ImageJ writes
  double x_resolution = 0.0, y_resolution = 0.0; ///< of the page: pixels in a unit; 0: not stated
  bool in_centimetres = false;                   ///< whether that unit is one
  std::size_t directory = 0;                     ///< the page's number among all, from 0
  std::size_t columns = 0, rows = 0;             ///< of the page [pixel]; 0: any
};

/// From the Image of OME-XML that the page belongs to (PhysicalSizeX), from ImageJ's description (unit=micron), or from
/// pixels in a centimetre. Pixels in an inch are those of printers, and state nothing.
/// @return nothing if the file does not state it
std::optional<PixelSize> pixel_size(const StatedScale& scale);

} // namespace matrigrate::fields
