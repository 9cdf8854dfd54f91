#include "target.hpp"

#include "fields/picture.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <stdexcept>
#include <string_view>

/// The first byte chooses page and channel, the others are a PNG or TIFF from anywhere: it is refused, or it has a
/// finite sample for each pixel.
int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  matrigrate::fields::PictureChoice choice;
  if (data[0] % 4U > 0) choice.page = data[0] % 4U;
  if (data[0] / 4U % 4U > 0) choice.channel = data[0] / 4U % 4U;
  try {
    const matrigrate::fields::Picture picture =
        matrigrate::fields::read_picture({reinterpret_cast<const char*>(data + 1), size - 1}, choice);
    if (picture.samples.size() != picture.width * picture.height) std::abort();
    if (!std::ranges::all_of(picture.samples, [](double s) { return std::isfinite(s); })) std::abort();
  } catch (const std::invalid_argument&) { // refused
  }
  return 0;
}
