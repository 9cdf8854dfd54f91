#include "exchange/simularium.hpp"

#include "unit/exchange/film.hpp"

#include <nlohmann/json.hpp>

#include <gtest/gtest.h>

#include <stdexcept>
#include <vector>

namespace matrigrate::exchange {
namespace {

/// An agent of a frame.
struct Agent {
  int kind, id, type;
  std::vector<double> points;
};

/// The agents of a frame, as the viewer takes its numbers apart.
std::vector<Agent> agents(const nlohmann::json& data) {
  std::vector<Agent> all;
  for (std::size_t at = 0; at < data.size();) {
    const auto more = data.at(at + 10).get<std::size_t>();
    Agent agent{data.at(at), data.at(at + 1), data.at(at + 2), {}};
    for (std::size_t k = 0; k < more; ++k) agent.points.push_back(data.at(at + 11 + k));
    all.push_back(agent);
    at += 11 + more;
  }
  return all;
}

TEST(Simularium, HasTheAgentsOfEachFrame) {
  const std::vector<TrackRow> rows{{.t = 0.0, .centre = {0, 0}, .polarization = {}},
                                   {.t = 60.0, .centre = {3, 4}, .polarization = {}}};
  const auto file = nlohmann::json::parse(simularium(small_film(), rows, "A \"title\"", "1.2"));
  const auto& info = file.at("trajectoryInfo");
  EXPECT_EQ(info.at("version"), 3);
  EXPECT_EQ(info.at("timeStepSize"), 300.0);
  EXPECT_EQ(info.at("totalSteps"), 2);
  EXPECT_EQ(info.at("trajectoryTitle"), "A \"title\"");
  EXPECT_EQ(info.at("size").at("x"), 8.0);
  const auto& bundle = file.at("spatialData");
  EXPECT_EQ(bundle.at("bundleSize"), 2);
  EXPECT_EQ(bundle.at("bundleData").at(1).at("time"), 300.0);
  const std::vector<Agent> first = agents(bundle.at("bundleData").at(0).at("data"));
  ASSERT_EQ(first.size(), 1U + 1U + 4U); // cell, adhesion, matrix
  EXPECT_EQ(first[0].kind, 1001);
  EXPECT_EQ(first[0].points, (std::vector<double>{-1, -1, 2, 1, -1, 2, 1, 1, 2, -1, 1, 2, -1, -1, 2})); // closed
  EXPECT_EQ(info.at("typeMapping").at(std::to_string(first[0].type)).at("name"), "cell 1");
  EXPECT_EQ(first[1].kind, 1000);
  EXPECT_EQ(info.at("typeMapping").at(std::to_string(first[1].type)).at("name"), "adhesion");
  EXPECT_EQ(info.at("typeMapping").at(std::to_string(first[3].type)).at("name"), "matrix#degraded");
  EXPECT_EQ(agents(bundle.at("bundleData").at(1).at("data")).size(), 5U);
  for (const auto& [number, of] : info.at("typeMapping").items())
    EXPECT_FALSE(of.at("name").get<std::string>().empty());
  EXPECT_EQ(file.at("plotData").at("data").at(0).at("data").at(0).at("y"), (nlohmann::json{0.0, 5.0}));
}

TEST(Simularium, HasFramesOfOneIntervalOnly) {
  observe::Film film = small_film();
  film.frames.push_back(film.frames.back());
  film.frames.back().t = 500.0; // the run ended then
  const auto file = nlohmann::json::parse(simularium(film, {}, "", "1.2"));
  EXPECT_EQ(file.at("trajectoryInfo").at("timeStepSize"), 300.0);
  EXPECT_EQ(file.at("trajectoryInfo").at("totalSteps"), 2);
  EXPECT_EQ(file.at("spatialData").at("bundleData").size(), 2U);
  EXPECT_EQ(file.at("spatialData").at("bundleSize"), 2);
  film.frames.push_back(film.frames.back());
  film.frames.back().t = 700.0;
  EXPECT_THROW(simularium(film, {}, "", "1.2"), std::invalid_argument);
}

} // namespace
} // namespace matrigrate::exchange
