#include "parameters/schema.hpp"

#include <array>

namespace matrigrate {

namespace {

constexpr std::string_view paper = "Heck et al. 2020";
constexpr std::string_view of_methods = "Heck et al. 2020, Methods";
constexpr Range rate{0.0, 1e6};
constexpr Range share{0.0, 1.0};
constexpr Range weight{0.0, 1e300};
constexpr Range stiffness{0.0, 1e100};
constexpr double half_turn = 3.141592653589793;

// clang-format off
constexpr std::array strain{LawVariable{"eps", "", -0.5, 1.0, 0.1, -0.1, 0.3, "strain of the fibre"}};
constexpr std::array segment{LawVariable{"kappa", "1/um", -5.0, 5.0, 0.0, -1.0, 1.0, "curvature of the cortex (convex: positive)"}};
constexpr std::array adhesion{LawVariable{"F", "nN", 0.0, 10.0, 0.3, 0.0, 1.5, "force of the adhesion"},
                              LawVariable{"f_mat", "", 0.01, 1.0, 0.5, 0.01, 1.0, "maturation of its protrusion"},
                              LawVariable{"t", "s", 0.0, 1e5, 600.0, 0.0, 3600.0, "time since contraction began"}};
constexpr std::array growth{LawVariable{"A", "", 0.1, 10.0, 1.0, 0.5, 3.0, "area of the cell over the initial one"},
                            LawVariable{"l", "um", 0.0, 100.0, 10.0, 0.0, 40.0, "length of the protrusion"},
                            LawVariable{"t", "s", 0.0, 1e5, 200.0, 0.0, 3600.0, "time since it began"}};
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
                  std::string_view description, std::span<const LawVariable> arguments, std::string_view before) {
  return {path, member, unit, range, "", source, description, Audience::optional, before, nullptr, arguments};
}

constexpr std::array rows_of_laws{
    law("laws.fibre_stiffness", [](Parameters& p) -> std::string& { return p.laws.fibre_stiffness; }, "1", stiffness, paper,
        "Eq. 5: stiffness of a fibre over k_0", strain,
        "eps < 0 ? 0 : eps <= eps_s ? 1 : exp((eps - eps_s)/d_s)"),
    law("laws.curvature_factor", [](Parameters& p) -> std::string& { return p.laws.curvature_factor; }, "1", share, "MODEL.md, I14",
        "Eq. 6: factor of the actomyosin tension", segment,
        "exp(-0.5*((kappa - kappa_0)/kappa_w)^2)"),
    law("laws.disassembly_rate", [](Parameters& p) -> std::string& { return p.laws.disassembly_rate; }, "1/s", rate, paper,
        "Eq. 7: rate at which an adhesion disassembles", adhesion,
        "r_off_min + r_off_0*exp(-zeta_diss*F/f_mat)"),
    law("laws.growth_force", [](Parameters& p) -> std::string& { return p.laws.growth_force; }, "1", Range{0.0, 100.0}, paper,
        "Eq. 10: force of growth over F_prot", growth,
        "n_prot > 0 && A > 1 ? 1/A : 1"),
    law("laws.initiation_rate", [](Parameters& p) -> std::string& { return p.laws.initiation_rate; }, "1/s", rate, of_methods,
        "Rate of initiation at a particle of the front", place,
        "r_prot"),
    law("laws.initiation_bias", [](Parameters& p) -> std::string& { return p.laws.initiation_bias; }, "1", weight, of_methods,
        "Where along the cortex protrusions begin: the rate is multiplied by bias / mean bias, so the total rate of the cell stays the same. A bias of 0 along the whole cortex is none", place,
        "1"),
    law("laws.polarization_rate", [](Parameters& p) -> std::string& { return p.laws.polarization_rate; }, "1/s", rate, of_methods,
        "Rate at which the polarization turns to the mean direction of the adhesions", turn,
        "r_pol"),
    law("laws.degradation_tip", [](Parameters& p) -> std::string& { return p.laws.degradation_tip; }, "1/s", rate, of_methods,
        "Rate of degradation at the tip of a growing protrusion", matrix,
        "r_degr_tip"),
    law("laws.degradation_protrusion", [](Parameters& p) -> std::string& { return p.laws.degradation_protrusion; }, "1/s", rate, of_methods,
        "Rate of degradation along a protrusion", matrix,
        "p > p_th_degr ? r_degr_prot : 0"),
    law("laws.degradation_body", [](Parameters& p) -> std::string& { return p.laws.degradation_body; }, "1/s", rate, of_methods,
        "Rate of degradation around the body of the cell; around its rear times body_rear_share", matrix,
        "p > p_th_degr ? r_degr_body : 0"),
    Row{"laws.constants", [](Parameters& p) -> std::string& { return p.laws.constants; }, "", {},
        "", "this program", "Constants of your own for these formulas, or a table [laws.constants]", Audience::optional, ""},
};
// clang-format on

} // namespace

std::span<const Row> law_rows() { return rows_of_laws; }

} // namespace matrigrate
