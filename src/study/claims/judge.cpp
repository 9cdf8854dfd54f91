#include "claims/claims.hpp"

#include "observe/readout_table.hpp"
#include "statistics/compare.hpp"
#include "statistics/sample.hpp"
#include "study_plan/names.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

namespace matrigrate::study {

namespace {

/// What varies at a point, by its values: "50 Pa, n_prot 2"; the name stays where the value alone would not tell which
/// parameter is meant. A label that the study gives stays.
std::string brief_label(const Study& study, const Point& point) {
  if (point.set >= study.sets.size()) return point.label;
  const FactorSet& set = study.sets[point.set];
  const Names names(study);
  if (set.settings.empty()
      || (set.label != label_of(set.settings, names) && set.label != label_of(set.settings, names, true)))
    return point.label;
  std::vector<std::string> values;
  for (const Setting& setting : set.settings) {
    const bool is_last_word = setting.key.ends_with("." + names.of(setting.key));
    const std::string text = label_of({setting}, names);
    values.push_back(is_last_word ? text.substr(names.of(setting.key).size() + 1) : text);
  }
  const std::string text = fmt::format("{}", fmt::join(values, ", "));
  return study.conditions.empty() ? text : fmt::format("{}: {}", study.conditions[point.condition].label, text);
}

/// "speed, start to end (um/h)"
std::string readout_words(std::string_view readout) {
  const ReadOutSpec* spec = find_readout(readout);
  return spec == nullptr ? std::string(readout) : spec->meaning_with_unit();
}

/// The runs at one point of a study.
struct Group {
  std::string study;
  std::string label;
  const Ensemble* ensemble = nullptr; ///< null where there is no such study, or no such point of it
  std::size_t point = 0;
};

/// Gathers conditions; a claim holds if all of them are met, and is undecided where a group has fewer than two runs or
/// the runs that there are tell too little. Its sentences name points by the values that vary.
class Judge {
public:
  /// @param study  that conditions mean where they name none
  Judge(const Evidence& evidence, const std::string& study) : m_evidence(evidence), m_study(study) {}

  void add(const ClaimCondition& c) {
    const ClaimPoints points = c.rule->points;
    ClaimRuns runs;
    Group from, to;
    if (points == ClaimPoints::all) {
      runs.all = column(c, c.readout);
      if (!c.other.empty()) runs.other = column(c, c.other);
    } else if (points == ClaimPoints::curves) {
      runs.from_msd = curves(from = group(c.from));
      runs.to_msd = curves(to = group(c.to));
    } else {
      if (points == ClaimPoints::from_to) runs.from = values(from = group(c.from), c.readout);
      to = points == ClaimPoints::lowest || points == ClaimPoints::highest ? extreme(c) : group(c.to);
      if (!c.other.empty()) runs.excess = excess(to, c);
      runs.to = values(to, c.readout);
    }
    ClaimReading reading = c.rule->judge(c, runs);
    if (!reading.all_runs.empty()) {
      m_others.push_back(filled(reading.all_runs, c, from, to));
      m_ours.push_back(m_others.back());
    }
    reading.wanted = filled(reading.wanted, c, from, to);
    m_conditions.push_back(std::move(reading));
  }

  Finding finding() const {
    constexpr const char* too_few = "too few runs";
    Finding finding{.ours = m_ours, .conditions = {}, .brief = brief()};
    bool defined = !m_conditions.empty(), met = true, states_direction = false, direction = true, vague = false;
    for (const ClaimReading& c : corrected()) {
      const bool untold = c.met && c.vague;
      defined = defined && c.defined;
      met = met && c.met;
      vague = vague || untold;
      states_direction = states_direction || c.direction.has_value();
      direction = direction && c.direction.value_or(true);
      const std::string sentence = fmt::format("{} ({})", c.wanted, c.measured);
      finding.conditions.push_back(!c.defined ? fmt::format("{}: {}", c.wanted, too_few)
                                   : untold   ? sentence + ": too few runs to tell"
                                              : sentence + (c.met ? ": met" : ": not met"));
      if (c.defined && !c.met)
        finding.unmet.push_back(sentence);
      else if ((!c.defined || untold) && std::ranges::find(finding.unmet, too_few) == finding.unmet.end())
        finding.unmet.emplace_back(too_few);
      if (c.defined && c.against) finding.against.push_back(sentence);
    }
    finding.verdict = !defined || (met && vague)      ? Verdict::undecided
                      : met                           ? Verdict::holds
                      : states_direction && direction ? Verdict::in_direction
                                                      : Verdict::does_not_hold;
    return finding;
  }

private:
  /// A mean that a condition is about.
  struct Mean {
    Group group;
    std::string what;
    std::string value; ///< with its interval
  };

