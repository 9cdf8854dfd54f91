#include "base/random.hpp"
#include "parameters/node.hpp"
#include "store/trajectory_hash.hpp"
#include "study/design/designs.hpp"
#include "study/design/range.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <unordered_map>

namespace matrigrate::study {

namespace {

constexpr std::size_t max_levels = 100;
constexpr std::size_t usual_levels = 4;
constexpr std::size_t usual_trajectories = 10;

/// What a number of a trajectory is drawn for.
enum class Draw : std::uint32_t { level, direction, order };

/// A value that a factor can take.
struct Level {
  Given given;
  Setting setting;
  double place = 0.0; ///< within the range, from 0 to 1
};

struct Factor {
  const Row* row;
  Place place;
  std::vector<Level> levels; ///< an even number; a step is half as many

  std::size_t jump() const { return levels.size() / 2; }
};

/// A value of a factor as it will be set; none, and a fault, if it is not allowed.
std::optional<Level> level_of(const Row& row, Given given, Place place, const Parameters& base, FaultList& faults) {
  Parameters scratch = base;
  if (const std::string fault = assign(row, given, scratch); !fault.empty()) {
    faults.add(place, row.path, fault);
    return std::nullopt;
  }
  return Level{std::move(given), {std::string(row.path), value_text(row, scratch)}, 0.0};
}

std::optional<Factor> number_factor(const Named& named, std::size_t levels, const Parameters& base, FaultList& faults) {
  const auto span = span_of(named, base, faults);
  if (!span) return std::nullopt;
  Factor factor{span->row, span->place, {}};
  for (std::size_t k = 0; k < levels; ++k) {
    const double share = static_cast<double>(k) / static_cast<double>(levels - 1);
    auto level = level_of(*span->row, given_number(*span->row, span->at(share)), span->place, base, faults);
    if (!level) return std::nullopt;
    Parameters scratch = base;
    assign(*span->row, level->given, scratch);
    level->place = span->share(*number_in_unit(*span->row, scratch));
    factor.levels.push_back(std::move(*level));
  }
  for (std::size_t k = 0; k < factor.jump(); ++k)
    if (factor.levels[k].setting == factor.levels[k + factor.jump()].setting) {
      faults.add(span->place, span->row->path, "has levels that are the same in six digits; give a wider range");
      return std::nullopt;
    }
  return factor;
}

std::optional<Factor> choice_factor(const Named& named, const Parameters& base, FaultList& faults) {
  const toml::array* list = named.node->as_array();
  const std::string such = fmt::format("two values are expected, each {}", allowed_text(*named.row));
  const auto complain = [&](std::string message) {
    faults.add(place_of(*named.node), named.row->path, std::move(message));
    return std::nullopt;
  };
  if (list == nullptr) return complain(fmt::format("is {}, but {}", type_of(*named.node), such));
  if (list->size() != 2)
    return complain(fmt::format("has {} value{}, but {}", list->size(), list->size() == 1 ? "" : "s", such));
  Factor factor{named.row, place_of(*named.node), {}};
  for (const toml::node& node : *list)
    if (auto level = level_of(*named.row, given_by(node), place_of(node), base, faults))
      factor.levels.push_back(std::move(*level));
  if (factor.levels.size() < 2) return std::nullopt;
  if (factor.levels[0].setting == factor.levels[1].setting)
    return complain(fmt::format("{} is listed twice", factor.levels[0].setting.value));
  factor.levels[1].place = 1.0;
  return factor;
}

std::size_t levels_of(const toml::table& ranges, FaultList& faults) {
  const toml::node* node = ranges.get("levels");
  if (node == nullptr) return usual_levels;
  const std::size_t levels = faults.whole(*node, "morris.levels", 2, max_levels);
  if (levels % 2 == 0) return levels;
  faults.add(
      place_of(*node), "morris.levels",
      fmt::format("{} is odd; allowed are even numbers, so that a step of half the levels reaches all of them alike",
                  levels));
  return usual_levels;
}

/// Where factors stand while a trajectory is followed.
class Trajectory {
public:
  Trajectory(const std::vector<Factor>& factors, std::uint64_t seed, std::size_t number)
      : m_factors(factors), m_order(factors.size()) {
    std::vector<double> rank;
    for (const Factor& factor : factors) {
      const std::uint64_t key =
          std::stoull(store::text_hash(fmt::format("morris {} {}", seed, factor.row->path)), nullptr, 16);
      const auto draw = [&](Draw what) {
        return uniform(key, Purpose::sampling, number, static_cast<std::uint32_t>(what));
      };
      const auto start = static_cast<std::size_t>(draw(Draw::level) * static_cast<double>(factor.jump()));
      m_up.push_back(draw(Draw::direction) < 0.5);
      m_level.push_back(m_up.back() ? start : start + factor.jump());
      rank.push_back(draw(Draw::order));
    }
    std::iota(m_order.begin(), m_order.end(), std::size_t{0});
    std::ranges::stable_sort(m_order, {}, [&](std::size_t f) { return rank[f]; });
  }

