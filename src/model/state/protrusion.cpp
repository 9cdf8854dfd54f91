#include "state/protrusion.hpp"

#include <array>
#include <cstddef>

namespace matrigrate {

std::string_view name(const Phase& phase) {
  constexpr std::array<std::string_view, 4> names{"growing", "maturing", "contracting", "finishing"};
  return names[phase.index()];
}

std::string_view name(EndCause cause) {
  constexpr std::array<std::string_view, 5> names{"", "unadhered", "disassembly", "rupture", "lost"};
  return names[static_cast<std::size_t>(cause)];
}

} // namespace matrigrate
