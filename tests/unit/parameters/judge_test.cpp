#include "parameters/judge.hpp"

#include "base/failure.hpp"

#include <nlohmann/json.hpp>

#include <gtest/gtest.h>

namespace matrigrate {
namespace {

nlohmann::json answer(const std::string& question) { return nlohmann::json::parse(judged("[" + question + "]")).at(0); }

std::string fault(const std::string& question) { return answer(question).at("fault"); }

TEST(Judge, GivesNumbersInTheDocumentedUnit) {
  EXPECT_EQ(answer(R"({"path": "ecm.youngs_modulus", "value": "0.05 kPa"})").at("number"), 50.0);
  EXPECT_EQ(answer(R"({"path": "run.duration", "value": "6 h 30 min"})").at("number"), 6.5);
  EXPECT_EQ(answer(R"({"path": "cells.y", "value": "-0.02 mm"})").at("number"), -20.0);
  EXPECT_EQ(answer(R"({"path": "ecm.lattice", "value": "square"})"), (nlohmann::json{{"fault", ""}, {"number", 0.0}}));
}

TEST(Judge, HasTheWordsOfTheReader) {
  EXPECT_EQ(fault(R"({"path": "ecm.youngs_modulus", "value": "50 s"})"),
            "\"50 s\" is a time, but a stress is expected; write it like \"200 Pa\"");
  EXPECT_EQ(fault(R"({"path": "ecm.youngs_modulus", "real": "nan"})"), "nan is not a finite number");
  EXPECT_EQ(fault(R"({"path": "ecm.youngs_modulus", "type": "an array"})"),
            "is an array, but a number with its unit is expected, such as \"200 Pa\"");
  EXPECT_EQ(fault(R"({"path": "ecm.youngs_modulu", "value": 1})"),
            "there is no such parameter; did you mean ecm.youngs_modulus?");
  EXPECT_EQ(fault(R"({"path": "emc", "section": true})"), "there is no such section; did you mean ecm?");
}

TEST(Judge, RefusesWhatIsNoListOfValues) {
  for (const char* text : {"", "{", "[1]", "[{}]", R"([{"path": "ecm.radius"}])", R"([{"path": 3, "value": 1}])",
                           R"([{"path": "ecm.radius", "value": [1]}])"})
    EXPECT_THROW(judged(text), ConfigurationError) << text;
}

} // namespace
} // namespace matrigrate
