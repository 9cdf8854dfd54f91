#include "claims/claims.hpp"

namespace matrigrate::study {

namespace {

using namespace readout;

Finding x1(const Evidence& e) {
  const Group uniform{"durotaxis", 0};
  const Group gradient{"durotaxis", 1};
  return Judge(e).above(gradient, index_x, 0.0).differs(uniform, gradient, index_x, Sign::up).finding();
}

Finding x2(const Evidence& e) {
  const Group gel{"microtracks", 0};
  const Group track{"microtracks", 1};
  const Group gel_inhibited{"microtracks", 2};
  const Group track_inhibited{"microtracks", 3};
  return Judge(e)
      .differs(gel, track, v_abs, Sign::up)
      .differs(gel, gel_inhibited, v_abs, Sign::down)
      .same(track, track_inhibited, v_abs)
      .finding();
}

Finding x3(const Evidence& e) {
  const Group aligned{"contact-guidance", 0};
  const Group in_all_directions{"contact-guidance", 2};
  return Judge(e)
      .differs(in_all_directions, aligned, angle, Sign::down)
      .below(aligned, angle, random_angle_deg)
      .same(in_all_directions, aligned, v_path_600s)
      .finding();
}

Finding x4(const Evidence& e) {
  // Five widths without degradation, five with a nucleus, and both with degradation; 5.2 um is half of the nucleus's
  // diameter.
  const Group narrow{"channel-width", 1};
  const Group nucleus_narrow{"channel-width", 6};
  const Group nucleus_wide{"channel-width", 9};
  const Group nucleus_narrow_degrading{"channel-width", 16};
  return Judge(e)
      .differs(nucleus_wide, nucleus_narrow, v_abs, Sign::down)
      .differs(narrow, nucleus_narrow, v_abs, Sign::down)
      .differs(nucleus_narrow, nucleus_narrow_degrading, v_abs, Sign::up)
      .finding();
}

Finding x5(const Evidence& e) {
  const Group free{"two-cells", 0};
  const Group adherent{"two-cells", 1};
  return Judge(e).above(free, parting, 0.0).differs(free, adherent, contact, Sign::up).finding();
}

} // namespace

std::span<const Claim> experiment_claims() {
  static const std::vector<Claim> all{
      {"X1",
       {"durotaxis"},
       "cells move up a gradient of stiffness (DuChez et al. 2019, Biophys J 116:670)",
       "forward migration index above 0 on gels of 2 to 7 kPa",
       x1},
      {"X2",
       {"microtracks"},
       "cells are faster in tracks than in the gel, and there need no degradation (Kraning-Rush et al. 2013, Integr "
       "Biol 5:606)",
       "faster in tracks; inhibitors of proteases slow cells in the gel alone",
       x2},
      {"X3",
       {"contact-guidance"},
       "aligned fibres turn paths along them without making cells faster (Riching et al. 2014, Biophys J 107:2546)",
       "persistence rises with alignment, speed does not",
       x3},
      {"X4",
       {"channel-width"},
       "the nucleus stops cells in narrow pores unless they degrade them (Wolf et al. 2013, J Cell Biol 201:1069)",
       "without proteases slower with narrower pores, arrest at a tenth of the nucleus's cross section",
       x4},
      {"X5",
       {"two-cells"},
       "cells that meet move apart again, unless they adhere to each other (Scarpa et al. 2013, Biol Open 2:901; "
       "simulated: "
       "Kulawiak et al. 2016, PLoS Comput Biol 12:e1005239)",
       "after a collision neural crest cells repolarize and the distance of their nuclei grows; adhesion holds pairs",
       x5}};
  return all;
}

} // namespace matrigrate::study
