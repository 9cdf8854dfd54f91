#include "base/points_in.hpp"

#include "base/pack.hpp"

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <limits>

namespace matrigrate {

namespace {

/// False only if no point lies in the box: where no x or no y is within its bounds. That rules out most blocks of
/// points in lattice order.
MATRIGRATE_SIMD
bool may_hold(const Box& box, std::span<const Vec2> points) {
  const Doubles low{box.low.x(), box.low.y(), box.low.x(), box.low.y()};
  const Doubles high{box.high.x(), box.high.y(), box.high.x(), box.high.y()};
  auto within = low > low; // none yet
  std::size_t k = 0;
  for (; k + 2 <= points.size(); k += 2) {
    Doubles two;
    load(points[k].data(), two);
    within |= (two >= low) & (two <= high);
  }
  return k < points.size() || ((within[0] | within[2]) != 0 && (within[1] | within[3]) != 0);
}

} // namespace

Box around(const Vec2& point, double reach) {
  const double wider = 1.000001 * reach;
  return {point.array() - wider, point.array() + wider};
}

Box unbounded_along_x(Box box) {
  box.low.x() = -std::numeric_limits<double>::infinity();
  box.high.x() = std::numeric_limits<double>::infinity();
  return box;
}

MATRIGRATE_SIMD
void mark_points_in(const Box& box, std::span<const Vec2> points, std::uint8_t* marks) {
  const double left = box.low.x(), right = box.high.x(), low = box.low.y(), high = box.high.y();
  const double* at = points.data()->data();
  for (std::size_t k = 0; k < points.size(); ++k) {
    const double x = at[2 * k], y = at[2 * k + 1];
    marks[k] = ((x >= left) & (x <= right) & (y >= low) & (y <= high)) ? 1 : 0;
  }
}

std::size_t next_marked(std::span<const std::uint8_t> marks, std::size_t from) {
  if (from >= marks.size()) return marks.size();
  const void* found = std::memchr(marks.data() + from, 1, marks.size() - from);
  if (found == nullptr) return marks.size();
  return static_cast<std::size_t>(static_cast<const std::uint8_t*>(found) - marks.data());
}

std::vector<std::uint32_t> points_in(const Box& box, std::span<const Vec2> points) {
  constexpr std::size_t block = 64;
  std::uint8_t inside[block];
  std::vector<std::uint32_t> found;
  for (std::size_t begin = 0; begin < points.size(); begin += block) {
    const std::size_t n = std::min(block, points.size() - begin);
    if (!may_hold(box, points.subspan(begin, n))) continue;
    mark_points_in(box, points.subspan(begin, n), inside);
    std::size_t count = found.size();
    found.resize(count + n);
    for (std::size_t k = 0; k < n; ++k) { // without branches, which would be unpredictable
      found[count] = static_cast<std::uint32_t>(begin + k);
      count += inside[k];
    }
    found.resize(count);
  }
  return found;
}

} // namespace matrigrate
