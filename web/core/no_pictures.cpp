// In place of src/fields/picture.cpp: libpng and libtiff are not there in WebAssembly.
#include "fields/samples.hpp"

#include <stdexcept>

namespace matrigrate::fields {

Samples samples_from_picture(const std::filesystem::path& /*file*/, double /*pixel*/, const Vec2& /*centre*/) {
  throw std::invalid_argument("pictures are not available in the live page: run the scenario with the program");
}

} // namespace matrigrate::fields
