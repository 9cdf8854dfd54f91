#pragma once

#include "draw/particle_picture.hpp"
#include "parameters/parameters.hpp"
#include "report/verdict_page.hpp"
#include "tables/table.hpp"

#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace matrigrate::validation {

enum class Sense { near, at_least, at_most };

/// One number of a case against what it should be.
struct Check {
  std::string quantity; ///< what was measured, with its unit: "Young's modulus [Pa]"
  double measured = 0.0;
  double expected = 0.0;
  double tolerance = 0.0;    ///< largest |measured - expected| that holds, in the unit of the quantity
  std::string reason;        ///< where the tolerance comes from
  Sense sense = Sense::near; ///< at_least: holds from expected - tolerance upwards; at_most: up to expected + tolerance

  bool holds() const;
};

/// Everything that a case found; nothing of it is written yet.
struct Result {
  std::vector<Check> checks; ///< whether the program does what its equations say
  std::vector<Check> claims; ///< what the paper says of it, by rules on the quantity that it names; those of Figs 2 and
                             ///< 4 must come out
  std::vector<std::string> claim_notes; ///< what has to be known beside the claims
  std::vector<std::string> remarks;     ///< what is off, and why
  store::Table table;                   ///< the measured curves, written as NAME.csv
  std::vector<report::Plot> plots;      ///< a page draws them
  std::vector<draw::Picture> pictures;  ///< written as NAME-<picture>.svg

  bool holds() const; ///< all checks hold, and there is at least one

  /// Two columns of the table.
  report::Series curve(std::string label, std::string_view x, std::string_view y,
                       report::Mark mark = report::Mark::line) const;
  void add(std::string name, std::string caption, report::Plot plot);
};

/// A verification of a part of the model on its own.
struct Case {
  std::string name;    ///< as typed after `validate`
  std::string summary; ///< one sentence
  std::function<Result(const Parameters&)> run;
};

/// What the cases start from: the defaults, with a drag system solved so closely that the solver's error does not show
/// beside that of the discretisation.
Parameters default_parameters();

/// Runs a case, after a check of run.time_step against the limits of the explicit step: some cases refine the step on
/// their own, none may hide that the one asked for is too large.
/// @throws NumericalFailure
Result run_case(const Case& which, const Parameters& p);

/// All cases, in the order of the documentation.
const std::vector<Case>& cases();

} // namespace matrigrate::validation
