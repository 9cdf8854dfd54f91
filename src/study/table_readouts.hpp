#pragma once

#include <array>
#include <filesystem>
#include <string_view>

/// Read-outs of a run that claims need and that its tables hold: shares and ratios.
/// Test: tests/unit/study/comparison_test.cpp
namespace matrigrate::study {

/// An adhesion counts as ended "at a low force" below this f_adh_rel (Eq. 9): half of what its maturation stands for.
inline constexpr double low_relative_force = 0.5;

/// share_f_adh_rel_low: of the mature adhesions that ended, those with f_adh_rel < low_relative_force
/// (protrusions.csv). share_2_or_3_protrusions: of the rows of tracks.csv, those with 2 or 3 protrusions alive.
/// migration_index_x: the way along x over the length of the path sampled every 600 s, from -1 to 1 (tracks.csv; the
/// forward migration index of experiments); of a single cell alone.
std::array<std::string_view, 3> table_readout_names();

/// @param folder  of a run
/// @return  in the order of the names; NaN where there is nothing to take a share of
/// @throws InputOutputError if a table cannot be read
std::array<double, 3> table_readouts(const std::filesystem::path& folder);

} // namespace matrigrate::study
