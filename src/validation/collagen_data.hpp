#pragma once

#include <vector>

namespace matrigrate::validation {

/// A point of a stress-strain curve.
struct StressPoint {
  double strain; ///< [-]
  double stress; ///< [Pa]
};

/// A collagen gel: its concentration, the k_0 fitted to it, and its measured curve.
struct CollagenGel {
  double concentration; ///< [mg/ml]
  double k_0;           ///< [kPa]
  std::vector<StressPoint> measured;
};

/// Gels of three concentrations, extensional rheometry attributed to Steinwachs et al. 2016 (Nature Methods 13:171), as
/// distributed with the documentation of saenopy (notebook on materials; labelled shear there). k_0 from Heck et al.
/// 2020, Fig 2C.
inline std::vector<CollagenGel> collagen_gels() {
  return {{0.6,
           0.447,
           {{0.0189, 0.59},
            {0.0393, 1.08},
            {0.0597, 1.57},
            {0.0801, 2.14},
            {0.100, 2.89},
            {0.121, 3.83},
            {0.141, 5.09},
            {0.162, 6.77},
            {0.182, 8.94},
            {0.202, 11.7},
            {0.223, 14.9},
            {0.243, 18.6},
            {0.263, 22.8},
            {0.284, 27.1}}},
          {1.2, 1.645, {{0.0171, 2.57}, {0.0381, 4.69}, {0.0587, 6.34}, {0.0792, 7.93}, {0.0996, 9.56}, {0.120, 11.4},
                        {0.140, 13.5},  {0.161, 16.2},  {0.181, 19.7},  {0.202, 24.1},  {0.222, 29.5},  {0.242, 36.3},
                        {0.263, 44.3},  {0.283, 53.6},  {0.304, 63.7},  {0.324, 74.7},  {0.344, 86.1},  {0.365, 97.5},
                        {0.385, 110},   {0.406, 122},   {0.426, 133}}},
          {2.4,
           5.208,
           {{0.0159, 8.46},
            {0.0376, 16.8},
            {0.0582, 24.3},
            {0.0786, 33.4},
            {0.0990, 45.4},
            {0.119, 61.1},
            {0.140, 81.6},
            {0.160, 106},
            {0.180, 134},
            {0.201, 165},
            {0.221, 196},
            {0.241, 226}}}};
}

} // namespace matrigrate::validation
