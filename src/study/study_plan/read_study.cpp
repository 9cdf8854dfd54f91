#include "study_plan/read_study.hpp"

#include "fields/grids.hpp"
#include "parameters/assign.hpp"
#include "parameters/changes.hpp"
#include "parameters/document.hpp"
#include "parameters/laws/constants.hpp"
#include "parameters/nearest.hpp"
#include "parameters/presets.hpp"
#include "parameters/read.hpp"
#include "parameters/version.hpp"
#include "study_plan/sweep.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <stdexcept>
#include <unordered_map>

namespace matrigrate::study {

namespace {

constexpr std::uint64_t largest_seed = (std::uint64_t{1} << 53U) - 1;

/// What stands at the top of a file.
const std::vector<std::string> known_keys{"title",  "scenario", "preset",     "replicates", "seed",
                                          "set",    "readouts", "conditions", "statistics", "common_random_numbers",
                                          "points", "claims",   "targets",    "sweep",      "latin_hypercube"};

/// What replaces the sections of earlier versions.
const std::map<std::string_view, std::string> replaced{
    {"one_at_a_time",
     "is no design any more; list the base and each value alone as [[points]], or draw ranges by [latin_hypercube], of "
     "which matrigrate.calibrate.fit tells how much each parameter matters"},
    {"in_place_of", gone_with_first_closures},
    {"morris", "is no design any more; draw the ranges by [latin_hypercube], of which matrigrate.calibrate.fit tells "
               "how much each parameter matters"},
    {"steps", "belong to a design that is no more; leave them out: the points and their runs stay. A [latin_hypercube] "
              "and matrigrate.calibrate.fit tell how much each parameter matters"},
    {"outcomes", "have gone; write [[targets]], or give the numbers by condition to matrigrate.calibrate.fit"}};

/// The rules on several parameters, at the points of a study.
class RuleCheck {
public:
  /// @param more  rules besides rules(), which take long: each is judged once for the same values of its parameters,
  ///              and for the first 1000 values only. The runs themselves are checked again.
  RuleCheck(std::span<const Rule> more, FaultList& faults) : m_more(more), m_faults(faults) {}

  /// Faults for the rules that p breaks.
  /// @param places  of parameters in the file; the first one of a rule that is among them is blamed
  void check(const Parameters& p, const Places& places) {
    if (!check(p, "", places)) return;
    for (const Period& period : periods(p)) check(period.p, fmt::format("from {} on: ", period.when), places);
  }

private:
  /// @param when  in front of each fault   @return whether there is none
  bool check(const Parameters& p, const std::string& when, const Places& places) {
    Judgement judgement;
    bool good = true;
    const auto tell = [&](const Rule& rule, const std::string& broken) {
      if (!broken.empty()) blame(rule, when + broken, places);
      good = good && broken.empty();
    };
    for (const Rule& rule : rules()) tell(rule, judgement(rule, p, [&](const Rule& r) { return r.broken(p); }));
    for (const Rule& rule : m_more) tell(rule, judgement(rule, p, [&](const Rule& r) { return found(r, p); }));
    return good;
  }

  std::string found(const Rule& rule, const Parameters& p) {
    constexpr std::size_t most = 1000;
    std::string given(rule.name);
    for (const std::string_view key : rule.keys) given += fmt::format("\n{} = {}", key, value_text(*find_row(key), p));
    const auto known = m_found.find(given);
    if (known != m_found.end()) return known->second;
    return m_found.size() < most ? m_found.emplace(std::move(given), rule.broken(p)).first->second : std::string();
  }

  void blame(const Rule& rule, const std::string& broken, const Places& places) {
    auto blamed = places.end();
    if (rule.is_of_first) blamed = std::ranges::find(places, rule.keys.front(), &Places::value_type::first);
    if (blamed == places.end())
      blamed = std::ranges::find_if(places, [&](const auto& known) {
        return std::ranges::any_of(rule.keys, [&](std::string_view key) { return overlap(key, known.first); });
      });
    if (blamed == places.end())
      m_faults.add({}, rule.keys.front(), broken);
    else
      m_faults.add(blamed->second, blamed->first, said_of(rule, blamed->first, broken));
  }

  std::span<const Rule> m_more;
  FaultList& m_faults;
  std::unordered_map<std::string, std::string> m_found; ///< what is wrong, by rule and values
};

class Reader {
public:
  Reader(std::string name, std::filesystem::path folder, const Changes& changes)
      : m_faults(std::move(name)), m_folder(std::move(folder)), m_changes(changes) {}

