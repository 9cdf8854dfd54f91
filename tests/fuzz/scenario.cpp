#include "target.hpp"

#include "base/failure.hpp"
#include "parameters/read.hpp"
#include "parameters/schema.hpp"
#include "parameters/write.hpp"

#include <cstdlib>
#include <string>

/// A scenario from anywhere: it is refused with all its faults, or it is read, and what is written of it is read back.
int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  try {
    const matrigrate::Parameters p = matrigrate::parse_parameters(text, "fuzz.toml");
    if (!matrigrate::same(matrigrate::parse_parameters(matrigrate::to_toml(p), "again.toml"), p)) std::abort();
  } catch (const matrigrate::ConfigurationError& error) {
    if (error.faults().empty()) std::abort();
  }
  return 0;
}
