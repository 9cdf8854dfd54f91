#include "observe/fields.hpp"

#include "base/parallel.hpp"
#include "state/protrusion.hpp"

namespace matrigrate {

std::vector<double> displacement_field(const EcmState& ecm) {
  std::vector<double> field(ecm.size(), undefined);
  for (std::size_t i = 0; i < ecm.size(); ++i)
    if (ecm.f[i] > 0.0) field[i] = ecm.displacement(i).norm();
  return field;
}

std::vector<double> fibre_stress_field(const EcmState& ecm, const FibreParameters& p, const FibreNetwork& network) {
  std::vector<double> field(ecm.size(), undefined);
  if (network.empty()) return field;
  parallel_for(ecm.size(), [&](std::size_t i) {
    if (ecm.f[i] > 0.0) field[i] = plane_von_mises(fibre_stress(ecm, p, network, i));
  });
  return field;
}

} // namespace matrigrate
