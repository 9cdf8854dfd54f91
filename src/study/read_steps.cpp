#include "parameters/nearest.hpp"
#include "parameters/node.hpp"
#include "parameters/scan.hpp"
#include "study/design/designs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <unordered_map>

namespace matrigrate::study {

namespace {

const std::vector<std::string>& design_names() {
  static const std::vector<std::string> names{"one_at_a_time", "morris"};
  return names;
}

const std::vector<std::string>& step_keys() {
  static const std::vector<std::string> keys{"design", "factor", "trajectory", "from", "to", "size"};
  return keys;
}

class StepReader {
public:
  StepReader(const std::vector<FactorSet>& sets, FaultList& faults) : m_faults(faults) {
    for (std::size_t i = 0; i < sets.size(); ++i) m_index.emplace(sets[i].label, i);
  }

  Step read(const toml::table& table) {
    m_faults.check_keys(table, "steps", step_keys());
    Step step;
    if (const auto* node = wanted(table, "design"))
      step.design = static_cast<Design>(m_faults.choice(*node, "steps.design", design_names()));
    if (const auto* node = wanted(table, "factor")) step.factor = factor(*node);
    if (const auto* node = wanted(table, "from")) step.from = set(*node, "steps.from");
    if (const auto* node = wanted(table, "to")) step.to = set(*node, "steps.to");
    if (step.design == Design::one_at_a_time) return step;
    if (const auto* node = wanted(table, "trajectory"))
      step.trajectory = m_faults.whole(*node, "steps.trajectory", 1, max_runs);
    if (const auto* node = wanted(table, "size")) step.size = size(*node);
    return step;
  }

private:
  const toml::node* wanted(const toml::table& table, std::string_view key) {
    return m_faults.wanted(table, "steps", key);
  }

  std::string factor(const toml::node& node) {
    const std::string path = m_faults.text(node, "steps.factor");
    if (!path.empty() && find_row(path) == nullptr)
      m_faults.add(place_of(node), "steps.factor", fmt::format("there is no parameter {}", excerpt(path)),
                   [path] { return parameter_hint(path); });
    return path;
  }

  std::size_t set(const toml::node& node, std::string_view key) {
    const std::string label = m_faults.text(node, key);
    const auto found = m_index.find(label);
    if (found != m_index.end()) return found->second;
    m_faults.add(place_of(node), key, fmt::format("\"{}\" is not the label of a point", excerpt(label)));
    return 0;
  }

  double size(const toml::node& node) {
    const double size = m_faults.number(node, "steps.size").value_or(1.0);
    if (size != 0.0) return size;
    m_faults.add(place_of(node), "steps.size", "is 0, but a step changes its factor");
    return 1.0;
  }

  FaultList& m_faults;
  std::unordered_map<std::string, std::size_t> m_index;
};

} // namespace

std::string name(Design design) { return design_names()[static_cast<std::size_t>(design)]; }

std::vector<Step> read_steps(const toml::array& steps, const std::vector<FactorSet>& sets, FaultList& faults) {
  std::vector<Step> all;
  StepReader reader(sets, faults);
  for (const toml::node& node : steps) {
    const toml::table* table = node.as_table();
    if (table != nullptr)
      all.push_back(reader.read(*table));
    else
      faults.add(place_of(node), "steps", fmt::format("is {}, but a table is expected", type_of(node)));
  }
  return all;
}

} // namespace matrigrate::study
