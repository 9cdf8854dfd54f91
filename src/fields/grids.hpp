#pragma once

#include "base/vector.hpp"
#include "fields/picture.hpp"

#include <filesystem>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// Numbers over the plane as samples on a regular grid, and grids from files. Test: tests/unit/fields/fields_test.cpp
namespace matrigrate::fields {

struct FileWords;

/// Values at the nodes of a grid, bilinear between them and constant beyond its border.
struct Samples {
  Vec2 origin = Vec2::Zero();  ///< of the first node [um]
  Vec2 spacing = Vec2::Ones(); ///< between nodes along x and y, > 0 [um]
  std::size_t columns = 0, rows = 0;
  std::vector<double> values; ///< row by row, upwards; columns * rows of them
  std::string column{};       ///< that the values are from, of a CSV file
  bool axes = false;          ///< the values are directions without a sense [degrees]: 90 is -90

  double at(const Vec2& x) const;

  /// The direction without a sense, where the nodes have those of from + per_value * value [degrees], in (-90, 90].
  double axis_at(const Vec2& x, double from, double per_value) const;

  Vec2 end() const; ///< of the last node [um]
};

/// A grid from CSV with a header line: columns x_um and y_um, and the one named, or the third; a row per node of a
/// regular grid, in any order. Memory and time grow as the text does.
/// @throws std::invalid_argument saying what is wrong: no such column, no commas, no number, no regular grid, a node
/// missing or twice
Samples samples_from_csv(std::string_view csv, std::string_view column);

/// A picture with a node in the middle of each pixel, as (sample - zero) / (one - zero).
/// @param pixel   width of a pixel [um], > 0
/// @param centre  where the picture's centre lies [um]
Samples samples_from_picture(const Picture& picture, double pixel, const Vec2& centre, double zero, double one);

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
  struct Kept;
  template <class Fits>
  std::optional<Kept> kept(const Fits& fits);

  std::mutex m_mutex;
  std::vector<Kept> m_kept; ///< the last one first
};

} // namespace matrigrate::fields
