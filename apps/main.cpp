#include "apps/terminal/stop_signal.hpp"
#include "apps/terminal/terminal.hpp"
#include "apps/terminal/usage.hpp"
#include "apps/verbs.hpp"
#include "base/failure.hpp"
#include "base/platform.hpp"
#include "run/provenance.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <fcntl.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <exception>
#include <new>
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
