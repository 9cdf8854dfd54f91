#include "target.hpp"

#include "base/failure.hpp"
#include "study_plan/read_study.hpp"

#include <cstdlib>
#include <string>

/// A study from anywhere: it is refused with all its faults, or read, and what is written of it is not empty.
int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  try {
    const matrigrate::study::Study study = matrigrate::study::parse_study(text, "fuzz.toml", "/nonexistent");
    if (matrigrate::study::to_toml(study, "base.toml").empty()) std::abort();
  } catch (const matrigrate::ConfigurationError& error) {
    if (error.faults().empty()) std::abort();
  } catch (const matrigrate::InputOutputError&) { // its scenario is not there
  }
  return 0;
}
