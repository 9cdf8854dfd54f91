#include "parameters/assign.hpp"
#include "parameters/document.hpp"
#include "parameters/nearest.hpp"
#include "study_plan/claim.hpp"
#include "study_plan/read_study.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <set>
#include <sstream>

namespace matrigrate::study {

namespace {

const std::vector<std::string> kind_names{"calibration", "predicted", "verification", "experiment"};

bool has(const std::vector<std::string>& list, const std::string& one) {
  return std::ranges::find(list, one) != list.end();
}

/// The table, to be read again.
std::string text_of(const toml::table& table) {
  toml::array list;
  list.push_back(table);
  std::ostringstream text;
  text << toml::table{{"claims", list}} << "\n";
  return text.str();
}

class ClaimReader {
public:
  ClaimReader(const std::vector<Point>& points, const LabelsOf& labels_of, FaultList& faults)
      : m_labels_of(labels_of), m_faults(faults), m_readouts(all_readouts()), m_labels(all_labels(points)) {
    for (const ClaimRule& rule : claim_rules()) m_rules.push_back(rule.name);
  }

  Claim read(const toml::table& table) {
    static const std::vector<std::string> keys{
        "id", "kind", "sentence", "published", "conditions", "kind_with_first_closures", "closures"};
    m_faults.check_keys(table, "claims", keys);
    Claim claim;
    if (const auto* node = m_faults.wanted(table, "claims", "id", "; write id = \"A1\"")) claim.id = id(*node);
    if (const auto* node =
            m_faults.wanted(table, "claims", "sentence", "; write sentence = \"cells are faster in a stiff matrix\""))
      claim.sentence = text(*node, "claims.sentence");
    if (const auto* node = m_faults.wanted(table, "claims", "kind", "; write kind = \"predicted\""))
      claim.kind = static_cast<ClaimKind>(m_faults.choice(*node, "claims.kind", kind_names));
    if (const auto* node = table.get("closures"); node != nullptr && node->value<std::string>() != "second")
      m_faults.add(*node, "claims.closures", gone_with_first_closures);
    if (const auto* node = table.get("published")) claim.published = m_faults.text(*node, "claims.published");
    if (const auto* node =
            m_faults.wanted(table, "claims", "conditions", "; write conditions = [{ rule = \"differs\", ... }]"))
      claim.conditions = conditions(*node);
    claim.text = text_of(table);
    return claim;
  }

private:
  std::string text(const toml::node& node, std::string_view key) {
    std::string typed = m_faults.text(node, key);
    if (node.is_string() && typed.empty()) m_faults.add(node, key, "is empty");
    return typed;
  }

  std::string id(const toml::node& node) {
    std::string typed = text(node, "claims.id");
    if (!typed.empty() && !m_ids.insert(typed).second)
      m_faults.add(node, "claims.id", fmt::format("\"{}\" is the id of two claims", excerpt(typed)));
    return typed;
  }

  std::vector<ClaimCondition> conditions(const toml::node& node) {
    std::vector<ClaimCondition> all;
    const toml::array* list = node.as_array();
    if (list == nullptr || list->empty())
      m_faults.add(node, "claims.conditions", "is no list of conditions, each a table with a rule");
    else
      for (const toml::node& one : *list)
        if (const toml::table* table = m_faults.table(one, "claims.conditions"))
          std::ranges::move(condition(*table), std::back_inserter(all));
    return all;
  }

  static std::string full(std::string_view key) { return fmt::format("claims.conditions.{}", key); }

