#pragma once

#include "apps/reproduce/options.hpp"
#include "claims/judge.hpp"
#include "draw/plot.hpp"

#include <map>
#include <string>
#include <vector>

/// Figures of `matrigrate reproduce` beside the box plots, each drawn from a table that is written with it.
/// Test: tests/apps/reproduce_test.cpp
namespace matrigrate::apps {

/// Writes shapes.csv, shapes.svg and centres.csv into the folders of the studies, and fibre-stress.csv and
/// fibre-stress.svg, of one run with two protrusions among fibres (Fig 13), beside them; draws validate-<case>.svg
/// (Figs 2 and 4) from the tables of the verification cases.
/// @return by the id of the row that they belong to
/// @throws InputOutputError if frames cannot be read
std::map<std::string, std::vector<draw::Figure>> draw_runs(const study::Evidence& evidence,
                                                           const ReproduceOptions& options);

/// The same and all other figures of studies (<study>.svg, <study>-paths.svg, validate-<case>.svg and so on), drawn
/// from the kept tables of options.from into options.folder.
/// @throws InputOutputError if a table cannot be read
std::map<std::string, std::vector<draw::Figure>> draw_kept(const study::Evidence& evidence,
                                                           const ReproduceOptions& options);

} // namespace matrigrate::apps
