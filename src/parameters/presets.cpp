#include "parameters/presets.hpp"

#include "parameters/read.hpp"

#include <algorithm>

namespace matrigrate {

std::span<const Preset> presets() {
  static const std::vector<Preset> all{
      {"baseline", "The paper's baseline: a matrix of 200 Pa", {}},
      {"soft", "The paper's softest matrix: 50 Pa", {"ecm.youngs_modulus=50 Pa"}},
      {"stiff", "The paper's stiffest matrix: 400 Pa", {"ecm.youngs_modulus=400 Pa"}},
  };
  return all;
}

const Preset* find_preset(std::string_view name) {
  const auto all = presets();
  const auto preset = std::ranges::find(all, name, &Preset::name);
  return preset == all.end() ? nullptr : &*preset;
}

Parameters parameters_of(const Preset& preset) { return apply_overrides({}, preset.overrides); }

} // namespace matrigrate
