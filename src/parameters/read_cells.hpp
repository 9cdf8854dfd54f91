#pragma once

#include "parameters/parameters.hpp"

#include <toml++/toml.h>

#include <cstddef>
#include <string>
#include <vector>

/// [[cells]] of a scenario: where several cells start. Test: tests/unit/parameters/parameters_test.cpp
namespace matrigrate {

/// What stands at [[cells]].
struct CellsRead {
  struct Fault {
    toml::source_region place;
    std::string key; ///< "cells", "cells[2]", "cells[2].x"
    std::string message;
  };
  std::vector<CellStart> starts;           ///< those that could be read, in the order of the file [um]
  std::vector<toml::source_region> places; ///< of each of `starts`
  std::vector<Fault> faults;
};

/// Reads an array of tables, each with the keys of cell_rows().
/// @return all faults of form and value; whether the cells have room, cell_faults() tells
CellsRead read_cells(const toml::node& node);

/// "cells[1]" for the first one.
std::string cell_key(std::size_t cell);

} // namespace matrigrate
