#include "tables/run_files.hpp"

#include "base/failure.hpp"
#include "observe/readout_table.hpp"
#include "tables/table.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <ranges>
#include <type_traits>

namespace matrigrate::store {

namespace {

/// A column of a table: what it is called, what it takes from a row, and where a number of it goes when the table is
/// read again.
template <class Row>
struct TableColumn {
  using Of = Row;

  std::string_view name; ///< ends in its unit
  Field (*get)(const Row&);
  void (*set)(Row&, double) = nullptr; ///< none: it follows from the others, or the table is not read
};

/// A field that counts. @throws InputOutputError if it is no number of things
template <class T>
T counted(double field) {
  if (!(field >= 0.0 && field < static_cast<double>(std::numeric_limits<T>::max())))
    throw InputOutputError("a row has no number where things are counted");
  return static_cast<T>(field);
}

template <class Row, class T>
Row row_of(T Row::*);
template <class Row, class T>
T type_of_member(T Row::*);

/// A column that is a member of its row: a number, or a number of things.
template <auto member>
constexpr auto column(std::string_view name) {
  using Row = decltype(row_of(member));
  using T = decltype(type_of_member(member));
  if constexpr (std::is_floating_point_v<T>)
    return TableColumn<Row>{name, [](const Row& row) -> Field { return row.*member; },
                            [](Row& row, double value) { row.*member = value; }};
  else
    return TableColumn<Row>{name, [](const Row& row) -> Field { return count(static_cast<std::size_t>(row.*member)); },
                            [](Row& row, double value) { row.*member = counted<T>(value); }};
}

std::vector<std::string_view> names_of(const auto& columns) {
  std::vector<std::string_view> names;
  for (const auto& one : columns) names.push_back(one.name);
  return names;
}

std::vector<Field> fields_of(const auto& columns, const auto& row) {
  std::vector<Field> fields;
  for (const auto& one : columns) fields.push_back(one.get(row));
  return fields;
}

/// @throws InputOutputError if the table has other columns
auto rows_in(const Table& table, const auto& columns) {
  if (!std::ranges::equal(table.columns, names_of(columns))) throw InputOutputError("has columns of another table");
  std::vector<typename std::ranges::range_value_t<decltype(columns)>::Of> rows(table.rows.size());
  for (std::size_t i = 0; i < rows.size(); ++i)
    for (std::size_t k = 0; k < columns.size(); ++k)
      if (columns[k].set != nullptr) columns[k].set(rows[i], table.rows[i][k]);
  return rows;
}

/// A column that is a coordinate: 0 for x, 1 for y.
template <auto member, int axis>
constexpr auto coordinate(std::string_view name) {
  using Row = decltype(row_of(member));
  return TableColumn<Row>{name, [](const Row& row) -> Field { return (row.*member)[axis]; },
                          [](Row& row, double value) { (row.*member)[axis] = value; }};
}

NucleusRow& nucleus_of(TrackRow& row) { return row.nucleus ? *row.nucleus : row.nucleus.emplace(); }

template <std::size_t k>
constexpr TableColumn<TrackRow> in_phase(std::string_view name) {
  return {name, [](const TrackRow& row) { return count(row.in_phase[k]); },
          [](TrackRow& row, double value) { row.in_phase[k] = counted<std::uint32_t>(value); }};
}

template <double NucleusRow::*member>
constexpr TableColumn<TrackRow> of_nucleus(std::string_view name) {
  return {name, [](const TrackRow& row) -> Field { return (*row.nucleus).*member; },
          [](TrackRow& row, double value) { nucleus_of(row).*member = value; }};
}

constexpr std::size_t nucleus_columns = 4; // the last

constexpr std::array<TableColumn<TrackRow>, 18> track_table{{
    {"track", [](const TrackRow& row) { return count(number_of(row.cell)); },
     [](TrackRow& row, double value) { row.cell = counted<std::uint32_t>(value - 1.0); }},
    column<&TrackRow::t>("t_s"),
    coordinate<&TrackRow::centre, 0>("x_um"),
    coordinate<&TrackRow::centre, 1>("y_um"),
    column<&TrackRow::area>("area_um2"),
    column<&TrackRow::perimeter>("perimeter_um"),
    {"polarization_rad", [](const TrackRow& row) -> Field { return row.polarization.value_or(undefined); },
     [](TrackRow& row, double value) { row.polarization = std::isnan(value) ? std::nullopt : std::optional(value); }},
    {"n_simultaneous", [](const TrackRow& row) { return count(row.alive()); }},
    in_phase<0>("n_growing"),
    in_phase<1>("n_maturing"),
    in_phase<2>("n_contracting"),
    in_phase<3>("n_finishing"),
    column<&TrackRow::initiated>("n_initiated"),
    column<&TrackRow::step>("step"),
    {"nucleus_x_um", [](const TrackRow& row) -> Field { return row.nucleus->centre.x(); },
     [](TrackRow& row, double value) { nucleus_of(row).centre.x() = value; }},
    {"nucleus_y_um", [](const TrackRow& row) -> Field { return row.nucleus->centre.y(); },
     [](TrackRow& row, double value) { nucleus_of(row).centre.y() = value; }},
    of_nucleus<&NucleusRow::area>("nucleus_area_um2"),
    of_nucleus<&NucleusRow::aspect>("nucleus_aspect_ratio"),
}};

std::span<const TableColumn<TrackRow>> track_table_of(bool nucleus) {
  return std::span(track_table).first(track_table.size() - (nucleus ? 0 : nucleus_columns));
}

constexpr std::array<TableColumn<HealthRow>, 18> health_table{{
    column<&HealthRow::t>("t_s"),
    column<&HealthRow::step>("step"),
    column<&HealthRow::iterations>("solver_iterations"),
    column<&HealthRow::max_iterations>("solver_iterations_max"),
    column<&HealthRow::residual>("solver_residual"),
    column<&HealthRow::largest_residual>("solver_residual_max"),
    column<&HealthRow::area_ratio>("area_ratio"),
    column<&HealthRow::density_min>("density_min"),
    column<&HealthRow::density_max>("density_max"),
    column<&HealthRow::density_bounds>("n_density_bounds"),
    column<&HealthRow::orphans>("n_orphans"),
    column<&HealthRow::torn>("n_torn"),
    column<&HealthRow::engulfed>("n_engulfed"),
    column<&HealthRow::solid_inside>("n_solid_inside"),
    column<&HealthRow::deepest_solid>("deepest_solid_um"),
    column<&HealthRow::crosses_itself>("crosses_itself"),
    column<&HealthRow::fastest>("fastest_um_per_s"),
    column<&HealthRow::force_imbalance>("force_imbalance"),
}};

constexpr std::array<TableColumn<GroupRow>, 11> group_table{{
    column<&GroupRow::t>("t_s"),
    coordinate<&GroupRow::centre, 0>("x_um"),
    coordinate<&GroupRow::centre, 1>("y_um"),
    column<&GroupRow::spread>("spread_um"),
    column<&GroupRow::speed>("speed_um_per_h"),
    column<&GroupRow::order>("order"),
    {"direction_deg", [](const GroupRow& row) -> Field { return row.direction * 180.0 / std::numbers::pi; },
     [](GroupRow& row, double value) { row.direction = value * std::numbers::pi / 180.0; }},
    column<&GroupRow::nearest>("nearest_um"),
    column<&GroupRow::gap>("gap_um"),
    column<&GroupRow::contacts>("n_contacts"),
    column<&GroupRow::step>("step"),
}};

/// A protrusion, and the parameters without which its relative force is not known.
struct ProtrusionRow {
  const ProtrusionRecord& r;
  const Parameters& p;
};

template <auto member>
constexpr TableColumn<ProtrusionRow> of_record(std::string_view name) {
  return {name, [](const ProtrusionRow& row) { return column<member>("").get(row.r); }};
}

constexpr std::array<TableColumn<ProtrusionRow>, 13> protrusion_table{{
    of_record<&ProtrusionRecord::id>("id"),
    of_record<&ProtrusionRecord::centre>("centre_particle"),
    of_record<&ProtrusionRecord::t_initiation>("t_initiation_s"),
    of_record<&ProtrusionRecord::t_adhesion>("t_adhesion_s"),
    of_record<&ProtrusionRecord::t_mature>("t_mature_s"),
    of_record<&ProtrusionRecord::t_disassembly>("t_disassembly_s"),
    of_record<&ProtrusionRecord::t_end>("t_end_s"),
    of_record<&ProtrusionRecord::length>("length_um"),
    {"direction_deg", [](const ProtrusionRow& row) -> Field { return row.r.direction * 180.0 / std::numbers::pi; }},
    of_record<&ProtrusionRecord::f_mat>("f_mat"),
    of_record<&ProtrusionRecord::force>("force_nN"),
    {"f_adh_rel", [](const ProtrusionRow& row) -> Field { return relative_force(row.r, row.p); }},
    {"cause", [](const ProtrusionRow& row) -> Field { return name(row.r.cause); }},
}};

/// A table with the rows of all cells. @param rows_of  a cell gives its rows
template <class RowsOf>
std::string cells_csv(std::span<const CellResult> cells, std::vector<std::string_view> columns, const RowsOf& rows_of) {
  const bool several = cells.size() > 1;
  if (several) columns = with_cell(std::move(columns));
  std::string text = csv_line({columns.begin(), columns.end()});
  for (const CellResult& cell : cells)
    for (const std::vector<Field>& row : rows_of(cell)) text += csv_line(several ? with_cell(cell.cell, row) : row);
  return text;
}

} // namespace

std::vector<std::string_view> track_columns(bool nucleus) { return names_of(track_table_of(nucleus)); }
std::vector<Field> fields(const TrackRow& row) { return fields_of(track_table_of(row.nucleus.has_value()), row); }

std::vector<TrackRow> track_rows_of(std::string_view text) {
  const Table table = read_table(text);
  return rows_in(table, track_table_of(table.columns.size() > track_columns().size()));
}

std::vector<std::string_view> health_columns() { return names_of(health_table); }
std::vector<Field> fields(const HealthRow& row) { return fields_of(health_table, row); }

std::vector<std::string_view> group_columns() { return names_of(group_table); }
std::vector<Field> fields(const GroupRow& row) { return fields_of(group_table, row); }
std::vector<GroupRow> group_rows_of(std::string_view text) { return rows_in(read_table(text), group_table); }

std::vector<std::string_view> protrusion_columns() { return names_of(protrusion_table); }
std::vector<Field> fields(const ProtrusionRecord& r, const Parameters& p) {
  return fields_of(protrusion_table, ProtrusionRow{r, p});
}

std::vector<Field> with_cell(std::uint32_t cell, std::vector<Field> fields) {
  fields.insert(fields.begin(), count(number_of(cell)));
  return fields;
}

std::vector<std::string_view> with_cell(std::vector<std::string_view> columns) {
  columns.insert(columns.begin(), "cell");
  return columns;
}

std::string protrusions_csv(std::span<const CellResult> cells, const Parameters& p) {
  return cells_csv(cells, protrusion_columns(), [&](const CellResult& cell) {
    std::vector<std::vector<Field>> rows;
    for (const ProtrusionRecord& r : cell.records) rows.push_back(fields(r, p));
    return rows;
  });
}

std::string msd_csv(std::span<const CellResult> cells, double interval) {
  return cells_csv(cells, {"lag_s", "msd_um2", "samples"}, [&](const CellResult& cell) {
    std::vector<std::vector<Field>> rows;
    for (const MsdPoint& point : mean_square_displacement(cell.rows, interval))
      rows.push_back({point.lag, point.msd, count(point.samples)});
    return rows;
  });
}

std::vector<NamedValue> named_values(const ReadOuts& r) {
  std::vector<NamedValue> values;
  for (const ReadOutSpec& spec : readout_table())
    values.push_back({spec.name, spec.meaning_with_unit(),
                      std::visit([](const auto value) { return Field(value); }, spec.value(r))});
  return values;
}

std::string readouts_json() {
  nlohmann::ordered_json all = nlohmann::ordered_json::array();
  for (const ReadOutSpec& r : readout_table())
    all.push_back({{"name", r.name},
                   {"label", r.label},
                   {"unit", r.unit},
                   {"meaning", r.meaning},
                   {"of_uniaxial_fibres", r.of_fibres},
                   {"of_several_cells", r.of_groups}});
  return all.dump(1) + "\n";
}

std::vector<NamedValue> shown_values(const ReadOuts& r, const Parameters& p) {
  const bool fibres = p.fibres.arrangement == FibreArrangement::uniaxial;
  std::vector<NamedValue> values = named_values(r);
  std::erase_if(values, [&](const NamedValue& v) {
    const ReadOutSpec& spec = *find_readout(v.name);
    return spec.of_claims || (spec.of_fibres && !fibres);
  });
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
  return cells_csv(cells, std::move(columns), [](const CellResult& cell) {
    std::vector<Field> row;
    for (const NamedValue& v : named_values(cell.readouts)) row.push_back(v.value);
    return std::vector<std::vector<Field>>{row};
  });
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
