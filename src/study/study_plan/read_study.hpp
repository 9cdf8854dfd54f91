#pragma once

#include "base/failure.hpp"
#include "parameters/rules.hpp"
#include "study_plan/fault_list.hpp"
#include "study_plan/study.hpp"

#include <cstddef>
#include <filesystem>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace matrigrate::study {

inline constexpr std::size_t largest_file = std::size_t{1} << 25; ///< bytes: the resolved form of 100,000 points

/// Of what the second set of closures has no place for.
inline constexpr const char* gone_with_first_closures =
    "has gone with the first set of closures; the version of the tag closures-2 has both";

/// The section [statistics]. Test: tests/unit/study_plan/read_study_test.cpp
/// @param points  whose labels a control may name
Comparisons read_comparisons(const toml::table& table, const std::vector<Point>& points, FaultList& faults);

/// The labels of the points of another study; none if it is not known.
using LabelsOf = std::function<std::optional<std::vector<std::string>>(const std::string& study)>;

/// The tables [[claims]]. Test: tests/unit/study_plan/read_claims_test.cpp
/// @param points     of the study, whose labels conditions name; those of others are named "study: label"
/// @param labels_of  others; if it is empty, they are not checked
std::vector<Claim> read_claims(const toml::array& list, const std::vector<Point>& points, const LabelsOf& labels_of,
                               FaultList& faults);

/// The tables [[targets]]: `readout`, `value` or a range of `low` and `high`, `error`, and, if wanted, `weight` and
/// `at`, the label of a condition or a list of them. `tracks`, a file of measured tracks, stands for value and error:
/// the mean of the read-out over its tracks, and the standard error of this mean.
/// Test: tests/unit/study_plan/targets_test.cpp
/// @param folder  that names of files count from
std::vector<Target> read_targets(const toml::array& list, const std::vector<Condition>& conditions,
                                 const std::filesystem::path& folder, FaultList& faults);

/// The [[targets]] of a TOML file, whatever else it holds; at no condition.
/// @throws InputOutputError if a file cannot be read
/// @throws ConfigurationError with all faults; also if there is no target
std::vector<Target> read_target_file(const std::filesystem::path& file);

/// Distance of a value from a target in its standard errors: 0 within a range, from its nearer end outside.
double distance(const Target& target, double value);

/// Distance of a run from all targets, from the distance z of each: sqrt(sum w z^2 / sum w); NaN if a z is.
double distance(const std::vector<Target>& targets, const std::vector<double>& z);

// From a study file to a study. A file that is not TOML has one fault; otherwise every fault is reported at once,
// sorted by line, as for scenarios; the values are checked by the same table of parameters. At most 100,000 runs are
// allowed. Test: tests/unit/study_plan/read_study_test.cpp

/// What the command line changes, and what is checked besides.
struct Changes {
  std::vector<std::string> overrides; ///< "key=value" each, over what the study fixes
  std::optional<std::size_t> replicates;
  std::span<const Rule> more = {}; ///< rules that each point must fulfil besides rules()
  LabelsOf labels_of = {};         ///< other studies, which claims may name
};

/// @throws InputOutputError if the file, or the scenario that it names, cannot be read or has more than 32 MiB
/// @throws ConfigurationError with all faults, those of the scenario among them
Study read_study(const std::filesystem::path& file, const Changes& changes = {});

/// Whether a file is a study rather than a scenario, whatever faults its values have.
/// @throws InputOutputError if it cannot be read or has more than 32 MiB
/// @throws ConfigurationError with one fault if it is not TOML
bool is_study_file(const std::filesystem::path& file);

/// @param name    stands for the file in faults
/// @param folder  where the scenario is looked for
/// @throws InputOutputError if the scenario that it names cannot be read
/// @throws ConfigurationError with all faults
Study parse_study(std::string_view text, const std::string& name, const std::filesystem::path& folder,
                  const Changes& changes = {});

/// The study with all its factor sets written out as points, to be read back to the same runs.
/// @param scenario  file name of the base, which stands beside it
std::string to_toml(const Study& study, const std::string& scenario);

} // namespace matrigrate::study
