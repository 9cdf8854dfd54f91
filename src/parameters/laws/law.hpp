#pragma once

#include "fields/expression.hpp"
#include "parameters/schema.hpp"

#include <cstddef>
#include <initializer_list>
#include <span>
#include <string>
#include <string_view>
#include <vector>

/// The laws of the model, each a formula (parameters/laws/law_names.hpp says what it may name).
/// Test: tests/unit/parameters/law_test.cpp
namespace matrigrate {

struct Rule;

/// Where, when and on which protrusion a law of a cell acts: the values of shared_arguments(), in their order.
struct LawPlace {
  double x = 0.0;         ///< [um]
  double y = 0.0;         ///< [um]
  double time = 0.0;      ///< [s]
  double density = 1.0;   ///< of the solid matrix around [-]
  double pressure = 0.0;  ///< [Pa]
  double f_degr = 0.0;    ///< [-]
  double stiffness = 0.0; ///< [Pa]
  double l = 0.0;         ///< of the protrusion [um]
  double age = 0.0;       ///< [s]
  double t_mat = 0.0;     ///< [s]
  double f_mat = 0.0;     ///< [-]
};

/// That of particle i; where no law uses any there are none, and it does not matter.
inline LawPlace place_at(std::span<const LawPlace> places, std::size_t i) {
  return places.empty() ? LawPlace{} : places[i];
}

/// A law of one set of parameters, evaluated by one thread at a time.
class Law {
public:
  /// @param path  "laws.curvature_factor"
  /// @throws std::invalid_argument saying what is wrong with the text of the law, and where
  Law(std::string_view path, const Parameters& p);

  /// Whether the value may depend on an argument, and on any.
  bool uses(std::string_view argument) const;
  bool varies() const;

  /// Whether it may depend on any shared argument, and on those of the matrix around.
  bool uses_place() const { return !m_shared.empty(); }
  bool uses_matrix() const;

  /// Its value, in the unit of its row.
  /// @param own  its own arguments, all, in their order
  /// @throws NumericalFailure if the law is not the default one, and the value is not allowed
  double operator()(std::initializer_list<double> own, const LawPlace& place = {}) const;

  /// How fast its value falls with one of its own arguments; 0 where it rises. For what is linearly implicit.
  double fall(std::size_t argument, std::initializer_list<double> own, const LawPlace& place) const;

private:
  double at(std::span<const double> own, const LawPlace& place) const;
  std::size_t own_count() const { return m_variables.size() - m_shared.size(); }

  const Row* m_row;
  bool m_judged;
  std::vector<LawVariable> m_variables;
  std::vector<double LawPlace::*> m_shared; ///< of the variables after its own
  fields::Expression m_formula;
};

/// The laws of a set of parameters, except that of the fibres, which has a table (ecm/law/fibre_table.hpp).
/// Test: tests/unit/simulation/laws_test.cpp, tests/physics/laws_test.cpp
struct Laws {
  /// @throws std::invalid_argument saying what cannot be read; rules() say it with its place
  explicit Laws(const Parameters& p);

  Law curvature_factor;
  Law contraction;
  Law maturation_force;
  Law maturation;
  Law adhesion_stiffness;
  Law disassembly_rate;
  Law growth_force;
  Law initiation_rate;
  Law initiation_bias;
  Law polarization_rate;
  Law degradation_tip;
  Law degradation_protrusion;
  Law degradation_body;
};

/// What the text of a law is a formula in: its own arguments, and those of the shared ones that it names. Left out are
/// those whose names are of constants, in a law that puts_constants_first(): of its own ones these are the last.
std::vector<LawVariable> law_variables(const Row& law, std::string_view text, const Parameters& p);

/// A text as a formula in the variables and names of a law.
/// @throws std::invalid_argument saying what is wrong, where, and which name may be meant
fields::Expression law_formula(const Row& law, const Parameters& p, const std::string& text,
                               std::span<const LawVariable> variables);
fields::Expression law_formula(const Row& law, const Parameters& p, const std::string& text);

/// Which of its variables a formula may depend on.
std::vector<bool> used_by(const fields::Expression& formula, std::span<const LawVariable> variables);

/// What is wrong with the text of a law; empty if nothing is.
std::string fault_of_law(const Parameters& p, const Row& law);

/// "F = 0.3 nN, f_mat = 0.5".   @param named  which variables are told
std::string law_arguments(std::span<const LawVariable> variables, std::span<const double> values,
                          const std::vector<bool>& named);

/// "is -2 1/s at F = 1 nN; allowed is >= 0 and <= 1e+06 1/s; ...": what is wrong with a value out of the law's range,
/// and what helps.
/// @param where  the arguments there
std::string law_fault(const Row& law, double value, const std::string& where);

/// The default of a row of kind law.
const std::string& usual_text(const Row& law);

/// Whether a row of kind law means something else than the default, and all such rows.
bool is_changed(const Row& law, const Parameters& p);
std::vector<const Row*> changed_laws(const Parameters& p);

/// The constants of the user that a law names: "F_c = 0.05 nN, r_c = 0.2 1/s".
std::string constants_of(const Row& law, const Parameters& p);

/// The values of a law over one of its arguments, between drawn_low and drawn_high, the others at their usual values.
struct LawCurve {
  LawVariable over;
  std::string at; ///< those of the others that matter: "f_mat = 0.5, t = 0 s"; empty where none does
  std::vector<double> x;
  std::vector<double> usual;   ///< of the default law, with the parameters as they are
  std::vector<double> changed; ///< not finite where it is so
};

/// Over each argument that the law depends on; of one that depends on none, over the first of the default law.
/// @param points  >= 2
std::vector<LawCurve> law_curves(const Parameters& p, const Row& law, std::size_t points);

/// What is doubtful about the changed laws, a sentence each: constants with a name that came_later(), or that none
/// names, and comparisons that come out alike wherever a law is judged, such as angle < 90 of an angle in rad.
std::vector<std::string> law_notes(const Parameters& p);

// Laws judged over the ranges of their arguments, on a grid.

/// Why no run begins with a law that can be read: it compares three values at once, its units do not agree, or a value
/// is not allowed between the bounds of its arguments (with these, and the place in the formula). Empty if nothing is
/// wrong.
std::string fault_of_law_values(const Parameters& p, const Row& law);

/// One for each law that may differ from the default: its values are allowed.
std::vector<Rule> rules_of_law_values();

/// What the values of a law may depend on.
std::vector<std::string_view> keys_of_law(const Row& law);

/// The rule that the values of a law, or of a field, are allowed.
std::string values_rule(const Row& row);

/// The comparisons of a law that can be read which come out alike at all points of its grid: "angle < 90, at character
/// 1, holds wherever the law is judged (angle from -3.14159 to 3.14159 rad)".
std::vector<std::string> steady_comparisons(const Parameters& p, const Row& law);

/// The numbers that a law names, written out or as parameters, and their negatives: where it may jump.
std::vector<double> law_numbers(const Row& law, const Parameters& p);

} // namespace matrigrate
