#pragma once

#include "study_results/comparison.hpp"

#include <nlohmann/json.hpp>

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

/// What pages draw of a study, as viewer/src/study/contract.ts describes it. Test:
/// tests/unit/study_report/study_report_test.cpp
namespace matrigrate::study {

// What the runs of a study look like: paths, shapes, mean square displacements and adhesions, as tables that are small
// enough to be kept and that pages can be made from. Runs that are not done are left out. The last column of each
// table is the label of the point. All throw InputOutputError if a table of a run that is done cannot be read.
// Test: tests/unit/study_report/study_report_test.cpp

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

// Their JSON.

/// A sample that is compared, with the numbers of groups.csv.   @param place  of its point on the axes
nlohmann::ordered_json group_json(std::string_view readout, const nlohmann::ordered_json& place,
                                  const statistics::Moments& moments, const statistics::Box& box);

/// [low, high]; null unless both are finite.
nlohmann::ordered_json interval_json(const statistics::Interval& found);

/// Two points that were compared.   @param places  of all points on the axes
nlohmann::ordered_json test_json(const Comparison& c, TestKind test, const std::vector<nlohmann::ordered_json>& places);

/// Index of the k-th of `chosen` out of n, the first and the last among them.
std::size_t evenly(std::size_t k, std::size_t chosen, std::size_t n);

/// The read-outs that a study compares: [{name, label, meaning, unit}].
nlohmann::ordered_json readouts_json(const Study& study);

/// Axes, read-outs, samples and comparisons: {axes, readouts, groups, tests}.
nlohmann::ordered_json compared_json(const Study& study, const std::vector<Result>& results,
                                     const std::vector<Comparison>& comparisons);

/// A mean square displacement: {point, lag_min, msd_um2, sem_um2, slope}.
nlohmann::ordered_json msd_json(const std::vector<MeanMsd>& means, const nlohmann::ordered_json& place);

/// Measured tracks as pages draw them over simulated ones (MeasuredTracks of viewer/src/contract.ts), from a common
/// origin and from time 0: of more than 200 as many, of each at most 100 positions, evenly chosen.
/// @return null without tracks
nlohmann::ordered_json measured_json(const std::vector<tracks::CellTrack>& tracks);

/// The tracks of the targets that hold at a point, and further ones.
std::vector<tracks::CellTrack> tracks_at(const Study& study, const std::vector<tracks::CellTrack>& further,
                                         std::size_t point);

/// The tracks of each file that targets name, and further ones, with the places of the points that they belong to.
/// @param places  of the points in the grid of the page
nlohmann::ordered_json measured_json(const Study& study, const std::vector<tracks::CellTrack>& further,
                                     const std::vector<nlohmann::ordered_json>& places);

/// A run as the page of a study takes it (viewer/src/study/contract.ts): how it stands, its read-outs, path and outline
/// at the end.
/// @param place  of its point on the axes
/// @throws InputOutputError if a table of a run that is done cannot be read
nlohmann::ordered_json run_json(const Study& study, const std::filesystem::path& study_folder, const Result& result,
                                const nlohmann::ordered_json& place);

/// Texts of these tables; empty for a missing table.
struct CurveTables {
  std::string paths, shapes, msd, adhesions;
};

/// compared_json with title, runs and msd, from tables alone: {title, axes, readouts, groups, tests, runs, msd}.
/// @throws InputOutputError if a table lacks a column
nlohmann::ordered_json drawn_study(const Study& study, const std::vector<Result>& results, const CurveTables& tables);

} // namespace matrigrate::study
