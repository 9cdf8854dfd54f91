#include "apps/terminal/usage.hpp"

#include "apps/verbs.hpp"
#include "parameters/nearest.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <vector>

namespace matrigrate::apps {

namespace {

std::vector<std::string> verbs_of(const CLI::App& app) {
  std::vector<std::string> verbs;
  for (const CLI::App* verb : app.get_subcommands({})) verbs.push_back(verb->get_name());
  return verbs;
}

bool contains(const std::vector<std::string>& words, const std::string& word) {
  return std::ranges::find(words, word) != words.end();
}

/// The verb that was parsed last, and how it is typed: "study plan ".
struct ChosenVerb {
  const CLI::App* verb;
  std::string words;
};

ChosenVerb chosen_verb(const CLI::App& app) {
  ChosenVerb chosen{&app, ""};
  while (!chosen.verb->get_subcommands().empty()) {
    chosen.verb = chosen.verb->get_subcommands().front();
    chosen.words += chosen.verb->get_name() + " ";
  }
  return chosen;
}

std::vector<std::string> options_of(const CLI::App& verb) {
  std::vector<std::string> names;
  for (const CLI::Option* option : verb.get_options()) {
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
    for (const std::string& name : option->get_snames()) names.push_back("-" + name);
  }
  return names;
}

} // namespace

void call_subcommands_verbs(CLI::App& app) {
  app.get_formatter()->label("SUBCOMMAND", "VERB");
  for (CLI::App* verb : app.get_subcommands({})) {
    verb->group("Verbs");
    call_subcommands_verbs(*verb);
  }
}

void require_verb(const CLI::App& app, int argc, char** argv) {
  const CLI::App* group = &app;
  for (int i = 1; !verbs_of(*group).empty(); ++i) {
    const bool top = group == &app;
    const std::string name = top ? "" : group->get_name();
    const std::vector<std::string> verbs = verbs_of(*group);
    const std::string list = fmt::format("\nThe verbs{} are: {}; matrigrate {}-h tells what they do",
                                         top ? "" : " of " + name, fmt::join(verbs, ", "), top ? "" : name + " ");
    if (i >= argc) throw UsageError(fmt::format("a verb{} is required{}", top ? "" : " of " + name, list));
    const std::string word = argv[i];
    if (word.starts_with('-')) return;
    if (!contains(verbs, word)) {
      const std::string meant = !top && contains(verbs_of(app), word)
                                    ? fmt::format("; did you mean matrigrate {}?", word)
                                    : did_you_mean(nearest(word, verbs));
      throw UsageError(fmt::format("{} no verb \"{}\"{}{}", top ? "there is" : name + " has", word, meant, list));
    }
    group = group->get_subcommand(word);
  }
}

std::string usage_fault(const CLI::App& app, const CLI::ParseError& error) {
  const auto [verb, words] = chosen_verb(app);
  const std::vector<std::string> extra = app.remaining(true);
  const std::string help = fmt::format("\nmatrigrate {}-h tells how it is used", words);
  const auto option = std::ranges::find_if(extra, [](const std::string& word) { return word.starts_with('-'); });
  if (option != extra.end()) {
    const std::string name = option->substr(0, option->find('='));
    return fmt::format("there is no option {}{}{}", name, did_you_mean(nearest(name, options_of(*verb))), help);
  }
  if (!extra.empty() && dynamic_cast<const CLI::ExtrasError*>(&error) != nullptr)
    return fmt::format("too many arguments: {}{}", fmt::join(extra, " "), help);
  if (std::string_view(error.what()) == "A subcommand is required") return fmt::format("a verb is required{}", help);
  return fmt::format("{}{}", error.what(), help);
}

} // namespace matrigrate::apps
