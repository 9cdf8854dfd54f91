#include "target.hpp"

#include "base/failure.hpp"
#include "store/field_file.hpp"
#include "store/frame_log.hpp"

#include <algorithm>
#include <cstdlib>
#include <string_view>

namespace {

/// Whether all arrays of all frames have the lengths that the others give them.
bool belong_together(const matrigrate::observe::Film& film) {
  return std::ranges::all_of(film.frames, [&film](const matrigrate::observe::Frame& frame) {
    return matrigrate::store::fits(frame, film.head, frame.matrix.fibre_von_mises.empty() ? 0 : film.head.particles());
  });
}

} // namespace

/// A fields.h5 from anywhere: it is refused, or its frames can be shown; so can those of a damaged one that are whole.
/// With the preset `fuzz` HDF5 itself is not instrumented: the fuzzer sees its faults only where they end the process,
/// and cannot steer into its code.
int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace matrigrate::store;
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  for (const Wanted wanted : {Wanted::all, Wanted::whole}) try {
      if (!belong_together(read_field_file(bytes, wanted))) std::abort();
    } catch (const matrigrate::InputOutputError&) { // refused
    }
  return 0;
}
