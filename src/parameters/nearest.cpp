#include "parameters/nearest.hpp"

#include "parameters/schema.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <numeric>
#include <span>

namespace matrigrate {

namespace {

constexpr std::size_t longest_name = 80; // longer ones are no slip of the fingers, and would take long

char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

std::string_view last_part(std::string_view path) { return path.substr(path.rfind('.') + 1); }

/// Slips that are forgiven in a name of this length.
std::size_t allowance(std::size_t length) { return std::max<std::size_t>(1, length / 3); }

/// Words that people try, and what they mean here.
struct Alias {
  std::string_view words;    ///< alone or in one of the sections
  std::string_view sections; ///< in which they mean this; these and the words each between spaces
  std::string_view path;     ///< of the parameter, or the name of the read-out
};

constexpr std::array aliases{
    Alias{" stiffness elasticity elastic_modulus modulus rigidity ", " ecm matrix gel ", "ecm.youngs_modulus"},
    Alias{" domain_radius ", " ecm matrix gel ", "ecm.radius"},
    Alias{" poisson_ratio ", " ecm matrix gel ", "ecm.poissons_ratio"},
    Alias{" resolution ", " ecm matrix gel ", "ecm.particle_spacing"},
    Alias{" hours end_time ", " run time simulation ", "run.duration"},
    Alias{" time ", " run simulation ", "run.duration"},
    Alias{" dt step ", " run time simulation ", "run.time_step"},
    Alias{" contraction contractility ", " cell actomyosin ", "actomyosin.force"},
    Alias{" size diameter ", " cell ", "cell.radius"},
    Alias{" orientation ", " fibres fibers ", "fibres.direction_deg"}};

/// Words for what a run comes to, and the read-outs that tell it.
constexpr std::array results{
    Alias{" speed velocity migration_speed ", " cell ecm run migration ", "v_migr_abs_um_per_h"},
    Alias{" persistence ", " cell ecm run migration ", "msd_slope"}};

std::optional<std::string> meant_by(std::string_view path, std::span<const Alias> known) {
  const std::string word = fmt::format(" {} ", last_part(path)); // an exact word: no letters are forgiven
  const std::string section =
      path.find('.') == std::string::npos ? "" : fmt::format(" {} ", path.substr(0, path.rfind('.')));
  for (const Alias& alias : known)
    if (alias.words.find(word) != std::string_view::npos && alias.sections.find(section) != std::string_view::npos)
      return std::string(alias.path);
  return std::nullopt;
}

} // namespace

std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> before(b.size() + 1);
  std::vector<std::size_t> above(b.size() + 1);
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(above.begin(), above.end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i) {
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const bool equal = lower(a[i - 1]) == lower(b[j - 1]);
      row[j] = std::min({above[j] + 1, row[j - 1] + 1, above[j - 1] + (equal ? 0 : 1)});
      const bool swapped = i > 1 && j > 1 && lower(a[i - 1]) == lower(b[j - 2]) && lower(a[i - 2]) == lower(b[j - 1]);
      if (swapped) row[j] = std::min(row[j], before[j - 2] + 1);
    }
    before.swap(above);
    above.swap(row);
  }
  return above[b.size()];
}

std::optional<std::string> nearest(std::string_view typed, const std::vector<std::string>& names) {
  if (typed.empty() || typed.size() > longest_name) return std::nullopt;
  std::optional<std::string> best;
  std::size_t best_distance = allowance(typed.size()) + 1;
  for (const std::string& name : names) {
    const std::size_t distance = edit_distance(typed, name);
    if (distance >= best_distance) continue;
    best = name;
    best_distance = distance;
  }
  return best;
}

std::optional<std::string> nearest_readout(std::string_view typed, const std::vector<std::string>& names) {
  if (auto near = nearest(typed, names)) return near;
  const auto begins = [&](const std::string& name) { return name.starts_with(fmt::format("{}_", typed)); };
  if (const auto found = std::ranges::find_if(names, begins); found != names.end()) return *found;
  const auto result = typed.find('.') == std::string_view::npos ? meant_by(typed, results) : std::nullopt;
  return result && std::ranges::find(names, *result) != names.end() ? result : std::nullopt;
}

std::optional<std::string> nearest_parameter(std::string_view path) {
  if (path.empty() || path.size() > longest_name) return std::nullopt;
  if (auto meant = meant_by(path, aliases)) return meant;
  const std::string_view key = last_part(path);
  std::optional<std::string> best;
  std::size_t best_distance = allowance(path.size()) + 1;
  const auto consider = [&](std::string_view name, std::size_t distance) {
    if (distance >= best_distance) return;
    best = std::string(name);
    best_distance = distance;
  };
  for (const Row& row : schema()) {
    if (!row.symbol.empty() && key == row.symbol) return std::string(row.path);
    consider(row.path, edit_distance(path, row.path));
    const std::size_t elsewhere = edit_distance(key, key_of(row));
    if (elsewhere <= allowance(key.size())) consider(row.path, elsewhere + 1); // the right key in a wrong section
  }
  for (const Section& section : sections()) consider(section.name, edit_distance(path, section.name));
  return best;
}

std::string did_you_mean(const std::optional<std::string>& name) {
  return name ? fmt::format("; did you mean {}?", *name) : std::string();
}

std::string parameter_hint(std::string_view path) {
  if (const auto readout = meant_by(path, results))
    return fmt::format("; it is a result, the read-out {}, and cannot be set", *readout);
  return did_you_mean(nearest_parameter(path));
}

} // namespace matrigrate
