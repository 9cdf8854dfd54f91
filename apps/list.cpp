#include "apps/terminal/terminal.hpp"
#include "apps/verbs.hpp"
#include "claims/claims.hpp"
#include "parameters/write.hpp"
#include "study_plan/read_study.hpp"
#include "tables/run_files.hpp"
#include "validation/case.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <memory>

namespace matrigrate::apps {

namespace {

struct ListArguments {
  bool parameters = false;
  bool schema = false;
  bool readouts = false;
};

/// The name of each, and what it stands for.
template <class All, class Description>
void print_entries(std::string_view title, std::string_view use, const All& all, const Description& description) {
  std::size_t width = 0;
  for (const auto& one : all) width = std::max(width, one.name.size());
  print(fmt::format("{}, for {}\n", coloured(title, Colour::strong, Stream::out), use));
  for (const auto& one : all) print(fmt::format("  {:<{}}  {}\n", one.name, width, std::invoke(description, one)));
}

std::string title_of(const study::ShippedStudy& s) {
  return study::parse_study(s.text, std::string(s.name), ".").title;
}

int print_list(const ListArguments& options) {
  if (options.parameters) print(parameters_markdown());
  if (options.schema) print(json_schema());
  if (options.readouts) print(store::readouts_json());
  if (options.parameters || options.schema || options.readouts) return done;
  print_entries("Presets", "matrigrate new FILE --preset NAME", presets(), &Preset::description);
  print_entries("\nPublished laws", "matrigrate new FILE --law NAME", published_laws(), &Preset::description);
  print_entries("\nCases", "matrigrate validate NAME", validation::cases(), &validation::Case::summary);
  print_entries("\nStudies", "matrigrate reproduce and in studies/", study::shipped_studies(), title_of);
  return done;
}

} // namespace

void add_list(CLI::App& app, Action& chosen) {
  CLI::App* verb = app.add_subcommand(
      "list", "The presets, published laws, verification cases and studies that ship with the program");
  const auto options = std::make_shared<ListArguments>();
  auto* parameters =
      verb->add_flag("--parameters", options->parameters, "Instead: all parameters, as a Markdown table a section");
  auto* schema =
      verb->add_flag("--schema-json", options->schema, "Instead: the JSON schema of a scenario file, for editors")
          ->excludes(parameters);
  verb->add_flag("--readouts-json", options->readouts, "Instead: all read-outs with label, unit and meaning, as JSON")
      ->excludes(parameters)
      ->excludes(schema);
  verb->callback([options, &chosen] { chosen = [options] { return print_list(*options); }; });
}

} // namespace matrigrate::apps
