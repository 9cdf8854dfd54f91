#include "base/csv_text.hpp"
#include "tables/table.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <limits>
#include <stdexcept>
#include <string>

namespace matrigrate::store {
namespace {

TEST(Table, WritesAHeaderAndOneLineARow) {
  Table table{{"time_s", "stress_Pa"}, {}};
  table.add({0.0, 1.5});
  table.add({10.0, -2.0});
  EXPECT_EQ(to_csv(table), "time_s,stress_Pa\n0,1.5\n10,-2\n");
}

TEST(Table, NumbersReadBackToTheSameBits) {
  const std::vector<double> numbers{0.1,  1.0 / 3.0,           1e-310, 6.02214076e23,
                                    -0.0, 123456789.123456789, 1e22,   std::numeric_limits<double>::max()};
  for (const double number : numbers) {
    Table table{{"x"}, {}};
    table.add({number});
    const std::string csv = to_csv(table);
    const double read = std::strtod(csv.c_str() + 2, nullptr);
    EXPECT_EQ(read, number) << csv;
    EXPECT_EQ(std::signbit(read), std::signbit(number)) << csv;
  }
}

TEST(Table, WritesNumbersInTheirShortestForm) {
  Table table{{"x"}, {}};
  table.add({0.1});
  EXPECT_EQ(to_csv(table), "x\n0.1\n");
}

TEST(Table, WritesMissingNumbersAsEmptyFields) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double inf = std::numeric_limits<double>::infinity();
  Table table{{"a", "b", "c"}, {}};
  table.add({nan, 2.0, nan});
  table.add({inf, -inf, 0.0});
  EXPECT_EQ(to_csv(table), "a,b,c\n,2,\ninf,-inf,0\n");
  Table lone{{"a"}, {}};
  lone.add({nan});
  EXPECT_EQ(to_csv(lone), "a\n\"\"\n") << "an empty line would be skipped by readers";
}

TEST(Table, QuotesColumnsThatHoldSeparators) {
  const Table table{{"a,b", "say \"x\"", "plain"}, {}};
  EXPECT_EQ(to_csv(table), "\"a,b\",\"say \"\"x\"\"\",plain\n");
}

TEST(Table, NoSpreadsheetComputesText) {
  EXPECT_EQ(csv_text("=cmd|'/c calc'!A1"), "'=cmd|'/c calc'!A1");
  EXPECT_EQ(csv_text("=HYPERLINK(\"x\",1)"), "\"'=HYPERLINK(\"\"x\"\",1)\"");
  for (const std::string text : {"+1+2", "-1+cmd|' /C calc'!A1", "-10 %", "@SUM(A1)", "\t=1", "-", "+"})
    EXPECT_EQ(csv_text(text), "'" + text);
  EXPECT_EQ(csv_text("\r=1"), "\"'\r=1\"");
  for (const std::string text : {"-1.5", "+1.5", "-1e-3", "-inf", "0", "", "50 Pa", "E = 50 Pa", "a-b", "'=1"})
    EXPECT_EQ(csv_text(text), text) << "left as it is";
}

TEST(Table, RefusesRowsOfAnotherLength) {
  Table table{{"a", "b"}, {}};
  EXPECT_THROW(table.add({1.0}), std::invalid_argument);
  EXPECT_TRUE(table.rows.empty());
  table.rows.push_back({1.0, 2.0, 3.0});
  EXPECT_THROW(to_csv(table), std::invalid_argument);
}

} // namespace
} // namespace matrigrate::store
