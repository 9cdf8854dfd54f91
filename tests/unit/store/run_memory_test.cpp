#include "store/run_memory.hpp"

#include "base/failure.hpp"
#include "tables/run_files.hpp"
#include "unit/store/folder_of_tables.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>

namespace matrigrate {
namespace {

using store::RunMemory;

RunMemory example_memory() {
  RunMemory memory;
  memory.rows = {{.t = 1.0 / 3.0, .step = 7, .centre = {0.1, -0.2}, .area = 5.0, .polarization = {}, .initiated = 2},
                 {.t = 60.0, .step = 9, .cell = 3, .polarization = 0.3, .in_phase = {1, 0, 2, 3}}};
  const std::vector<std::string_view> columns = store::track_columns();
  std::string& tracks = memory.tables["tracks.csv"] = store::csv_line({columns.begin(), columns.end()});
  for (const TrackRow& row : memory.rows) tracks += store::csv_line(store::fields(row));
  memory.tables["health.csv"] = "t_s\n1\n";
  memory.step = 11;
  memory.watch = {.max_iterations = 3, .largest_residual = 1e-5};
  memory.counts = {.solve = {.iterations = 2, .residual = 0.5, .converged = true}, .orphans = 3, .list_builds = 8};
  memory.frames = {0.0, 31.2};
  memory.trajectory = 0xfedcba9876543210U;
  memory.march_wall_time = 12.5;
  return memory;
}

/// What parse_memory says of a memory in a folder.
std::string refusal(const std::string& text, const std::filesystem::path& folder) {
  try {
    store::parse_memory(text, folder);
  } catch (const InputOutputError& error) {
    return error.what();
  }
  return "accepted";
}

TEST(RunMemory, GivesTheSameBitsBack) {
  const store::FolderOfTables folder;
  folder.write(example_memory());
  const std::string text = store::to_text(example_memory());
  const RunMemory read = store::parse_memory(text, folder.path);
  EXPECT_EQ(store::to_text(read), text) << "all of it";
  EXPECT_EQ(read.tables, example_memory().tables);
  EXPECT_EQ(read.trajectory, 0xfedcba9876543210U);
  EXPECT_EQ(read.rows[0].t, 1.0 / 3.0);
  EXPECT_FALSE(read.rows[0].polarization);
  EXPECT_EQ(read.rows[1].in_phase[3], 3U);
  EXPECT_EQ(read.rows[1].cell, 3U);
  EXPECT_EQ(read.step, 11U);
  EXPECT_TRUE(std::isnan(read.force_imbalance));
  EXPECT_EQ(read.counts.list_builds, 8U);
}

TEST(RunMemory, LeavesOutRowsThatCameLater) {
  const store::FolderOfTables folder;
  RunMemory later = example_memory();
  for (auto& [name, text] : later.tables) text += "of any kind";
  folder.write(later);
  const RunMemory read = store::parse_memory(store::to_text(example_memory()), folder.path);
  EXPECT_EQ(read.tables, example_memory().tables);
  EXPECT_EQ(read.rows.size(), 2U);
}

TEST(RunMemory, RefusesTablesThatWereChanged) {
  const store::FolderOfTables folder;
  const std::string text = store::to_text(example_memory());
  EXPECT_TRUE(refusal(text, folder.path).find(".csv: cannot be read") != std::string::npos) << "there are none";
  for (const char* name : {"tracks.csv", "health.csv"}) {
    folder.write(example_memory());
    const std::string whole = example_memory().tables.at(name);
    write_file(folder.path / name, whole.substr(0, whole.size() - 1));
    EXPECT_EQ(refusal(text, folder.path), fmt::format("{}: has been cut: {} bytes are left of the {} at the checkpoint",
                                                      (folder.path / name).string(), whole.size() - 1, whole.size()));
    std::string edited = whole;
    edited[edited.size() - 2] ^= 1;
    write_file(folder.path / name, edited);
    EXPECT_EQ(refusal(text, folder.path),
              (folder.path / name).string() + ": has been changed since the checkpoint was written");
  }
}

TEST(RunMemory, LeavesDrawingsOfEarlierVersionsOut) {
  const store::FolderOfTables folder;
  folder.write(example_memory());
  auto json = nlohmann::ordered_json::parse(store::to_text(example_memory()));
  json["scenes"] = {{60.0, 40.0, 2.0, {{{1.0, 2.0}}}, {}, {{{{1.0, 1.0}}, {}, {}, {}}}, {}}};
  EXPECT_EQ(store::to_text(store::parse_memory(json.dump(), folder.path)), store::to_text(example_memory()));
}

TEST(RunMemory, RefusesWhatItIsNot) {
  const store::FolderOfTables folder;
  folder.write(example_memory());
  for (const char* text : {"", "{}", "[]", "{\"tables\": 3}", "null"})
    EXPECT_THROW(store::parse_memory(text, folder.path), InputOutputError) << text;
  const auto json = nlohmann::ordered_json::parse(store::to_text(example_memory()));
  for (const auto& [name, part] : json.items()) {
    nlohmann::ordered_json without = json;
    without.erase(name);
    EXPECT_NE(refusal(without.dump(), folder.path), "accepted") << name;
  }
  nlohmann::ordered_json no_health = json;
  no_health["tables"].erase("health.csv");
  EXPECT_TRUE(refusal(no_health.dump(), folder.path).ends_with("health.csv is not named"));
  nlohmann::ordered_json large = json;
  large["counts"][4] = 1e300;
  EXPECT_TRUE(refusal(large.dump(), folder.path).ends_with("a number is no integer, or out of range"));
}

} // namespace
} // namespace matrigrate