  Study read(std::string_view text) {
    m_table = table_of(text, m_faults.file());
    m_written_out = is_written_out(text);
    if (m_written_out) m_gone = follow_gone(m_table, scenario_table());
    refuse_scenario();
    check_keys();
    read_head();
    read_base();
    read_points();
    read_targets();
    read_statistics();
    require_room();
    m_faults.raise();
    return std::move(m_study);
  }

private:
  const toml::node* get(std::string_view key) const { return m_table.get(key); }

  /// The scenario of the study as its file has it; empty if it cannot be read, which is told later.
  toml::table scenario_table() const {
    const auto name = m_table["scenario"].value<std::string>();
    if (!name) return {};
    try {
      return table_of(read_document(m_folder / *name, largest_file), *name);
    } catch (const std::runtime_error&) {
      return {};
    }
  }

  /// What points of an earlier version say by parameters that have gone: readings are kept for who reads what was made,
  /// and the seeds follow from what stood there.
  void take_gone(std::vector<Draft>& drafts) {
    for (Draft& draft : drafts) {
      const auto found = m_gone.find(draft.place);
      if (found == m_gone.end()) continue;
      Point& point = draft.point;
      point.seeded_by = point.settings;
      for (const auto& [path, value] : found->second) {
        const Gone& parameter = *find_gone(path);
        std::erase_if(point.seeded_by, [&](const Setting& s) { return s.key == parameter.law; });
        point.seeded_by.push_back({path, value});
        if (!parameter.law.empty() || parameter.is_drawing) continue;
        point.parameters.origin.gone.erase(path);
        if (value == parameter.left) continue;
        point.parameters.origin.gone.emplace(path, value);
        if (!m_changes.more.empty()) m_faults.add(draft.place, path, gone_text(value, parameter));
      }
    }
  }

  /// The table of that name; null, and a fault if something else stands there.
  const toml::table* section(std::string_view key) {
    const toml::node* node = get(key);
    if (node == nullptr || node->is_table()) return node == nullptr ? nullptr : node->as_table();
    m_faults.add(*node, key, fmt::format("is {}, but a section [{}] is expected", type_of(*node), key));
    return nullptr;
  }

  /// The array of tables of that name; null, and a fault if something else stands there.
  const toml::array* list(std::string_view key, std::string_view what) {
    const toml::node* node = get(key);
    if (node == nullptr || node->is_array()) return node == nullptr ? nullptr : node->as_array();
    m_faults.add(*node, key, fmt::format("is no list of {0}; write [[{0}]] and {1} below", key, what));
    return nullptr;
  }

  /// One fault for a file that is a scenario, in place of one for each of its sections.
  void refuse_scenario() {
    const auto of_scenario = [](const auto& entry) {
      return std::ranges::any_of(sections(), [&](const Section& s) { return s.name == entry.first.str(); });
    };
    if (is_study(m_table) || get("scenario") || get("preset") || std::ranges::none_of(m_table, of_scenario)) return;
    m_faults.add({}, "",
                 fmt::format("is a scenario of one run, and not a study; matrigrate run {0} computes it. A study names "
                             "it, scenario = \"{0}\", and what varies: docs/studies.md",
                             m_faults.file()));
    m_faults.raise();
  }

  void check_keys() {
    for (const auto& [name, node] : m_table) {
      const std::string key(name.str());
      if (std::ranges::find(known_keys, key) != known_keys.end()) continue;
      if (const auto instead = replaced.find(key); instead != replaced.end())
        m_faults.add(name, key, instead->second);
      else
        m_faults.add(name, key, fmt::format("a study has no such {}", node.is_table() ? "section" : "key"),
                     [key] { return did_you_mean(nearest(key, known_keys)); });
    }
  }

  /// Of the base and of all points, with what was read of their files.
  void complete_fields_of_sections() {
    if (!m_study.base.grids) m_study.base.grids = std::make_shared<fields::Grids>();
    const auto complete = [&](toml::table& table) { complete_fields(table, m_folder, *m_study.base.grids, m_faults); };
    for (const char* key : {"set", "sweep"})
      if (toml::table* table = m_table[key].as_table()) complete(*table);
    for (const char* key : {"points", "conditions"})
      if (toml::array* list = m_table[key].as_array())
        for (toml::node& node : *list)
          if (toml::table* table = node.as_table()) complete(*table);
  }

