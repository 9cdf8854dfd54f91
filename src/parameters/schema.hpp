#pragma once

#include "parameters/parameters.hpp"
#include "parameters/units.hpp"

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

/// The one table of parameters. Reader, checks, scenario files, documentation and editor schema are made from it; a new
/// parameter is one member in parameters.hpp and one row in schema.cpp, with `before`. Test:
/// tests/unit/parameters/schema_test.cpp
namespace matrigrate {

/// Allowed values, in the unit of the row.
struct Range {
  double low = 0.0;
  double high = 0.0;
  bool low_allowed = true;
  bool high_allowed = true;
};

/// Where a parameter of an enumeration is stored: which of `names` it is.
struct Choice {
  std::span<const std::string_view> names; ///< in the order of the enumeration
  std::size_t (*index)(Parameters&);
  void (*set)(Parameters&, std::size_t);
};

/// Where a constant of the laws is stored.
struct OneConstant {
  std::string_view name;
};

/// The member of a set of parameters.
template <class T>
using Access = T& (*)(Parameters&);

/// Where a parameter is stored. The alternative is its type: quantity or ratio, integer, flag, text of a field or law,
/// choice; all constants of the laws, and one of them, a quantity or ratio as well.
using Member = std::variant<Access<double>, Access<int>, Access<std::uint64_t>, Access<bool>, Access<std::string>,
                            Choice, Access<std::vector<LawConstant>>, OneConstant>;

/// Who is likely to touch a parameter: `usual` ones stand open in a new scenario, `optional` and `numerical` ones
/// commented out.
enum class Audience { usual, optional, numerical };

/// An argument of a law.
struct LawVariable {
  std::string_view name;
  std::string_view unit;    ///< empty of ratios
  double low;               ///< a law is judged between here
  double high;              ///< and here
  double usual;             ///< where a curve over another variable is drawn
  double drawn_low;         ///< where cells usually are: a law is drawn from here
  double drawn_high;        ///< to here
  std::string_view meaning; ///< a few words
};

/// A parameter.
struct Row {
  std::string_view path;        ///< "ecm.youngs_modulus"
  Member member;                ///< its default is that of the struct
  std::string_view unit;        ///< of a bare number, of `range` and of the documentation; "1" for a ratio
  Range range;                  ///< of numbers
  std::string_view symbol;      ///< the paper's letters; empty if it has none
  std::string_view source;      ///< of the default
  std::string_view description; ///< one sentence without the full stop
  Audience audience = Audience::usual;

  /// The value that stands for what was done before there was such a key, without its quotes, or the path of the key
  /// whose value it was: files of earlier versions lack the key. None of a key that all versions have. A default may
  /// change, this value may not.
  std::optional<std::string_view> before = {};
  bool (*of_part)(const Parameters&) = nullptr; ///< whether the part of the model is there that it belongs to
  std::span<const LawVariable> arguments = {};  ///< of a law, in the order in which it takes them
  std::span<const LawVariable> shared = {};     ///< those that it may use besides, a beginning of shared_arguments()
};

/// A section of the scenario file.
struct Section {
  std::string_view name;
  std::string_view title;
};

/// An angle is stored in the unit of its row, and written as a bare number. Of a field or law, unit and range are those
/// of its values.
enum class Kind { quantity, ratio, angle, integer, boolean, choice, field, law, constants };

/// All parameters; those of a section stand together, sections in the order of sections().
std::span<const Row> schema();
std::span<const Section> sections();

/// The keys of one table of [[cells]]; their members are those of the last of Parameters::cells.
std::span<const Row> cell_rows();

/// The key `at` of one table of [[changes]]; its member is that of the last of Parameters::changes.
const Row& change_time();

/// The part of schema() that is the laws: the section [laws] without laws.constants.
std::span<const Row> law_rows();

/// What the laws of a cell may use besides their own arguments: place, time, matrix around, protrusion.
std::span<const LawVariable> shared_arguments();

/// What [[cells]] is about, in a sentence.
inline constexpr std::string_view cells_title =
    "Several cells: one [[cells]] for each, with its centre; without any one cell at cell.start_x, cell.start_y";

/// What [[changes]] is about, in a sentence.
inline constexpr std::string_view changes_title = "Parameters in time: one [[changes]] for each time, with `at` and "
                                                  "the parameters that have other values from then on";

/// Largest number of cells.
inline constexpr std::size_t max_cells = 1000;

/// @return the row of a dotted path, or null
const Row* find_row(std::string_view path);

/// The same of a path that a user names: also that of a constant of the laws of p, "laws.constants.F_s". The row lives
/// as long as the constant, in p or a copy.
const Row* find_row(std::string_view path, const Parameters& p);

/// Where the real number of a row is stored; null of other rows, and of a constant that p has not.
double* real_of(const Row& row, Parameters& p);

Kind kind(const Row& row);

/// What a bare number, and the bounds of `range`, are converted from: the unit of the row; of an angle 1.
units::Unit unit_of(const Row& row);

std::string_view section_of(const Row& row); ///< "ecm"
std::string_view key_of(const Row& row);     ///< "youngs_modulus"

/// A text as a basic string of TOML, which is one of JSON as well.
std::string in_quotes(std::string_view text);

/// The value as it stands in a scenario file, to be read back to the same bits: "\"200 Pa\"", "0.45", "true",
/// "\"square\"".
std::string value_text(const Row& row, const Parameters& p);

/// The same, of a law and of constants in one spelling: blanks, the order of constants and their units do not matter.
/// Two values are the same if their meanings are.
std::string meaning_text(const Row& row, const Parameters& p);
bool differs(const Row& row, const Parameters& a, const Parameters& b);

/// The description; of a law with its arguments.
std::string description_of(const Row& row);

/// "0 to 10 nN": where laws are judged over an argument.
std::string range_text(const LawVariable& argument);

/// The text of a row that holds one: a field, a law.
const std::string& text_of(const Row& row, const Parameters& p);

/// `before` as it stands in a scenario file with these parameters; empty if the row has none.
std::string before_text(const Row& row, const Parameters& p);

/// Whether the value stands in the fingerprint of a configuration: the part that it belongs to is there, and it is not
/// that of before. So a new parameter at its value of before renames no run.
bool counts(const Row& row, const Parameters& p);

/// The allowed values in words: "> 0 and <= 1000 Pa", "true or false", "\"square\" or \"hexagonal\"".
std::string allowed_text(const Row& row);

/// Whether the value is within the range of a row, both in its unit.
bool in_range(const Row& row, double value);

/// The starts of several cells as one line: "[{ x = \"0 um\", y = \"40 um\" }, ...]"; "[]" without.
std::string cells_text(const Parameters& p);

/// Whether two sets of parameters agree in the bits of every row; laws and constants in their meaning.
bool same(const Parameters& a, const Parameters& b);

} // namespace matrigrate
