#include "apps/terminal/terminal.hpp"
#include "apps/verbs.hpp"
#include "base/failure.hpp"
#include "base/file.hpp"
#include "parameters/document.hpp"
#include "parameters/nearest.hpp"
#include "parameters/write.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <filesystem>
#include <memory>
#include <optional>
#include <span>

namespace matrigrate::apps {

namespace {

struct NewArguments {
  std::string file;
  std::string preset = "baseline";
  std::optional<std::string> law;
  std::string schema;
};

constexpr const char* schema_file = "scenario.schema.json";

/// The names of presets, in lines of at most 100 characters.
std::string names_of(std::span<const Preset> all, std::string text) {
  constexpr std::size_t widest = 100;
  std::size_t width = text.size();
  for (const Preset& preset : all) {
    width += preset.name.size() + 1;
    text += width > widest ? '\n' : ' ';
    text += preset.name;
    if (width > widest) width = preset.name.size();
  }
  return text;
}

/// @param kind  what it is, for the fault that there is none of that name
const Preset& preset_among(const std::string& name, std::string_view kind, std::span<const Preset> all) {
  if (const Preset* preset = find_preset(name, all)) return *preset;
  std::vector<std::string> names;
  for (const Preset& preset : all) names.emplace_back(preset.name);
  throw UsageError(fmt::format("there is no {0} \"{1}\"{2}\nThe {0}s are: {3}", kind, excerpt(name),
                               did_you_mean(nearest(name, names)), fmt::join(names, ", ")));
}

/// Writes the schema beside a scenario, unless it is there already or something else has its name.
void write_schema(const std::filesystem::path& scenario) {
  constexpr std::size_t largest = std::size_t{1} << 20U;
  const std::filesystem::path file = scenario.parent_path() / schema_file;
  const std::string text = json_schema();
  const std::string start = text.substr(0, text.find("\"type\""));
  if (std::filesystem::exists(std::filesystem::symlink_status(file))) {
    const std::string there = read_file(file, largest);
    if (there == text) return;
    if (!there.starts_with(start)) // not ours
      return print_warning(fmt::format("{}: is not the schema of this version and was not changed; matrigrate list "
                                       "--schema-json prints the schema of this version",
                                       file.string()));
  }
  write_file(file, text);
  print(fmt::format("{}: for editors that complete and check TOML\n", file.string()));
}

int write_scenario(const NewArguments& options) {
  const Preset& preset =
      options.law ? preset_among(*options.law, "law", published_laws()) : preset_named(options.preset);
  if (excerpt(options.schema, options.schema.size()) != options.schema)
    throw UsageError("--schema: the path holds a line break, a control character, or bytes that are not UTF-8");
  if (std::filesystem::exists(std::filesystem::symlink_status(options.file)))
    throw InputOutputError(options.file
                           + ": exists and is not overwritten; choose another name, or delete the file first");
  write_file(options.file, new_scenario(preset, options.schema.empty() ? schema_file : options.schema));
  if (options.schema.empty()) write_schema(options.file);
  print(fmt::format("{}: written from the {} {}; next: matrigrate explain {}\n", options.file,
                    options.law ? "law" : "preset", preset.name, options.file));
  return done;
}

} // namespace

const Preset& preset_named(const std::string& name) { return preset_among(name, "preset", presets()); }

void add_new(CLI::App& app, Action& chosen) {
  CLI::App* verb = app.add_subcommand("new", "Write a commented scenario file; never overwrites one");
  const auto options = std::make_shared<NewArguments>();
  verb->add_option("FILE", options->file, "The file to write, such as scenario.toml")->required();
  auto* preset = verb->add_option("--preset", options->preset, "What to start from: a preset of `matrigrate list`")
                     ->capture_default_str();
  verb->add_option("--law", options->law, "Instead: a published law of `matrigrate list`, with its reference")
      ->excludes(preset);
  verb->add_option("--schema", options->schema,
                   "The JSON schema that the first line names for editors, seen from FILE (default: "
                   "scenario.schema.json,\nwhich is then written beside FILE)");
  verb->footer("")->footer([] {
    return names_of(presets(), "The presets:") + "\n" + names_of(published_laws(), "The laws:");
  }); // instead of the exit codes
  verb->callback([options, &chosen] { chosen = [options] { return write_scenario(*options); }; });
}

} // namespace matrigrate::apps
