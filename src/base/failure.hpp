#pragma once

#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

/// The ways in which a call may fail, one type per exit code of the program (the table of exit codes is in
/// docs/exit-codes.md).
namespace matrigrate {

/// A fault at one place of an input file. Printed as `file:line:column: key: message`.
struct Fault {
  std::string file;    ///< path as the user gave it, or "--set" for the command line
  int line = 0;        ///< 1-based; 0 where the place has no line
  int column = 0;      ///< 1-based; 0 where the place has no column
  std::string key;     ///< dotted path of the parameter; empty for the file as a whole
  std::string message; ///< what is wrong, what is allowed, the nearest name
};

/// `file:line:column: key: message`, without unknown parts.
std::string to_string(const Fault& fault);

/// The configuration is wrong: all of its faults at once. Exit code 3.
class ConfigurationError : public std::runtime_error {
public:
  explicit ConfigurationError(std::vector<Fault> faults);
  const std::vector<Fault>& faults() const { return m_faults; }

private:
  std::vector<Fault> m_faults;
};

/// Why a computation cannot continue: what programs act on and count; the sentence for the user is what().
enum class FailureCause {
  solver,          ///< a linear system was not solved
  step_limit,      ///< a particle would move too far in the shortest step, or run.time_step is not stable
  rim,             ///< a cell has reached the clamped rim of the matrix
  crossing,        ///< a cortex crosses itself
  nucleus_outside, ///< a nucleus has passed through the cortex
  collapse,        ///< a cell has lost its area
  solid_inside,    ///< solid matrix lies deep inside a cell
  not_finite,      ///< a value is not finite
  law,             ///< a law of the user's has a value that is not allowed
  imbalance        ///< inner forces do not balance
};

/// "solver", "step_limit", ...: "cause" in run.json and in results.csv.
std::string_view to_string(FailureCause cause);

/// The cause of that name; nothing for other text.
std::optional<FailureCause> parse_failure_cause(std::string_view text);

/// The computation cannot continue. Exit code 4.
class NumericalFailure : public std::runtime_error {
public:
  NumericalFailure(FailureCause cause, const std::string& what) : std::runtime_error(what), m_cause(cause) {}
  FailureCause cause() const { return m_cause; }

private:
  FailureCause m_cause;
};

/// A file could not be read or written. Exit code 5.
class InputOutputError : public std::runtime_error {
public:
  using std::runtime_error::runtime_error;
};

} // namespace matrigrate
