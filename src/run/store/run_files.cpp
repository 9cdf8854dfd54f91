#include "store/run_files.hpp"

#include "base/failure.hpp"
#include "observe/readout_table.hpp"
#include "store/csv.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace matrigrate::store {

std::vector<std::string_view> track_columns(bool nucleus) {
  std::vector<std::string_view> columns{
      "track",          "t_s",       "x_um",       "y_um",          "area_um2",    "perimeter_um", "polarization_rad",
      "n_simultaneous", "n_growing", "n_maturing", "n_contracting", "n_finishing", "n_initiated",  "step"};
  if (nucleus)
    columns.insert(columns.end(), {"nucleus_x_um", "nucleus_y_um", "nucleus_area_um2", "nucleus_aspect_ratio"});
  return columns;
}

std::vector<Field> fields(const TrackRow& row) {
  std::vector<Field> all{count(number_of(row.cell)),
                         row.t,
                         row.centre.x(),
                         row.centre.y(),
                         row.area,
                         row.perimeter,
                         row.polarization.value_or(undefined),
                         count(row.alive()),
                         count(row.in_phase[0]),
                         count(row.in_phase[1]),
                         count(row.in_phase[2]),
                         count(row.in_phase[3]),
                         count(row.initiated),
                         row.step};
  if (row.nucleus)
    all.insert(all.end(), {row.nucleus->centre.x(), row.nucleus->centre.y(), row.nucleus->area, row.nucleus->aspect});
  return all;
}

namespace {

/// A field that counts. @throws InputOutputError if it is no number of things
template <class T>
T counted(double field) {
  if (!(field >= 0.0 && field < static_cast<double>(std::numeric_limits<T>::max())))
    throw InputOutputError("a row has no number where things are counted");
  return static_cast<T>(field);
}

} // namespace

std::vector<TrackRow> track_rows_of(std::string_view text) {
  const Table table = read_table(text);
  const bool nucleus = table.columns.size() > track_columns().size();
  if (!std::ranges::equal(table.columns, track_columns(nucleus)))
    throw InputOutputError("has columns of another table");
  std::vector<TrackRow> rows;
  rows.reserve(table.rows.size());
  for (const std::vector<double>& field : table.rows) {
    TrackRow& row = rows.emplace_back();
    row = {.t = field[1],
           .step = counted<std::uint64_t>(field[13]),
           .cell = counted<std::uint32_t>(field[0] - 1.0),
           .centre = {field[2], field[3]},
           .area = field[4],
           .perimeter = field[5],
           .polarization = std::isnan(field[6]) ? std::nullopt : std::optional(field[6]),
           .initiated = counted<std::uint32_t>(field[12])};
    for (std::size_t k = 0; k < row.in_phase.size(); ++k) row.in_phase[k] = counted<std::uint32_t>(field[8 + k]);
    if (nucleus) row.nucleus = {.centre = {field[14], field[15]}, .area = field[16], .aspect = field[17]};
  }
  return rows;
}

std::vector<std::string_view> health_columns() {
  return {"t_s",
          "step",
          "solver_iterations",
          "solver_iterations_max",
          "solver_residual",
          "solver_residual_max",
          "area_ratio",
          "density_min",
          "density_max",
          "n_density_bounds",
          "n_orphans",
          "n_torn",
          "n_engulfed",
          "n_solid_inside",
          "deepest_solid_um",
          "crosses_itself",
          "fastest_um_per_s",
          "force_imbalance"};
}

std::vector<Field> fields(const HealthRow& row) {
  return {row.t,
          row.step,
          count(static_cast<std::size_t>(row.iterations)),
          count(static_cast<std::size_t>(row.max_iterations)),
          row.residual,
          row.largest_residual,
          row.area_ratio,
          row.density_min,
          row.density_max,
          count(row.density_bounds),
          count(row.orphans),
          count(row.torn),
          count(row.engulfed),
          count(row.solid_inside),
          row.deepest_solid,
          count(row.crosses_itself ? 1 : 0),
          row.fastest,
          row.force_imbalance};
}

std::vector<std::string_view> group_columns() {
  return {"t_s",        "x_um",   "y_um",       "spread_um", "speed_um_per_h", "order", "direction_deg",
          "nearest_um", "gap_um", "n_contacts", "step"};
}

std::vector<Field> fields(const GroupRow& row) {
  return {row.t,
          row.centre.x(),
          row.centre.y(),
          row.spread,
          row.speed,
          row.order,
          row.direction * 180.0 / std::numbers::pi,
          row.nearest,
          row.gap,
          count(row.contacts),
          row.step};
}

std::vector<std::string_view> protrusion_columns() {
  return {"id",      "centre_particle", "t_initiation_s", "t_adhesion_s", "t_mature_s", "t_disassembly_s",
          "t_end_s", "length_um",       "direction_deg",  "f_mat",        "force_nN",   "f_adh_rel",
          "cause"};
}

