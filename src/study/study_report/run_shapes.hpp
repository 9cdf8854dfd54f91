#pragma once

#include "observe/frame.hpp"
#include "study_plan/study.hpp"
#include "study_results/results.hpp"

#include <filesystem>
#include <string>
#include <string_view>

/// Cells and matrix of the runs of a study as small tables: shapes at the end, the stress of the fibres around a cell,
/// and its picture. Test: tests/unit/study_report/run_shapes_test.cpp
namespace matrigrate::study {

/// shapes.csv: replicate, x_um, y_um, point; every second particle of the cortex where a run ended, the first three
/// replicates of each point. Runs that are not done, or whose checkpoint is gone, are left out.
std::string shapes_csv(const Study& study, const std::vector<Result>& results,
                       const std::filesystem::path& study_folder);

/// fibre-stress.csv: what (matrix, or outline of the cell), x_um, y_um, von_mises_Pa of the fibres (Eq. 11), at the
/// last frame of a film, as far as 60 um from the cell's centre; fluid and outline have no stress.
std::string fibre_stress_csv(const observe::Film& film);

/// The stress on the solid matrix, with the outline (Fig 13).
std::string fibre_stress_svg(std::string_view fibre_stress_csv, double spacing);

} // namespace matrigrate::study
