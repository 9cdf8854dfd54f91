#include "apps/parameter_options.hpp"
#include "apps/run_output.hpp"
#include "apps/terminal/terminal.hpp"
#include "apps/verbs.hpp"
#include "base/failure.hpp"
#include "base/file.hpp"
#include "parameters/presets.hpp"
#include "parameters/read.hpp"
#include "simulation/start.hpp"
#include "study_plan/read_study.hpp"
#include "study_results/results.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <stdlib.h>

#include <algorithm>
#include <cerrno>
#include <memory>
#include <random>
#include <system_error>

namespace matrigrate::apps {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::string_view target_word = "target=";

struct SampleArguments {
  std::vector<std::string> words;
  std::string preset = "baseline";
  std::string scenario;
  std::string targets;
  ParameterOptions parameters;
  std::vector<std::string> command_line;
};

/// A folder of the system's, removed with its contents by the destructor.
struct TemporaryFolder {
  TemporaryFolder() {
    std::string name = (temporary_folder() / "matrigrate.XXXXXX").string();
    if (::mkdtemp(name.data()) == nullptr)
      throw InputOutputError(fmt::format("{}: cannot be written: {}; TMPDIR names another folder to work in", name,
                                         std::generic_category().message(errno)));
    path = name;
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  ~TemporaryFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path, ignored);
  }
  std::filesystem::path path;
};

/// What is to be simulated, and where the JSON goes.
struct Request {
  Parameters p;
  std::vector<study::Target> targets;
  std::filesystem::path file; ///< empty: the standard output
};

/// Adds the faults of a step of reading to those of the others.
template <class Step>
void collect(std::vector<Fault>& faults, const Step& step) {
  try {
    step();
  } catch (const ConfigurationError& error) {
    faults.insert(faults.end(), error.faults().begin(), error.faults().end());
  }
}

/// A seed that no other sample has; that of the scenario would give each the same random numbers.
std::uint64_t new_seed() {
  std::random_device device;
  return ((std::uint64_t{device()} << 32U) | device()) >> 11U;
}

Parameters read_values(const SampleArguments& options) {
  ParameterOptions values = options.parameters;
  const auto is_seed = [](const std::string& text) { return text.starts_with("run.seed="); };
  if (!values.seed && std::ranges::none_of(values.overrides, is_seed)) values.seed = std::to_string(new_seed());
  try {
    if (!options.scenario.empty()) return read_parameters(options.scenario, all_overrides(values), start_rules());
    return apply_overrides(parameters_of(preset_named(options.preset)), all_overrides(values), start_rules());
  } catch (const ConfigurationError& error) {
    std::vector<Fault> faults = naming_options(error, values).faults();
    for (Fault& fault : faults)
      if (fault.file == "--set") fault.file.clear();
    throw ConfigurationError(std::move(faults));
  }
}

/// @throws UsageError naming the keys that are given more than once, also by an option
void require_once(const SampleArguments& options) {
  std::vector<std::string> keys, twice;
  for (const std::string& word : options.words) keys.push_back(word.substr(0, word.find('=')));
  if (options.parameters.seed) keys.emplace_back("run.seed");
  if (options.parameters.hours) keys.emplace_back("run.duration");
  if (options.parameters.threads) keys.emplace_back("run.threads");
  std::ranges::sort(keys);
  for (std::size_t k = 1; k < keys.size(); ++k)
    if (keys[k] == keys[k - 1] && (twice.empty() || twice.back() != keys[k])) twice.push_back(keys[k]);
  if (!twice.empty()) throw UsageError(fmt::format("{}: is given more than once", fmt::join(twice, ", ")));
}

Request request_of(SampleArguments options) {
  require_once(options);
  Request request;
  for (std::string word : options.words) {
    word.erase(word.find_last_not_of(' ') + 1); // pyABC's external models put a blank behind each value
    if (word.starts_with(target_word))
      request.file = word.substr(target_word.size());
    else
      options.parameters.overrides.push_back(std::move(word));
  }
  std::error_code none;
  if (!request.file.empty() && std::filesystem::exists(request.file)
      && std::filesystem::file_size(request.file, none) != 0)
    throw InputOutputError(fmt::format("{}: holds something already", request.file.string()));
  std::vector<Fault> faults;
  collect(faults, [&] { request.p = read_values(options); });
  if (!options.targets.empty()) collect(faults, [&] { request.targets = study::read_target_file(options.targets); });
  if (!faults.empty()) throw ConfigurationError(std::move(faults));
  OutputParameters& output = request.p.output; // what is written is removed
  output.report = false;
  output.checkpoint_interval = output.field_interval = 0.0;
  return request;
}

