#include "study_plan/study.hpp"

#include "observe/readout_table.hpp"
#include "store/trajectory_hash.hpp"
#include "study_plan/read_study.hpp"
#include "study_plan/settings.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <stdexcept>

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

/// A string, or a list of strings, of TOML: those of JSON are a part of them.
std::string quoted(const std::string& text) { return nlohmann::json(text).dump(); }
std::string quoted(const std::vector<std::string>& texts) {
  std::vector<std::string> all;
  for (const std::string& text : texts) all.push_back(quoted(text));
  return fmt::format("[{}]", fmt::join(all, ", "));
}

std::string statistics_section(const Comparisons& c) {
  std::string text = fmt::format("\n[statistics]\ncompare = \"{}\"\n", pairs_names[static_cast<std::size_t>(c.pairs)]);
  if (c.pairs == Pairs::control) text += fmt::format("control = {}\n", quoted(c.control));
  return text + fmt::format("test = \"{}\"\nalpha = {}\n", test_names[static_cast<std::size_t>(c.test)], c.alpha);
}

void add_settings(const std::vector<Setting>& settings, std::string& text) {
  for (const Setting& s : settings) text += fmt::format("\"{}\" = {}\n", s.key, s.value);
}

std::string target_section(const Study& study, const Target& t) {
  std::string text = fmt::format("\n[[targets]]\nreadout = {}\n", quoted(t.readout));
  if (t.tracks != nullptr) {
    const auto sets = measured_sets(study);
    const auto own = std::ranges::find(sets, t.tracks) - sets.begin();
    text += fmt::format("tracks = {}\n", quoted(measured_file(static_cast<std::size_t>(own))));
  } else {
    text += t.low == t.high ? fmt::format("value = {}\n", t.low) : fmt::format("low = {}\nhigh = {}\n", t.low, t.high);
    text += fmt::format("error = {}\n", t.error);
  }
  text += fmt::format("weight = {}\n", t.weight);
  if (t.at.empty()) return text;
  std::vector<std::string> labels;
  for (const std::size_t c : t.at) labels.push_back(study.conditions[c].label);
  return text + fmt::format("at = {}\n", quoted(labels));
}

} // namespace

std::vector<std::string> default_readouts() {
  std::vector<std::string> names;
  for (const ReadOutSpec& spec : readout_table())
    if (spec.usual) names.emplace_back(spec.name);
  return names;
}

std::vector<std::string> all_readouts() {
  std::vector<std::string> names;
  for (const ReadOutSpec& spec : readout_table()) names.emplace_back(spec.name);
  return names;
}

std::size_t readout_column(std::string_view readout) {
  const auto all = readout_table();
  const auto found = std::ranges::find(all, readout, &ReadOutSpec::name);
  if (found == all.end()) throw std::invalid_argument(fmt::format("there is no read-out {}", readout));
  return static_cast<std::size_t>(found - all.begin());
}

std::vector<MeasuredTracks> measured_sets(const Study& study) {
  std::vector<MeasuredTracks> sets;
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

std::string to_toml(const Study& study, const std::string& scenario) {
  std::string text = fmt::format("# A study with all its points written out{}. Running this file again adds nothing.\n",
                                 study.conditions.empty() ? "" : "; each is run at each condition");
  if (!study.title.empty()) text += fmt::format("title = {}\n", quoted(study.title));
  text +=
      fmt::format("scenario = {}\nreplicates = {}\nseed = {}\ncommon_random_numbers = {}\nreadouts = {}\n",
                  quoted(scenario), study.replicates, study.seed, study.common_random_numbers, quoted(study.readouts));
  text += statistics_section(study.comparisons);
  for (const Condition& condition : study.conditions) {
    text += fmt::format("\n[[conditions]]\nlabel = {}\n", quoted(condition.label));
    add_settings(condition.settings, text);
  }
  for (const Target& target : study.targets) text += target_section(study, target);
  for (const FactorSet& set : study.sets) {
    text += fmt::format("\n[[points]]\nlabel = {}\n", quoted(set.label));
    add_settings(set.settings, text);
  }
  for (const Claim& claim : study.claims) text += "\n" + claim.text;
  return text;
}

} // namespace matrigrate::study
