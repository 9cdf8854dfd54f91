#pragma once

#include "base/failure.hpp"
#include "study/study.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// From a study file to a study. Every fault is reported at once, sorted by line, as for scenarios; the values are
/// checked by the same table of parameters. Test: tests/unit/study/read_study_test.cpp
namespace matrigrate::study {

/// What the command line changes.
struct Changes {
  std::vector<std::string> overrides; ///< "key=value" each, over what the study fixes
  std::optional<std::size_t> replicates;
};

/// @throws ConfigurationError with all faults, those of the scenario among them
/// @throws InputOutputError if the file, or the scenario that it names, cannot be read
Study read_study(const std::filesystem::path& file, const Changes& changes = {});

/// @param name    stands for the file in faults
/// @param folder  where the scenario is looked for
/// @throws ConfigurationError with all faults
/// @throws InputOutputError if the scenario that it names cannot be read
Study parse_study(std::string_view text, const std::string& name, const std::filesystem::path& folder,
                  const Changes& changes = {});

/// The study with all its points written out, to be read back to the same runs.
/// @param scenario  file name of the base, which stands beside it
std::string to_toml(const Study& study, const std::string& scenario);

} // namespace matrigrate::study
