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

Field diagonal(const synthetic::Body& body) {
  Field D;
  D.resize(body.x.size());
  for (std::size_t i = 0; i < D.size(); ++i) D.x()[i] = static_cast<float>(body.A.diagonal[i]);
  return D;
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
    body.A.pairs.multiply(diagonal(body), x, y);
    std::vector<Vec2> v(n), expected(n);
    for (std::size_t i = 0; i < n; ++i) v[i] = Vec2(x.x()[i], x.y()[i]);
    for (std::size_t i = 0; i < n; ++i) {
      expected[i] = body.A.diagonal[i] * v[i];
      if (body.prescribed[i]) continue;
      for (const std::uint32_t j : body.pairs.of(i))
        if (!body.prescribed[j])
          expected[i] -= synthetic::drag((body.x[i] - body.x[j]).norm(), body.volume * body.volume) * v[j];
    }
    std::vector<Vec2> product(n);
    multiply(body.A, v, product);
    for (std::size_t i = 0; i < n; ++i) EXPECT_NEAR((product[i] - expected[i]).norm(), 0.0, 1e-5);
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
  near.A.pairs.residual(diagonal(near), x, x, a);
  far.A.pairs.residual(diagonal(far), x, x, b);
  EXPECT_EQ(a.values(), b.values());
}
