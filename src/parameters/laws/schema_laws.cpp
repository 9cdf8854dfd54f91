#include "parameters/schema.hpp"

#include <array>

namespace matrigrate {

namespace {

constexpr std::string_view paper = "Heck et al. 2020";
constexpr std::string_view of_methods = "Heck et al. 2020, Methods";
constexpr Range rate{0.0, 1e6};
constexpr Range share{0.0, 1.0};
constexpr Range weight{0.0, 1e300};
constexpr Range force{0.0, 1e3};
constexpr Range stiffness{0.0, 1e100};
constexpr double half_turn = 3.141592653589793;

// clang-format off
constexpr std::array strain{LawVariable{"eps", "", -0.5, 1.0, 0.1, -0.1, 0.3, "strain of the fibre"}};
/// What the laws of a cell may use besides; those of no protrusion the first seven, that of f_mat all but the last.
constexpr std::array of_the_place{LawVariable{"x", "um", -2000.0, 2000.0, 0.0, -100.0, 100.0, "where the law acts: particle of the cortex, tip of the protrusion, particle of the matrix, centre of the cell"},
                                  LawVariable{"y", "um", -2000.0, 2000.0, 0.0, -100.0, 100.0, "the same"},
                                  LawVariable{"time", "s", 0.0, 1e7, 3600.0, 0.0, 21600.0, "time since the run began"},
                                  LawVariable{"density", "", 0.1, 10.0, 1.0, 0.8, 1.2, "density of the solid matrix around, over the initial one (without solid: 1)"},
                                  LawVariable{"pressure", "Pa", -1e4, 1e4, 0.0, -100.0, 500.0, "pressure of the solid matrix around (without: 0)"},
                                  LawVariable{"f_degr", "", 0.0, 1.0, 0.5, 0.0, 1.0, "intact fraction of the matrix around, with what is inside the cell"},
                                  LawVariable{"stiffness", "Pa", 0.0, 1e7, 200.0, 0.0, 1000.0, "Young's modulus of the solid matrix around (without: 0)"},
                                  LawVariable{"l", "um", 0.0, 100.0, 10.0, 0.0, 40.0, "length of the protrusion (elsewhere: 0)"},
                                  LawVariable{"age", "s", 0.0, 1e5, 1200.0, 0.0, 7200.0, "time since the protrusion began (elsewhere: 0)"},
                                  LawVariable{"t_mat", "s", 0.0, 1e5, 600.0, 0.0, 3600.0, "time since it matured (before, and elsewhere: 0)"},
                                  LawVariable{"f_mat", "", 0.0, 1.0, 0.5, 0.0, 1.0, "maturation of the protrusion, growing: 0 (elsewhere: that of the body)"}};
constexpr std::span all_shared{of_the_place};
constexpr std::span without_f_mat = all_shared.first(10);
constexpr std::span of_no_protrusion = all_shared.first(7);

constexpr std::array segment{LawVariable{"kappa", "1/um", -5.0, 5.0, 0.0, -1.0, 1.0, "curvature of the cortex (convex: positive)"}};
constexpr std::array strand{LawVariable{"f_mat", "", 0.0, 1.0, 0.5, 0.0, 1.0, "maturation of the strand, growing or maturing: 0"},
                            LawVariable{"f_curv", "", 0.0, 1.0, 1.0, 0.0, 1.0, "curvature_factor there"},
                            LawVariable{"kappa", "1/um", -5.0, 5.0, 0.0, -1.0, 1.0, "curvature of the cortex (convex: positive)"},
                            LawVariable{"speed", "um/s", -10.0, 10.0, 0.0, -0.1, 0.2, "speed at which the segment shortens"}};
constexpr std::array maturing{LawVariable{"steps", "", 0.0, 10.0, 3.0, 0.0, 10.0, "steps of maturation that are done"},
                              LawVariable{"F", "nN", 0.0, 10.0, 0.3, 0.0, 1.5, "force of the adhesion"},
                              LawVariable{"t", "s", 0.0, 1e5, 300.0, 0.0, 600.0, "time since the protrusion adhered, without the wait for its steps"}};
constexpr std::array matured{LawVariable{"steps", "", 0.0, 11.0, 3.0, 0.0, 11.0, "steps, the running one included: whole while the protrusion matures, in the end by its part"}};
constexpr std::array spring{LawVariable{"stretch", "um", 0.0, 10.0, 0.15, 0.0, 1.0, "length of the adhesion beyond its rest length"}};
constexpr std::array adhesion{LawVariable{"F", "nN", 0.0, 10.0, 0.3, 0.0, 1.5, "force of the adhesion"},
                              LawVariable{"f_mat", "", 0.01, 1.0, 0.5, 0.01, 1.0, "maturation of its protrusion"},
                              LawVariable{"t", "s", 0.0, 1e5, 600.0, 0.0, 3600.0, "time since contraction began"}};
constexpr std::array growth{LawVariable{"A", "", 0.1, 10.0, 1.0, 0.5, 3.0, "area of the cell over the initial one"},
                            LawVariable{"l", "um", 0.0, 100.0, 10.0, 0.0, 40.0, "length of the protrusion"},
                            LawVariable{"t", "s", 0.0, 1e5, 200.0, 0.0, 3600.0, "time since it began"},
                            LawVariable{"speed", "um/s", -10.0, 10.0, 0.0, -0.05, 0.2, "speed of its tip along its direction"}};
constexpr std::array place{LawVariable{"angle", "rad", -half_turn, half_turn, 0.0, -half_turn, half_turn, "angle to the polarization (before there is one: the mean of the law over all angles)"},
                           LawVariable{"kappa", "1/um", -5.0, 5.0, 0.05, -1.0, 1.0, "curvature of the cortex (convex: positive)"},
                           LawVariable{"occupancy", "", 0.0, 1.0, 0.5, 0.0, 1.0, "share of receptors that attractant occupies"},
                           LawVariable{"ligand", "", 0.0, 100.0, 1.0, 0.0, 2.0, "ligand on the solid"},
                           LawVariable{"alignment", "", -1.0, 1.0, 0.0, -1.0, 1.0, "alignment with the fibres (1: along, -1: across)"}};
constexpr std::array turn{LawVariable{"angle", "rad", 0.0, half_turn, 0.5, 0.0, half_turn, "angle between the two"}};
constexpr std::array matrix{LawVariable{"f", "", 0.0, 1.0, 1.0, 0.0, 1.0, "intact fraction of the matrix"},
                            LawVariable{"p", "Pa", -1e4, 1e4, 100.0, -100.0, 500.0, "pressure"}};

using Text = std::string& (*)(Parameters&);

/// @param before  the law of every version without these keys
constexpr Row law(std::string_view path, Text member, std::string_view unit, Range range, std::string_view source,
                  std::string_view description, std::span<const LawVariable> arguments,
                  std::span<const LawVariable> shared, std::string_view before) {
  return {path, member, unit, range, "", source, description, Audience::optional, before, nullptr, arguments, shared};
}

constexpr std::array rows_of_laws{
    law("laws.fibre_stiffness", [](Parameters& p) -> std::string& { return p.laws.fibre_stiffness; }, "1", stiffness, paper,
        "Eq. 5: stiffness of a fibre over k_0", strain, {},
        "eps < 0 ? 0 : eps <= eps_s ? 1 : exp((eps - eps_s)/d_s)"),
    law("laws.curvature_factor", [](Parameters& p) -> std::string& { return p.laws.curvature_factor; }, "1", share, "MODEL.md, I14",
        "Eq. 6: factor of the actomyosin tension", segment, all_shared,
        "exp(-0.5*((kappa - kappa_0)/kappa_w)^2)"),
    law("laws.contraction", [](Parameters& p) -> std::string& { return p.laws.contraction; }, "nN", force, paper,
        "Eq. 6: tension of a segment of the cortex", strand, all_shared,
        "f_mat*f_curv*F_am"),
    law("laws.maturation_force", [](Parameters& p) -> std::string& { return p.laws.maturation_force; }, "nN", force, of_methods,
        "Force of the adhesion at which the next step of maturation is done", maturing, all_shared,
        "0.1*sum(steps, s_mat)*(m_mat*F_am)"),
    law("laws.maturation", [](Parameters& p) -> std::string& { return p.laws.maturation; }, "1", share, of_methods,
        "f_mat after so many steps of maturation", matured, without_f_mat,
        "min(1, 0.1*steps)"),
    law("laws.adhesion_stiffness", [](Parameters& p) -> std::string& { return p.laws.adhesion_stiffness; }, "nN/um", Range{0.0, 1e6}, of_methods,
        "Stiffness of an adhesion: its force over its stretch", spring, all_shared,
        "k_ad"),
    law("laws.disassembly_rate", [](Parameters& p) -> std::string& { return p.laws.disassembly_rate; }, "1/s", rate, paper,
        "Eq. 7: rate at which an adhesion disassembles", adhesion, all_shared,
        "r_off_min + r_off_0*exp(-zeta_diss*F/f_mat)"),
    law("laws.growth_force", [](Parameters& p) -> std::string& { return p.laws.growth_force; }, "1", Range{0.0, 100.0}, paper,
        "Eq. 10: force of growth over F_prot", growth, all_shared,
        "n_prot > 0 && A > 1 ? 1/A : 1"),
    law("laws.initiation_rate", [](Parameters& p) -> std::string& { return p.laws.initiation_rate; }, "1/s", rate, of_methods,
        "Rate of initiation at a particle of the front", place, of_no_protrusion,
        "r_prot"),
    law("laws.initiation_bias", [](Parameters& p) -> std::string& { return p.laws.initiation_bias; }, "1", weight, of_methods,
        "Where along the cortex protrusions begin: the rate is multiplied by bias / mean bias, so the total rate of the cell stays the same. A bias of 0 along the whole cortex is none", place, of_no_protrusion,
        "1"),
    law("laws.polarization_rate", [](Parameters& p) -> std::string& { return p.laws.polarization_rate; }, "1/s", rate, of_methods,
        "Rate at which the polarization turns to the mean direction of the adhesions", turn, of_no_protrusion,
        "r_pol"),
    law("laws.degradation_tip", [](Parameters& p) -> std::string& { return p.laws.degradation_tip; }, "1/s", rate, of_methods,
        "Rate of degradation at the tip of a growing protrusion", matrix, all_shared,
        "r_degr_tip"),
    law("laws.degradation_protrusion", [](Parameters& p) -> std::string& { return p.laws.degradation_protrusion; }, "1/s", rate, of_methods,
        "Rate of degradation along a protrusion", matrix, all_shared,
        "p > p_th_degr ? r_degr_prot : 0"),
    law("laws.degradation_body", [](Parameters& p) -> std::string& { return p.laws.degradation_body; }, "1/s", rate, of_methods,
        "Rate of degradation around the body of the cell; around its rear times body_rear_share", matrix, of_no_protrusion,
        "p > p_th_degr ? r_degr_body : 0"),
    Row{"laws.constants", [](Parameters& p) -> std::vector<LawConstant>& { return p.laws.constants; }, "", {},
        "", "this program", "Constants of your own for these formulas, each of them a parameter: a table, or one text", Audience::optional, ""},
};
// clang-format on

} // namespace

std::span<const LawVariable> shared_arguments() { return of_the_place; }

std::span<const Row> law_rows() { return rows_of_laws; }

} // namespace matrigrate
