#include "claims/judge.hpp"

#include "statistics/compare.hpp"
#include "statistics/sample.hpp"
#include "study_plan/names.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
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

} // namespace

const Ensemble* Judge::ensemble(const std::string& study) const {
  const auto found = m_evidence.find(study.empty() ? m_study : study);
  return found == m_evidence.end() ? nullptr : &found->second;
}

Judge::Group Judge::group(const PointName& name) const {
  const std::string study = name.study.empty() ? m_study : name.study;
  const Ensemble* known = ensemble(study);
  if (known == nullptr) return {study, study};
  const auto point = std::ranges::find(known->study.points, name.label, &Point::label);
  const std::string of_study = m_evidence.size() == 1 ? "" : study + ": ";
  if (point == known->study.points.end()) return {study, of_study + name.label + " (no such point)"};
  return {study, of_study + brief_label(known->study, *point), known,
          static_cast<std::size_t>(point - known->study.points.begin())};
}

std::vector<double> Judge::values(const Group& g, std::string_view readout) {
  if (g.ensemble == nullptr) return {};
  std::vector<double> x = sample(g.ensemble->results, g.point, readout);
  tell(g, readout_words(readout), statistics::mean_interval(x, claim_alpha), x.size());
  return x;
}

/// Mean square displacements of the runs at a point that have one.
MsdCurves Judge::curves(const Group& g) {
  MsdCurves runs;
  if (g.ensemble == nullptr) return runs;
  for (std::size_t k = 0; k < g.ensemble->msd.size(); ++k)
    if (g.ensemble->results[k].run.point == g.point && !g.ensemble->msd[k].empty()) runs.push_back(g.ensemble->msd[k]);
  tell(g, "slope of the mean curve of the square displacement, lags of 10 min to half the run",
       mean_curve_slope(runs, g.point), runs.size());
  return runs;
}

/// Of all runs of a study.
std::vector<double> Judge::column(const ClaimCondition& c, std::string_view readout) const {
  std::vector<double> x;
  const Ensemble* known = ensemble(c.study);
  if (known == nullptr) return x;
  for (const Result& r : known->results) x.push_back(r.readouts.at(readout_column(readout)));
  return x;
}

/// The point with the lowest, or highest, mean: the first of them.
Judge::Group Judge::extreme(const ClaimCondition& c) {
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
std::vector<double> Judge::excess(const Group& g, const ClaimCondition& c) {
  std::vector<double> differences;
  if (g.ensemble == nullptr) return differences;
  values(g, c.other); // tells it
  for (const Result& r : g.ensemble->results)
    if (r.run.point == g.point)
      differences.push_back(r.readouts.at(readout_column(c.readout)) - r.readouts.at(readout_column(c.other)));
  return statistics::finite(differences);
}

Judge& Judge::add(const ClaimCondition& c) {
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
  const ClaimReading reading = c.rule->judge(c, runs);
  if (!reading.all_runs.empty()) {
    m_others.push_back(filled(reading.all_runs, c, from, to));
    m_ours.push_back(m_others.back());
  }
  m_conditions.push_back({filled(reading.wanted, c, from, to), reading.measured, reading});
  return *this;
}

/// The conditions, of which those of a family are met or not by their corrected p.
std::vector<Judge::Condition> Judge::corrected() const {
  std::vector<Condition> all = m_conditions;
  for (const ClaimFamily family : {ClaimFamily::no_difference, ClaimFamily::agreement}) {
    std::vector<double> p;
    for (const Condition& c : all)
      if (c.reading.family == family) p.push_back(c.reading.p);
    const std::vector<double> adjusted = statistics::holm(p);
    std::size_t next = 0;
    for (Condition& c : all) {
      if (c.reading.family != family) continue;
      const double corrected = adjusted[next++];
      c.reading.met = c.reading.close || !(corrected < claim_alpha);
      if (corrected != c.reading.p && std::isfinite(corrected))
        c.measured += fmt::format(", corrected {:.2g}", corrected);
      if (c.reading.close && corrected < claim_alpha) c.measured += ", within a tenth";
    }
  }
  return all;
}

Finding Judge::finding() const {
  constexpr const char* too_few = "too few runs";
  Finding finding{.ours = m_ours, .conditions = {}, .brief = brief()};
  bool defined = !m_conditions.empty(), met = true, states_direction = false, direction = true, vague = false;
  for (const Condition& c : corrected()) {
    const bool untold = c.reading.met && c.reading.vague;
    defined = defined && c.reading.defined;
    met = met && c.reading.met;
    vague = vague || untold;
    states_direction = states_direction || c.reading.direction.has_value();
    direction = direction && c.reading.direction.value_or(true);
    const std::string sentence = fmt::format("{} ({})", c.wanted, c.measured);
    finding.conditions.push_back(!c.reading.defined ? fmt::format("{}: {}", c.wanted, too_few)
                                 : untold           ? sentence + ": too few runs to tell"
                                                    : sentence + (c.reading.met ? ": met" : ": not met"));
    if (c.reading.defined && !c.reading.met)
      finding.unmet.push_back(sentence);
    else if ((!c.reading.defined || untold) && std::ranges::find(finding.unmet, too_few) == finding.unmet.end())
      finding.unmet.emplace_back(too_few);
    if (c.reading.defined && c.reading.against) finding.against.push_back(sentence);
  }
  finding.verdict = !defined || (met && vague)      ? Verdict::undecided
                    : met                           ? Verdict::holds
                    : states_direction && direction ? Verdict::in_direction
                                                    : Verdict::does_not_hold;
  return finding;
}

Finding judged(const Claim& claim, const Evidence& evidence, ClaimEdition edition) {
  Judge judge(evidence, claim.study);
  for (const ClaimCondition& c : claim.conditions)
    if (c.edition.value_or(edition) == edition) judge.add(c);
  return judge.finding();
}

} // namespace matrigrate::study
