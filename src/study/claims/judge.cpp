#include "claims/judge.hpp"

#include "statistics/compare.hpp"
#include "study_plan/names.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace matrigrate::study {

namespace {

/// Takes a name out of a text, but not the end of a path.
void drop_name(std::string& text, const std::string& name) {
  for (std::size_t at = 0; (at = text.find(name, at)) != std::string::npos;)
    if (at > 0 && text[at - 1] == '.')
      at += name.size();
    else
      text.erase(at, name.size());
}

/// The label of a point without the names of the parameters that vary; whole paths, which tell two apart, stay.
std::string without_names(std::string label, const Study& study) {
  const Names names(study);
  for (const std::string& key : swept_keys(study))
    if (key.ends_with("." + names.of(key))) drop_name(label, names.of(key) + " ");
  return label;
}

} // namespace

const Ensemble* Judge::ensemble(const std::string& study) const {
  const auto found = m_evidence.find(study.empty() ? m_study : study);
  return found == m_evidence.end() ? nullptr : &found->second;
}

Judge::Group Judge::group(const PointName& name) const {
  const std::string study = name.study.empty() ? m_study : name.study;
  const Ensemble* known = ensemble(study);
  if (known == nullptr) return {study, {study, study}};
  const auto point = std::ranges::find(known->study.points, name.label, &Point::label);
  const std::string of_study = m_evidence.size() == 1 ? "" : study + ": ";
  const Words label{of_study + name.label, of_study + without_names(name.label, known->study)};
  if (point == known->study.points.end())
    return {study, {label.whole + " (no such point)", label.brief + " (no such point)"}};
  return {study, label, known, static_cast<std::size_t>(point - known->study.points.begin())};
}

std::vector<double> Judge::values(const Group& g, std::string_view readout) {
  if (g.ensemble == nullptr) return {};
  std::vector<double> x = sample(g.ensemble->results, g.point, readout);
  tell(g, readout, x);
  return x;
}

/// Of all runs of a study.
std::vector<double> Judge::column(const ClaimCondition& c, std::string_view readout) const {
  std::vector<double> x;
  const Ensemble* known = ensemble(c.study);
  if (known == nullptr) return x;
  for (const Result& r : known->results) x.push_back(r.readouts.at(readout_column(readout)));
  return x;
}

void Judge::condition(Words wanted, const std::string& measured, bool defined, bool met, Reading reading) {
  m_conditions.push_back({std::move(wanted), {measured, measured}, defined, met, reading});
}

Judge& Judge::add(const ClaimCondition& c) {
  switch (c.rule) {
  case ClaimRule::differs:
  case ClaimRule::same:
  case ClaimRule::leans:
  case ClaimRule::not_beyond:
    compare(c);
    break;
  case ClaimRule::ratio_below:
    ratio_below(c);
    break;
  case ClaimRule::exceeds:
    exceeds(c);
    break;
  case ClaimRule::agrees:
    agrees(c);
    break;
  case ClaimRule::lowest_agrees:
  case ClaimRule::highest_agrees:
    extreme_agrees(c);
    break;
  case ClaimRule::within:
    within(c);
    break;
  case ClaimRule::below:
  case ClaimRule::above:
    beyond(c);
    break;
  case ClaimRule::correlates:
  case ClaimRule::uncorrelated:
    correlate(c);
    break;
  case ClaimRule::mean_above:
  case ClaimRule::none_above:
  case ClaimRule::mostly_up_to:
    over_all_runs(c);
    break;
  }
  return *this;
}

/// The conditions, of which those of a family are met or not by their corrected p.
std::vector<Judge::Condition> Judge::corrected() const {
  std::vector<Condition> all = m_conditions;
  for (const Family family : {Family::no_difference, Family::agreement}) {
    std::vector<double> p;
    for (const Condition& c : all)
      if (c.reading.family == family) p.push_back(c.reading.p);
    const std::vector<double> adjusted = statistics::holm(p);
    std::size_t next = 0;
    for (Condition& c : all) {
      if (c.reading.family != family) continue;
      const double corrected = adjusted[next++];
      c.met = c.reading.close || !(corrected < alpha);
      std::string more;
      if (corrected != c.reading.p && std::isfinite(corrected)) more = fmt::format(", corrected {:.2g}", corrected);
      if (c.reading.close && corrected < alpha) more += ", within a tenth";
      c.measured.whole += more;
      c.measured.brief += more;
    }
  }
  return all;
}

Finding Judge::finding() const {
  constexpr const char* too_few = "too few runs";
  Finding finding{.ours = m_ours, .conditions = {}, .brief = brief()};
  bool defined = !m_conditions.empty(), met = true, states_direction = false, direction = true, vague = false;
  for (const Condition& c : corrected()) {
    const bool untold = c.met && c.reading.vague;
    defined = defined && c.defined;
    met = met && c.met;
    vague = vague || untold;
    states_direction = states_direction || c.reading.direction.has_value();
    direction = direction && c.reading.direction.value_or(true);
    finding.conditions.push_back(c.defined ? fmt::format("{} ({}): {}", c.wanted.whole, c.measured.whole,
                                                         untold  ? "too few runs to tell"
                                                         : c.met ? "met"
                                                                 : "not met")
                                           : fmt::format("{}: {}", c.wanted.whole, too_few));
    const std::string brief = fmt::format("{} ({})", c.wanted.brief, c.measured.brief);
    if (c.defined && !c.met)
      finding.unmet.push_back(brief);
    else if ((!c.defined || untold) && std::ranges::find(finding.unmet, too_few) == finding.unmet.end())
      finding.unmet.emplace_back(too_few);
    if (c.defined && c.reading.against) finding.against.push_back(brief);
  }
  finding.verdict = !defined || (met && vague)      ? Verdict::undecided
                    : met                           ? Verdict::holds
                    : states_direction && direction ? Verdict::in_direction
                                                    : Verdict::does_not_hold;
  return finding;
}

Finding judged(const Claim& claim, const Evidence& evidence) {
  Judge judge(evidence, claim.study);
  for (const ClaimCondition& c : claim.conditions) judge.add(c);
  return judge.finding();
}

} // namespace matrigrate::study
