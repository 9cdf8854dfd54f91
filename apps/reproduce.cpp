#include "apps/shipped_pages.hpp"
#include "apps/study/verbs.hpp"
#include "apps/terminal/terminal.hpp"
#include "apps/verbs.hpp"
#include "base/failure.hpp"
#include "claims/claims.hpp"
#include "parameters/nearest.hpp"
#include "run/folder_lock.hpp"
#include "run/folder_state.hpp"
#include "run/run_record.hpp"
#include "simulation/step_limits.hpp"
#include "study_report/study_files.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <csignal>
#include <memory>
#include <optional>
#include <utility>

namespace matrigrate::apps {

namespace {

/// What `matrigrate reproduce` was asked for.
struct ReproduceOptions : study::EvidenceOptions {
  int jobs = 0;
  bool json = false;
  bool quiet = false;
  std::string command; ///< as it was typed
};

/// A signal ended the work.
struct Stopped {
  int signal;
};

/// Studies with their tables, whose pages come last: their claims may need several studies.
using Tables = std::vector<std::pair<StudyFolder, Collected>>;

/// Computes runs of a study.
/// @throws Stopped after a signal
/// @throws InputOutputError if a run cannot write its files
void compute_missing(const StudyFolder& study, const std::vector<std::size_t>& runs, const ReproduceOptions& options) {
  make_study_folder(study);
  const FolderLock lock(study.folder, FolderLock::Kind::alone);
  write_study(study);
  const bool quiet = options.quiet || options.json;
  if (!quiet)
    print_error(fmt::format("{}: {} points x {} replicates\n", study.study.title, study.study.points.size(),
                            study.study.replicates));
  const PoolOutcome outcome = apps::compute(study, runs, {.jobs = job_count(options.jobs)}, quiet);
  if (outcome.signal != 0) throw Stopped{outcome.signal};
  const std::string troubles = troubles_text(study, outcome.troubles);
  if (!troubles.empty()) print_error(troubles);
  if (outcome.cannot_write)
    throw InputOutputError(fmt::format("{}: a run could not write its files", study.folder.string()));
}

/// As study::Compute asks for.   @throws as compute_missing
std::vector<study::Result> computed(const StudyFolder& study, const std::vector<std::size_t>& runs,
                                    const std::vector<study::Result>& kept, const ReproduceOptions& options,
                                    Tables& all) {
  std::optional<Stopped> stopped;
  try {
    compute_missing(study, runs, options);
  } catch (const Stopped& by) { // the tables tell how far it came
    stopped = by;
  }
  Collected tables = collect_tables(study, kept);
  auto results = study::with_kept(tables.results, kept);
  all.emplace_back(study, std::move(tables));
  if (stopped) throw *stopped;
  return results;
}

Colour colour_of(study::Verdict verdict) {
  return verdict == study::Verdict::holds           ? Colour::good
         : verdict == study::Verdict::does_not_hold ? Colour::bad
                                                    : Colour::warning;
}

/// The table for people. Where runs are not the paper's, that stands beside the verdict.
std::string reproduction_text(const std::vector<study::JudgedClaim>& rows) {
  std::string text;
  for (const study::JudgedClaim& row : rows) {
    text += fmt::format("{:<4}{}{}\n    {}\n", row.id,
                        coloured(to_string(row.finding.verdict), colour_of(row.finding.verdict), Stream::out),
                        row.caveat.empty() ? "" : fmt::format(" ({})", row.caveat), row.sentence);
    if (!row.published.empty()) text += fmt::format("    published: {}\n", row.published);
    for (const std::string& line : row.finding.ours) text += fmt::format("    ours: {}\n", line);
    for (const std::string& line : row.finding.conditions) text += fmt::format("      {}\n", line);
    if (row.second_edition)
      text += fmt::format("    by the second edition of the rules: {}\n", to_string(row.second_edition->verdict));
    if (row.in_larger_disc)
      text +=
          fmt::format("    {}\n      {}\n", study::with_larger_disc(*row.in_larger_disc), row.in_larger_disc->brief);
  }
  return text;
}

/// How the runs of each study ended, the verdicts in a table, a line per row, and the bottom line.
std::string reproduction_table(const std::vector<study::JudgedClaim>& rows, const study::Evidence& evidence) {
  std::string text;
  for (const auto& [name, ensemble] : evidence) text += fmt::format("{}: {}\n", name, study::ends_text(ensemble));
  return text + "\n" + claims_text(rows);
}

/// Of the paper's claims and, where they are asked for by name, of the experiments beside it.
std::vector<study::Claim> chosen_claims(const ReproduceOptions& options) {
  std::vector<study::Claim> chosen = study::shipped_claims();
  std::erase_if(chosen, [&](const study::Claim& claim) {
    return options.id == "all" ? claim.kind == study::ClaimKind::experiment : !claim.id.starts_with(options.id);
  });
  return chosen;
}

/// @throws UsageError if there is no such row
void check_id(const std::string& id) {
  if (id == "V" || id == "V1" || id == "V2" || id == "V3")
    throw UsageError(
        fmt::format("{} is verified by itself: matrigrate validate fibres fibres-uniaxial disassembly", id));
  if (id == "F" || id == "F1")
    throw UsageError(fmt::format("{} is no row any more: the page of a run plays both fields, matrigrate run", id));
  std::vector<std::string> ids{"A", "B", "C", "D", "E", "X", "all"};
  for (const study::Claim& claim : study::shipped_claims()) ids.push_back(claim.id);
  if (std::ranges::find(ids, id) != ids.end()) return;
  throw UsageError(fmt::format("there is no row \"{}\"{}\nThe rows are: {}", id, did_you_mean(nearest(id, ids)),
                               fmt::join(ids, ", ")));
}

/// True if the studies are run as the paper ran them.
bool as_published(const ReproduceOptions& options) { return !options.replicates && options.overrides.empty(); }

std::string setting_text(const ReproduceOptions& options) {
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

int reproduce(const ReproduceOptions& options) {
  check_id(options.id);
  const std::vector<study::Claim> claims = chosen_claims(options);
  for (const std::string& name : study::studies_of(claims)) // faults of overrides before anything is written
    study::shipped(name, options);
  for (const std::string& folder : {options.from, options.kept})
    if (!folder.empty()) require(run::look_at(folder), run::Use::see_files);
  study::require_own_study_folders(claims, options);
  study::require_own_claim_report(options);
  make_folder(options.folder);
  const std::string setting = setting_text(options);
  if (!options.quiet && !options.json) print_error(setting + "\n");
  study::ClaimEvidence all;
  Tables tables;
  try {
    all = study::gather_evidence(claims, options,
                                 [&](const auto&... given) { return computed(given..., options, tables); });
    for (auto& [study, found] : tables)
      if (!study.folder.string().ends_with("-larger-disc"))
        study::write_study_report(study, found, {.page_template = study_page_template()});
  } catch (const Stopped& stopped) {
    print("stopped; the same command continues\n");
    return stopped.signal == SIGINT ? interrupted : requeue;
  }
  const std::vector<study::JudgedClaim> rows = study::judged_claims(claims, all);
  study::write_claim_report(
      rows, all.evidence, options,
      {.page_template = verdicts_page_template(), .setting = setting, .command = options.command});
  if (options.json)
    print_json({{"setting", setting}, {"as_published", as_published(options)}, {"rows", study::claims_json(rows)}});
  else
    print(reproduction_text(rows) + reproduction_table(rows, all.evidence) + setting + "\n"
          + fmt::format("open {}/report-{}.html\n", options.folder, options.id));
  const auto holds = [](const study::JudgedClaim& row) { return row.finding.verdict == study::Verdict::holds; };
  return std::ranges::all_of(rows, holds) ? done : numerical;
}

} // namespace

void add_reproduce(CLI::App& app, Action& chosen, const std::vector<std::string>& command_line) {
  CLI::App* verb = app.add_subcommand("reproduce", "Run the paper's ensembles and judge its claims by them");
  verb->footer(
      "Computes what is missing of the studies that the rows need (each in its own folder below DIR, so that\n"
      "rows share runs), then prints for each claim the published value, ours, the statistic and whether it\n"
      "holds, and writes claims.csv, claims-<ID>.csv with every condition, and report-<ID>.html with all\n"
      "figures. Runs use the adaptive integrator with steps of up to 5 s unless --integrator reference is\n"
      "given: 0.4 s throughout, as in the paper, and 7 to 9 times slower. Runs that end at the rim of the\n"
      "matrix, of points that decide on a claim, are made again in a disc of 1.5 times the radius, and give a\n"
      "verdict of their own beside it. Exit code 4 if a claim does not hold or is undecided. X rows are\n"
      "experiments beside the paper (docs/validation.md). --from judges by kept tables and runs nothing:\n"
      "matrigrate reproduce all --from docs/validation. --kept goes on from kept tables: only runs that have not\n"
      "ended there are made.");
  const auto options = std::make_shared<ReproduceOptions>();
  options->command = command_text(command_line);
  verb->add_option("ID", options->id, "A, B, C, D, E, X, all, or one row such as A2; all leaves X out")->required();
  verb->add_option("-o,--output", options->folder, "Folder for studies and verdicts (default: reproduce)");
  verb->add_option("--replicates", options->replicates, "Runs at each point (default: as many as the paper)")
      ->check(CLI::Range(1, 100000));
  verb->add_option("--jobs", options->jobs, "Runs at a time, one thread each (default: the number of cores)")
      ->check(CLI::Range(1, 4096));
  verb->add_option("--integrator", options->integrator, "adaptive (default) or reference")
      ->check(CLI::IsMember({"adaptive", "reference"}));
  verb->add_option("--set", options->overrides, "key=value, over all studies; may be repeated")
      ->allow_extra_args(false);
  CLI::Option* from = verb->add_option("--from", options->from,
                                       "Folder with kept tables (<study>-results.csv) to judge by; nothing is run");
  verb->add_option("--kept", options->kept,
                   "Folder with kept tables (<study>-results.csv): their runs are not made again");
  for (const char* of_runs : {"--replicates", "--jobs", "--integrator", "--set", "--kept"})
    from->excludes(verb->get_option(of_runs));
  verb->add_flag("--json", options->json, "Print the table as JSON");
  verb->add_flag("--quiet", options->quiet, "Show no progress");
  verb->callback([options, &chosen] { chosen = [options] { return reproduce(*options); }; });
}

} // namespace matrigrate::apps
