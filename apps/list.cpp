#include "apps/shipped_studies.hpp"
#include "apps/terminal.hpp"
#include "apps/verbs.hpp"
#include "parameters/write.hpp"
#include "study/read_study.hpp"
#include "validation/case.hpp"

#include <fmt/format.h>

#include <memory>

namespace matrigrate::apps {

namespace {

struct Options {
  bool parameters = false;
  bool schema = false;
};

void print_entry(std::string_view name, std::string_view description) {
  print(fmt::format("  {:<14}{}\n", name, description));
}

std::string title_of(const ShippedStudy& s) { return study::parse_study(s.text, std::string(s.name), ".").title; }

int print_list(const Options& options) {
  if (options.parameters) print(parameters_markdown());
  if (options.schema) print(json_schema());
  if (options.parameters || options.schema) return done;
  print(coloured("Presets", Colour::strong, Stream::out) + ", for matrigrate new FILE --preset NAME\n");
  for (const Preset& preset : presets()) print_entry(preset.name, preset.description);
  print("\n" + coloured("Cases", Colour::strong, Stream::out) + ", for matrigrate validate NAME\n");
  for (const validation::Case& c : validation::cases()) print_entry(c.name, c.summary);
  print("\n" + coloured("Studies", Colour::strong, Stream::out) + ", for matrigrate reproduce and in studies/\n");
  for (const ShippedStudy& s : shipped_studies()) print(fmt::format("  {:<26}{}\n", s.name, title_of(s)));
  return done;
}

} // namespace

void add_list(CLI::App& app, Action& chosen) {
  CLI::App* verb = app.add_subcommand("list", "The presets, validation cases and studies that ship with the program");
  const auto options = std::make_shared<Options>();
  auto* parameters =
      verb->add_flag("--parameters", options->parameters, "Instead: all parameters, as a Markdown table a section");
  verb->add_flag("--schema-json", options->schema, "Instead: the JSON schema of a scenario file, for editors")
      ->excludes(parameters);
  verb->callback([options, &chosen] { chosen = [options] { return print_list(*options); }; });
}

} // namespace matrigrate::apps