  void read_head() {
    if (const auto* node = get("title")) m_study.title = m_faults.text(*node, "title");
    if (const auto* node = get("seed")) m_study.seed = m_faults.whole(*node, "seed", 0, largest_seed);
    if (const auto* node = get("common_random_numbers"))
      m_study.common_random_numbers = m_faults.flag(*node, "common_random_numbers");
    if (const auto* node = get("replicates"))
      m_study.replicates = m_faults.whole(*node, "replicates", 1, max_runs);
    else
      m_faults.add({}, "replicates", "is missing; write replicates = 12, the runs at each point");
    if (m_changes.replicates) m_study.replicates = *m_changes.replicates;
    read_readouts();
  }

  void read_readouts() {
    const toml::node* node = get("readouts");
    m_study.readouts = default_readouts();
    if (node == nullptr) return;
    const toml::array* list = node->as_array();
    if (list == nullptr || list->empty())
      return m_faults.add(*node, "readouts", "is no list of names, such as [\"n_protrusions\"]");
    m_study.readouts.clear();
    const std::vector<std::string> names = all_readouts();
    if (list->size() > names.size())
      return m_faults.add(*node, "readouts",
                          fmt::format("has {} names, but there are {} read-outs", list->size(), names.size()));
    for (const toml::node& entry : *list) m_study.readouts.push_back(names[m_faults.choice(entry, "readouts", names)]);
  }

  void read_base() {
    const toml::node* scenario = get("scenario");
    const toml::node* preset = get("preset");
    if ((scenario == nullptr) == (preset == nullptr))
      m_faults.add(preset == nullptr ? Place{} : Place(*preset), "scenario",
                   fmt::format("{}; a study has one of scenario = \"FILE.toml\" and preset = \"NAME\"",
                               preset == nullptr ? "is missing" : "is given together with a preset"));
    if (preset != nullptr) read_preset(*preset);
    try {
      if (scenario != nullptr && preset == nullptr) read_scenario(*scenario);
    } catch (const ConfigurationError& error) {
      m_faults.add(error.faults());
    }
    complete_fields_of_sections();
    fix_parameters();
    try {
      if (m_faults.empty() && !m_changes.overrides.empty())
        m_study.base = apply_overrides(m_study.base, m_changes.overrides);
    } catch (const ConfigurationError& error) {
      m_faults.add(error.faults());
    }
  }

  void read_scenario(const toml::node& node) {
    const std::string name = m_faults.text(node, "scenario");
    if (name.empty()) return;
    const std::filesystem::path file(name);
    try {
      const std::filesystem::path path = file.is_absolute() ? file : m_folder / file;
      m_study.base = m_written_out ? read_unjudged(path) : read_parameters(path);
    } catch (const InputOutputError& error) {
      throw InputOutputError(
          to_string(Fault{m_faults.file(), Place(node).line, Place(node).column, "scenario", error.what()}));
    }
    if (!m_changes.more.empty()) m_faults.add(faults_of_gone(m_study.base, (m_folder / file).string()));
  }

  void read_preset(const toml::node& node) {
    std::vector<std::string> names;
    for (const Preset& preset : presets()) names.emplace_back(preset.name);
    m_study.base = parameters_of(presets()[m_faults.choice(node, "preset", names)]);
  }

  /// Constants of the laws that stand alone in [set], which defines those that the scenario has not.
  void define_constants() {
    toml::table* laws = m_table["set"]["laws"].as_table();
    toml::table* constants = laws == nullptr ? nullptr : (*laws)["constants"].as_table();
    if (constants == nullptr) return;
    for (const auto& [name, node] : *constants) {
      const std::string path = fmt::format("laws.constants.{}", name.str());
      if (std::string fault = define_constant(name.str(), node, m_study.base); !fault.empty())
        m_faults.add(node, path, std::move(fault));
      m_fixed.emplace_back(path, node);
    }
    laws->erase("constants");
  }

  void fix_parameters() {
    const toml::table* fixed = section("set");
    if (fixed == nullptr) return;
    define_constants();
    for (const Named& named : named_parameters(*fixed, "set", {}, m_study.base, m_faults)) {
      assigned(*named.row, *named.node, m_study.base, m_faults);
      m_fixed.emplace_back(named.row->path, *named.node);
    }
  }

  void read_points() {
    std::vector<ConditionDraft> conditions;
    if (const auto* tables = list("conditions", "a label and parameters"))
      conditions = read_conditions(*tables, m_study.base, m_faults);
    Allowance allowance(m_study.replicates, conditions.size());
    std::vector<Draft> sets = read_sets(allowance);
    for (const ConditionDraft& draft : conditions) m_study.conditions.push_back(draft.condition);
    name_sets(sets, m_study.conditions);
    check_overlaps(m_table, conditions, m_study.base, m_faults);
    for (const Draft& draft : sets) m_study.sets.push_back({draft.point.label, draft.point.settings});
    std::vector<Draft> points = crossed(std::move(sets), conditions);
    take_gone(points);
    check_points(points);
    for (Draft& draft : points) m_study.points.push_back(std::move(draft.point));
  }

