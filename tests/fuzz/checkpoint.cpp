#include "target.hpp"

#include "base/failure.hpp"
#include "store/checkpoint.hpp"
#include "store/run_memory.hpp"

#include <string>

/// The first byte tells which reader takes the others: that of the file, or those of the parts within it, which a file
/// with a wrong fingerprint would never let through.
int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const std::string text(reinterpret_cast<const char*>(data + 1), size - 1);
  try {
    switch (data[0] % 3) {
    case 0:
      matrigrate::store::parse_checkpoint(text, "fuzz.h5");
      break;
    case 1:
      matrigrate::store::parse_memory(text, "no-folder");
      break;
    case 2:
      matrigrate::store::parse_state_parts(text);
      break;
    }
  } catch (const matrigrate::InputOutputError&) { // refused
  }
  return 0;
}
