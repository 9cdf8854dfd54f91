#pragma once

#include <span>
#include <string_view>
#include <vector>

namespace matrigrate::study {

/// A study of the folder studies/, which the program carries with it (cmake/studies.cmake).
struct ShippedStudy {
  std::string_view name; ///< of the file, without its ending
  std::string_view text;
};

std::span<const ShippedStudy> shipped_studies();

} // namespace matrigrate::study
