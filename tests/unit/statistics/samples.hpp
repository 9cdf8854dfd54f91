#pragma once

#include <vector>

namespace matrigrate::statistics {

/// Hours of sleep gained with two drugs (Student 1908), the data set `sleep` of R.
inline const std::vector<double> sleep_1{0.7, -1.6, -0.2, -1.2, -0.1, 3.4, 3.7, 0.8, 0.0, 2.0};
inline const std::vector<double> sleep_2{1.9, 0.8, 1.1, 0.1, -0.1, 4.4, 5.5, 1.6, 4.6, 3.4};

} // namespace matrigrate::statistics
