#pragma once

#include <stdexcept>
#include <string>
#include <vector>

/// The ways in which a call may fail, one type per exit code of the program (the table of exit codes is in README.md).
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

/// The computation cannot continue: a step limit broken, a solver that does not converge, a value not finite. Exit
/// code 4.
class NumericalFailure : public std::runtime_error {
public:
  using std::runtime_error::runtime_error;
};

/// A file could not be read or written. Exit code 5.
class InputOutputError : public std::runtime_error {
public:
  using std::runtime_error::runtime_error;
};

} // namespace matrigrate
