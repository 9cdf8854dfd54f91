#include "apps/run_output.hpp"

#include "apps/terminal/terminal.hpp"
#include "apps/verbs.hpp"
#include "base/file.hpp"
#include "base/text.hpp"
#include "tables/run_files.hpp"
#include "tables/state_json.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <filesystem>
#include <string>
#include <system_error>

namespace matrigrate::apps {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t max_summary = std::size_t{1} << 20U; // bytes of summary.json

Json summary_of(const run::RunOutcome& outcome) {
  const std::string text =
      outcome.computed ? store::summary_json(outcome.cells) : read_file(outcome.folder / "summary.json", max_summary);
  return store::parse_json(text);
}

void print_record(const run::RunOutcome& outcome, const std::string& report) {
  Json all{{"folder", outcome.folder.string()}, {"report", report}};
  all["summary"] = summary_of(outcome);
  all.update(outcome.record);
  print_json(all);
}

void print_text(const run::RunOutcome& outcome) {
  if (!outcome.computed)
    return print(fmt::format("{} is done already; nothing was computed.\n", outcome.folder.string()));
  print(outcome.sentence + "\n\n");
  for (const CellResult& cell : outcome.cells) {
    if (outcome.cells.size() > 1) print(fmt::format("Cell {}\n", number_of(cell.cell)));
    for (const store::NamedValue& v : store::shown_values(cell.readouts, outcome.p))
      print(fmt::format("{:>10}  {}\n", store::readable(v.value), v.meaning));
  }
  print("\n");
}

} // namespace

void RunDisplay::warn(std::string_view text) { print_warning(text); }

void RunDisplay::begin() {
  m_signal.emplace();
  if (m_limit) StopSignal::before_first_step(std::isfinite(*m_limit) ? m_limit : std::nullopt);
}

void RunDisplay::begin_steps(double t, double t_end) {
  m_begin = t;
  m_end = t_end;
  m_progress.emplace(m_quiet);
}

void RunDisplay::step(const State& s) {
  StopSignal::first_step();
  m_progress->show([&](double elapsed) {
    std::size_t now = 0, so_far = 0;
    for (const Cell& cell : s.cells) {
      now += cell.protrusions.size();
      so_far += cell.initiated;
    }
    ProgressText text{.share = s.t / m_end,
                      .where = fmt::format("{} of {}", time_text(s.t), time_text(m_end)),
                      .left = time_left(elapsed, s.t - m_begin, m_end - s.t),
                      .remark = fmt::format("{} protrusion{} now, {} so far", now, now == 1 ? "" : "s", so_far)};
    text.line = fmt::format("{} ({:.0f} %), {}, about {}", text.where, 100.0 * text.share, text.remark, text.left);
    return text;
  });
}

std::optional<run::StopRequest> RunDisplay::stop_request() {
  const int signal = StopSignal::received();
  if (signal == 0) return std::nullopt;
  return signal == SIGINT ? run::StopRequest::user : run::StopRequest::terminate;
}

int print_outcome(const run::RunOutcome& outcome, const OutcomeStyle& style) {
  const std::string report = (outcome.folder / "report.html").string();
  if (style.json) {
    print_record(outcome, report);
    return run::exit_code(outcome.end);
  }
  if (!style.quiet) print_text(outcome);
  if (style.quiet && outcome.end != run::RunEnd::completed) print_failure(outcome.sentence);
  std::error_code ignored;
  print(fmt::format("open {}\n", std::filesystem::exists(report, ignored) ? report : outcome.folder.string()));
  return run::exit_code(outcome.end);
}

void tell_lost_frames(const run::FinishedRun& run) {
  if (const std::string text = store::to_text(run::lost_frames(run)); !text.empty()) print_warning(text);
  if (!run.trouble.empty()) print_warning(run.trouble);
}

} // namespace matrigrate::apps
