#pragma once

#include "observe/displacement_statistics.hpp"
#include "observe/health.hpp"
#include "observe/readouts.hpp"
#include "observe/tracks.hpp"
#include "store/row_file.hpp"

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

/// The tables of a run. Units stand in the names of the columns; what is not defined is an empty field, or null in
/// JSON. Test: tests/unit/store/run_files_test.cpp
namespace matrigrate::io {

/// tracks.csv. The first four columns are those that celltrackR reads: track, time, x, y.
std::vector<std::string_view> track_columns();
std::vector<Field> fields(const TrackRow& row);

/// health.csv.
std::vector<std::string_view> health_columns();
std::vector<Field> fields(const HealthRow& row);

/// protrusions.csv.
std::vector<std::string_view> protrusion_columns();
std::vector<Field> fields(const ProtrusionRecord& r, const ActomyosinParameters& p);

/// The whole of protrusions.csv.
std::string protrusions_csv(std::span<const ProtrusionRecord> records, const ActomyosinParameters& p);

/// msd.csv.
std::string msd_csv(std::span<const MsdPoint> points);

/// A read-out in words and in figures.
struct NamedValue {
  std::string_view name; ///< as in the files, with its unit
  std::string meaning;   ///< for people, with its unit
  Field value;
};
std::vector<NamedValue> named_values(const ReadOuts& r);

/// Those that a run can have, for people: without those of uniaxial fibres where there are none.
std::vector<NamedValue> shown_values(const ReadOuts& r, const Parameters& p);

/// "12.7 um/h from start to end, persistent (MSD slope 1.42), 21 protrusions.": persistent above a slope of 1.2,
/// confined below 0.8, between them like a random walk (slope 1). What is not defined is left out.
std::string result_sentence(const ReadOuts& r);

/// A value for people: four digits, or "-" where it is not defined.
std::string readable(const Field& value);

/// summary.csv: a header and one row.
std::string summary_csv(const ReadOuts& r);

/// summary.json: one object.
std::string summary_json(const ReadOuts& r);

} // namespace matrigrate::io
