#pragma once

#include <filesystem>
#include <span>

/// Read-outs of runs by versions up to 0.2.0, whose summary.json lacks those that claims need.
/// Test: tests/apps/other_version_test.cpp
namespace matrigrate::run {

/// Sets these read-outs from the tables of a run; of several cells their mean over those for which they are defined.
/// @param values  in the order of readout_table()
/// @throws InputOutputError if a table cannot be read
void add_from_tables(const std::filesystem::path& folder, std::span<double> values);

} // namespace matrigrate::run
