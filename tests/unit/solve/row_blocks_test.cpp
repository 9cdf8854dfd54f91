#include "solve/row_blocks.hpp"

#include "synthetic.hpp"

#include <gtest/gtest.h>

using namespace matrigrate;

namespace {

Field some_values(std::size_t n) {
  Field a;
  a.resize(n);
  for (std::size_t i = 0; i < n; ++i) {
    a.x()[i] = std::sin(1.0F + static_cast<float>(i));
    a.y()[i] = std::cos(0.3F * static_cast<float>(i));
  }
  return a;
}

RowBlocks blocks(const synthetic::Body& body) {
  RowBlocks result;
  result.assign(body.pairs, body.A.coupling, body.A.diagonal);
  return result;
}

} // namespace

TEST(RowBlocks, MultiplyAsTheSystemDoes) {
  for (const bool stirred : {false, true}) {
    synthetic::Body body = synthetic::disc(31.0);
    if (stirred) synthetic::stir(body, 20.0, 6.0, 0.5);
    const std::size_t n = body.x.size();
    ASSERT_NE(n % Field::lanes, 0U); // the last block is not full
    const Field x = some_values(n);
    Field y = some_values(n);
    blocks(body).multiply(x, y);
    std::vector<Vec2> v(n), expected(n);
    for (std::size_t i = 0; i < n; ++i) v[i] = Vec2(x.x()[i], x.y()[i]);
    multiply(body.A, v, expected);
    for (std::size_t i = 0; i < n; ++i) {
      EXPECT_NEAR(y.x()[i], expected[i].x(), 1e-5);
      EXPECT_NEAR(y.y()[i], expected[i].y(), 1e-5);
    }
  }
}

TEST(RowBlocks, DoNotSeeHowFarTheListReaches) {
  synthetic::Body near = synthetic::disc(31.0);
  synthetic::Body far = synthetic::disc(31.0);
  near.assemble(0.1);
  far.assemble(2.0);
  ASSERT_LT(near.pairs.pairs(), far.pairs.pairs());
  const Field x = some_values(near.x.size());
  Field a = x, b = x;
  blocks(near).residual(x, x, a);
  blocks(far).residual(x, x, b);
  EXPECT_EQ(a.values(), b.values());
}
