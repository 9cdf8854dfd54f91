#pragma once

#include "parameters/schema.hpp"
#include "study_plan/fault_list.hpp"
#include "study_plan/study.hpp"

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// Parameters named in a study file. Test: tests/unit/study_plan/read_study_test.cpp
namespace matrigrate::study {

/// A parameter that a table of the file names, and its value there.
struct Named {
  const Row* row;
  const toml::node* node;
};

/// The parameters of a table, in the order of the file; "a.b" = ..., a.b = ... and [table.a] b = ... are the same.
/// Unknown names are faults, and so are run.seed and run.threads, which the study decides on.
/// @param section  how the table is called in faults
/// @param own      key of the table that is no parameter, and is left to the caller
/// @param base     whose laws have constants
std::vector<Named> named_parameters(const toml::table& table, std::string_view section, std::string_view own,
                                    const Parameters& base, FaultList& faults);

/// Whether to set one parameter sets the other, too: it is the same, or one of them is all constants of the laws, of
/// which the other is one.
bool overlap(std::string_view path, std::string_view other);

/// Completes each field that a table names (complete_field), be it one text or a list of them, so that its file counts
/// from the folder of the study and its content decides on the runs.
/// @param grids   keeps what is read
/// @param prefix  path of the table; empty for one of sections
void complete_fields(toml::table& table, const std::filesystem::path& folder, fields::Grids& grids, FaultList& faults,
                     const std::string& prefix = {});

/// The value of a setting as people read it: of a field from a file without folder and fingerprint; others as they are.
std::string without_folder(const std::string& value);

/// The settings sorted by key, laws in one spelling, and all constants in place of one.   @param p  parameters with
/// these settings
std::vector<Setting> meant(std::vector<Setting> settings, const Parameters& p);

/// These, a line each.
std::string meaning_of(const std::vector<Setting>& settings, const Parameters& p);

/// The value of a number's row, in the row's unit; none for flags and choices.
std::optional<double> number_in_unit(const Row& row, Parameters p);

/// Gives the parameter a value. @return how it stands in a scenario file; none, and a fault, if it is not allowed
std::optional<Setting> assigned(const Row& row, const toml::node& node, Parameters& p, FaultList& faults);

// Studies that an earlier version has written out, whose points may name parameters that have gone
// (parameters/version.hpp). Test: tests/unit/study_plan/plan_test.cpp

/// What points say by parameters that have gone: by the place of the point's table, path and value.
using GoneValues = std::map<Place, std::map<std::string, std::string, std::less<>>>;

/// Whether a program wrote the text of a study.
bool is_written_out(std::string_view text);

/// Says by laws what [[points]] and [[conditions]] say by parameters that laws have replaced, and takes the readings
/// that have gone out of points; of conditions they stay, to be refused.
/// @param scenario  of the study: what a point does not say
/// @return what points said
GoneValues follow_gone(toml::table& study, const toml::table& scenario);

} // namespace matrigrate::study
