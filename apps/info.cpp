#include "apps/terminal/terminal.hpp"
#include "apps/verbs.hpp"
#include "run/provenance.hpp"

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <memory>

namespace matrigrate::apps {

void add_info(CLI::App& app, Action& chosen) {
  CLI::App* verb = app.add_subcommand("info", "Version, commit, compiler, libraries and CPU");
  verb->footer("--json prints {version, git_hash, git_dirty, compiler, flags, build_type, sanitizers,\n"
               "libraries: {name: version}, cpu: {model, threads, simd: [names]}}.");
  const auto json = std::make_shared<bool>(false);
  verb->add_flag("--json", *json, "Print it as JSON");
  verb->callback([json, &chosen] {
    chosen = [json] {
      *json ? print_json(provenance()) : print(provenance_text());
      return done;
    };
  });
}

} // namespace matrigrate::apps
