#pragma once

#include "base/vector.hpp"
#include "fields/expression.hpp"

#include <filesystem>
#include <memory>
#include <optional>
#include <string>

namespace matrigrate::fields {

// Numbers over the plane, as a scenario gives them. Test: tests/unit/fields/fields_test.cpp

class Grids;
struct Grid;

/// A field that a scenario names by one text:
///
///   "200 + 50*tanh(x/20)"                      a formula in x, y and r, the distance from the origin [um] (Expression)
///   "stiffness.csv"                            a grid (samples_from_csv); "... column=E_Pa" takes that column
///   "collagen.png pixel=0.5 from=50 to=400"    a picture, PNG or TIFF: width of a pixel [um], and the values of black
///                                              and white; "x=10 y=-5" is where its centre lies [um] (0, 0)
///
/// docs/how-to/fields.md has all keys. Names of files count from the folder of the scenario (file_words.hpp). The
/// samples of a picture are taken as they are stored; values lie on a straight line between those of black and white.
class Field {
public:
  /// @param folder  that relative names of files count from
  /// @param grids   those that were read already, and then this one as well; null: a file is read
  /// @throws std::invalid_argument saying what is wrong with the text or the file
  /// @throws InputOutputError if a file cannot be read
  Field(const std::string& text, const std::filesystem::path& folder, Grids* grids = nullptr);

  /// Its value at a point [um], in the unit of its formula or file; may be NaN or infinite of a formula.
  double at(const Vec2& x) const;

  /// The name of a CSV file's column that the values are from; empty of all else.
  std::string column() const;

  /// The same field in another unit: `factor` times its values, > 0.
  void scale(double factor) { m_factor *= factor; }

  /// Between the nodes of a grid, its values are now directions without a sense, in degrees: between 80 and -80
  /// lies 90.
  void take_as_axes() { m_are_axes = true; }

  /// "a formula", or "a grid of 301 x 301 nodes from (-150, -150) to (150, 150) um".
  std::string description() const;

  /// What is wrong with a formula that compares three values at once, -5 < y < 5; empty of all others.
  std::string chained() const;

  /// The text that gives the same field anywhere: of a file with its whole path and a fingerprint of its content
  /// ("hash=..."), by which a file that has changed is refused.
  const std::string& text() const { return m_text; }

private:
  std::string m_text;
  std::shared_ptr<const Grid> m_grid; ///< null of a formula
  std::optional<Expression> m_formula;
  double m_factor = 1.0;
  bool m_are_axes = false;
};

/// Whether a text names a file by its whole path and fingerprint, as Field::text() does.
bool names_one_file(const std::string& text);

} // namespace matrigrate::fields
