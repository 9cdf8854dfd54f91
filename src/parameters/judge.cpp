#include "parameters/judge.hpp"

#include "parameters/changes.hpp"
#include "parameters/nearest.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace matrigrate {

Judged judged(std::string_view path, const Given& value) {
  constexpr std::string_view change = "changes.";
  const bool changes = path.starts_with(change) && path != change_time().path;
  if (changes) path.remove_prefix(change.size());
  const auto of_cells = std::ranges::find(cell_rows(), path, &Row::path);
  const Row* row = path == change_time().path      ? &change_time()
                   : of_cells == cell_rows().end() ? find_row(path)
                                                   : &*of_cells;
  if (row == nullptr) return {unknown_name(path, false)};
  Parameters p;
  if (std::string reason = changes ? fixed_in_run(*row, p) : ""; !reason.empty()) return {std::move(reason)};
  std::string fault = assign(*row, value, p);
  const double* real = real_of(*row, p);
  if (!fault.empty() || real == nullptr) return {std::move(fault)};
  return {{}, units::number_in(*real, unit_of(*row))};
}

std::string unknown_name(std::string_view path, bool section) {
  return fmt::format("there is no such {}{}", section ? "section" : "parameter", parameter_hint(path));
}

} // namespace matrigrate
