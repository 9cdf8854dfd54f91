#include "study_plan/sweep.hpp"

#include "base/random.hpp"
#include "parameters/assign.hpp"
#include "parameters/document.hpp"
#include "store/trajectory_hash.hpp"
#include "study_plan/names.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>
#include <numeric>
#include <unordered_map>
#include <unordered_set>

namespace matrigrate::study {

namespace {

constexpr int usual_digits = 6, most_digits = 17;

double rounded(double value, int digits) {
  const std::string text = fmt::format("{:.{}g}", value, digits);
  double number = 0.0;
  std::from_chars(text.data(), text.data() + text.size(), number);
  return number;
}

/// A range that is sampled, in the unit of the row: ["low", "high"] or ["low", "high", "log"].
struct Span {
  const Row* row;
  Place place;
  double low = 0.0;
  double high = 0.0;
  bool log = false;

  /// The value at a share of the way from low to high, on the scale of the range.
  double at(double share) const { return log ? low * std::pow(high / low, share) : low + share * (high - low); }
  /// Where a value lies: the inverse of at().
  double share(double value) const {
    return log ? std::log(value / low) / std::log(high / low) : (value - low) / (high - low);
  }
};

/// The range that stands behind a parameter; none, and faults, if it is none.
std::optional<Span> span_of(const Named& named, const Parameters& base, FaultList& faults) {
  const Row& row = *named.row;
  const auto complain = [&](std::string message) {
    faults.add(*named.node, row.path, std::move(message));
    return std::nullopt;
  };
  const toml::array* list = named.node->as_array();
  const std::string such = fmt::format("such as [{0}, {0}] or [{0}, {0}, \"log\"]", value_text(row, base));
  if (!number_in_unit(row, base)) return complain("is no number, and has no range");
  if (list == nullptr || list->size() < 2 || list->size() > 3)
    return complain(fmt::format("is {}, but a range of low and high is expected, {}", type_of(*named.node), such));
  Span span{&row, Place(*named.node)};
  if (list->size() == 3) {
    if (list->get(2)->value_or(std::string()) != "log") return complain("the third of a range can only be \"log\"");
    span.log = true;
  }
  Parameters low = base;
  Parameters high = base;
  const auto first = assigned(row, *list->get(0), low, faults);
  const auto second = assigned(row, *list->get(1), high, faults);
  if (!first || !second) return std::nullopt;
  span.low = *number_in_unit(row, low);
  span.high = *number_in_unit(row, high);
  if (!(span.low < span.high)) return complain(fmt::format("{} is not below {}", first->value, second->value));
  if (span.log && !(span.low > 0.0)) return complain("a logarithmic range must start above 0");
  return span;
}

/// A number rounded to some digits, or to an integer, as if typed.
Given given_number(const Row& row, double value, int digits) {
  if (kind(row) == Kind::quantity) return {fmt::format("{:.{}g} {}", value, digits, row.unit), "a string"};
  if (kind(row) == Kind::integer) return {static_cast<std::int64_t>(std::llround(value)), "a number"};
  return {rounded(value, digits), "a number"};
}

/// The digits that keep a rounded value in its stratum of n of a range, at least the usual ones; none if the range is
/// too narrow for n values.
/// @param share  of the way from low to high, in [0, 1)
std::optional<int> digits_for_stratum(const Span& span, double share, std::size_t n) {
  if (kind(*span.row) == Kind::integer) return usual_digits; // several samples may have the same one
  const double strata = static_cast<double>(n), value = span.at(share);
  for (int digits = usual_digits; digits <= most_digits; ++digits)
    if (std::floor(span.share(rounded(value, digits)) * strata) == std::floor(share * strata)) return digits;
  const bool at_its_edge = std::abs(span.share(value) - share) * strata < 1e-6;
  return at_its_edge ? std::optional(most_digits) : std::nullopt;
}

/// A count as people write it, also beyond any integer.
std::string count_text(double count) {
  return count < 1e15 ? fmt::format("{:.0f}", count) : fmt::format("{:.2g}", count);
}

/// A parameter with a list of values.
struct ValueList {
  const Row* row;
  std::vector<const toml::node*> nodes;
  std::vector<Setting> settings;
};

/// The lists of a section. Faults: no list, an empty list, a wrong value, a value listed twice.
std::vector<ValueList> value_lists(const toml::table& sweep, const Parameters& base, FaultList& faults) {
  std::vector<ValueList> all;
  for (const Named& named : named_parameters(sweep, "sweep", {}, base, faults)) {
    const toml::array* list = named.node->as_array();
    if (list == nullptr || list->empty()) {
      faults.add(*named.node, named.row->path,
                 fmt::format("is {}, but a list of values is expected, such as [{}]",
                             list == nullptr ? type_of(*named.node) : "empty", value_text(*named.row, base)));
      continue;
    }
    if (list->size() > max_runs) {
      faults.add(*named.node, named.row->path, fmt::format("has {} values; allowed are {}", list->size(), max_runs));
      continue;
    }
    ValueList& axis = all.emplace_back(ValueList{named.row, {}, {}});
    std::unordered_set<std::string> listed;
    for (const toml::node& value : *list) {
      Parameters scratch = base;
      const auto setting = assigned(*named.row, value, scratch, faults);
      if (!setting) continue;
      if (!listed.insert(meaning_text(*named.row, scratch)).second)
        faults.add(value, named.row->path, fmt::format("{} is listed twice", setting->value));
      axis.nodes.push_back(&value);
      axis.settings.push_back(*setting);
    }
    if (axis.settings.empty()) all.pop_back(); // all of them at fault
  }
  return all;
}

std::string label_in(const toml::table& table, FaultList& faults) {
  const toml::node* node =
      faults.wanted(table, "conditions", "label", "; write label = \"soft\", the name for targets");
  if (node == nullptr) return {};
  std::string label = faults.text(*node, "conditions.label");
  if (label.empty() && node->is_string()) faults.add(*node, "conditions.label", "is empty");
  return label;
}

void check_twins(const std::vector<ConditionDraft>& all, FaultList& faults) {
  std::map<std::string, int> labels;
  std::map<std::string, int> seen;
  for (const ConditionDraft& draft : all) {
    const std::string& label = draft.condition.label;
    if (!label.empty() && labels[label]++ > 0)
      faults.add(draft.place, "conditions", fmt::format("\"{}\" is the label of two conditions", excerpt(label)));
    if (seen[draft.meaning]++ > 0)
      faults.add(draft.place, "conditions", fmt::format("\"{}\": is the same as another condition", excerpt(label)));
  }
}

} // namespace

void name_sets(std::vector<Draft>& sets, const std::vector<Condition>& conditions) {
  std::unordered_set<std::string> keys;
  const auto take = [&](const std::vector<Setting>& settings) {
    for (const Setting& s : settings) keys.insert(s.key);
  };
  for (const Draft& draft : sets) take(draft.point.settings);
  for (const Condition& condition : conditions) take(condition.settings);
  const Names names({keys.begin(), keys.end()});
  std::vector<Draft*> unnamed;
  for (Draft& draft : sets)
    if (draft.point.label.empty()) unnamed.push_back(&draft);
  for (Draft* draft : unnamed) draft->point.label = label_of(draft->point.settings, names);
  std::unordered_map<std::string, int> count;
  for (const Draft& draft : sets) ++count[draft.point.label];
  for (Draft* draft : unnamed)
    if (count[draft->point.label] > 1) draft->point.label = label_of(draft->point.settings, names, true);
}

bool Allowance::allows(double more, Place place, std::string_view key, FaultList& faults) {
  m_points += more;
  const double points = m_points * static_cast<double>(std::max<std::size_t>(1, m_conditions));
  const double runs = points * static_cast<double>(m_replicates);
  if (runs <= static_cast<double>(max_runs)) return true;
  const std::string made = m_conditions > 0
                               ? fmt::format("{} factor sets; with {} conditions and {} replicates",
                                             count_text(m_points), m_conditions, m_replicates)
                               : fmt::format("{} points; with {} replicates", count_text(m_points), m_replicates);
  faults.add(place, key, fmt::format("makes {} these are {} runs; allowed are {}", made, count_text(runs), max_runs));
  return false;
}

std::vector<Draft> grid_points(const toml::table& sweep, const Parameters& base, Allowance& allowance,
                               FaultList& faults) {
  const std::vector<ValueList> all = value_lists(sweep, base, faults);
  if (all.empty()) return {};
  double product = 1.0;
  for (const ValueList& axis : all) product *= static_cast<double>(axis.nodes.size());
  if (!allowance.allows(product, Place(sweep), "sweep", faults)) return {};
  const auto count = static_cast<std::size_t>(product);
  std::vector<Draft> drafts(count);
  for (std::size_t i = 0; i < count; ++i) {
    Draft& draft = drafts[i];
    draft.point.parameters = base;
    std::size_t block = count;
    for (const ValueList& axis : all) {
      block /= axis.nodes.size();
      const std::size_t k = i / block % axis.nodes.size();
      assign(*axis.row, given_by(*axis.nodes[k]), draft.point.parameters);
      draft.point.settings.push_back(axis.settings[k]);
      draft.settings.emplace_back(axis.row->path, *axis.nodes[k]);
    }
    draft.place = draft.settings.front().second;
  }
  return drafts;
}

std::vector<Draft> listed_points(const toml::array& points, const Parameters& base, Allowance& allowance,
                                 FaultList& faults) {
  std::vector<Draft> drafts;
  if (!allowance.allows(static_cast<double>(points.size()), Place(points), "points", faults)) return drafts;
  for (const toml::node& node : points) {
    const toml::table* table = faults.table(node, "points", "table of parameters");
    if (table == nullptr) continue;
    Draft draft;
    draft.place = Place(node);
    draft.point.parameters = base;
    for (const Named& named : named_parameters(*table, "points", "label", base, faults))
      if (auto setting = assigned(*named.row, *named.node, draft.point.parameters, faults)) {
        draft.point.settings.push_back(std::move(*setting));
        draft.settings.emplace_back(named.row->path, *named.node);
      }
    if (const toml::node* label = table->get("label")) draft.point.label = faults.text(*label, "points.label");
    drafts.push_back(std::move(draft));
  }
  return drafts;
}

std::vector<double> stratified(std::size_t n, std::uint64_t seed) {
  std::vector<std::size_t> strip(n);
  std::iota(strip.begin(), strip.end(), std::size_t{0});
  for (std::size_t i = n; i-- > 1;) { // Fisher and Yates
    const double u = uniform(seed, Purpose::sampling, i, 0);
    std::swap(strip[i], strip[static_cast<std::size_t>(u * static_cast<double>(i + 1))]);
  }
  std::vector<double> places(n);
  for (std::size_t i = 0; i < n; ++i)
    places[i] = (static_cast<double>(strip[i]) + uniform(seed, Purpose::sampling, i, 1)) / static_cast<double>(n);
  return places;
}

std::vector<Draft> hypercube_points(const toml::table& hypercube, const Parameters& base, std::uint64_t seed,
                                    Allowance& allowance, FaultList& faults) {
  const toml::node* samples = hypercube.get("samples");
  if (samples == nullptr) faults.add(hypercube, "latin_hypercube.samples", "is missing; write samples = 50");
  const std::size_t n = samples == nullptr ? 0 : faults.whole(*samples, "latin_hypercube.samples", 1, max_runs);
  std::vector<Span> spans;
  for (const Named& named : named_parameters(hypercube, "latin_hypercube", "samples", base, faults))
    if (const auto span = span_of(named, base, faults)) spans.push_back(*span);
  if (spans.empty()) {
    if (faults.empty()) faults.add(hypercube, "latin_hypercube", "has no range of a parameter");
    return {};
  }
  if (!allowance.allows(static_cast<double>(n), Place(hypercube), "latin_hypercube.samples", faults)) return {};
  std::vector<Draft> drafts(n);
  for (Draft& draft : drafts) draft.point.parameters = base;
  for (const Span& span : spans) {
    const std::uint64_t key = std::stoull(store::text_hash(fmt::format("{} {}", seed, span.row->path)), nullptr, 16);
    const std::vector<double> places = stratified(n, key);
    for (std::size_t i = 0; i < n; ++i) {
      Point& point = drafts[i].point;
      const std::optional<int> digits = digits_for_stratum(span, places[i], n);
      if (!digits) {
        faults.add(
            span.place, span.row->path,
            fmt::format("the range is too narrow for {} different values; take fewer samples or a wider range", n));
        return {};
      }
      const std::string fault =
          assign(*span.row, given_number(*span.row, span.at(places[i]), *digits), point.parameters);
      if (!fault.empty()) faults.add(span.place, span.row->path, fault);
      point.settings.push_back({std::string(span.row->path), value_text(*span.row, point.parameters)});
      drafts[i].settings.emplace_back(span.row->path, span.place);
      drafts[i].place = span.place;
    }
  }
  for (std::size_t i = 0; i < n; ++i) drafts[i].point.label = fmt::format("sample {}", i + 1);
  return drafts;
}

std::vector<ConditionDraft> read_conditions(const toml::array& list, const Parameters& base, FaultList& faults) {
  std::vector<ConditionDraft> all;
  if (list.size() > max_runs)
    faults.add(list, "conditions", fmt::format("has {} conditions; allowed are {}", list.size(), max_runs));
  if (list.size() > max_runs) return all;
  for (const toml::node& node : list) {
    const toml::table* table = faults.table(node, "conditions", "table of parameters");
    if (table == nullptr) continue;
    ConditionDraft& draft = all.emplace_back(ConditionDraft{{label_in(*table, faults), {}}, node, {}, {}});
    Parameters p = base;
    for (const Named& named : named_parameters(*table, "conditions", "label", base, faults)) {
      auto setting = assigned(*named.row, *named.node, p, faults);
      if (!setting) continue;
      draft.condition.settings.push_back(std::move(*setting));
      draft.parameters.push_back(named);
    }
    draft.meaning = meaning_of(draft.condition.settings, p);
  }
  if (faults.empty()) check_twins(all, faults);
  return all;
}

std::vector<Draft> crossed(std::vector<Draft> sets, const std::vector<ConditionDraft>& conditions) {
  for (std::size_t i = 0; i < sets.size(); ++i) sets[i].point.set = i;
  if (conditions.empty()) return sets;
  std::vector<Draft> points;
  points.reserve(sets.size() * conditions.size());
  for (const Draft& set : sets)
    for (std::size_t c = 0; c < conditions.size(); ++c) {
      Draft& draft = points.emplace_back(set);
      draft.point.label = fmt::format("{}: {}", conditions[c].condition.label, set.point.label);
      draft.point.condition = c;
      const std::vector<Setting>& settings = conditions[c].condition.settings;
      draft.point.settings.insert(draft.point.settings.begin(), settings.begin(), settings.end());
      for (const Named& named : conditions[c].parameters) {
        assign(*named.row, given_by(*named.node), draft.point.parameters);
        draft.settings.emplace_back(named.row->path, *named.node);
      }
    }
  return points;
}

void check_overlaps(const toml::table& study, const std::vector<ConditionDraft>& conditions, const Parameters& base,
                    FaultList& faults) {
  std::map<std::string_view, std::string> set; // the first condition that sets a parameter
  for (const ConditionDraft& draft : conditions)
    for (const Named& named : draft.parameters) set.emplace(named.row->path, draft.condition.label);
  if (set.empty()) return;
  FaultList told(""); // elsewhere
  const auto check = [&](const toml::node* node, std::string_view section, std::string_view own) {
    if (node == nullptr || !node->is_table()) return;
    for (const Named& named : named_parameters(*node->as_table(), section, own, base, told)) {
      const auto found =
          std::ranges::find_if(set, [&](const auto& one) { return overlap(one.first, named.row->path); });
      if (found != set.end())
        faults.add(
            *named.node, named.row->path,
            fmt::format("is also set by the condition \"{}\"; a condition must not set a factor", found->second));
    }
  };
  check(study.get("sweep"), "sweep", {});
  check(study.get("latin_hypercube"), "latin_hypercube", "samples");
  if (const toml::array* points = study["points"].as_array())
    for (const toml::node& point : *points) check(&point, "points", "label");
}

} // namespace matrigrate::study
