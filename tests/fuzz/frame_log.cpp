#include "target.hpp"

#include "../unit/store/logs.hpp"
#include "base/failure.hpp"
#include "store/deflate.hpp"

#include <xxhash.h>

#include <algorithm>
#include <cstdlib>
#include <string>
#include <string_view>

namespace {

/// A log of one head and frames made of these bytes, with the right lengths and fingerprints. Blocks end with a line
/// "block".
std::string sealed(std::string_view bytes) {
  std::string log = "matrigrate frames 1\n";
  while (!bytes.empty()) {
    const std::string_view content = bytes.substr(0, bytes.find("\nblock\n"));
    bytes.remove_prefix(std::min(content.size() + 7, bytes.size()));
    const std::string stored = matrigrate::store::deflated_fast(content);
    for (const std::uint64_t number :
         {std::uint64_t{stored.size()}, std::uint64_t{content.size()}, XXH3_64bits(stored.data(), stored.size())})
      log.append(reinterpret_cast<const char*>(&number), sizeof(number));
    log += stored;
  }
  return log;
}

} // namespace

/// The first byte tells whether the others are a log, or the contents of its blocks, which a fuzzer could not give the
/// right fingerprints. A log from anywhere is refused, or its whole frames have the lengths that its head gives them.
int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace matrigrate::store;
  if (size == 0) return 0;
  const std::string_view bytes(reinterpret_cast<const char*>(data + 1), size - 1);
  try {
    const matrigrate::observe::Film film = data[0] % 2 == 0 ? read_log(bytes) : read_log(sealed(bytes));
    const auto whole = [&](const auto& frame) {
      return fits(frame, film.head, frame.matrix.fibre_von_mises.empty() ? 0 : film.head.particles());
    };
    if (!film.head.consistent() || !std::ranges::all_of(film.frames, whole)) std::abort();
    const std::string again = log_bytes(film);
    if (log_bytes(read_log(again)) != again) std::abort(); // what is whole, stays
  } catch (const matrigrate::InputOutputError&) {          // refused
  }
  return 0;
}
