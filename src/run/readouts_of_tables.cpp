#include "run/readouts_of_tables.hpp"

#include "base/file.hpp"
#include "observe/readout_table.hpp"
#include "tables/csv.hpp"
#include "tables/run_files.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <variant>
#include <vector>

namespace matrigrate::run {

namespace {

constexpr std::size_t largest_table = std::size_t{1} << 28U;

/// What is made of the text of a table. @throws InputOutputError naming it
template <class Read>
auto from_table(const std::filesystem::path& file, const Read& read) {
  const std::string text = read_file(file, largest_table);
  return naming(file, [&] { return read(text); });
}

/// f_adh_rel of the protrusions of each cell.
std::vector<std::vector<double>> forces_of(const std::string& protrusions, std::size_t cells) {
  const std::vector<double> force = store::csv_columns(protrusions, {"id", "f_adh_rel"})[1];
  const std::vector<double> cell = store::csv_column(protrusions, "cell");
  std::vector<std::vector<double>> forces(cells);
  for (std::size_t k = 0; k < force.size(); ++k)
    for (std::size_t id = 0; id < cells; ++id)
      if (cell.empty() || cell[k] == static_cast<double>(id + 1)) forces[id].push_back(force[k]);
  return forces;
}

std::vector<CellResult> cells_in(const std::filesystem::path& folder) {
  const std::vector<TrackRow> rows = from_table(folder / "tracks.csv", store::track_rows_of);
  std::uint32_t count = 0;
  for (const TrackRow& row : rows) count = std::max(count, matrigrate::number_of(row.cell));
  const auto forces =
      from_table(folder / "protrusions.csv", [&](const std::string& text) { return forces_of(text, count); });
  std::vector<CellResult> cells;
  for (std::uint32_t id = 0; id < count; ++id) {
    CellResult& cell = cells.emplace_back(CellResult{.cell = id, .rows = rows_of(rows, id)});
    cell.readouts = readouts(cell.rows, {}, Parameters());
    cell.readouts.share_low_force = share_of_low_forces(forces[id]);
  }
  if (count > 1) add_group(cells, from_table(folder / "group.csv", store::group_rows_of));
  return cells;
}

} // namespace

void add_from_tables(const std::filesystem::path& folder, std::span<double> values) {
  const std::vector<CellResult> cells = cells_in(folder);
  for (std::size_t k = 0; k < values.size(); ++k) {
    const ReadOutSpec& spec = readout_table()[k];
    if (!spec.of_claims) continue;
    double sum = 0.0;
    double defined = 0.0;
    for (const CellResult& cell : cells) {
      const double value = std::get<double>(spec.value(cell.readouts));
      if (std::isnan(value)) continue;
      sum += value;
      defined += 1.0;
    }
    values[k] = defined > 0.0 ? sum / defined : undefined;
  }
}

} // namespace matrigrate::run
