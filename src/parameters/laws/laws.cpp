#include "parameters/laws/laws.hpp"

#include <regex>
#include <sstream>

namespace matrigrate {

Laws::Laws(const Parameters& p)
    : curvature_factor("laws.curvature_factor", p), disassembly_rate("laws.disassembly_rate", p),
      growth_force("laws.growth_force", p), initiation_rate("laws.initiation_rate", p),
      initiation_bias("laws.initiation_bias", p), polarization_rate("laws.polarization_rate", p),
      degradation_tip("laws.degradation_tip", p), degradation_protrusion("laws.degradation_protrusion", p),
      degradation_body("laws.degradation_body", p) {}

std::string constants_of(const Row& law, const Parameters& p) {
  static const std::regex form(R"(\s*(\w+)\s*=\s*(.*\S)\s*)");
  const std::string text = text_of(law, p);
  std::istringstream all(p.laws.constants);
  std::string named;
  std::smatch found;
  for (std::string one; std::getline(all, one, ',');)
    if (std::regex_match(one, found, form) && std::regex_search(text, std::regex("\\b" + found[1].str() + "\\b")))
      named += (named.empty() ? "" : ", ") + found[1].str() + " = " + found[2].str();
  return named;
}

const Laws& usual_laws() {
  static const Laws laws;
  return laws;
}

} // namespace matrigrate