  std::vector<Draft> read_sets(Allowance& allowance) {
    std::vector<Draft> drafts;
    const auto take = [&](std::vector<Draft> more) { std::ranges::move(more, std::back_inserter(drafts)); };
    if (const auto* sweep = section("sweep")) take(grid_points(*sweep, m_study.base, allowance, m_faults));
    if (const auto* points = list("points", "its parameters"))
      take(listed_points(*points, m_study.base, allowance, m_faults));
    if (const auto* hypercube = section("latin_hypercube"))
      take(hypercube_points(*hypercube, m_study.base, m_study.seed, allowance, m_faults));
    if (drafts.empty()) drafts.emplace_back().point.parameters = m_study.base;
    return drafts;
  }

  void read_targets() {
    if (const auto* tables = list("targets", "a readout, its value and error"))
      m_study.targets = study::read_targets(*tables, m_study.conditions, m_folder, m_faults);
  }

  void check_points(const std::vector<Draft>& drafts) {
    if (!m_faults.empty()) return; // a rule would judge a default that nobody chose
    RuleCheck rule_check(m_changes.more, m_faults);
    std::vector<std::pair<std::string, std::string>> seen; // settings and labels
    for (const Draft& draft : drafts) {
      std::string settings = meaning_of(draft.point.settings, draft.point.parameters);
      for (const auto& [path, value] : draft.point.parameters.origin.gone) settings += path + " = " + value + "\n";
      seen.emplace_back(std::move(settings), draft.point.label);
      Places places = draft.settings;
      places.insert(places.end(), m_fixed.begin(), m_fixed.end());
      rule_check.check(draft.point.parameters, places);
    }
    const auto twice = [&](auto part, std::string_view what) {
      std::vector<std::size_t> order(seen.size());
      for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
      std::ranges::stable_sort(order, {}, [&](std::size_t i) { return seen[i].*part; });
      std::map<Place, std::vector<std::size_t>> found; // a design has one place for all
      for (std::size_t k = 1; k < order.size(); ++k)
        if (seen[order[k]].*part == seen[order[k - 1]].*part) found[drafts[order[k]].place].push_back(order[k]);
      for (const auto& [place, same] : found)
        m_faults.add(place, "points",
                     fmt::format("\"{}\": {}{}", excerpt(seen[same.front()].second), what,
                                 same.size() == 1 ? "" : fmt::format(", and so are {} more", same.size() - 1)));
    };
    twice(&std::pair<std::string, std::string>::first, "is the same as another point");
    if (m_faults.empty()) twice(&std::pair<std::string, std::string>::second, "is the label of two points");
  }

  /// The file with all points written out must be one that can be read again.
  void require_room() {
    if (!m_faults.empty()) return;
    const std::size_t size = to_toml(m_study, "scenario.resolved.toml").size();
    if (size > largest_file)
      m_faults.add({}, "",
                   fmt::format("takes {} bytes with its {} points written out; allowed are {}", size,
                               m_study.points.size(), largest_file));
  }

  void read_statistics() {
    if (const toml::table* table = section("statistics"))
      m_study.comparisons = read_comparisons(*table, m_study.points, m_faults);
    if (const auto* tables = list("claims", "an id, a sentence and conditions"))
      m_study.claims = read_claims(*tables, m_study.points, m_changes.labels_of, m_faults);
  }

  FaultList m_faults;
  std::filesystem::path m_folder;
  Changes m_changes;
  toml::table m_table;
  bool m_written_out = false; ///< by the program, with all its points
  GoneValues m_gone;
  Study m_study;
  Places m_fixed; ///< parameters of [set]
};

} // namespace

Study parse_study(std::string_view text, const std::string& name, const std::filesystem::path& folder,
                  const Changes& changes) {
  return Reader(name, folder, changes).read(text);
}

Study read_study(const std::filesystem::path& file, const Changes& changes) {
  return parse_study(read_document(file, largest_file), file.string(), file.parent_path(), changes);
}

bool is_study_file(const std::filesystem::path& file) {
  return is_study(table_of(read_document(file, largest_file), file.string()));
}

} // namespace matrigrate::study
