#include "study/study.hpp"

#include "store/run_files.hpp"
#include "study/table_readouts.hpp"

#include <algorithm>

namespace matrigrate::study {

const std::vector<std::string>& default_readouts() {
  static const std::vector<std::string> names{"v_migr_abs_um_per_h", "v_migr_path_60s_um_per_h",
                                              "n_protrusions",       "tau_prot_min",
                                              "l_prot_um",           "f_mat",
                                              "f_adh_rel",           "msd_slope"};
  return names;
}

std::vector<std::string> all_readouts() {
  std::vector<std::string> names;
  for (const io::NamedValue& v : io::named_values(ReadOuts{})) names.emplace_back(v.name);
  for (const std::string_view name : table_readout_names()) names.emplace_back(name);
  return names;
}

std::vector<std::string> swept_keys(const Study& study) {
  std::vector<std::string> keys;
  for (const Point& point : study.points)
    for (const Setting& s : point.settings)
      if (std::ranges::find(keys, s.key) == keys.end()) keys.push_back(s.key);
  return keys;
}

} // namespace matrigrate::study
