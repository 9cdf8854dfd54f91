#pragma once

#include <array>
#include <filesystem>
#include <string_view>

/// Read-outs of a run that claims of the paper need and that its tables hold: shares, which are no means of a run.
/// Test: tests/unit/study/comparison_test.cpp
namespace matrigrate::study {

/// An adhesion counts as ended "at a low force" below this f_adh_rel (Eq. 9): half of what its maturation stands for.
inline constexpr double low_relative_force = 0.5;

/// share_f_adh_rel_low: of the mature adhesions that ended, those with f_adh_rel < low_relative_force
/// (protrusions.csv). share_2_or_3_protrusions: of the rows of tracks.csv, those with 2 or 3 protrusions alive.
std::array<std::string_view, 2> table_readout_names();

/// @param folder  of a run
/// @return  in the order of the names; NaN where there is nothing to take a share of
/// @throws InputOutputError if a table cannot be read
std::array<double, 2> table_readouts(const std::filesystem::path& folder);

} // namespace matrigrate::study
