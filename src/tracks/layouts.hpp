#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// The columns of the tables that tracking programs write. Test: tests/unit/tracks/reading_test.cpp
namespace matrigrate::tracks {

/// Names of the columns of a program, in lower case and without units (plain_name); the first that is there counts. A
/// name that ends with * stands for all that begin so, one that begins with * for all that have it in them: what stands
/// before it in the name of the track then stands before the names of x, y and z, too.
struct Layout {
  using Names = std::vector<std::string_view>;

  std::string_view name; ///< "trackmate"; "any": names of several programs, tried last
  Names track{}, t{}, frame{}, x{"x"}, y{"y"}, z{"z"};
  Names required{};    ///< without which a table is not of this program
  bool unique = false; ///< whether ids do not repeat in other movies of the table
};

/// In the order in which they are tried.
const std::vector<Layout>& layouts();

/// Names of columns of steps, which are no positions.
bool holds_steps(std::string_view plain_name);

/// Names of columns of time in any table.
bool names_time(std::string_view plain_name);

/// Names of columns that tell movies apart.
bool tells_movies_apart(std::string_view plain_name);

/// Names of columns that are true where a tracker has made a position up.
bool tells_made_up(std::string_view plain_name);

/// A name as a program or a person writes it: " Track n°", "Time [min]", "x_um" are "track n", "time" in "min", "x" in
/// "um". What is not ASCII is left out of the name.
struct ColumnTitle {
  std::string whole; ///< with its unit: "x_um"
  std::string name;  ///< without: "x"
  std::string unit;  ///< empty if it has none
};
ColumnTitle column_title(std::string_view written);

/// Size of a unit of length [um] or of time [s]: "µm", "(sec)", "Min"; nothing of one that is not known, as "pixel".
std::optional<double> length_unit(std::string_view unit);
std::optional<double> time_unit(std::string_view unit);

/// Whether a unit of time is the frame.
bool counts_frames(std::string_view unit);

/// Without blanks around it.
std::string_view trimmed(std::string_view text);

/// In lower case; other letters than those of ASCII stay.
std::string lower(std::string_view text);

} // namespace matrigrate::tracks
