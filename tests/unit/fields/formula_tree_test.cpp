#include "fields/formula_tree.hpp"

#include "fields/expression.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <string_view>

namespace matrigrate::fields {
namespace {

constexpr std::array<std::string_view, 3> x_y_F{"x", "y", "F"};

Expression formula(const std::string& text) { return {text, x_y_F, std::array{NamedNumber{"r_0", 0.5}}}; }

std::string text_of(const std::string& text) { return written(formula(text).tree().whole); }

double value_of(const std::string& text, double x = 3.0, double y = 2.0) {
  return formula(text).at(std::array{x, y, 0.1});
}

std::string said_of(const std::string& text) {
  try {
    (void)formula(text);
  } catch (const std::invalid_argument& error) {
    const std::string head = "cannot be read as a formula in x, y and F, ";
    const std::string said = error.what();
    EXPECT_TRUE(said.starts_with(head)) << said;
    return said.substr(head.size());
  }
  return "is read";
}

TEST(FormulaTree, WritesOneTextOfAllSpellings) {
  for (const char* text : {"x^2 + 1", "x**2+1", "x\u00b2 + 1", " pow(x, 2)\n+\t1", "(x^2) + 1", "power(x,2) + 1"})
    EXPECT_EQ(text_of(text), "x^2 + 1") << text;
  for (const char* text : {"200 - x*y", "200 \u2212 x\u00b7y", "200\u00a0-x\u00d7y", "((200)) - (x*y)"})
    EXPECT_EQ(text_of(text), "200 - x*y") << text;
  for (const char* text : {"x < 0 && y <= 1 ? 1 : 2", "x < 0 and y \u2264 1 ? 1 : 2", "if(x<0 && y<=1, 1, 2)",
                           "piecewise(1, and(x < 0, y <= 1), 2)", "(x < 0) && (y <= 1) ? (1) : 2"})
    EXPECT_EQ(text_of(text), "x < 0 && y <= 1 ? 1 : 2") << text;
  EXPECT_EQ(text_of("piecewise(1, x < 0, 2, x < 1, 3)"), "x < 0 ? 1 : x < 1 ? 2 : 3");
  EXPECT_EQ(text_of("not x < 0 or y > 1"), "!(x < 0) || y > 1");
  EXPECT_EQ(text_of("200 + pi + np.exp(x) + EXP(x) + arcsin(x)"), "200 + _pi + exp(x) + exp(x) + asin(x)");
  EXPECT_EQ(text_of("x\u207b\u00b2"), "x^-2");
}

TEST(FormulaTree, KeepsTheOrderOfEvaluation) {
  for (const char* text : {"x - (y - 1)", "x/(y*2)", "x*(y/2)", "x + (y + 1)", "(-x)^2", "-x^2", "2^-3^2", "(2^3)^2",
                           "2^3^2", "-(x + y)", "-(-x)", "x - -y", "(x < y) + 1", "(x > y) == (y > 1)",
                           "(x < 0 ? 1 : 2)*3", "x < 0 ? y < 0 ? 1 : 2 : 3", "max(x, y, 1)", "x*-y"})
    EXPECT_EQ(text_of(text), text);
  EXPECT_EQ(value_of("-x^2"), -9.0);
  EXPECT_EQ(value_of("2^-3^2"), std::pow(2.0, -9.0));
  EXPECT_EQ(value_of("2^3^2"), 512.0);
  EXPECT_EQ(value_of("x - (y - 1)"), 2.0);
  EXPECT_EQ(value_of("x - -y"), 5.0);
  EXPECT_EQ(value_of("-(-x)"), 3.0);
  EXPECT_EQ(value_of("+x"), 3.0);
}

TEST(FormulaTree, GivesFunctionsOfOtherPrograms) {
  EXPECT_EQ(value_of("floor(x/2) + ceil(x/2)"), 3.0);
  EXPECT_EQ(value_of("mod(-x, y)"), 1.0) << "the sign of what is divided by";
  EXPECT_EQ(value_of("mod(x, 2.5)"), 0.5);
  EXPECT_EQ(value_of("!(x < 0) ? 7 : 8"), 7.0);
  EXPECT_EQ(value_of("not(x < 0) and true ? 7 : 8"), 7.0);
  EXPECT_EQ(value_of("_pi"), std::numbers::pi);
  EXPECT_EQ(value_of("log(x)"), std::log(3.0));
}

TEST(FormulaTree, HasOneMeaningOfConstantsAndVariables) {
  EXPECT_EQ(value_of("0.5 && 1"), 1.0);
  EXPECT_EQ(value_of("r_0 && r_0 ? 7 : 8"), 7.0);
  EXPECT_EQ(value_of("0 || r_0"), 1.0);
  EXPECT_EQ(value_of("0.5*(x > 0) && 1"), 1.0);
  EXPECT_EQ(value_of("!0.5"), 0.0);
  for (const char* text : {"max(0, sqrt(-1))", "max(sqrt(-1), 0)", "min(1, sqrt(-x))", "min(0, 1, sqrt(-1), 2)",
                           "sign(sqrt(-1))", "max(0, sqrt(-1), 1)"})
    EXPECT_TRUE(std::isnan(value_of(text))) << text;
  EXPECT_EQ(value_of("min(x, y, 7)"), 2.0);
  EXPECT_EQ(value_of("max(x, y, -7)"), 3.0);
}

TEST(FormulaTree, TellsComparisonsOfThree) {
  const auto chained = [](const char* text) { return formula(text).tree().chained; };
  EXPECT_EQ(chained("-5 < y < 5 ? 0 : 1"),
            "at character 8: < 5 would compare 0 or 1 with 5, since -5 < y is 0 or 1; compare twice: -5 < y && y < 5");
  EXPECT_EQ(chained("exp(x > F > 0)"),
            "at character 11: > 0 would compare 0 or 1 with 0, since x > F is 0 or 1; compare twice: x > F && F > 0");
  EXPECT_NE(chained("x == y == 1 ? 1 : 0").find("compare twice: x == y && y == 1"), std::string::npos);
  EXPECT_NE(chained("x and 0 <= y <= 1").find("0 <= y && y <= 1"), std::string::npos);
  EXPECT_EQ(chained("-5 < y && y < 5"), "");
  EXPECT_EQ(chained("(x < 0) == (y < 0)"), "");
  EXPECT_EQ(chained("(x < 0) < 5"), "") << "with parentheses it is meant";
}

TEST(FormulaTree, CountsCharactersOnce) {
  EXPECT_EQ(said_of("\u03bc\u00b7x"), "at character 1: there is no \u03bc");
  EXPECT_EQ(said_of("200 \u2212 z"), "at character 7: there is no z");
  EXPECT_EQ(said_of("x\u00b2 + z"), "at character 6: there is no z");
  EXPECT_EQ(said_of(std::string("x\0*100", 6)), "at character 2: a control character, U+0000, is no text");
  EXPECT_EQ(said_of("x\x01"), "at character 2: a control character, U+0001, is no text");
  EXPECT_EQ(said_of("x \u263a"),
            "at character 3: between x and \u263a a sign is missing; write x*\u263a for their product");
}

TEST(FormulaTree, SaysHowToWrite) {
  EXPECT_EQ(said_of("200 + x % 10"),
            "at character 9: write mod(a, b) for the rest of a/b, which has the sign of b, and 0.5 for 50 %");
  EXPECT_EQ(said_of("200 + 2x"), "at character 8: between 2 and x a sign is missing; write 2*x for their product");
  EXPECT_EQ(said_of("100*heaviside(x) + 50"), "at character 5: there is no heaviside; write a > 0 ? 1 : 0");
  EXPECT_EQ(said_of("e^x"), "at character 1: there is no e; write exp(a) for e^a, _e for the number");
  EXPECT_EQ(said_of("1 if x < 0 else 2"), "at character 3: write c ? a : b, which is a where c holds and b otherwise");
  EXPECT_EQ(said_of("if(x < 0, 1)"), "at character 1: write c ? a : b, which is a where c holds and b otherwise");
  EXPECT_EQ(said_of("x <> y"), "at character 3: write != for unequal");
  EXPECT_EQ(said_of("x & y"), "at character 3: write && for and");
  EXPECT_EQ(said_of("x(2)"), "at character 2: x is no function; write x*( )");
  EXPECT_EQ(said_of("[x]"), "at character 1: write parentheses ( )");
  EXPECT_EQ(said_of("LOG(x)"),
            "at character 1: there is no LOG; write log10(a) of the decimal logarithm, ln(a) of the natural one");
  EXPECT_EQ(said_of("exp"), "at character 1: exp is a function; write exp( )");
  EXPECT_EQ(said_of("exp(1, 2)"), "at character 1: exp takes one value, and here are 2");
  EXPECT_EQ(said_of("atan2(1)"), "at character 1: atan2 takes 2 values, and here are 1");
  EXPECT_EQ(said_of("sum()"), "at character 1: sum takes one value or more, and here are 0");
  EXPECT_EQ(said_of("max(1, (x)"), "at character 4: the parenthesis that opens here is never closed");
  EXPECT_EQ(said_of("x ? 1"),
            "at character 6: a choice is c ? a : b, and here is the end of the formula in place of :");
  EXPECT_EQ(said_of("x : 1"), "at character 3: there is no ? before; a choice is c ? a : b");
  EXPECT_EQ(said_of("x +"), "at character 4: the formula ends where a value is expected");
  EXPECT_EQ(said_of("x + )"), "at character 5: a value is expected, and here is )");
  EXPECT_EQ(said_of("1 + 0,5*x"),
            "at character 6: a comma stands outside of a function; write 0.5 with a decimal point");
}

TEST(FormulaTree, NamesThatAreDefinedComeFirst) {
  const std::array constants{NamedNumber{"pi", 7.0}, NamedNumber{"e", 2.0}};
  EXPECT_EQ(Expression("pi*e", x_y_F, constants).at(std::array{0.0, 0.0, 0.0}), 14.0);
}

} // namespace
} // namespace matrigrate::fields
