#include "base/file.hpp"
#include "run/output/output.hpp"
#include "tables/run_files.hpp"

namespace matrigrate::run {

/// protrusions.csv: those that have ended, which the state holds, and at the end of the run those still alive.
Output protrusions(RunSoFar& run, const State& start) {
  const bool several = start.cells.size() > 1;
  const auto columns = several ? store::with_cell(store::protrusion_columns()) : store::protrusion_columns();
  const std::filesystem::path file = run.folder / "protrusions.csv";
  const auto text = std::make_shared<std::string>();
  const auto table = std::make_shared<store::RowFile>(file, columns, *text);
  Output output{.interval = each_step};
  output.write = [=, &p = run.p, written = std::vector<std::size_t>(start.cells.size())](const State& s,
                                                                                         const Workspace&) mutable {
    for (std::size_t k = 0; k < s.cells.size(); ++k)
      for (const Cell& cell = s.cells[k]; written[k] < cell.ended.size(); ++written[k]) {
        const std::vector<store::Field> fields = store::fields(cell.ended[written[k]], p);
        table->add(several ? store::with_cell(cell.id, fields) : fields);
      }
  };
  output.finish = [=, &p = run.p, held = text](const RunFinish& end) {
    write_file(file, store::protrusions_csv(end.cells, p));
  };
  return output;
}

} // namespace matrigrate::run
