#pragma once

#include "solve/drag_system.hpp"

#include <gtest/gtest.h>

#include <utility>
#include <vector>

namespace matrigrate {

/// The drag of the matrix, coefficient by coefficient.
inline void expect_same(const DragSystem& a, const DragSystem& b) {
  EXPECT_EQ(a.diagonal, b.diagonal);
  EXPECT_EQ(a.prescribed, b.prescribed);
  EXPECT_EQ(a.F, b.F);
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::vector<std::pair<std::size_t, float>> of_a, of_b;
    a.pairs.each_of_row(i, [&](std::size_t j, float G) { of_a.emplace_back(j, G); });
    b.pairs.each_of_row(i, [&](std::size_t j, float G) { of_b.emplace_back(j, G); });
    EXPECT_EQ(of_a, of_b) << "row " << i;
  }
}

} // namespace matrigrate
