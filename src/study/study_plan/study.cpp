#include "study_plan/study.hpp"

#include "observe/readout_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

namespace matrigrate::study {

const std::vector<std::string>& default_readouts() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> usual;
    for (const ReadOutSpec& spec : readout_table())
      if (spec.usual) usual.emplace_back(spec.name);
    return usual;
  }();
  return names;
}

std::vector<std::string> all_readouts() {
  std::vector<std::string> names;
  for (const ReadOutSpec& spec : readout_table()) names.emplace_back(spec.name);
  return names;
}

std::size_t readout_column(std::string_view readout) {
  const std::vector<std::string> names = all_readouts();
  const auto found = std::ranges::find(names, readout);
  if (found == names.end()) throw std::invalid_argument(fmt::format("there is no read-out {}", readout));
  return static_cast<std::size_t>(found - names.begin());
}

std::vector<std::shared_ptr<const std::vector<tracks::CellTrack>>> measured_sets(const Study& study) {
  std::vector<std::shared_ptr<const std::vector<tracks::CellTrack>>> sets;
  for (const Target& target : study.targets)
    if (target.tracks != nullptr && std::ranges::find(sets, target.tracks) == sets.end()) sets.push_back(target.tracks);
  return sets;
}

std::string measured_file(std::size_t k) { return fmt::format("measured-{}.csv", k + 1); }

bool has_several_cells(const Study& study) {
  return std::ranges::any_of(study.points, [](const Point& point) { return point.parameters.cells.size() > 1; });
}

std::vector<std::string> swept_keys(const Study& study) {
  std::vector<std::string> keys;
  for (const Point& point : study.points)
    for (const Setting& s : point.settings)
      if (std::ranges::find(keys, s.key) == keys.end()) keys.push_back(s.key);
  return keys;
}

} // namespace matrigrate::study
