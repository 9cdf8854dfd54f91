#include "store/csv.hpp"

#include "base/failure.hpp"
#include "store/row_file.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace matrigrate::io {
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

} // namespace
} // namespace matrigrate::io
