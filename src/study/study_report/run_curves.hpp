#pragma once

#include "study_plan/study.hpp"
#include "study_results/results.hpp"

#include <filesystem>
#include <string>
#include <vector>

/// What the runs of a study look like: paths, shapes, mean square displacements and adhesions, as tables that are small
/// enough to be kept and that pages can be made from. Runs that are not done are left out. The last column of each
/// table is the label of the point. All throw InputOutputError if a table of a run that is done cannot be read.
/// Test: tests/unit/study_report/study_report_test.cpp
namespace matrigrate::study {

/// Mean square displacement over the runs of a point at a lag that all of them have; of several cells the mean over
/// those of a run counts.
struct MeanMsd {
  double lag = 0.0;  ///< [s]
  double mean = 0.0; ///< [um^2]
  double sem = 0.0;  ///< standard error of the mean; NaN of a single run [um^2]
  std::size_t runs = 0;
};

/// That of a point.
std::vector<MeanMsd> mean_msd(const std::vector<Result>& results, std::size_t point,
                              const std::filesystem::path& study_folder);

/// paths.csv: replicate, t_s, x_um and y_um from the start of the path, each 600 s, cell (of several cells), point.
std::string paths_csv(const Study& study, const std::vector<Result>& results,
                      const std::filesystem::path& study_folder);

/// msd.csv: lag_s, msd_um2, sem_um2, n_runs, point.
std::string msd_csv(const Study& study, const std::vector<Result>& results, const std::filesystem::path& study_folder);

/// adhesions.csv: replicate, length_um, f_mat, f_adh_rel, point; an adhesion that has ended a row.
std::string adhesions_csv(const Study& study, const std::vector<Result>& results,
                          const std::filesystem::path& study_folder);

/// shapes.csv: replicate, x_um, y_um, point; every second particle of the cortex where a run ended, the first three
/// replicates of each point. Runs whose checkpoint is gone are left out.
std::string shapes_csv(const Study& study, const std::vector<Result>& results,
                       const std::filesystem::path& study_folder);

} // namespace matrigrate::study
