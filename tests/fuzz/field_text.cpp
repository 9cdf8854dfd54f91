#include "target.hpp"

#include "base/failure.hpp"
#include "fields/field.hpp"

#include <cstdlib>
#include <stdexcept>
#include <string>

/// The text of a field from anywhere: it is refused, or it has a value wherever it is asked. No file is there.
int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  try {
    const matrigrate::fields::Field field(text, "/nonexistent");
    for (const matrigrate::Vec2& x : {matrigrate::Vec2(0.0, 0.0), matrigrate::Vec2(-3.5, 1e3)}) field.at(x);
    if (field.text() != text || field.description() != "a formula") std::abort();
  } catch (const std::invalid_argument&) {        // refused
  } catch (const matrigrate::InputOutputError&) { // names a file
  }
  return 0;
}
