#include "solve/drag_system.hpp"

#include "base/parallel.hpp"

namespace matrigrate {

void multiply(const DragSystem& A, std::span<const Vec2> x, std::span<Vec2> y) {
  const Adjacency& pairs = *A.pairs;
  parallel_for(A.size(), [&](std::size_t i) {
    Vec2 sum = A.diagonal[i] * x[i];
    for (std::uint32_t k = pairs.first[i]; k < pairs.first[i + 1]; ++k) sum -= A.coupling[k] * x[pairs.index[k]];
    y[i] = sum;
  });
}

} // namespace matrigrate
