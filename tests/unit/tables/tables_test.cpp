#include "base/failure.hpp"
#include "base/text.hpp"
#include "tables/table.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <limits>
#include <stdexcept>
#include <string>

namespace matrigrate::store {
namespace {

TEST(Csv, ReadsWhatTheProgramWrites) {
  using View = std::string_view;
  const std::string text = csv_line({View("name"), View("x_um"), View("note")})
                           + csv_line({View("a, \"b\""), 0.1, View("two\nlines")})
                           + csv_line({View(""), NAN, View("c")});
  const CsvTable table = read_csv(text);
  EXPECT_EQ(table.header, (std::vector<std::string>{"name", "x_um", "note"}));
  ASSERT_EQ(table.rows.size(), 2U);
  EXPECT_EQ(table.rows[0], (std::vector<std::string>{"a, \"b\"", "0.1", "two\nlines"}));
  EXPECT_EQ(table.rows[1], (std::vector<std::string>{"", "", "c"}));
  EXPECT_EQ(table.column("note"), 2U);
  EXPECT_FALSE(table.column("y_um"));
  EXPECT_EQ(csv_number("0.1"), 0.1);
  EXPECT_TRUE(std::isnan(csv_number("")));
}

TEST(Csv, ANumberIsReadWholeOrRefused) {
  for (const char* bad : {"1,5", "0x10", "abc", "nan", "inf", "1e400", "1 ", "+1"})
    EXPECT_THROW(csv_number(bad), InputOutputError) << bad;
  const auto message = [](const auto& read) {
    try {
      read();
    } catch (const InputOutputError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_EQ(message([] { csv_column("t_s,x_um\n0,1\n1,2x\n", "x_um"); }), "line 3, column x_um: \"2x\" is no number");
  EXPECT_EQ(message([] { read_table("t_s,x_um\n0,1\n1,2x\n"); }), "line 3, column x_um: \"2x\" is no number");
}

TEST(Csv, TablesOfNumbersAreReadBackAndGroupedByTheirFirstColumn) {
  Table table{.columns = {"angle_deg", "stress_Pa"}, .rows = {}};
  table.add({90.0, 0.1});
  table.add({0.0, NAN});
  table.add({90.0, 1.0 / 3.0});
  const Table read = read_table(to_csv(table));
  EXPECT_EQ(read.columns, table.columns);
  EXPECT_EQ(read.column("angle_deg"), (std::vector<double>{90.0, 0.0, 90.0}));
  EXPECT_TRUE(std::isnan(read.column("stress_Pa")[1]));
  EXPECT_THROW(read.column("strain"), InputOutputError);
}

TEST(Csv, ColumnsOfOneTableHaveAsManyNumbers) {
  const auto columns = csv_columns("t_s,x_um\n0,1\n5,\n", {"x_um", "t_s"});
  ASSERT_EQ(columns.size(), 2U);
  EXPECT_EQ(columns[1], (std::vector<double>{0.0, 5.0}));
  EXPECT_EQ(columns[0].size(), 2U);
  EXPECT_THROW(csv_columns("t_s,x_um\n0,1\n", {"t_s", "y_um"}), InputOutputError);
  EXPECT_TRUE(csv_columns("", {"t_s", "y_um"})[1].empty());
}

TEST(Csv, RefusesWhatIsNoTable) {
  const auto message = [](std::string_view text) {
    try {
      read_csv(text);
    } catch (const InputOutputError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_EQ(message("a,b\n1,2\n1\n"), "line 3: has 1 fields, its header 2");
  EXPECT_EQ(message("a\n\"1\n"), "line 2: a quote is not closed");
  EXPECT_EQ(message("a\n\"1\"2\n"), "line 2: a quoted field goes on after its quote");
  EXPECT_EQ(message("a,b\n1,2"), "") << "the last line may lack its end";
  EXPECT_TRUE(read_csv("").header.empty());
}

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