  /// One at each of the points that are listed.
  std::vector<ClaimCondition> condition(const toml::table& table) {
    const toml::node* typed = m_faults.wanted(table, "claims.conditions", "rule", "; write rule = \"differs\"");
    if (typed == nullptr) return {};
    const std::size_t index = m_faults.choice(*typed, full("rule"), m_rules);
    if (typed->value<std::string>() != m_rules[index]) return {};
    const std::vector<std::string>& needed = claim_rules()[index].keys;
    std::vector<std::string> keys = needed;
    keys.emplace_back("rule");
    if (!has(keys, "to") && !has(keys, "at")) keys.emplace_back("study");
    keys.emplace_back("of_edition");
    std::vector<std::string> known = keys;
    known.emplace_back("edition"); // of earlier versions
    m_faults.check_keys(table, "claims.conditions", known,
                        fmt::format("\"{}\" has no such key; it has {}", m_rules[index], fmt::join(keys, ", ")));
    for (const std::string& key : needed)
      m_faults.wanted(table, "claims.conditions", key,
                      fmt::format("; \"{}\" needs {}", m_rules[index], fmt::join(needed, ", ")));
    ClaimCondition c{.rule = &claim_rules()[index]};
    for (const std::string& key : keys)
      if (const toml::node* node = table.get(key)) take(key, *node, c);
    if (has(keys, "low") && table.contains("low") && table.contains("high") && !(c.value < c.high))
      m_faults.add(*table.get("low"), full("low"), "is not below high");
    if (const toml::node* edition = table.get("edition"); // of the rules, of which earlier versions had two
        edition != nullptr && m_faults.choice(*edition, full("edition"), {"first", "second", "both"}) == 0)
      return {};
    return at_points(table, c);
  }

  void take(const std::string& key, const toml::node& node, ClaimCondition& c) {
    const auto number = [&] { return m_faults.number(node, full(key)).value_or(0.0); };
    if (key == "readout" || key == "with" || key == "over")
      (key == "readout" ? c.readout : c.other) = m_readouts[m_faults.choice(node, full(key), m_readouts)];
    else if (key == "sign")
      c.sign = static_cast<Sign>(m_faults.choice(node, full(key), {"up", "down"}));
    else if (key == "value" || key == "bound" || key == "low")
      c.value = number();
    else if (key == "high")
      c.high = number();
    else if (key == "runs")
      c.runs = static_cast<double>(m_faults.whole(node, full(key), 1, 1'000'000));
    else if (key == "share")
      c.share = share(node);
    else if (key == "of_edition")
      c.edition = static_cast<ClaimEdition>(m_faults.whole(node, full(key), 2, 3));
    else if (key == "study")
      c.study = study(node);
  }

  double share(const toml::node& node) {
    const auto value = m_faults.number(node, full("share"));
    if (value && !(*value > 0.0 && *value <= 1.0))
      m_faults.add(node, full("share"), fmt::format("{} is out of range; allowed is > 0 and <= 1", *value));
    return value.value_or(1.0);
  }

  std::string study(const toml::node& node) {
    std::string name = text(node, full("study"));
    if (!name.empty() && m_labels_of && !m_labels_of(name))
      m_faults.add(
          node, full("study"),
          fmt::format("there is no {0}.toml beside this file, and no study {0} of `matrigrate list`", excerpt(name)));
    return name;
  }

  /// The condition with each of the points that `at`, or `from` and `to`, list.
  std::vector<ClaimCondition> at_points(const toml::table& table, const ClaimCondition& c) {
    const toml::node* to = table.get("to") != nullptr ? table.get("to") : table.get("at");
    if (to == nullptr) return {c};
    const std::vector<PointName> ends = points(*to, table.contains("to") ? "to" : "at");
    std::vector<PointName> starts(1);
    if (const auto* from = table.get("from")) starts = points(*from, "from");
    if (ends.empty() || starts.empty()) return {};
    const std::size_t n = std::max(ends.size(), starts.size());
    if ((ends.size() != n && ends.size() != 1) || (starts.size() != n && starts.size() != 1))
      m_faults.add(
          *to, full("to"),
          fmt::format("lists {} points, but from lists {}; write as many, or one", ends.size(), starts.size()));
    std::vector<ClaimCondition> all(n, c);
    for (std::size_t i = 0; i < n; ++i) {
      all[i].from = starts[std::min(i, starts.size() - 1)];
      all[i].to = ends[std::min(i, ends.size() - 1)];
    }
    return all;
  }

  std::vector<PointName> points(const toml::node& node, std::string_view key) {
    std::vector<PointName> all;
    const toml::array* list = node.as_array();
    if (list == nullptr) return {point(node, key)};
    if (list->empty()) m_faults.add(node, full(key), "lists no point");
    for (const toml::node& one : *list) all.push_back(point(one, key));
    return all;
  }

