#include "apps/terminal/stop_signal.hpp"
#include "apps/terminal/terminal.hpp"
#include "apps/verbs.hpp"
#include "base/failure.hpp"
#include "base/platform.hpp"
#include "parameters/nearest.hpp"
#include "run/provenance.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstdlib>
#include <exception>
#include <new>
#include <regex>
#include <sstream>
#include <system_error>

namespace matrigrate::apps {

// Each is in the file of its name.
using Verb = void(CLI::App&, Action&);
using VerbOfRuns = void(CLI::App&, Action&, std::vector<std::string> command_line); // which run.json keeps
Verb add_new, add_list, add_check, add_explain, add_report, add_open, add_live, add_diff, add_export, add_tracks,
    add_validate, add_selftest, add_study, add_info;
VerbOfRuns add_run, add_resume, add_sample, add_demo;
void add_reproduce(CLI::App& app, Action& chosen, const std::vector<std::string>& command_line);

namespace {

// What is wrong with a command line. Test: tests/apps/usage_test.cpp

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
  static const std::regex no_number("Could not convert: ([^ ]+) = ?(.*)");
  static const std::regex out_of_range("([^ ]+): Value (.*) not in range ([^ ]+) to ([^ ]+)");
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

/// In the help of the program and of its groups of verbs.
/// @param rare  verbs that stand last, under a title of their own
void call_subcommands_verbs(CLI::App& app, const std::vector<std::string>& rare) {
  app.get_formatter()->label("SUBCOMMAND", "VERB");
  for (CLI::App* verb : app.get_subcommands({})) {
    verb->group(contains(rare, verb->get_name()) ? "More verbs" : "Verbs");
    call_subcommands_verbs(*verb, {});
  }
}

/// @throws UsageError naming the verbs there are, if the command line has none or an unknown one
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

/// In one line: the unknown option with the nearest one, the arguments that are too many in the order typed, or what
/// the parser says.
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

/// Help and version are no errors, unless they cannot be written.
int print_help(const CLI::App& app, const CLI::ParseError& asked) {
  std::ostringstream text;
  app.exit(asked, text, text);
  print(text.str());
  flush();
  return done;
}

/// Opens /dev/null on those of the descriptors 0 to 2 that are closed, so that no file of a run gets their numbers and
/// with it what is meant for the terminal. Each is opened the wrong way round: reading and writing still fail.
void secure_descriptors() {
  for (const int descriptor : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    if (::fcntl(descriptor, F_GETFD) != -1) continue;
    if (::open("/dev/null", descriptor == STDIN_FILENO ? O_WRONLY : O_RDONLY) != descriptor) std::_Exit(input_output);
  }
}

/// What may help where memory ends; of each verb.
std::string_view& advice_on_memory() {
  static constinit std::string_view advice;
  return advice;
}

std::string_view advice_on_memory_of(std::string_view verb) {
  for (const std::string_view simulating :
       {"run", "resume", "sample", "study", "explain", "check", "demo", "reproduce"})
    if (verb == simulating) return "; matrigrate explain prints what a scenario needs";
  if (verb == "export") return "; export one kind at a time";
  return {};
}

int run_program(int argc, char** argv) {
  CLI::App app("A single cell migrating through a degradable viscoelastic matrix.\n"
               "Model: Heck et al. 2020, PLoS Comput Biol 16(1): e1007250.");
  app.name("matrigrate");
  app.require_subcommand(1);
  app.set_version_flag("--version", version_line());
  app.footer("Exit codes: 0 done; 1 internal error; 2 usage; 3 configuration; 4 numerical failure; 5 input or output;\n"
             "75 stopped by a signal; 130 by Ctrl-C.");
  Action chosen;
  add_new(app, chosen);
  add_check(app, chosen);
  add_explain(app, chosen);
  add_run(app, chosen, {argv, argv + argc});
  add_resume(app, chosen, {argv, argv + argc});
  add_report(app, chosen);
  add_open(app, chosen);
  add_export(app, chosen);
  add_diff(app, chosen);
  add_study(app, chosen);
  add_tracks(app, chosen);
  add_list(app, chosen);
  add_live(app, chosen);
  add_info(app, chosen);
  add_demo(app, chosen, {argv, argv + argc}); // from here on more rarely used
  add_sample(app, chosen, {argv, argv + argc});
  add_reproduce(app, chosen, {argv, argv + argc});
  add_validate(app, chosen);
  add_selftest(app, chosen);
  call_subcommands_verbs(app, {"demo", "sample", "reproduce", "validate", "selftest"});
  require_verb(app, argc, argv);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return print_help(app, error);
    throw UsageError(usage_fault(app, error));
  }
  advice_on_memory() = advice_on_memory_of(app.get_subcommands().front()->get_name());
  const int code = chosen();
  flush();
  return code;
}

int complain(std::string_view what, ExitCode code) {
  print_failure(what);
  return code;
}

/// Takes no memory, as there is none.
[[noreturn]] void end_without_memory() {
  say("matrigrate: not enough memory");
  say(advice_on_memory());
  say("\n");
  std::_Exit(numerical);
}

/// Memory may also end where nothing can be caught: in a destructor or a thread.
[[noreturn]] void end_by_terminate() {
  try {
    if (const std::exception_ptr error = std::current_exception()) std::rethrow_exception(error);
  } catch (const std::bad_alloc&) {
    end_without_memory();
  } catch (...) { // an error of the program
  }
  std::abort();
}

} // namespace

} // namespace matrigrate::apps

int main(int argc, char** argv) {
  using namespace matrigrate;
  using namespace matrigrate::apps;
  secure_descriptors();
  platform::begin(argc > 0 ? *argv : nullptr);
  std::signal(SIGXFSZ, SIG_IGN); // a file that passes a size limit is an error like others, not the end
  std::set_terminate(end_by_terminate);
  give_sudden_ends_an_exit_code();
  try {
    return run_program(argc, argv);
  } catch (const UsageError& error) {
    return complain(error.what(), usage);
  } catch (const ConfigurationError& error) {
    print_faults(error.faults());
    return configuration;
  } catch (const NumericalFailure& error) {
    return complain(error.what(), numerical);
  } catch (const InputOutputError& error) {
    return complain(error.what(), input_output);
  } catch (const std::system_error& error) { // of a file system or a thread
    return complain(error.what(), input_output);
  } catch (const std::bad_alloc&) {
    end_without_memory();
  } catch (const std::exception& error) {
    return complain(fmt::format("internal error, please report it: {}", error.what()), internal);
  }
}
