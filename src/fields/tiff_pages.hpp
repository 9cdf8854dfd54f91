#pragma once

#include "fields/scale.hpp"

#include <tiffio.h>

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string_view>

/// TIFF files in memory, and the pages in them. Test: tests/unit/fields/picture_test.cpp,
/// tests/unit/fields/scale_test.cpp
namespace matrigrate::fields::tiff {

inline constexpr std::size_t max_block_bytes = std::size_t{1}
                                               << 28U; // of a strip or tile, and of all that libtiff takes

/// A TIFF in memory, as libtiff asks for it.
struct Source {
  std::string_view bytes;
  std::uint64_t at = 0;
  std::array<char, 200> message{}; ///< the first fault
};

using Tiff = std::unique_ptr<TIFF, void (*)(TIFF*)>;

/// @return  null if it is no TIFF
Tiff open(Source& source);

/// @throws std::invalid_argument always: it cannot be read, with libtiff's first fault
[[noreturn]] void refuse(const Source& source);

/// A tag of the directory at hand.
template <class Value>
Value value_of(TIFF* tiff, std::uint32_t tag, Value otherwise) {
  Value value = otherwise;
  return TIFFGetFieldDefaulted(tiff, tag, &value) == 0 ? otherwise : value;
}

/// What was chosen of a file.
struct Page {
  std::size_t plane = 0;          ///< of a stack in one directory, from 0; else 0
  std::optional<PixelSize> pixel; ///< as the file states it for this page
};

/// Makes the directory of a page that at hand. The pages of a file with one directory are those that ImageJ's
/// description counts ("images=3").
/// @param number  from 1; may be left out if there is one only
/// @throws std::invalid_argument if there is no such page, or one has to be chosen
Page choose_page(TIFF* tiff, const Source& source, const std::optional<std::size_t>& number);

} // namespace matrigrate::fields::tiff
