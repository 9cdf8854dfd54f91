#pragma once

#include "study_plan/read_study.hpp"

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace matrigrate::study {

/// A study of the folder studies/, which the program carries with it (cmake/shipped.cmake).
struct ShippedStudy {
  std::string_view name; ///< of the file, without its ending
  std::string_view text;
};

std::span<const ShippedStudy> shipped_studies();

/// The same, read.
struct ReadStudy {
  std::string name; ///< of the file, without its ending
  Study study;
};
const std::vector<ReadStudy>& read_shipped_studies();

/// The labels of the study NAME.toml in a folder, or of the shipped one of that name.
/// @throws ConfigurationError if that file has faults, InputOutputError if it cannot be read
LabelsOf other_studies(const std::filesystem::path& folder);

/// @throws std::out_of_range if there is none of that name
const ShippedStudy& shipped_file(std::string_view name);

} // namespace matrigrate::study