  const Ensemble* ensemble(const std::string& study) const {
    const auto found = m_evidence.find(study.empty() ? m_study : study);
    return found == m_evidence.end() ? nullptr : &found->second;
  }

  Group group(const PointName& name) const {
    const std::string study = name.study.empty() ? m_study : name.study;
    const Ensemble* known = ensemble(study);
    if (known == nullptr) return {study, study};
    const auto point = std::ranges::find(known->study.points, name.label, &Point::label);
    const std::string of_study = m_evidence.size() == 1 ? "" : study + ": ";
    if (point == known->study.points.end()) return {study, of_study + name.label + " (no such point)"};
    return {study, of_study + brief_label(known->study, *point), known,
            static_cast<std::size_t>(point - known->study.points.begin())};
  }

  void tell(const Group& g, const std::string& what, const statistics::Interval& mean, std::size_t n) {
    const std::string value = n < 2 ? fmt::format("{:.3g}", mean.value)
                                    : fmt::format("{:.3g} [{:.3g}, {:.3g}]", mean.value, mean.low, mean.high);
    const std::string text = fmt::format("{}: {} at {} (n = {})", what, n == 0 ? "no runs" : value, g.label, n);
    if (std::ranges::find(m_ours, text) != m_ours.end()) return;
    m_ours.push_back(text);
    if (n > 0) m_means.push_back({g, what, value});
  }

  std::vector<double> values(const Group& g, std::string_view readout) {
    if (g.ensemble == nullptr) return {};
    std::vector<double> x = sample(g.ensemble->results, g.point, readout);
    tell(g, readout_words(readout), statistics::mean_interval(x, claim_alpha), x.size());
    return x;
  }

  /// Mean square displacements of the runs at a point that have one.
  MsdCurves curves(const Group& g) {
    MsdCurves runs;
    if (g.ensemble == nullptr) return runs;
    const auto& [study, results, msd] = *g.ensemble;
    for (std::size_t k = 0; k < msd.size(); ++k)
      if (results[k].run.point == g.point && !msd[k].empty()) runs.push_back(msd[k]);
    tell(g, "slope of the mean curve of the square displacement, lags of 10 min to half the run",
         mean_curve_slope(runs, g.point), runs.size());
    return runs;
  }

  /// Of all runs of a study.
  std::vector<double> column(const ClaimCondition& c, std::string_view readout) const {
    std::vector<double> x;
    const Ensemble* known = ensemble(c.study);
    if (known == nullptr) return x;
    for (const Result& r : known->results) x.push_back(r.readouts.at(readout_column(readout)));
    return x;
  }

  /// The point with the lowest, or highest, mean: the first of them.
  Group extreme(const ClaimCondition& c) {
    const double sign = c.rule->points == ClaimPoints::lowest ? -1.0 : 1.0;
    const Ensemble* known = ensemble(c.study);
    Group found = group({c.study, ""});
    double best = std::nan("");
    if (known != nullptr)
      for (std::size_t i = 0; i < known->study.points.size(); ++i) {
        Group g = group({c.study, known->study.points[i].label});
        const double mean = statistics::moments(values(g, c.readout)).mean;
        if (i > 0 && !(sign * (mean - best) > 0.0)) continue;
        best = mean;
        found = std::move(g);
      }
    return found;
  }

