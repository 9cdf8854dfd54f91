#pragma once

#include "base/vector.hpp"
#include "fields/samples.hpp"

#include <filesystem>
#include <memory>
#include <string>

/// Grids from files, each of which is read once. Test: tests/unit/fields/fields_test.cpp
namespace matrigrate::fields {

struct FileWords;

/// Values of a grid, from that of its zero to that of its one.
struct Grid {
  Samples samples;
  double from = 0.0, to = 1.0;

  double at(const Vec2& x) const { return from + (to - from) * samples.at(x); }
};

/// A grid and the text that gives the same one from any folder.
struct NamedGrid {
  std::shared_ptr<const Grid> grid;
  std::string text;
};

/// The grid that a text names. A file that has not changed since it was read by this process is not read again, as long
/// as its grid is among the last ones: eight, or 256 MB of values. Fingerprint and values are of the same bytes.
/// @throws std::invalid_argument if the file is not what the text says, or has another fingerprint
/// @throws InputOutputError if it cannot be read
NamedGrid grid_of(const FileWords& words, const std::filesystem::path& folder);

} // namespace matrigrate::fields
