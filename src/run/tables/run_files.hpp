#pragma once

#include "observe/health.hpp"
#include "observe/readouts.hpp"
#include "observe/tracks.hpp"
#include "tables/table.hpp"

#include <span>
#include <string>
#include <string_view>
#include <vector>

/// The tables of a run. Units stand in the names of the columns; what is not defined is an empty field, or null in
/// JSON. Test: tests/unit/tables/run_files_test.cpp
namespace matrigrate::store {

/// tracks.csv. The first four columns are those that celltrackR reads: track, time, x, y; the track is the number of
/// the cell.
std::vector<std::string_view> track_columns(bool nucleus = false); ///< of cells with a nucleus
std::vector<Field> fields(const TrackRow& row);

/// The rows of a tracks.csv, to the last bit.
/// @throws InputOutputError if it is none
std::vector<TrackRow> track_rows_of(std::string_view text);

/// health.csv
std::vector<std::string_view> health_columns();
std::vector<Field> fields(const HealthRow& row);

/// group.csv, of several cells, and its rows; the direction is rounded.
/// @throws InputOutputError if it is none
std::vector<std::string_view> group_columns();
std::vector<Field> fields(const GroupRow& row);
std::vector<GroupRow> group_rows_of(std::string_view text);

/// protrusions.csv of a single cell. That of several has the column `cell`, its number, before the others; so have
/// msd.csv and summary.csv.
std::vector<std::string_view> protrusion_columns();
std::vector<Field> fields(const ProtrusionRecord& r, const Parameters& p);

/// A row, or the columns, of a table of several cells.
std::vector<Field> with_cell(std::uint32_t cell, std::vector<Field> fields);
std::vector<std::string_view> with_cell(std::vector<std::string_view> columns);

/// The whole of protrusions.csv, cell after cell.
std::string protrusions_csv(std::span<const CellResult> cells, const Parameters& p);

/// msd.csv, cell after cell, at multiples of an interval [s].
std::string msd_csv(std::span<const CellResult> cells, double interval);

/// A read-out in words and in figures.
struct NamedValue {
  std::string_view name; ///< as in the files, with its unit
  std::string meaning;   ///< for people, with its unit
  Field value;
};
std::vector<NamedValue> named_values(const ReadOuts& r);

/// What docs/readouts.json holds, for readers in other languages: all read-outs as a list of objects {name, label,
/// unit, meaning, of_uniaxial_fibres, of_several_cells}.
std::string readouts_json();

/// The read-outs that a run can have, for people: those of uniaxial fibres only if there are such fibres, and none that
/// claims alone need.
std::vector<NamedValue> shown_values(const ReadOuts& r, const Parameters& p);

/// "12.7 um/h from start to end, persistent (MSD slope 1.42), 21 protrusions.": persistent above a slope of 1.2,
/// confined below 0.8, between them like a random walk (slope 1). What is not defined is left out.
std::string result_sentence(const ReadOuts& r);

/// The sentence of a single cell, or of each of several cells: "Cell 1: ... Cell 2: ..."
std::string result_sentence(std::span<const CellResult> cells);

/// A value for people: four digits, or "-" where it is not defined.
std::string readable(const Field& value);

/// summary.csv: a header and one row a cell.
std::string summary_csv(std::span<const CellResult> cells);

/// summary.json: one object; of several cells it is {"cells": [...]}, an object a cell with its number as `cell`.
std::string summary_json(std::span<const CellResult> cells);

} // namespace matrigrate::store