std::vector<Field> fields(const ProtrusionRecord& r, const Parameters& p) {
  return {count(r.id),  count(r.centre), r.t_initiation,
          r.t_adhesion, r.t_mature,      r.t_disassembly,
          r.t_end,      r.length,        r.direction * 180.0 / std::numbers::pi,
          r.f_mat,      r.force,         relative_force(r, p),
          name(r.cause)};
}

std::vector<Field> with_cell(std::uint32_t cell, std::vector<Field> fields) {
  fields.insert(fields.begin(), count(number_of(cell)));
  return fields;
}

std::vector<std::string_view> with_cell(std::vector<std::string_view> columns) {
  columns.insert(columns.begin(), "cell");
  return columns;
}

namespace {

/// Adds rows to a table with these columns.
class CellTable {
public:
  CellTable(std::span<const CellResult> cells, std::vector<std::string_view> columns) : m_several(cells.size() > 1) {
    if (m_several) columns = with_cell(std::move(columns));
    m_text = csv_line({columns.begin(), columns.end()});
  }
  void add(std::uint32_t cell, std::vector<Field> fields) {
    m_text += csv_line(m_several ? with_cell(cell, std::move(fields)) : fields);
  }
  const std::string& text() const { return m_text; }

private:
  bool m_several;
  std::string m_text;
};

} // namespace

std::string protrusions_csv(std::span<const CellResult> cells, const Parameters& p) {
  CellTable table(cells, protrusion_columns());
  for (const CellResult& cell : cells)
    for (const ProtrusionRecord& r : cell.records) table.add(cell.cell, fields(r, p));
  return table.text();
}

std::string msd_csv(std::span<const CellResult> cells, double interval) {
  CellTable table(cells, {"lag_s", "msd_um2", "samples"});
  for (const CellResult& cell : cells)
    for (const MsdPoint& point : mean_square_displacement(cell.rows, interval))
      table.add(cell.cell, {point.lag, point.msd, count(point.samples)});
  return table.text();
}

std::vector<NamedValue> named_values(const ReadOuts& r) {
  std::vector<NamedValue> values;
  for (const ReadOutSpec& spec : readout_table())
    values.push_back({spec.name, spec.meaning_with_unit(),
                      std::visit([](const auto value) { return Field(value); }, spec.value(r))});
  return values;
}

std::vector<NamedValue> shown_values(const ReadOuts& r, const Parameters& p) {
  std::vector<NamedValue> values = named_values(r);
  if (p.fibres.arrangement == FibreArrangement::uniaxial) return values;
  std::erase_if(values, [](const NamedValue& v) { return find_readout(v.name)->of_fibres; });
  return values;
}

std::string result_sentence(const ReadOuts& r) {
  std::string text;
  if (std::isfinite(r.v_migr_abs)) text = fmt::format("{:.3g} um/h from start to end, ", r.v_migr_abs);
  if (std::isfinite(r.msd_slope))
    text += fmt::format("{} (MSD slope {:.3g}), ",
                        r.msd_slope > 1.2   ? "persistent"
                        : r.msd_slope < 0.8 ? "confined"
                                            : "like a random walk",
                        r.msd_slope);
  return text + fmt::format("{} protrusion{}.", r.n_protrusions, r.n_protrusions == 1 ? "" : "s");
}

std::string result_sentence(std::span<const CellResult> cells) {
  if (cells.size() == 1) return result_sentence(cells.front().readouts);
  std::string text;
  for (const CellResult& cell : cells)
    text += fmt::format("{}Cell {}: {}", text.empty() ? "" : " ", number_of(cell.cell), result_sentence(cell.readouts));
  return text;
}

std::string readable(const Field& value) {
  const double* number = std::get_if<double>(&value);
  if (number == nullptr) return csv_line({value}).substr(0, csv_line({value}).size() - 1);
  return std::isnan(*number) ? "-" : fmt::format("{:.4g}", *number);
}

std::string summary_csv(std::span<const CellResult> cells) {
  std::vector<std::string_view> columns;
  for (const ReadOutSpec& spec : readout_table()) columns.push_back(spec.name);
  CellTable table(cells, std::move(columns));
  for (const CellResult& cell : cells) {
    std::vector<Field> row;
    for (const NamedValue& v : named_values(cell.readouts)) row.push_back(v.value);
    table.add(cell.cell, std::move(row));
  }
  return table.text();
}

std::string summary_json(std::span<const CellResult> cells) {
  using Json = nlohmann::ordered_json;
  Json list = Json::array();
  for (const CellResult& cell : cells) {
    Json summary;
    if (cells.size() > 1) summary["cell"] = number_of(cell.cell);
    for (const NamedValue& v : named_values(cell.readouts)) // NaN is written as null
      std::visit([&](const auto& value) { summary[std::string(v.name)] = value; }, v.value);
    list.push_back(std::move(summary));
  }
  return (list.size() == 1 ? list.front() : Json{{"cells", list}}).dump(2) + "\n";
}

} // namespace matrigrate::store
