#include "base/file.hpp"
#include "base/platform.hpp"
#include "report/film_json.hpp"
#include "report/run_page.hpp"
#include "run/output/output.hpp"
#include "run/provenance.hpp"
#include "store/field_file.hpp"

#include <nlohmann/json.hpp>

namespace matrigrate::run {

/// report.html, made at the end.
Output report_page(RunSoFar& run, const State&) {
  Output output;
  output.finish = [&run](const RunFinish& end) {
    if (!run.p.output.report || end.page_template.empty()) return;
    platform::give_back_memory(); // before all frames that are played are in memory
    const bool frames = run.p.output.field_interval > 0.0;
    const nlohmann::ordered_json record = to_json(end.record, run.p);
    const std::string scenario = scenario_name(record, run.folder);
    const observe::Film film = frames ? store::read_film(run.folder, report::keep_what_is_played) : observe::Film{};
    write_file(run.folder / "report.html",
               report::filled_page(end.page_template, report::run_data({.title = run_title(run.p, scenario),
                                                                        .status = end.status,
                                                                        .facts = run_facts(run.p, record, scenario),
                                                                        .t_end = end.s.t,
                                                                        .p = run.p,
                                                                        .cells = end.cells,
                                                                        .health = run.memory.tables.at("health.csv"),
                                                                        .film = frames ? &film : nullptr,
                                                                        .provenance = provenance_text()})));
  };
  return output;
}

} // namespace matrigrate::run
