#pragma once

#include <string>

namespace matrigrate::report {

/// What became of a statement.
enum class Verdict { holds, in_direction, does_not_hold, undecided };

/// "holds", "in direction", "does not hold", "undecided": in texts, tables, JSON and pages.
std::string to_string(Verdict verdict);

} // namespace matrigrate::report