  /// By how much the read-out is above the other one, in each run at a point that has both.
  std::vector<double> excess(const Group& g, const ClaimCondition& c) {
    std::vector<double> differences;
    if (g.ensemble == nullptr) return differences;
    values(g, c.other); // tells it
    for (const Result& r : g.ensemble->results)
      if (r.run.point == g.point)
        differences.push_back(r.readouts.at(readout_column(c.readout)) - r.readouts.at(readout_column(c.other)));
    return statistics::finite(differences);
  }

  /// A sentence of a rule with the names of what it is about.
  std::string filled(std::string_view sentence, const ClaimCondition& c, const Group& from, const Group& to) const {
    const std::pair<std::string_view, std::string> names[] = {{"$readout", readout_words(c.readout)},
                                                              {"$other", readout_words(c.other)},
                                                              {"$from", from.label},
                                                              {"$to", to.label},
                                                              {"$study", c.study.empty() ? m_study : c.study}};
    std::string text;
    for (std::string_view rest = sentence; !rest.empty();) {
      const auto name = std::ranges::find_if(names, [&](const auto& one) { return rest.starts_with(one.first); });
      text += name == std::end(names) ? std::string(1, rest.front()) : name->second;
      rest.remove_prefix(name == std::end(names) ? 1 : name->first.size());
    }
    return text;
  }

  /// All means if they are few, else the first and the last of each read-out, in the order of its points.
  std::string brief() const {
    constexpr std::size_t few = 5;
    std::vector<std::string> parts;
    std::vector<std::string> all;
    for (const Mean& m : m_means)
      if (std::ranges::find(all, m.what) == all.end()) all.push_back(m.what);
    for (const std::string& what : all) {
      std::vector<const Mean*> of;
      for (const Mean& m : m_means)
        if (m.what == what) of.push_back(&m);
      std::ranges::stable_sort(of, {}, [](const Mean* m) { return std::pair(m->group.study, m->group.point); });
      if (m_means.size() > few && of.size() > 2) of = {of.front(), of.back()};
      std::vector<std::string> values;
      for (const Mean* m : of) values.push_back(fmt::format("{} ({})", m->value, m->group.label));
      parts.push_back(fmt::format("{}: {}", what, fmt::join(values, ", ")));
    }
    parts.insert(parts.end(), m_others.begin(), m_others.end());
    return fmt::format("{}", fmt::join(parts, "; "));
  }

  /// The conditions, of which those of a family are met or not by their corrected p.
  std::vector<ClaimReading> corrected() const {
    std::vector<ClaimReading> all = m_conditions;
    for (const ClaimFamily family : {ClaimFamily::no_difference, ClaimFamily::agreement}) {
      std::vector<double> p;
      for (const ClaimReading& c : all)
        if (c.family == family) p.push_back(c.p);
      const std::vector<double> adjusted = statistics::holm(p);
      std::size_t next = 0;
      for (ClaimReading& c : all) {
        if (c.family != family) continue;
        const double corrected = adjusted[next++];
        c.met = c.close || !(corrected < claim_alpha);
        if (corrected != c.p && std::isfinite(corrected)) c.measured += fmt::format(", corrected {:.2g}", corrected);
        if (c.close && corrected < claim_alpha) c.measured += ", within a tenth";
      }
    }
    return all;
  }

  const Evidence& m_evidence;
  const std::string& m_study;
  std::vector<Mean> m_means;
  std::vector<std::string> m_others; ///< correlations, and numbers over all runs of a study, in brief
  std::vector<std::string> m_ours;
  std::vector<ClaimReading> m_conditions; ///< their sentences filled
};

} // namespace

Finding judged(const Claim& claim, const Evidence& evidence, ClaimEdition edition) {
  Judge judge(evidence, claim.study);
  for (const ClaimCondition& c : claim.conditions)
    if (c.edition.value_or(edition) == edition) judge.add(c);
  return judge.finding();
}

} // namespace matrigrate::study
