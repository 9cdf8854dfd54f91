#pragma once

#include "observe/frame.hpp"

#include <string>

/// Frames as a stack of pictures for Fiji, napari and other programs of microscopy.
/// Test: tests/unit/exchange/ome_tiff_test.cpp, tests/readers/ome_tiff_reads.py
namespace matrigrate::exchange {

/// An OME-TIFF of all frames: times and channels (field_pictures.hpp), 32-bit floating point, compressed by zlib, with
/// the size of pixels in um and the times in s, and their interval where they are evenly spaced; its upper edge is at
/// the largest y.
/// @param film   with at least one frame
/// @param pixel  width of a pixel, > 0 [um]
/// @throws InputOutputError if libtiff cannot write it
std::string ome_tiff(const observe::Film& film, double pixel, const std::string& title, const std::string& version);

/// The most pixels along an edge.
inline constexpr std::size_t most_pixels = 8192;

} // namespace matrigrate::exchange
