#pragma once

#include "fields/picture.hpp"

#include <vector>

/// Direction of the fibres in a picture. Test: tests/unit/fields/scale_test.cpp
namespace matrigrate::fields {

/// The direction along which a picture changes least around each pixel: that of the eigenvector of the smaller
/// eigenvalue of the structure tensor, the mean of (grad s)(grad s)^T weighted by a normal distribution around the
/// pixel. Slopes are differences of fourth order of the picture smoothed over one pixel.
/// @param window  standard deviation of the weights, > 0 [pixel]
/// @return degrees from the x axis, in (-90, 90], y upwards, row by row downwards; where the picture is even, the
/// direction of the whole picture
/// @throws std::invalid_argument if all of the picture is even, or it is smaller than 3 x 3 pixels
std::vector<double> fibre_directions(const Picture& picture, double window);

} // namespace matrigrate::fields
