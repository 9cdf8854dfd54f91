#include "parameters/presets.hpp"

#include "parameters/read.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace matrigrate {

namespace {

/// All of these, and behind them those of files.
std::vector<Preset> with_files(std::vector<Preset> all, std::span<const Template> files = templates()) {
  for (const Template& file : files) {
    const std::size_t start = file.text.find("\n# ") + 3;
    all.push_back({file.name, file.text.substr(start, file.text.find(".\n", start) - start), {}, file.text});
  }
  return all;
}

} // namespace

std::span<const Preset> presets() {
  const std::vector<std::string> uniaxial{"ecm.youngs_modulus=10 Pa", "fibres.arrangement=uniaxial",
                                          "fibres.stiffness=10 kPa"};
  // The paper's Figs 11 to 13: a number of protrusions is kept up, and adhesions rupture at f_mat F_am.
  const auto kept = [](int number, std::vector<std::string> overrides = {}) {
    overrides.push_back("protrusion.number=" + std::to_string(number));
    overrides.emplace_back("adhesion.rupture=true");
    return overrides;
  };
  // OpenVT's reference models begin at the left of the domain; positions every 2 min.
  const auto reference = [](std::vector<std::string> overrides) {
    overrides.insert(overrides.end(), {"cell.start_x=-60 um", "output.track_interval=2 min"});
    return overrides;
  };
  static const std::vector<Preset> all = with_files({
      {"baseline", "The paper's baseline: a matrix of 200 Pa (Figs 5 to 7)", {}},
      {"second-closures",
       "The baseline with the second set of closures, the default of version 0.2.0",
       {"cell.bending_stiffness=5e-17 N m", "contact.fluid_share=0.15", "contact.body_fluid_share=0.15",
        "protrusion.least_facing=0.8", "adhesion.rest_speed=4 nm/s",
        "laws.curvature_factor=exp(-0.5*((kappa - kappa_0)/kappa_w)^2)"}},
      {"soft", "The paper's softest matrix: 50 Pa (Figs 5 to 7)", {"ecm.youngs_modulus=50 Pa"}},
      {"stiff", "The paper's stiffest matrix: 400 Pa (Figs 5 to 7)", {"ecm.youngs_modulus=400 Pa"}},
      {"weak-contraction",
       "The paper's weakest actomyosin force: 0.4 nN in both strands (Fig 7)",
       {"actomyosin.force=0.2 nN"}},
      {"strong-contraction",
       "The paper's strongest actomyosin force: 2 nN in both strands (Fig 7)",
       {"actomyosin.force=1 nN"}},
      {"frequent-protrusions",
       "The paper's highest rate of initiation (Fig 8)",
       {"protrusion.initiation_rate=1e-4 1/s"}},
      {"brief-adhesions",
       "The paper's shortest adhesions: 10 min at high force (Fig 8)",
       {"adhesion.r_off_min=1.667e-3 1/s"}},
      {"long-protrusions", "The paper's longest time of growth: 600 s (Fig 8)", {"protrusion.growth_time=600 s"}},
      {"sensitive-adhesions",
       "Disassembly four times as sensitive to force (Figs 9 and 10)",
       {"adhesion.zeta_diss=80 1/nN"}},
      {"insensitive-adhesions",
       "Disassembly at one rate whatever the force (Figs 9 and 10)",
       {"adhesion.r_off_min=5.56e-4 1/s", "adhesion.r_off_0=0 1/s"}},
      {"fibrillar",
       "An isotropic fibrillar gel of 1.2 mg/ml (Fig 2C)",
       {"ecm.youngs_modulus=10 Pa", "fibres.arrangement=isotropic", "fibres.stiffness=1645 Pa"}},
      {"one-protrusion", "One protrusion at a time, homogeneous matrix (Fig 11)", kept(1)},
      {"two-protrusions", "Two protrusions at a time, homogeneous matrix (Fig 11)", kept(2)},
      {"three-protrusions", "Three protrusions at a time, homogeneous matrix (Fig 11)", kept(3)},
      {"four-protrusions", "Four protrusions at a time, homogeneous matrix (Fig 11)", kept(4)},
      {"one-protrusion-fibres", "One protrusion at a time, uniaxial fibres (Fig 12)", kept(1, uniaxial)},
      {"two-protrusions-fibres", "Two protrusions at a time, uniaxial fibres (Figs 12 and 13)", kept(2, uniaxial)},
      {"three-protrusions-fibres", "Three protrusions at a time, uniaxial fibres (Fig 12)", kept(3, uniaxial)},
      {"four-protrusions-fibres", "Four protrusions at a time, uniaxial fibres (Fig 12)", kept(4, uniaxial)},
      {"stiffness-gradient",
       "Stiffness that rises by 2 Pa per um along x (durotaxis)",
       {"ecm.fields.youngs_modulus=max(50, 200 + 2*x)"}},
      {"stiffness-step",
       "Two gels that meet at x = 0: 100 Pa and 400 Pa",
       {"ecm.fields.youngs_modulus=x < 0 ? 100 : 400"}},
      {"channel", "A straight channel of 10 um through the matrix, along x", {"ecm.fields.f_degr=abs(y) < 5 ? 0 : 1"}},
      {"microtrack", "A track of 4 um that another cell has left, along x", {"ecm.fields.f_degr=abs(y) < 2 ? 0 : 1"}},
      {"pillars",
       "Rigid pillars of 16 um on a square grid of 50 um, around which the cell finds its way",
       {"ecm.fields.obstacle=(x-50*rint(x/50+0.5)+25)^2+(y-50*rint(y/50+0.5)+25)^2 < 64 ? 1 : 0"}},
      {"walled-channel",
       "A channel of 40 um between rigid walls, filled with matrix, along x",
       {"ecm.fields.obstacle=abs(y) > 20 && abs(y) < 30 ? 1 : 0"}},
      {"interface",
       "A soft gel above a stiff one, the cell between them",
       {"ecm.fields.youngs_modulus=225 - 175*tanh(y/5)"}},
      {"chemotaxis",
       "Attractant that rises along x, which the cell senses (off the paper)",
       {"ecm.fields.attractant=exp(x/100)", "laws.initiation_bias=exp(20*occupancy)"}},
      {"attractant-source",
       "Attractant that diffuses from a source 80 um to the right and is taken up by the cell (off the paper)",
       {"ecm.fields.attractant_source=(x-80)^2 + y^2 < 64 ? 0.1 : 0", "cues.diffusion=10 um^2/s", "cues.decay=1e-3 1/s",
        "cues.uptake=0.01 1/s", "laws.initiation_bias=exp(20*occupancy)"}},
      {"openvt-migration",
       "OpenVT's reference model 1: a cell at the left, with a bias to the right that is the same everywhere (off the "
       "paper)",
       reference({"ecm.fields.attractant=(0.5 + x/400)/(0.5 - x/400)", "laws.initiation_bias=exp(20*occupancy)"})},
      {"openvt-chemotaxis-linear",
       "OpenVT's reference model 2: attractant that falls linearly from 1 at the right to 0 at the left (off the "
       "paper)",
       reference({"ecm.fields.attractant=max(0, 0.5 + x/300)", "laws.initiation_bias=exp(20*occupancy)",
                  "cues.half_occupancy=0.5"})},
      {"openvt-chemotaxis-half-normal", "The same, with attractant that falls as a half-normal distribution",
       reference({"ecm.fields.attractant=exp(-0.5*((150 - x)/120)^2)", "laws.initiation_bias=exp(20*occupancy)",
                  "cues.half_occupancy=0.5"})},
      {"openvt-chemotaxis-exponential", "The same, with attractant that falls exponentially",
       reference({"ecm.fields.attractant=exp(-(150 - x)/120)", "laws.initiation_bias=exp(20*occupancy)",
                  "cues.half_occupancy=0.5"})},
      {"haptotaxis",
       "Ligand that rises along x, on which adhesions and initiation depend (off the paper)",
       {"ecm.fields.ligand=min(2, max(0, 1 + x/100))", "laws.initiation_bias=exp(4*ligand)"}},
      {"contact-guidance",
       "Uniaxial fibres that the cell feels along them as it begins protrusions (off the paper)",
       {"ecm.youngs_modulus=10 Pa", "fibres.arrangement=uniaxial", "fibres.stiffness=10 kPa",
        "laws.initiation_bias=exp(alignment)"}},
      {"curved-fibres",
       "Fibres on circles around the centre of the matrix (contact guidance)",
       {"ecm.youngs_modulus=10 Pa", "fibres.arrangement=uniaxial", "fibres.stiffness=10 kPa",
        "fibres.field.direction_deg=atan2(x, -y)*180/_pi"}},
      {"two-cells",
       "Two cells that begin 2 um apart (off the paper)",
       {"cells=[{x=\"-16 um\", y=\"0 um\"}, {x=\"16 um\", y=\"0 um\"}]"}},
  });
  return all;
}

std::span<const Preset> published_laws() {
  static const std::vector<Preset> all = with_files({}, law_files());
  return all;
}

const Preset* find_preset(std::string_view name, std::span<const Preset> among) {
  const auto preset = std::ranges::find(among, name, &Preset::name);
  return preset == among.end() ? nullptr : &*preset;
}

Parameters parameters_of(const Preset& preset) {
  if (!preset.text.empty()) return parse_parameters(preset.text, fmt::format("{}.toml", preset.name));
  std::vector<std::string> overrides{"run.integrator=adaptive"};
  overrides.insert(overrides.end(), preset.overrides.begin(), preset.overrides.end());
  return apply_overrides({}, overrides);
}

} // namespace matrigrate
