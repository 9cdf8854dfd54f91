#pragma once

#include "fields/expression.hpp"
#include "parameters/schema.hpp"

#include <initializer_list>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

/// Laws of the model as formulas: what a text may contain, which values it may have, and the law itself. In formulas
/// lengths are in um, times in s, forces in nN, stresses in Pa. Test: tests/unit/parameters/law_test.cpp
namespace matrigrate {

/// An argument of a law.
struct LawVariable {
  std::string_view name;
  std::string_view unit; ///< empty of ratios
  double low = 0.0;      ///< a law is judged between here
  double high = 0.0;     ///< and here
  double usual = 0.0;    ///< where a curve over another variable is drawn
};

/// The arguments of a row of kind law, in the order of Law::operator().
std::span<const LawVariable> law_variables(const Row& law);

/// What formulas may name besides the variables of their law: parameters by their symbol, "r_off,min" as r_off_min, and
/// the user's constants.
/// @throws std::invalid_argument saying what is wrong with laws.constants
std::vector<fields::NamedNumber> law_names(const Parameters& p);

/// A law of one set of parameters.
class Law {
public:
  Law() = default; ///< the default one

  /// @param path  "laws.curvature_factor"
  /// @throws std::invalid_argument saying what is wrong with the text of the law, and where
  Law(std::string_view path, const Parameters& p);

  /// Whether it is another text than the default, whose function is compiled.
  bool changed() const { return m_formula.has_value(); }

  /// Whether a changed law depends on the variable.
  bool uses(std::string_view variable) const;

  /// Value of a changed law, in the unit of its row. Not to be called by several threads at once.
  /// @param arguments  of all variables, in their order
  /// @throws NumericalFailure if the value is not allowed
  double operator()(std::initializer_list<double> arguments) const;

private:
  const Row* m_row = nullptr;
  std::optional<fields::Expression> m_formula;
};

/// What is wrong with the names of laws.constants, or with the text of a law; empty if nothing is.
std::string fault_of_constants(const Parameters& p);
std::string fault_of_law(const Parameters& p, const Row& law);

/// Why no run begins with a changed law that can be read: it compares three values at once, its units do not agree, or
/// a value is not allowed between the bounds of its variables (with the arguments, and the place in the formula). Empty
/// if nothing is wrong.
std::string fault_of_law_values(const Parameters& p, const Row& law);

/// What is doubtful about the changed laws, a sentence each: constants that none names, and comparisons that come out
/// alike wherever a law is judged, such as angle < 90 of an angle in rad.
std::vector<std::string> law_notes(const Parameters& p);

/// The values of a law over one of its variables, the others at their usual values.
struct LawCurve {
  LawVariable over;
  std::string at; ///< those of the others that matter: "f_mat = 0.5, t = 0 s"; empty where none does
  std::vector<double> x;
  std::vector<double> usual;   ///< of the default law, with the parameters as they are
  std::vector<double> changed; ///< not finite where it is so
};

/// Over each variable that the law depends on; of one that depends on none, over the first of the default law.
/// @param points  >= 2
std::vector<LawCurve> law_curves(const Parameters& p, const Row& law, std::size_t points);

/// The default of a row of kind law.
const std::string& usual_text(const Row& law);

/// Whether a row of kind law is another text than the default, and all such rows.
bool is_changed(const Row& law, const Parameters& p);
std::vector<const Row*> changed_laws(const Parameters& p);

} // namespace matrigrate
