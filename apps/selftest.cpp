#include "apps/terminal/terminal.hpp"
#include "apps/verbs.hpp"
#include "base/failure.hpp"
#include "base/parallel.hpp"
#include "base/process.hpp"
#include "parameters/write.hpp"
#include "run/provenance.hpp"
#include "simulation/simulation.hpp"
#include "store/checkpoint.hpp"
#include "store/trajectory_hash.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <memory>
#include <thread>

namespace matrigrate::apps {

namespace {

using Json = nlohmann::ordered_json;
using namespace std::chrono_literals;

// Of a release build with g++ 12 on x86-64 with FMA.
constexpr std::string_view known_hash = "8433094e3cca0b3a";
constexpr std::size_t largest_answer = 1U << 20U;

/// A short migration with every part of the model at work: fibres, growing and maturing protrusions, degradation.
Parameters short_migration(Integrator integrator) {
  Parameters p;
  p.run.integrator = integrator;
  p.run.time_step = integrator == Integrator::adaptive ? 1.2 : 0.4;
  p.run.duration = 96.0;
  p.ecm.radius = 60.0;
  p.fibres.arrangement = FibreArrangement::isotropic;
  p.protrusion.initiation_rate = 1e-3;
  p.protrusion.growth_time = 24.0;
  p.adhesion.maturation_time = 36.0;
  return p;
}

/// Goes on until t_end, and adds each step to the hash.
void go(Simulation& simulation, double t_end, store::TrajectoryHash& hash) {
  simulation.march(t_end, {}, [&](const State& now) {
    hash.add(now);
    return true;
  });
}

std::string hash_with_threads(const Parameters& p, int threads) {
  const ThreadLimit limit(threads);
  Simulation simulation(p);
  store::TrajectoryHash hash;
  go(simulation, p.run.duration, hash);
  return hash.text();
}

/// The run with a break at two thirds: the state goes through a checkpoint.
std::string hash_with_break(const Parameters& p) {
  Simulation first(p);
  store::TrajectoryHash hash;
  go(first, std::round(2.0 / 3.0 * p.run.duration / p.run.time_step) * p.run.time_step, hash);
  const std::string image = store::checkpoint_image(
      {.state = first.s, .scenario = to_toml(p), .configuration_hash = {}, .program = version_line(), .memory = {}});
  Simulation second(p, store::parse_checkpoint(image, "checkpoint").state);
  store::TrajectoryHash later(hash.value());
  go(second, p.run.duration, later);
  return later.text();
}

/// The result of the self-test of another build; what that says on stderr is left out. @throws InputOutputError if none
Json found_by(const std::string& program) {
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> output(std::tmpfile(), &std::fclose);
  if (!output) throw InputOutputError("no temporary file can be made");
  Child child({program, "selftest", "--json"}, ::fileno(output.get()));
  while (!child.ended()) std::this_thread::sleep_for(20ms);
  if (child.ended() == no_such_program) throw InputOutputError(program + ": there is no such program");
  std::string text(largest_answer, '\0');
  std::rewind(output.get());
  text.resize(std::fread(text.data(), 1, text.size(), output.get()));
  Json json = Json::parse(text.erase(text.rfind('}') + 1).erase(0, text.find('{')), nullptr, false);
  if (child.ended() != done || !json.is_object() || !json.contains("hash"))
    throw InputOutputError(program + ": its self-test failed");
  return json;
}

struct Check {
  std::string what;
  bool holds;
};

struct SelftestArguments {
  std::string other;
  bool json = false;
};

int selftest(const SelftestArguments& options) {
  std::vector<Check> checks;
  std::vector<std::string> hashes;
  const int most = std::max(4, hardware_threads());
  for (const Integrator integrator : {Integrator::reference, Integrator::adaptive}) {
    const Parameters p = short_migration(integrator);
    const std::string name = integrator == Integrator::reference ? "reference integrator" : "adaptive integrator";
    const std::string whole = hash_with_threads(p, 1);
    hashes.push_back(whole);
    checks.push_back({fmt::format("{}: 1 and 2 threads, the same bits", name), hash_with_threads(p, 2) == whole});
    checks.push_back(
        {fmt::format("{}: 1 and {} threads, the same bits", name, most), hash_with_threads(p, most) == whole});
    checks.push_back({fmt::format("{}: stopped and resumed, the same bits", name), hash_with_break(p) == whole});
  }
  const std::string hash = store::text_hash(hashes[0] + hashes[1]);
  if (!options.other.empty())
    checks.push_back({fmt::format("{}: the same bits", options.other), found_by(options.other).at("hash") == hash});
  const bool all = std::ranges::all_of(checks, &Check::holds);
  if (options.json) {
    Json list = Json::array();
    for (const Check& check : checks) list.push_back({{"what", check.what}, {"holds", check.holds}});
    print_json({{"hash", hash}, {"known_hash", known_hash}, {"checks", list}, {"holds", all}});
    return all ? done : numerical;
  }
  for (const Check& check : checks)
    print(fmt::format("{:<6}{}\n",
                      coloured(check.holds ? "ok" : "FAILS", check.holds ? Colour::good : Colour::bad, Stream::out),
                      check.what));
  print(fmt::format(
      "\nhash {}: {}\n", hash,
      hash == known_hash
          ? "the hash of the release build with g++ 12 on x86-64 with FMA, so runs agree with it to the last bit"
          : "not the hash of the release build with g++ 12 on x86-64 with FMA. With another compiler, processor\n"
            "family or library of mathematical functions this is no fault: the same bits are promised\n"
            "for one program on one machine, and results of others agree in their statistics only."));
  return all ? done : numerical;
}

} // namespace

void add_selftest(CLI::App& app, Action& chosen) {
  CLI::App* verb = app.add_subcommand("selftest", "Prove on this machine that runs are reproducible to the last bit");
  verb->footer("Simulates a short migration among fibres several times, with both integrators: with 1, 2 and all "
               "threads, and\nwith a break. Exit code 0 if all bits are the same, 4 if not.");
  const auto options = std::make_shared<SelftestArguments>();
  verb->add_option("--with", options->other,
                   "Compare with another build of the program, which must give the same bits");
  verb->add_flag("--json", options->json, "Print one JSON object");
  verb->callback([options, &chosen] { chosen = [options] { return selftest(*options); }; });
}

} // namespace matrigrate::apps
