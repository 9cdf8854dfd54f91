#pragma once

#include "parameters/rules.hpp"
#include "parameters/schema.hpp"
#include "study_plan/fault_list.hpp"
#include "study_plan/study.hpp"

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
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
/// @param own      keys of the table that are no parameters, and are left to the caller
/// @param base     whose laws have constants
std::vector<Named> named_parameters(const toml::table& table, std::string_view section,
                                    const std::vector<std::string>& own, const Parameters& base, FaultList& faults);

/// Whether to set one parameter sets the other, too: it is the same, or one of them is all constants of the laws, of
/// which the other is one.
bool overlap(std::string_view path, std::string_view other);

/// Completes each field that a table names (complete_field), be it one text or a list of them, so that its file counts
/// from the folder of the study and its content decides on the runs.
/// @param grids  keeps what is read
void complete_fields(toml::table& table, const std::filesystem::path& folder, fields::Grids& grids, FaultList& faults);

/// The value of a setting as people read it: of a field from a file without folder and fingerprint; others as they are.
std::string without_folder(const std::string& value);

/// The settings sorted by key, laws in one spelling, and all constants in place of one.   @param p  parameters with
/// these settings
std::vector<Setting> meant(std::vector<Setting> settings, const Parameters& p);

/// Gives the parameter a value. @return how it stands in a scenario file; none, and a fault, if it is not allowed
std::optional<Setting> assigned(const Row& row, const toml::node& node, Parameters& p, FaultList& faults);

/// The rules on several parameters, at the points of a study.
class RuleCheck {
public:
  /// @param more  rules besides rules(), which take long: each is judged once for the same values of its parameters,
  /// and
  ///              for the first 1000 values only. The runs themselves are checked again.
  explicit RuleCheck(std::span<const Rule> more) : m_more(more) {}

  /// Faults for the rules that p breaks.
  /// @param places  of parameters in the file; the first one of a rule that is among them is blamed
  void check(const Parameters& p, const std::vector<std::pair<std::string, Place>>& places, FaultList& faults);

private:
  static constexpr std::size_t max_found = 1000;

  /// @param when  in front of each fault   @return whether there is none
  bool check(const Parameters& p, const std::string& when, const std::vector<std::pair<std::string, Place>>& places,
             FaultList& faults);
  const std::string& found(const Rule& rule, const Parameters& p);
  static void blame(const Rule& rule, const std::string& broken,
                    const std::vector<std::pair<std::string, Place>>& places, FaultList& faults);

  std::span<const Rule> m_more;
  std::unordered_map<std::string, std::string> m_found; ///< what is wrong, by rule and values
};

} // namespace matrigrate::study
