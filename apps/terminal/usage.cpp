#include "apps/terminal/usage.hpp"

#include "apps/verbs.hpp"
#include "parameters/nearest.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <regex>
#include <string_view>

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

/// What a number given by an option may be: "a whole number from 1 to 4096".
std::string number_of(const CLI::Option& option, const std::string& range) {
  const std::string type = option.get_type_name();
  return (type.starts_with("FLOAT") ? "a number" : "a whole number") + range;
}

/// Of an option whose text is no number, or one out of its range: what is wanted; else nothing.
std::string number_fault(const CLI::App& verb, const std::string& what) {
  static const std::regex no_number("Could not convert: (-[^ ]+) = ?(.*)");
  static const std::regex out_of_range("(-[^ ]+): Value (.*) not in range ([^ ]+) to ([^ ]+)");
  constexpr std::size_t longest = 1000; // of a text that a regular expression is tried on
  if (what.size() > longest) return {};
  std::smatch found;
  const bool ranged = std::regex_match(what, found, out_of_range);
  if (!ranged && !std::regex_match(what, found, no_number)) return {};
  const CLI::Option* option = verb.get_option_no_throw(found[1]);
  if (option == nullptr) return {};
  const std::string range =
      ranged ? fmt::format(" from {:g} to {:g}", std::stod(found[3]), std::stod(found[4])) : std::string();
  return fmt::format("{}: \"{}\" is not {}", found[1].str(), found[2].str(), number_of(*option, range));
}

} // namespace

void call_subcommands_verbs(CLI::App& app, const std::vector<std::string>& rare) {
  app.get_formatter()->label("SUBCOMMAND", "VERB");
  for (CLI::App* verb : app.get_subcommands({})) {
    verb->group(contains(rare, verb->get_name()) ? "More verbs" : "Verbs");
    call_subcommands_verbs(*verb, {});
  }
}

void require_verb(const CLI::App& app, int argc, char** argv) {
  const CLI::App* group = &app;
  for (int i = 1; !verbs_of(*group).empty(); ++i) {
    const bool top = group == &app;
    const std::string name = top ? "" : group->get_name();
    const std::vector<std::string> verbs = verbs_of(*group);
    const std::string list = fmt::format("\nThe verbs{} are: {}; matrigrate {}-h says what they do",
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
  const std::string help = fmt::format("\nmatrigrate {}-h says how it is used", words);
  const auto option = std::ranges::find_if(extra, [](const std::string& word) { return word.starts_with('-'); });
  if (option != extra.end()) {
    const std::string name = option->substr(0, option->find('='));
    return fmt::format("there is no option {}{}{}", name, did_you_mean(nearest(name, options_of(*verb))), help);
  }
  if (!extra.empty() && dynamic_cast<const CLI::ExtrasError*>(&error) != nullptr)
    return fmt::format("too many arguments: {}{}", fmt::join(extra, " "), help);
  if (std::string_view(error.what()) == "A subcommand is required") return fmt::format("a verb is required{}", help);
  const std::string text = error.what();
  constexpr std::string_view twice = ": At Most 1 required but received ";
  if (const std::size_t at = text.find(twice); at != std::string::npos)
    return fmt::format("{} is given {} times{}", text.substr(0, at), text.substr(at + twice.size()), help);
  const std::string number = number_fault(*verb, error.what());
  return fmt::format("{}{}", number.empty() ? text.substr(0, 1000) : number, help);
}

} // namespace matrigrate::apps
