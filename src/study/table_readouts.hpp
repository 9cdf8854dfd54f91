#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

/// Read-outs of a run that claims need and that its tables hold: shares, ratios, and what several cells do together.
/// Test: tests/unit/study/table_readouts_test.cpp
namespace matrigrate::study {

/// An adhesion counts as ended "at a low force" below this f_adh_rel (Eq. 9): half of what its maturation stands for.
inline constexpr double low_relative_force = 0.5;

/// share_f_adh_rel_low: of the mature adhesions that ended, those with f_adh_rel < low_relative_force
/// (protrusions.csv). share_2_or_3_protrusions: of the rows of tracks.csv, those with 2 or 3 protrusions alive.
/// migration_index_x: the way along x over the length of the path sampled every 600 s, from -1 to 1 (tracks.csv; the
/// forward migration index of experiments), mean over the cells. Then group_readout_table().
struct TableReadOut {
  std::string_view name;
  std::string_view meaning;
};
std::span<const TableReadOut> table_readout_table();

/// The last of them, of several cells. parting_index: cosine of the angle between a cell's displacement over the run
/// and the direction away from the cell that was nearest at the start, mean over the cells, from -1 to 1 (tracks.csv).
/// share_in_contact: of the rows of group.csv, those with a contact between cells. nearest_um: its last value [um].
/// order: its mean.
std::span<const TableReadOut> group_readout_table();

/// @param folder  of a run
/// @return  in the order of table_readout_table(); NaN where there is nothing to take a share of, and in
///          group_readout_table() of a single cell
/// @throws InputOutputError if a table cannot be read
std::vector<double> table_readouts(const std::filesystem::path& folder);

/// All read-outs of a run, those of summary.json and these, as a JSON list of objects {name, label, unit, meaning,
/// of_uniaxial_fibres}: what docs/readouts.json holds, for readers in other languages.
std::string readouts_json();

} // namespace matrigrate::study
