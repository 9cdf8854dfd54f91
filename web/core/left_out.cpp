#include "base/parallel.hpp"
#include "fields/picture.hpp"

#include <stdexcept>

namespace matrigrate::fields {

// In place of src/fields/picture.cpp, png.cpp and tiff.cpp: libpng and libtiff are not there in WebAssembly.

Picture read_picture(std::string_view /*bytes*/, const PictureChoice& /*choice*/) {
  throw std::invalid_argument("pictures are not available in the live page: run the scenario with the program");
}

} // namespace matrigrate::fields

namespace matrigrate {

// Stands in for src/base/parallel.cpp where there is one thread.

bool alone() { return true; }

void parallel_ranges(std::size_t n, std::size_t /*grain*/, const std::function<void(std::size_t, std::size_t)>& body) {
  if (n > 0) body(0, n);
}

} // namespace matrigrate