/// How far the read-outs are from targets, in their errors; the distance is NaN if one of them is not defined.
void add_distance(Json& json, const std::vector<study::Target>& targets, const std::vector<double>& readouts) {
  Json list = Json::array();
  std::vector<double> all;
  for (const study::Target& target : targets) {
    const double value = readouts[study::readout_column(target.readout)];
    const double z = study::distance(target, value);
    all.push_back(z);
    list.push_back({{"readout", target.readout},
                    {"low", target.low},
                    {"high", target.high},
                    {"error", target.error},
                    {"weight", target.weight},
                    {"z", z}});
  }
  json["targets"] = list;
  json["distance"] = study::distance(targets, all);
}

RunOutcome run_in(const TemporaryFolder& folder, const Parameters& p, const SampleArguments& options) {
  RunDisplay display(true);
  try {
    return run::run(
        {.s = initial_state(p), .p = p},
        {.folder = folder.path, .command_line = options.command_line, .page_template = {}, .folder_is_kept = false},
        display);
  } catch (const InputOutputError& error) {
    throw InputOutputError(fmt::format("{}; TMPDIR names another folder to work in", error.what()));
  }
}

int sample(const SampleArguments& options) {
  const Request request = request_of(options);
  const TemporaryFolder folder;
  const RunOutcome outcome = run_in(folder, request.p, options);
  if (outcome.end != RunEnd::completed) {
    print_failure(outcome.sentence);
    return run::exit_code(outcome.end);
  }
  const std::vector<double> values = study::readouts_of(folder.path);
  const std::vector<std::string> names = study::all_readouts();
  Json readouts = Json::object();
  for (std::size_t i = 0; i < names.size(); ++i) readouts[names[i]] = values[i];
  Json json{{"seed", request.p.run.seed}, {"readouts", readouts}};
  if (!options.targets.empty()) add_distance(json, request.targets, values);
  const std::string text = json.dump() + "\n"; // what is not finite is null
  request.file.empty() ? print(text) : write_file(request.file, text);
  return done;
}

} // namespace

void add_sample(CLI::App& app, Action& chosen, std::vector<std::string> command_line) {
  CLI::App* verb = app.add_subcommand("sample", "Simulate once with given parameters; print the read-outs as JSON");
  verb->footer(
      "For samplers such as pyABC and sbi: matrigrate sample ecm.youngs_modulus=120 protrusion.force=\"0.3 nN\".\n"
      "A bare number is in the unit of `matrigrate list --parameters`. Prints one line:\n"
      "{seed, readouts: {name: number or null}}, with --targets also\n"
      "{targets: [{readout, low, high, error, weight, z}], distance}: z is the distance from the target in its\n"
      "errors, and distance the root of the weighted mean of z^2, null where a read-out of a target is not defined.\n"
      "The file of --targets is a study, or any TOML file with [[targets]].\n"
      "Works in a temporary folder (TMPDIR) and keeps none of the run's files; kill -9 leaves the folder,\n"
      "matrigrate.*. Each call draws a new seed, unless --seed or run.seed is given. The word target=FILE writes the\n"
      "JSON into this new or empty file, as external models of pyABC want it.\n"
      "Exit code 3 with all faults of parameters and targets, 4 if the computation fails; then nothing is printed.");
  const auto options = std::make_shared<SampleArguments>();
  options->command_line = std::move(command_line);
  verb->add_option("PARAMETERS", options->words, "Values as key=value, over the preset or the scenario");
  CLI::Option* preset =
      verb->add_option("--preset", options->preset, "What they change: see `matrigrate list` (default: baseline)");
  verb->add_option("--scenario", options->scenario, "Change this scenario file instead")->excludes(preset);
  verb->add_option("--targets", options->targets, "Measured read-outs, from which the distance is computed");
  verb->add_option("--seed", options->parameters.seed, "Seed of the random numbers: run.seed");
  verb->add_option("--hours", options->parameters.hours, "Simulated time in hours, or as \"30 min\": run.duration");
  add_threads(*verb, options->parameters, "Threads, 0 for as many as pay: run.threads; never changes a result");
  verb->callback([options, &chosen] { chosen = [options] { return sample(*options); }; });
}

} // namespace matrigrate::apps
