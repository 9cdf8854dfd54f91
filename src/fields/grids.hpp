#pragma once

#include "base/vector.hpp"
#include "fields/samples.hpp"

#include <filesystem>
#include <memory>
#include <string>

/// Grids from files. Test: tests/unit/fields/fields_test.cpp
namespace matrigrate::fields {

struct FileWords;

/// Values of a grid, from that of its zero to that of its one.
struct Grid {
  Samples samples;
  double from = 0.0, to = 1.0;

  double at(const Vec2& x) const { return from + (to - from) * samples.at(x); }
  double axis_at(const Vec2& x, double factor) const { ///< of factor times these values [degrees]
    return samples.axis_at(x, factor * from, factor * (to - from));
  }
};

/// A grid and the text that gives the same one from any folder.
struct NamedGrid {
  std::shared_ptr<const Grid> grid;
  std::string text;
};

/// The grids of a scenario or a study, so that each file is read once: the last eight of them, or 256 MB of values.
/// Threads may share it. What it keeps changes no result, since a text names a file together with its fingerprint.
class Grids {
public:
  Grids();
  Grids(const Grids&) = delete;
  Grids& operator=(const Grids&) = delete;
  ~Grids();

  /// The grid that a text names. A file that has not changed since it was read is not read again, as long as its grid
  /// is kept. Fingerprint and values are of the same bytes.
  /// @param folder  that a relative name counts from
  /// @throws std::invalid_argument if the file is not what the text says, or has another fingerprint
  /// @throws InputOutputError if it cannot be read
  NamedGrid of(const FileWords& words, const std::filesystem::path& folder);

private:
  class Keeper;
  std::unique_ptr<Keeper> m_keeper;
};

} // namespace matrigrate::fields
