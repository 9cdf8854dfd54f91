#include "base/file.hpp"
#include "run/output/output.hpp"
#include "tables/run_files.hpp"

namespace matrigrate::run {

/// The read-outs of each cell, made at the end: msd.csv, summary.csv and summary.json.
Output results(RunSoFar& run, const State&) {
  Output output;
  output.finish = [&folder = run.folder](const RunFinish& end) {
    write_file(folder / "msd.csv", store::msd_csv(end.cells, 600.0));
    write_file(folder / "summary.csv", store::summary_csv(end.cells));
    write_file(folder / "summary.json", store::summary_json(end.cells));
  };
  return output;
}

} // namespace matrigrate::run
