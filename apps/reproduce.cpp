#include "apps/export_pictures.hpp"
#include "apps/reproduce_output.hpp"
#include "apps/stop_signal.hpp"
#include "apps/study_files.hpp"
#include "apps/study_verbs.hpp"
#include "apps/terminal.hpp"
#include "apps/verbs.hpp"
#include "base/failure.hpp"
#include "base/file.hpp"
#include "claims/shipped_studies.hpp"
#include "parameters/nearest.hpp"
#include "run/finished_run.hpp"
#include "run/folder_lock.hpp"
#include "run/run_record.hpp"
#include "simulation/start_rules.hpp"
#include "simulation/step_limits.hpp"
#include "study_runs/child.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <map>
#include <memory>
#include <numeric>
#include <optional>
#include <thread>

namespace matrigrate::apps {

namespace {

struct Options {
  std::string id;
  std::string folder = "reproduce";
  std::optional<std::size_t> replicates;
  std::string integrator = "adaptive";
  std::vector<std::string> overrides;
  int jobs = 0;
  bool json = false;
  bool quiet = false;
  std::string command; ///< as it was typed
};

/// A signal ended the work.
struct Stopped {
  int signal;
};

/// The verification cases behind rows V1 to V3, whose claims judge them.
struct VerificationRow {
  std::string_view id, verification, sentence, published;
};
constexpr VerificationRow verification_rows[] = {
    {"V1", "fibres", "stress-strain curves of isotropic fibres agree with the law of Steinwachs et al. 2016",
     "curves agree very well (Fig 2C)"},
    {"V2", "fibres-uniaxial", "uniaxial fibres: somewhat stiffer along, very soft across", "curves of Fig 2D"},
    {"V3", "disassembly", "lifetime of an adhesion against its force, Eq. 7", "tends to 60 min at high force (Fig 4)"}};

bool chosen_by(std::string_view row, const std::string& id) { return id == "all" || row.starts_with(id); }

std::vector<const study::Claim*> chosen_claims(const std::string& id) {
  std::vector<const study::Claim*> chosen;
  for (const study::Claim& claim : study::claims())
    if (chosen_by(claim.id, id)) chosen.push_back(&claim);
  return chosen;
}

/// @throws UsageError if there is no such row
void check_id(const std::string& id) {
  std::vector<std::string> ids{"A", "B", "C", "D", "E", "V", "all"};
  for (const study::Claim& claim : study::claims()) ids.emplace_back(claim.id);
  for (const VerificationRow& row : verification_rows) ids.emplace_back(row.id);
  if (std::ranges::find(ids, id) != ids.end()) return;
  throw UsageError(fmt::format("there is no row \"{}\"{}\nThe rows are: {}", id, did_you_mean(nearest(id, ids)),
                               fmt::join(ids, ", ")));
}

study::Study shipped(std::string_view name, const Options& options) {
  study::Changes changes{options.overrides, options.replicates, start_rules()};
  changes.overrides.insert(changes.overrides.begin(), "run.integrator=" + options.integrator);
  const auto all = shipped_studies();
  const auto found = std::ranges::find(all, name, &ShippedStudy::name);
  return study::parse_study(found->text, fmt::format("studies/{}.toml", name), ".", changes);
}

/// The runs of one study, computed as far as they are missing.
PoolOutcome computed(const StudyFolder& study, const Options& options) {
  make_study_folder(study.folder);
  const FolderLock lock(study.folder, FolderLock::Kind::alone);
  write_study(study);
  std::vector<std::size_t> all(study.runs.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  const bool quiet = options.quiet || options.json;
  if (!quiet)
    print_error(fmt::format("{}: {} points x {} replicates\n", study.study.title, study.study.points.size(),
                            study.study.replicates));
  PoolOutcome outcome = compute(study, all, {.jobs = job_count(options.jobs), .quiet = quiet});
  const std::string troubles = troubles_text(study, outcome.troubles);
  if (!troubles.empty()) print_error(troubles);
  return outcome;
}

/// The verdict of a case's claims from its results.json; undecided if the case stopped or its own checks fail.
study::Finding finding_of(const std::filesystem::path& folder) {
  using Json = nlohmann::json;
  study::Finding finding;
  const Json results = Json::parse(read_file(folder / "results.json", std::size_t{1} << 24));
  const Json& verification = results.at("cases").at(0);
  bool claims_hold = !verification.at("claims").empty();
  for (const Json& claim : verification.at("claims")) {
    const bool holds = claim.at("holds").get<bool>();
    const std::string sense = claim.at("sense").get<std::string>();
    const std::string bound = sense == "near" ? fmt::format("within {:.3g} of ", claim.at("tolerance").get<double>())
                                              : fmt::format("{} ", sense == "at_least" ? "at least" : "at most");
    finding.ours.push_back(
        fmt::format("{}: {:.3g}", claim.at("quantity").get<std::string>(),
                    claim.at("measured").is_number() ? claim.at("measured").get<double>() : std::nan("")));
    finding.conditions.push_back(fmt::format("{}{:.3g} ({}): {}", bound, claim.at("expected").get<double>(),
                                             claim.at("reason").get<std::string>(), holds ? "met" : "not met"));
    claims_hold = claims_hold && holds;
  }
  for (const Json& note : verification.at("claim_notes")) finding.ours.push_back(note.get<std::string>());
  const bool verified = verification.at("holds").get<bool>();
  if (!verified)
    finding.conditions.push_back(
        fmt::format("the verification itself does not hold: see {}", (folder / "report.html").string()));
  finding.verdict = !verified     ? study::Verdict::undecided
                    : claims_hold ? study::Verdict::holds
                                  : study::Verdict::does_not_hold;
  return finding;
}

/// A verification case, as a process of its own; its files go beside the studies.
ReproducedRow verified(const VerificationRow& row, const Options& options) {
  const std::filesystem::path folder =
      std::filesystem::path(options.folder) / fmt::format("validate-{}", row.verification);
  const std::filesystem::path log =
      std::filesystem::path(options.folder) / fmt::format("validate-{}.log", row.verification);
  const int output = ::open(log.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  Child child({this_program(), "validate", std::string(row.verification), "-o", folder.string(), "--force"}, output);
  ::close(output);
  const StopSignal stop; // a second one ends this program, and with it the case
  std::optional<int> code;
  while (!(code = child.ended())) {
    if (StopSignal::received() != 0) throw Stopped{StopSignal::received()};
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
  study::Finding finding;
  if (*code == done || *code == numerical)
    finding = finding_of(folder);
  else
    finding.conditions.push_back(fmt::format("the case could not be run: see {}", log.string()));
  return {std::string(row.id), std::string(row.sentence), std::string(row.published), finding};
}

/// Runs the studies that the claims need. @return what they have come to
study::Evidence evidence_for(const std::vector<const study::Claim*>& claims, const Options& options) {
  std::vector<std::string_view> names;
  for (const study::Claim* claim : claims)
    for (const std::string_view name : claim->studies)
      if (std::ranges::find(names, name) == names.end()) names.push_back(name);
  study::Evidence evidence;
  std::vector<std::pair<StudyFolder, Collected>> collected;
  for (const std::string_view name : names) {
    StudyFolder study = planned(shipped(name, options), std::filesystem::path(options.folder) / name);
    const PoolOutcome outcome = computed(study, options);
    if (outcome.signal != 0) throw Stopped{outcome.signal};
    if (outcome.cannot_write)
      throw InputOutputError(fmt::format("{}: a run could not write its files", study.folder.string()));
    Collected tables = collect_tables(study);
    evidence.emplace(name, study::Ensemble{study.study, tables.results});
    collected.emplace_back(std::move(study), std::move(tables));
  }
  for (const auto& [study, tables] : collected) write_study_report(study, tables); // claims may need several studies
  return evidence;
}

/// One run with two protrusions among fibres, as in Fig 13; none without frames.
std::map<std::string, io::Figure> figures_of(const study::Evidence& evidence, const Options& options) {
  constexpr std::string_view name = "kept-protrusions-fibres";
  constexpr std::size_t two_protrusions = 1;
  const auto found = evidence.find(name);
  if (found == evidence.end()) return {};
  const auto& results = found->second.results;
  const auto one =
      std::ranges::find_if(results, [](const auto& r) { return r.run.point == two_protrusions && r.standing.done(); });
  if (one == results.end()) return {};
  const FinishedRun run = read_run(study::run_folder(std::filesystem::path(options.folder) / name, one->run));
  if (run.film.frames.empty()) return {};
  return {{"E5",
           {"fibre-stress", "Von Mises stress of the fibres on the solid matrix, at the end of one run (Fig 13)",
            last_picture(run, Layer::fibre_von_mises)}}};
}

/// Whether the studies are run as the paper ran them.
bool as_published(const Options& options) { return !options.replicates && options.overrides.empty(); }

std::string setting_text(const Options& options) {
  std::string text = options.integrator == "adaptive"
                         ? fmt::format("Integrator: adaptive, steps of up to {} s (the paper's reference is 0.4 s "
                                       "throughout: --integrator reference).",
                                       usual_time_step(Integrator::adaptive))
                         : "Integrator: reference, 0.4 s throughout, as in the paper.";
  if (options.replicates) text += fmt::format(" Replicates: {}.", *options.replicates);
  if (!options.overrides.empty()) text += fmt::format(" Changed: {}.", fmt::join(options.overrides, ", "));
  if (!as_published(options)) text += " Not run as the paper ran it, so these are no verdicts on the paper.";
  return text;
}

int reproduce(const Options& options) {
  check_id(options.id);
  const std::vector<const study::Claim*> claims = chosen_claims(options.id);
  for (const study::Claim* claim : claims) // faults of overrides before anything is written
    for (const std::string_view name : claim->studies) shipped(name, options);
  make_output_folder(options.folder, true);
  const std::string setting = setting_text(options);
  if (!options.quiet && !options.json) print_error(setting + "\n");
  std::vector<ReproducedRow> rows;
  study::Evidence evidence;
  try {
    for (const VerificationRow& row : verification_rows)
      if (chosen_by(row.id, options.id)) rows.push_back(verified(row, options));
    evidence = evidence_for(claims, options);
  } catch (const Stopped& stopped) {
    print("stopped; the same command goes on\n");
    return stopped.signal == SIGINT ? interrupted : requeue;
  }
  for (const study::Claim* claim : claims) rows.push_back(study::judged(*claim, evidence));
  write_reproduction(options.folder, options.id, rows, evidence, figures_of(evidence, options), setting,
                     options.command);
  if (options.json)
    print(reproduction_json(rows, evidence, setting, as_published(options)));
  else
    print(reproduction_text(rows, evidence) + setting + "\n"
          + fmt::format("open {}/report-{}.html\n", options.folder, options.id));
  const auto holds = [](const ReproducedRow& row) { return row.finding.verdict == study::Verdict::holds; };
  return std::ranges::all_of(rows, holds) ? done : numerical;
}

} // namespace

void add_reproduce(CLI::App& app, Action& chosen, const std::vector<std::string>& command_line) {
  CLI::App* verb = app.add_subcommand("reproduce", "Run the paper's ensembles and judge its claims by them");
  verb->footer(
      "Computes what is missing of the studies that the rows need (each in its own folder below DIR, so that rows\n"
      "share runs), then prints for each claim the published value, ours, the statistic and whether it holds, and\n"
      "writes claims-<ID>.csv, boxes-<ID>.svg and report-<ID>.html. Runs use the adaptive integrator with steps of up\n"
      "to 5 s unless --integrator reference is given: 0.4 s throughout, as in the paper, and 4 to 5 times slower.\n"
      "Exit code 4 if a claim does not hold or is undecided. V rows are judged on verification cases (matrigrate\n"
      "validate), by rules on the quantity that each claims.");
  const auto options = std::make_shared<Options>();
  options->command = command_text(command_line);
  verb->add_option("ID", options->id, "A, B, C, D, E, V, all, or one row such as A2")->required();
  verb->add_option("-o,--output", options->folder, "Folder for studies and verdicts (default: reproduce)");
  verb->add_option("--replicates", options->replicates, "Runs at each point (default: as many as the paper)")
      ->check(CLI::Range(1, 100000));
  verb->add_option("--jobs", options->jobs, "Runs at a time, one thread each (default: the number of cores)")
      ->check(CLI::Range(1, 4096));
  verb->add_option("--integrator", options->integrator, "adaptive (default) or reference")
      ->check(CLI::IsMember({"adaptive", "reference"}));
  verb->add_option("--set", options->overrides, "key=value, over all studies; may be repeated")
      ->allow_extra_args(false);
  verb->add_flag("--json", options->json, "Print the table as JSON");
  verb->add_flag("--quiet", options->quiet, "Show no progress");
  verb->callback([options, &chosen] { chosen = [options] { return reproduce(*options); }; });
}

} // namespace matrigrate::apps