  PointName point(const toml::node& node, std::string_view key) {
    const std::string typed = m_faults.text(node, full(key));
    if (!node.is_string() || has(m_labels, typed)) return {"", typed};
    std::vector<std::string> known = m_labels;
    if (const std::size_t colon = typed.find(": "); colon != std::string::npos) {
      PointName other{typed.substr(0, colon), typed.substr(colon + 2)};
      if (!m_labels_of) return other;
      if (const auto labels = m_labels_of(other.study)) {
        if (has(*labels, other.label)) return other;
        known.clear();
        for (const std::string& label : *labels) known.push_back(fmt::format("{}: {}", other.study, label));
      }
    }
    m_faults.add(
        node, full(key),
        fmt::format("\"{}\" is not the label of a point; the labels are {}", excerpt(typed), quoted_list(known)),
        [typed, known] { return did_you_mean(nearest(typed, known)); });
    return {"", typed};
  }

  const LabelsOf& m_labels_of;
  FaultList& m_faults;
  std::vector<std::string> m_readouts;
  std::vector<std::string> m_labels;
  std::vector<std::string> m_rules;
  std::set<std::string> m_ids;
};

double alpha_of(const toml::node& node, const std::string& key, FaultList& faults) {
  const auto value = node.value<double>();
  if (value && *value > 0.0 && *value <= 0.5) return *value;
  faults.add(node, key,
             value ? fmt::format("{} is out of range; allowed is > 0 and <= 0.5", *value)
                   : fmt::format("is {}, but a number without quotes is expected, such as 0.05", type_of(node)));
  return Comparisons{}.alpha;
}

void check_control(const Comparisons& c, const toml::table& table, const std::vector<Point>& points,
                   FaultList& faults) {
  if (c.pairs != Pairs::control) return;
  const toml::node* node = table.get("control");
  const std::vector<std::string> labels = all_labels(points);
  if (has(labels, c.control)) return;
  const std::string what = node == nullptr ? std::string("is missing: the label")
                                           : fmt::format("\"{}\" is not the label", excerpt(c.control));
  faults.add(node == nullptr ? *table.get("compare") : *node, "statistics.control",
             fmt::format("{} of a point; the labels are {}{}", what, quoted_list(labels),
                         did_you_mean(nearest(c.control, labels))));
}

} // namespace

std::vector<std::string> Claim::studies() const {
  std::vector<std::string> names{study};
  for (const ClaimCondition& c : conditions)
    for (const std::string& name : {c.study, c.from.study, c.to.study})
      if (!name.empty() && !has(names, name)) names.push_back(name);
  return names;
}

bool Claim::depends_on(const std::string& of_study, const std::string& label) const {
  const auto is = [&](const std::string& name) { return (name.empty() ? study : name) == of_study; };
  return std::ranges::any_of(conditions, [&](const ClaimCondition& c) {
    const bool names_points = !c.from.label.empty() || !c.to.label.empty();
    if (!names_points) return is(c.study);
    return (c.from.label == label && is(c.from.study)) || (c.to.label == label && is(c.to.study));
  });
}

bool Claim::has_editions() const {
  return std::ranges::any_of(conditions, [](const ClaimCondition& c) { return c.edition.has_value(); });
}

std::string kind_name(ClaimKind kind) { return kind_names[static_cast<std::size_t>(kind)]; }

std::vector<Claim> read_claims(const toml::array& list, const std::vector<Point>& points, const LabelsOf& labels_of,
                               FaultList& faults) {
  std::vector<Claim> all;
  ClaimReader reader(points, labels_of, faults);
  for (const toml::node& node : list)
    if (const toml::table* table = faults.table(node, "claims")) all.push_back(reader.read(*table));
  return all;
}

Comparisons read_comparisons(const toml::table& table, const std::vector<Point>& points, FaultList& faults) {
  Comparisons c;
  faults.check_keys(table, "statistics", {"compare", "test", "control", "alpha"});
  if (const auto* node = table.get("compare"))
    c.pairs = static_cast<Pairs>(faults.choice(*node, "statistics.compare", pairs_names));
  if (const auto* node = table.get("test"))
    c.test = static_cast<TestKind>(faults.choice(*node, "statistics.test", test_names));
  if (const auto* node = table.get("control")) c.control = faults.text(*node, "statistics.control");
  if (const auto* node = table.get("alpha")) c.alpha = alpha_of(*node, "statistics.alpha", faults);
  check_control(c, table, points, faults);
  return c;
}

} // namespace matrigrate::study
