// In place of src/fields/picture.cpp, png.cpp and tiff.cpp: libpng and libtiff are not there in WebAssembly.
#include "fields/picture.hpp"

#include <stdexcept>

namespace matrigrate::fields {

Picture read_picture(std::string_view /*bytes*/, const PictureChoice& /*choice*/) {
  throw std::invalid_argument("pictures are not available in the live page: run the scenario with the program");
}

} // namespace matrigrate::fields
