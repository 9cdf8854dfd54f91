#include "base/parallel.hpp"
#include "fields/picture.hpp"

#include <stdexcept>

// In place of src/base/parallel.cpp, since there is one thread, and of src/fields/picture.cpp, png.cpp and tiff.cpp:
// libpng and libtiff are not there in WebAssembly.
namespace matrigrate {

bool alone() { return true; }

int idle_threads() { return 1; }

void side_by_side(std::initializer_list<std::function<void()>> works) {
  for (const auto& work : works) work();
}

void parallel_ranges(std::size_t n, std::size_t /*grain*/, const std::function<void(std::size_t, std::size_t)>& body) {
  if (n > 0) body(0, n);
}

fields::Picture fields::read_picture(std::string_view /*bytes*/, const PictureChoice& /*choice*/) {
  throw std::invalid_argument("pictures are not available in the live page: run the scenario with the program");
}

} // namespace matrigrate
