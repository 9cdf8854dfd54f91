#include "parameters/version.hpp"

#include "parameters/document.hpp"
#include "parameters/presets.hpp"
#include "parameters/read.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cstddef>
#include <sstream>

namespace matrigrate {

namespace {

/// {0, 2, 0} of "0.2.0"; what is no number counts as 0.
std::array<int, 3> numbers_of(std::string_view version) {
  std::array<int, 3> all{};
  for (int& number : all) {
    const std::size_t dot = std::min(version.find('.'), version.size());
    std::from_chars(version.data(), version.data() + dot, number);
    version.remove_prefix(std::min(dot + 1, version.size()));
  }
  return all;
}

constexpr std::string_view no_snapshots =
    "a run draws no snapshots: its page plays it, export --png and --panel draw frames, --layer chooses the layer";

constexpr std::array profiles{GoneFormula{"\"gaussian\"", "exp(-((kappa - kappa_0)/kappa_w)^2)"},
                              GoneFormula{"\"triangle\"", "max(0, 1 - abs(kappa - kappa_0)/kappa_w)"}};
constexpr std::array of_chemotaxis{GoneFormula{"", "exp({}*occupancy)"}};
constexpr std::array of_haptotaxis{GoneFormula{"", "exp({}*ligand)"}};
constexpr std::array of_guidance{GoneFormula{"", "exp({}*alignment)"}};

constexpr Gone drawing(std::string_view path, std::string_view behind, std::string_view left) {
  return {path, behind, left, "", no_snapshots, {}, {}, true};
}

constexpr std::array parameters{
    Gone{"ecm.formulation", "ecm.thickness", "\"total_lagrangian\"", "",
         "the stress of the solid is summed over reference neighbours"},
    Gone{"fibres.law", "fibres.stiffening_strain", "\"tangent\"", "", "Eq. 5 is the tangent stiffness of a fibre"},
    Gone{"fibres.pull", "fibres.stiffening_strain", "\"axial\"", "", "a fibre pulls along itself"},
    Gone{"fibres.plane_to_space", "fibres.stiffening_strain", "false", "",
         "k_0 is fibres.stiffness; write 8/15 of it there"},
    Gone{"cell.centre_of_mass", "cell.radius", "\"particles\"", "\"area\"",
         "the centre of mass is the mean of the cortex particles"},
    Gone{"actomyosin.curvature_profile", "actomyosin.curvature_width", "\"half_gaussian\"", "", "",
         "laws.curvature_factor", profiles},
    Gone{"protrusion.growing_base", "protrusion.least_facing", "\"tied\"", "",
         "the base of a growing protrusion is tied"},
    Gone{"adhesion.rupture_strands", "adhesion.rupture_ratio", "2", "",
         "rupture and f_adh_rel count both strands; adhesion.rupture_ratio = 0.5 ruptures at the force of one"},
    Gone{"adhesion.handover", "adhesion.rest_speed", "\"bundle\"", "",
         "contraction replaces the pull of maturation as the cortex takes over the load, in adhesion.handover_time"},
    Gone{"adhesion.hold", "adhesion.maturation_strands", "\"matter\"", "\"place\"",
         "an adhesion holds the matter that was there when it formed"},
    Gone{"polarization.turning", "polarization.rate", "\"proportional\"", "",
         "the polarization turns in proportion to the angle"},
    Gone{"degradation.pressure", "degradation.body_rear_share", "\"sum\"", "",
         "the larger pressure and degradation.smaller_share of the smaller one are added; smaller_share = 0 is the "
         "larger pressure alone"},
    Gone{"cues.chemotaxis", "", "0", "", "", "laws.initiation_bias", of_chemotaxis},
    Gone{"cues.haptotaxis", "", "0", "", "", "laws.initiation_bias", of_haptotaxis},
    Gone{"cues.guidance", "", "0", "", "", "laws.initiation_bias", of_guidance},
    drawing("output.snapshot_interval", "output.track_interval", "\"1800 s\""),
    drawing("output.pictures", "output.report", "true"),
    drawing("output.displacement_layer", "output.report", "false"),
    drawing("output.fibre_stress_layer", "output.report", "true"),
};

} // namespace

bool has_this_model(std::string_view version) {
  const auto asked = numbers_of(version);
  return asked >= numbers_of(model_since) && asked <= numbers_of(this_version);
}

std::string version_of_program(std::string_view program) {
  const std::size_t name = program.find(' ');
  if (name != std::string_view::npos) program.remove_prefix(name + 1);
  return std::string(program.substr(0, program.find(' ')));
}

std::string model_text(std::string_view version) {
  if (has_this_model(version)) return {};
  if (numbers_of(version) > numbers_of(this_version))
    return fmt::format("{} is a later version, whose model may be another: results may differ, not only bits", version);
  return fmt::format(
      "the model has changed since {}: results differ, not only bits, most where adhesions mature within "
      "a few time steps",
      version);
}

std::span<const Gone> gone() { return parameters; }

const Gone* find_gone(std::string_view path) {
  const auto found = std::ranges::find(parameters, path, &Gone::path);
  return found == parameters.end() ? nullptr : &*found;
}

std::string gone_value(const toml::node& value) {
  if (const auto text = value.value_exact<std::string>()) return fmt::format("\"{}\"", excerpt(*text));
  if (const auto number = value.value_exact<double>()) return fmt::format("{}", *number);
  std::ostringstream text;
  value.visit([&](const auto& typed) { text << typed; });
  return excerpt(text.str());
}

std::string gone_value(const Gone& parameter, const Parameters& p) {
  const auto kept = p.origin.gone.find(parameter.path);
  return kept == p.origin.gone.end() ? std::string(parameter.left) : kept->second;
}

std::string gone_text(std::string_view value, const Gone& parameter) {
  if (parameter.is_drawing) return fmt::format("{} has gone: {}", value, parameter.fate);
  if (parameter.law.empty())
    return fmt::format("{} has gone: {}; the version of the tag closures-2 has the other readings", value,
                       parameter.fate);
  std::string text;
  for (const GoneFormula& one : parameter.formulas)
    text += fmt::format("{}\"{}\"{}", text.empty() ? "" : ", ", fmt::format(fmt::runtime(one.formula), value),
                        one.value.empty() ? std::string() : fmt::format(" for {}", one.value));
  return fmt::format("{} has gone: write {} = {}", value, parameter.law, text);
}

std::optional<std::string> formula_of_gone(const Gone& parameter, std::string_view value) {
  for (const GoneFormula& one : parameter.formulas)
    if (one.value.empty() || one.value == value) return fmt::format(fmt::runtime(one.formula), value);
  return std::nullopt;
}

std::string fault_of_gone(const Gone& parameter, const toml::node& value) {
  const std::string given = gone_value(value);
  return parameter.is_drawing || given == parameter.left ? "" : gone_text(given, parameter);
}

std::vector<Fault> faults_of_gone(const Parameters& p, const std::string& place) {
  std::vector<Fault> faults;
  for (const auto& [path, value] : p.origin.gone)
    faults.push_back({place, 0, 0, path, gone_text(value, *find_gone(path))});
  return faults;
}

namespace {

/// The latest set first.
constexpr std::array names{"third", "second", "first"};

/// All values of each set.
const std::array<Parameters, 3>& sets() {
  static const std::array<Parameters, 3> all = [] {
    const Parameters second = parameters_of(*find_preset("second-closures"));
    // The first set differs from the second in these, and in readings that have gone (tag closures-2).
    return std::array{Parameters{}, second,
                      apply_overrides(second, {"contact.fluid_share=0.1", "contact.body_fluid_share=0.1",
                                               "adhesion.rest_speed=0 nm/s",
                                               "laws.curvature_factor=max(0, 1 - abs(kappa - kappa_0)/kappa_w)"})};
  }();
  return all;
}

/// The parameters that the sets differ in, in the order of the schema.
std::vector<const Row*> rows_of_sets() {
  std::vector<const Row*> rows;
  for (const Row& row : schema())
    if (!row.path.starts_with("run.")
        && std::ranges::any_of(sets(), [&](const Parameters& set) { return differs(row, set, {}); }))
      rows.push_back(&row);
  return rows;
}

/// What to do about the closures of a set, or about mixed ones.
std::string note_of(std::size_t set, const std::string& text) {
  if (set == 0) return {};
  if (set == 1)
    return fmt::format("the closures are of the {}, as the preset second-closures has them; the default is the third",
                       text);
  if (set == 2)
    return fmt::format(
        "the numbers of the closures are of the {}, but its readings have gone: results are not those of "
        "that set, which the version of the tag closures-2 computes; begin from a new file (matrigrate "
        "new), or from --preset second-closures",
        text);
  return fmt::format("the closures are {}: results belong to no set. For the second set begin from matrigrate new FILE "
                     "--preset second-closures, for the third leave out those values of earlier sets",
                     text);
}

} // namespace

Closures closures_of(const Parameters& p) {
  constexpr std::size_t none = names.size();
  std::array<bool, none> is_whole{true, true, true};
  std::array<std::string, none + 1> values; // by the latest set that has them; the last ones are of no set
  for (const Row* row : rows_of_sets()) {
    std::array<bool, none> has{};
    std::ranges::transform(sets(), has.begin(), [&](const Parameters& set) { return !differs(*row, set, p); });
    const auto latest = static_cast<std::size_t>(std::ranges::find(has, true) - has.begin());
    for (std::size_t set = 0; set < none; ++set) is_whole[set] = is_whole[set] && (has[set] || latest == none);
    values[latest] += fmt::format("{}{} = {}", values[latest].empty() ? "" : ", ", row->path, value_text(*row, p));
  }
  const auto set = static_cast<std::size_t>(std::ranges::find(is_whole, true) - is_whole.begin());
  std::string text;
  if (set == none) {
    text = fmt::format("mixed: of the third set {}", values[0]);
    for (const std::size_t earlier : {1, 2})
      if (!values[earlier].empty()) text += fmt::format("; of the {} {}", names[earlier], values[earlier]);
  } else {
    text = fmt::format("{} set", names[set]);
  }
  if (!values[none].empty()) text += fmt::format("{}{}", set == none ? "; of no set " : ", but for ", values[none]);
  return {text, note_of(set, text)};
}

} // namespace matrigrate
