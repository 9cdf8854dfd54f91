#include "apps/terminal.hpp"
#include "apps/verbs.hpp"
#include "base/failure.hpp"
#include "parameters/read.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include <memory>

namespace matrigrate::apps {

namespace {

using Json = nlohmann::ordered_json;

struct Options {
  std::vector<std::string> files;
  bool json = false;
};

/// All faults of a file; none if it is good.
/// @param unreadable  becomes true if it cannot be read
std::vector<Fault> faults_of(const std::string& file, bool& unreadable) {
  try {
    read_parameters(file);
    return {};
  } catch (const ConfigurationError& error) {
    return error.faults();
  } catch (const InputOutputError& error) {
    unreadable = true;
    return {{.file = {}, .line = 0, .column = 0, .key = {}, .message = error.what()}};
  }
}

Json to_json(const std::string& file, const std::vector<Fault>& faults) {
  Json list = Json::array();
  for (const Fault& fault : faults)
    list.push_back({{"line", fault.line}, {"column", fault.column}, {"key", fault.key}, {"message", fault.message}});
  return {{"file", file}, {"good", faults.empty()}, {"faults", list}};
}

int check_files(const Options& options) {
  bool all_good = true;
  bool unreadable = false;
  Json files = Json::array();
  for (const std::string& file : options.files) {
    const std::vector<Fault> faults = faults_of(file, unreadable);
    all_good = all_good && faults.empty();
    if (options.json) {
      files.push_back(to_json(file, faults));
      continue;
    }
    print_faults(faults);
    if (faults.empty()) print(fmt::format("{}: {}\n", file, coloured("good", Colour::good, Stream::out)));
  }
  if (options.json)
    print(Json{{"good", all_good}, {"files", files}}.dump(2, ' ', false, Json::error_handler_t::replace) + "\n");
  return unreadable ? input_output : all_good ? done : configuration;
}

} // namespace

void add_check(CLI::App& app, Action& chosen) {
  CLI::App* verb = app.add_subcommand("check", "Validate scenario files; print every fault at once");
  verb->footer(
      "A fault is printed as file:line:column: key: what is wrong and what is allowed.\n"
      "--json prints {good, files: [{file, good, faults: [{line, column, key, message}]}]}; line and column are 0 "
      "where there is none.\nExit code 3 if any file has a fault, 5 if one cannot be read.");
  const auto options = std::make_shared<Options>();
  verb->add_option("FILE", options->files, "Scenario files")->required();
  verb->add_flag("--json", options->json, "Print the findings as JSON");
  verb->callback([options, &chosen] { chosen = [options] { return check_files(*options); }; });
}

} // namespace matrigrate::apps
