#include "parameters/gone.hpp"

#include "parameters/scan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <sstream>

namespace matrigrate {

namespace {

constexpr std::string_view no_snapshots =
    "a run draws no snapshots: its page plays it, export --png and --panel draw frames, --layer chooses the layer";

constexpr std::array parameters{
    Gone{"ecm.formulation", "ecm.thickness", "\"total_lagrangian\"", "",
         "the stress of the solid is summed over reference neighbours"},
    Gone{"fibres.law", "fibres.stiffening_strain", "\"tangent\"", "", "Eq. 5 is the tangent stiffness of a fibre"},
    Gone{"fibres.pull", "fibres.law", "\"axial\"", "", "a fibre pulls along itself"},
    Gone{"fibres.plane_to_space", "fibres.pull", "false", "", "k_0 is fibres.stiffness; write 8/15 of it there"},
    Gone{"cell.centre_of_mass", "cell.radius", "\"particles\"", "\"area\"",
         "the centre of mass is the mean of the cortex particles"},
    Gone{"actomyosin.curvature_profile", "actomyosin.curvature_width", "\"half_gaussian\"", "",
         "laws.curvature_factor = \"exp(-((kappa - kappa_0)/kappa_w)^2)\" for \"gaussian\", "
         "\"max(0, 1 - abs(kappa - kappa_0)/kappa_w)\" for \"triangle\"",
         true},
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
    Gone{"cues.chemotaxis", "", "0", "", "laws.initiation_bias = \"exp({}*occupancy)\"", true},
    Gone{"cues.haptotaxis", "", "0", "", "laws.initiation_bias = \"exp({}*ligand)\"", true},
    Gone{"cues.guidance", "", "0", "", "laws.initiation_bias = \"exp({}*alignment)\"", true},
    Gone{"output.snapshot_interval", "output.track_interval", "\"1800 s\"", "", no_snapshots, false, true},
    Gone{"output.pictures", "output.report", "true", "", no_snapshots, false, true},
    Gone{"output.displacement_layer", "output.pictures", "false", "", no_snapshots, false, true},
    Gone{"output.fibre_stress_layer", "output.displacement_layer", "true", "", no_snapshots, false, true},
};

/// A value as it stands in a scenario file.
std::string text_of(const toml::node& value) {
  if (const auto text = value.value_exact<std::string>()) return fmt::format("\"{}\"", excerpt(*text));
  std::ostringstream text;
  value.visit([&](const auto& typed) { text << typed; });
  return excerpt(text.str());
}

} // namespace

std::span<const Gone> gone() { return parameters; }

const Gone* find_gone(std::string_view path) {
  const auto found = std::ranges::find(parameters, path, &Gone::path);
  return found == parameters.end() ? nullptr : &*found;
}

std::string gone_text(std::string_view value, const Gone& parameter) {
  if (parameter.is_law)
    return fmt::format("{} has gone: write {}", value, fmt::format(fmt::runtime(parameter.fate), value));
  if (parameter.is_drawing) return fmt::format("{} has gone: {}", value, parameter.fate);
  return fmt::format("{} has gone: {}; the version of the tag closures-2 has the other readings", value,
                     parameter.fate);
}

std::string fault_of_gone(const Gone& parameter, const toml::node& value) {
  const std::string given = text_of(value);
  return parameter.is_drawing || given == parameter.left ? "" : gone_text(given, parameter);
}

} // namespace matrigrate
