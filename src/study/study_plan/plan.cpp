#include "study_plan/plan.hpp"

#include "store/trajectory_hash.hpp"
#include "study_plan/settings.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace matrigrate::study {

namespace {

/// A value without the folder of the file that it names: a study has the same seeds wherever it lies.
std::string anywhere(const std::string& value) {
  const std::size_t hash = value.find(" hash=");
  return hash == std::string::npos ? value : without_folder(value) + value.substr(hash);
}

/// What the seeds of a point follow from.
std::vector<Setting> seeding(const Study& study, const Point& point) {
  if (study.common_random_numbers) return {};
  return point.seeded_by.empty() ? point.settings : point.seeded_by;
}

} // namespace

std::uint64_t run_seed(std::uint64_t study_seed, std::vector<Setting> settings, std::size_t replicate) {
  std::ranges::sort(settings, {}, &Setting::key);
  std::string text = fmt::format("seed {}\n", study_seed);
  for (const Setting& s : settings) text += fmt::format("{} = {}\n", s.key, anywhere(s.value));
  text += fmt::format("replicate {}\n", replicate);
  return std::stoull(store::text_hash(text), nullptr, 16) & ((std::uint64_t{1} << 53U) - 1);
}

Parameters parameters_of(const Study& study, const Run& run) {
  Parameters p = study.points[run.point].parameters;
  p.run.seed = run.seed;
  p.run.threads = 1;
  return p;
}

std::uint64_t seed_as_typed(const Study& study, const Run& run) {
  return run_seed(study.seed, seeding(study, study.points[run.point]), run.replicate);
}

std::vector<Run> planned_runs(const Study& study, const Fingerprint& fingerprint) {
  std::vector<Run> runs;
  runs.reserve(study.runs());
  for (std::size_t replicate = 1; replicate <= study.replicates; ++replicate)
    for (std::size_t i = 0; i < study.points.size(); ++i) {
      const Point& point = study.points[i];
      const std::vector<Setting> settings = meant(seeding(study, point), point.parameters);
      Run run{i, replicate, run_seed(study.seed, settings, replicate), {}};
      run.hash = fingerprint(parameters_of(study, run));
      runs.push_back(std::move(run));
    }
  return runs;
}

} // namespace matrigrate::study
