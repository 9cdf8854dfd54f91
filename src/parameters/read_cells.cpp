#include "parameters/assign.hpp"
#include "parameters/document.hpp"
#include "parameters/nearest.hpp"
#include "parameters/read.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <utility>

namespace matrigrate {

namespace {

constexpr std::string_view form = "write [[cells]] and below it x and y, for each cell";

const Row* row_of(std::string_view key) {
  const auto row = std::ranges::find(cell_rows(), key, key_of);
  return row == cell_rows().end() ? nullptr : &*row;
}

std::vector<std::string> known_keys() {
  std::vector<std::string> keys;
  for (const Row& row : cell_rows()) keys.emplace_back(key_of(row));
  return keys;
}

void read_cell(const toml::table& table, const std::string& cell, CellsRead& read) {
  Parameters one;
  for (const auto& [name, node] : table) {
    const std::string key(name.str());
    const std::string path = fmt::format("{}.{}", cell, excerpt(key, 60));
    if (const Row* row = row_of(key)) {
      if (std::string fault = assign(*row, given_by(node), one); !fault.empty())
        read.faults.push_back({node.source(), path, std::move(fault)});
      continue;
    }
    const std::string hint = find_row("cell." + key) != nullptr
                                 ? fmt::format("; all cells are alike, with cell.{} of the section [cell]", key)
                                 : did_you_mean(nearest(key, known_keys()));
    read.faults.push_back({name.source(), path, fmt::format("there is no such key; a cell has x and y{}", hint)});
  }
  for (const Row& row : cell_rows())
    if (!table.contains(key_of(row)))
      read.faults.push_back(
          {table.source(), cell, fmt::format("has no {0}; write it like {0} = \"40 um\"", key_of(row))});
  read.starts.push_back(one.cells.empty() ? CellStart{} : one.cells.front());
  read.places.push_back(table.source());
}

} // namespace

std::string cell_key(std::size_t cell) { return fmt::format("cells[{}]", cell + 1); }

CellsRead read_cells(const toml::node& node) {
  CellsRead read;
  const auto refuse = [&](std::string message) {
    read.faults.push_back({node.source(), "cells", std::move(message)});
    return read;
  };
  const toml::array* cells = node.as_array();
  if (cells == nullptr)
    return refuse(fmt::format("is {}, but an array of tables is expected; {}", type_of(node), form));
  if (cells->empty())
    return refuse("is empty; leave it out for one cell at cell.start_x, cell.start_y, or " + std::string(form));
  if (cells->size() > max_cells)
    return refuse(fmt::format("has {} cells; allowed are 1 to {}", cells->size(), max_cells));
  for (std::size_t k = 0; k < cells->size(); ++k) {
    const toml::node& one = *cells->get(k);
    if (const toml::table* table = one.as_table())
      read_cell(*table, cell_key(k), read);
    else
      read.faults.push_back(
          {one.source(), cell_key(k), fmt::format("is {}, but a table is expected; {}", type_of(one), form)});
  }
  return read;
}

} // namespace matrigrate