  const std::vector<std::size_t>& order() const { return m_order; }
  const Level& at(std::size_t f) const { return m_factors[f].levels[m_level[f]]; }

  /// Changes a factor. @return by what share of its range
  double change(std::size_t f) {
    const double before = at(f).place;
    m_level[f] = m_up[f] ? m_level[f] + m_factors[f].jump() : m_level[f] - m_factors[f].jump();
    return at(f).place - before;
  }

private:
  const std::vector<Factor>& m_factors;
  std::vector<std::size_t> m_order; ///< in which factors are changed
  std::vector<std::size_t> m_level;
  std::vector<bool> m_up;
};

/// The sets that trajectories meet, each once.
class Visited {
public:
  Visited(const std::vector<Factor>& factors, const Parameters& base) : m_factors(factors), m_base(base) {}

  /// The set at which a trajectory stands, made if it is new.
  std::size_t set_of(const Trajectory& trajectory, const std::string& label, std::vector<Draft>& drafts) {
    std::string text;
    for (std::size_t f = 0; f < m_factors.size(); ++f) text += trajectory.at(f).setting.value + '\n';
    const auto [known, is_new] = m_known.try_emplace(std::move(text), drafts.size());
    if (!is_new) return known->second;
    Draft& draft = drafts.emplace_back(Draft{{.label = label, .settings = {}, .parameters = m_base}, {}, {}});
    for (std::size_t f = 0; f < m_factors.size(); ++f) {
      assign(*m_factors[f].row, trajectory.at(f).given, draft.point.parameters);
      draft.point.settings.push_back(trajectory.at(f).setting);
      draft.settings.emplace_back(m_factors[f].row->path, m_factors[f].place);
    }
    draft.place = m_factors.front().place;
    return known->second;
  }

private:
  const std::vector<Factor>& m_factors;
  const Parameters& m_base;
  std::unordered_map<std::string, std::size_t> m_known;
};

std::vector<Factor> factors_of(const toml::table& ranges, const Parameters& base, FaultList& faults) {
  const std::size_t levels = levels_of(ranges, faults);
  std::vector<Factor> factors;
  for (const Named& named : named_parameters(ranges, "morris", {"trajectories", "levels"}, faults)) {
    auto factor = number_in_unit(*named.row, base) ? number_factor(named, levels, base, faults)
                                                   : choice_factor(named, base, faults);
    if (factor) factors.push_back(std::move(*factor));
  }
  if (factors.empty() && faults.empty()) faults.add(place_of(ranges), "morris", "has no range of a parameter");
  return factors;
}

} // namespace

Designed morris_sets(const toml::table& ranges, const Parameters& base, std::uint64_t seed, Allowance& allowance,
                     FaultList& faults) {
  Designed made;
  const toml::node* node = ranges.get("trajectories");
  const std::size_t trajectories =
      node == nullptr ? usual_trajectories : faults.whole(*node, "morris.trajectories", 2, max_runs);
  const std::vector<Factor> factors = factors_of(ranges, base, faults);
  const double most = static_cast<double>(trajectories) * static_cast<double>(factors.size() + 1);
  if (factors.empty() || !allowance.allows(most, place_of(ranges), "morris", faults)) return made;
  Visited visited(factors, base);
  for (std::size_t t = 1; t <= trajectories; ++t) {
    Trajectory trajectory(factors, seed, t);
    std::size_t from = visited.set_of(trajectory, fmt::format("trajectory {}, start", t), made.drafts);
    for (std::size_t i = 0; i < factors.size(); ++i) {
      const std::size_t f = trajectory.order()[i];
      const double size = trajectory.change(f);
      const std::size_t to = visited.set_of(trajectory, fmt::format("trajectory {}, step {}", t, i + 1), made.drafts);
      made.steps.push_back({Design::morris, std::string(factors[f].row->path), t, from, to, size});
      from = to;
    }
  }
  return made;
}

} // namespace matrigrate::study
