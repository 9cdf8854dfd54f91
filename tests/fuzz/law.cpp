#include "target.hpp"

#include "base/failure.hpp"
#include "parameters/document.hpp"
#include "parameters/laws/constants.hpp"
#include "parameters/laws/law.hpp"
#include "parameters/laws/law_names.hpp"
#include "parameters/read.hpp"
#include "parameters/write.hpp"

#include <cmath>
#include <cstdlib>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

/// A law that can be read has a value or stops the run, means what its meaning does, and is written and read back.
void evaluate(const matrigrate::Parameters& p, const matrigrate::Row& row) {
  const matrigrate::Law law(row.path, p);
  if (!matrigrate::is_changed(row, p)) return;
  try {
    const double value = row.arguments.size() == 1 ? law({0.1}) : law({0.1, 0.5, 3.0});
    if (!matrigrate::in_range(row, value)) std::abort();
  } catch (const matrigrate::NumericalFailure&) { // not allowed there
  }
  matrigrate::Parameters meant = p;
  std::get<std::string& (*)(matrigrate::Parameters&)>(row.member)(meant) = matrigrate::law_meaning(row, p);
  if (matrigrate::differs(row, meant, p)) std::abort();
  if (!matrigrate::same(matrigrate::parse_parameters(matrigrate::to_toml(p), ""), p)) std::abort();
}

} // namespace

/// The first line is a formula, the second one the constants: of a law of one variable, and of one of three.
int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  if (matrigrate::unreadable(text, "")) return 0; // no reader would give it
  const std::size_t line = text.find('\n');
  matrigrate::Parameters p;
  p.laws.curvature_factor = text.substr(0, line);
  p.laws.disassembly_rate = p.laws.curvature_factor;
  try {
    if (line != std::string::npos) p.laws.constants = matrigrate::constants_in(text.substr(line + 1));
  } catch (const std::invalid_argument&) { // is refused
    return 0;
  }
  for (const char* path : {"laws.curvature_factor", "laws.disassembly_rate"}) {
    const matrigrate::Row& row = *matrigrate::find_row(path);
    if (!matrigrate::fault_of_law(p, row).empty()) continue;
    matrigrate::Parameters one;
    (path[5] == 'c' ? one.laws.curvature_factor : one.laws.disassembly_rate) = p.laws.curvature_factor;
    one.laws.constants = p.laws.constants;
    evaluate(one, row);
  }
  return 0;
}
