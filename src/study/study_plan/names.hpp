#pragma once

#include "parameters/schema.hpp"
#include "study_plan/study.hpp"

#include <nlohmann/json.hpp>

#include <map>
#include <string>
#include <vector>

namespace matrigrate::study {

// How the parameters of a study are called in labels, sentences and figures. Test:
// tests/unit/study_plan/plan_test.cpp

/// The parameters that a study varies, each by a name that no other of them has.
class Names {
public:
  /// @param keys  their paths
  explicit Names(const std::vector<std::string>& keys);
  explicit Names(const Study& study) : Names(swept_keys(study)) {}

  /// "youngs_modulus"; "n_prot", since "number" says of what too little; the whole path where another parameter of the
  /// study ends alike: "protrusion.force" beside "actomyosin.force".
  std::string of(const std::string& key) const;
  /// "polarization.rate (r_pol)", of a constant of the laws its name: where there is room, as along an axis.
  static std::string whole(const std::string& key);

private:
  std::map<std::string, std::string> m_names; ///< by path
};

/// The number of a parameter in the unit of its row, or what stands in its place: a word, a formula, a file.
std::string swept_text(const Row& row, const Parameters& p);

/// "youngs_modulus 50 Pa, force 0.6 nN"; "all" without settings. A field from a file is called by the name of the file
/// ("youngs_modulus stiff.csv").
/// @param whole  with the folder and the fingerprint of files
std::string label_of(const std::vector<Setting>& settings, const Names& names, bool whole = false);

/// A point as people read it: its label; of a sample of a Latin hypercube, whose label only counts, the values of its
/// factors to three digits: "youngs_modulus 138 Pa, viscosity 705 Pa s".
std::string point_text(const Study& study, std::size_t point);

// Along what the page of a study draws its points. Test: tests/unit/study_report/study_report_test.cpp

/// The parameters that differ between points, with their values in the order to draw: numbers in the unit of the
/// parameter, rising, or words. Where the points are no grid of these values: all factor sets by their labels, and the
/// conditions if there are any.
nlohmann::ordered_json axes_json(const Study& study);

/// For each point its index along each axis.
std::vector<nlohmann::ordered_json> places(const Study& study);

} // namespace matrigrate::study
