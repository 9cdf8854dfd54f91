#pragma once

#include "base/vector.hpp"

namespace matrigrate {

/// Components of a tensor of the plane, for any number type; the argument type of the laws.
template <class Real>
struct TensorOf {
  Real xx, xy, yx, yy;
};

using Tensor = TensorOf<double>;

inline Tensor components(const Mat2& A) { return {A(0, 0), A(0, 1), A(1, 0), A(1, 1)}; }
inline Mat2 matrix(const Tensor& A) { return (Mat2() << A.xx, A.xy, A.yx, A.yy).finished(); }

} // namespace matrigrate
