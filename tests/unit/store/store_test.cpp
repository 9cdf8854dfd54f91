#include "base/failure.hpp"
#include "base/file.hpp"
#include "store/deflate.hpp"
#include "store/run_memory.hpp"
#include "store/trajectory_hash.hpp"
#include "tables/run_files.hpp"
#include "tables/state_json.hpp"
#include "unit/store/folder_of_tables.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <unistd.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <string>

namespace matrigrate::store {
namespace {

TEST(Base64, IsThatOfRfc4648) {
  EXPECT_EQ(base64(""), "");
  EXPECT_EQ(base64("f"), "Zg==");
  EXPECT_EQ(base64("fo"), "Zm8=");
  EXPECT_EQ(base64("foo"), "Zm9v");
  EXPECT_EQ(base64("foob"), "Zm9vYg==");
  EXPECT_EQ(base64("fooba"), "Zm9vYmE=");
  EXPECT_EQ(base64("foobar"), "Zm9vYmFy");
}

TEST(Deflated, ComesBackAndRefusesWhatItIsNot) {
  const std::string text(1000, 'x');
  for (const std::string& stored : {deflated(text, 6), deflated_fast(text)}) {
    EXPECT_LT(stored.size(), 50U);
    EXPECT_EQ(inflated(stored, 1000), text);
    EXPECT_THROW(inflated(stored, 999), InputOutputError);
  }
  EXPECT_EQ(inflated(deflated_fast(""), 0), "");
  EXPECT_THROW(inflated("nonsense", 8), InputOutputError);
}

TEST(Deflated, HasRoomForWhatDoesNotCompress) {
  std::string noise;
  for (std::uint32_t k = 0, x = 1; k < 300000; ++k) noise += static_cast<char>((x = x * 1664525U + 1013904223U) >> 24U);
  EXPECT_EQ(inflated(deflated_fast(noise), noise.size()), noise);
}

TEST(BytePlanes, HoldTheFirstBytesOfAllNumbersFirst) {
  const std::array<std::uint16_t, 3> numbers{0x0102, 0x0304, 0x0506};
  EXPECT_EQ(byte_planes(std::span<const std::uint16_t>(numbers)), "\x02\x04\x06\x01\x03\x05");
  EXPECT_EQ(byte_planes(std::span<const std::uint8_t>()), "");
}

std::string nested(std::size_t levels) { return std::string(levels, '[') + std::string(levels, ']'); }

TEST(JsonText, RefusesTooManyLevels) {
  EXPECT_TRUE(parse_json(nested(max_json_levels)).is_array());
  EXPECT_TRUE(parse_json(nested(max_json_levels + 1)).is_discarded());
  EXPECT_TRUE(parse_json(R"({"a": )" + nested(200000) + "}").is_discarded());
  EXPECT_THROW(parse_memory(nested(200000), {}), InputOutputError);
  const std::string in_a_text = "[\"\\\"" + std::string(200000, '[') + "\"]";
  EXPECT_TRUE(parse_json(in_a_text).is_array()) << "brackets in a text are no levels";
}

TEST(JsonText, TellsWhatIsNoObject) {
  const auto file = std::filesystem::temp_directory_path() / ("json_text_" + std::to_string(::getpid()) + ".json");
  const auto refusal = [&](const std::string& text) -> std::string {
    write_file(file, text);
    try {
      read_json_object(file, 1U << 20U);
    } catch (const InputOutputError& error) {
      return error.what();
    }
    return "accepted";
  };
  EXPECT_EQ(refusal("{\"a\": 1}"), "accepted");
  EXPECT_EQ(refusal("[1]"), file.string() + ": is no JSON object, but of type array");
  EXPECT_EQ(refusal("\"a\""), file.string() + ": is no JSON object, but of type string");
  EXPECT_EQ(refusal("{"), file.string() + ": is no JSON");
  EXPECT_EQ(refusal(nested(200000)), file.string() + ": has brackets nested more than 100 levels deep");
  std::filesystem::remove(file);
}

} // namespace
} // namespace matrigrate::store

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

namespace matrigrate::store {
namespace {

State state() {
  State s;
  s.cells.emplace_back().cortex.x = {{1, 2}, {3, 4}};
  s.ecm.x = {{5, 6}, {7, 8}, {9, 10}};
  return s;
}

std::string hash(const State& s) {
  TrajectoryHash h;
  h.add(s);
  return h.text();
}

TEST(TrajectoryHash, SeesEveryBit) {
  const std::string reference = hash(state());
  EXPECT_EQ(reference.size(), 16U);
  EXPECT_EQ(hash(state()), reference);
  State s = state();
  s.ecm.x[2].y() = std::nextafter(10.0, 11.0);
  EXPECT_NE(hash(s), reference);
  s = state();
  s.cells[0].cortex.x[0].x() = std::nextafter(1.0, 0.0);
  EXPECT_NE(hash(s), reference);
  s = state();
  ++s.step;
  EXPECT_NE(hash(s), reference);
}

TEST(TrajectoryHash, SeesEveryCell) {
  State s = state();
  s.cells.push_back(s.cells[0]);
  EXPECT_NE(hash(s), hash(state()));
  const std::string both = hash(s);
  s.cells[1].cortex.x[1].y() = 5.0;
  EXPECT_NE(hash(s), both);
}

TEST(TrajectoryHash, SeesEveryNucleus) {
  State s = state();
  s.cells[0].nucleus.x = {{1, 1}, {2, 2}};
  const std::string with = hash(s);
  EXPECT_NE(with, hash(state()));
  s.cells[0].nucleus.x[1].x() = std::nextafter(2.0, 3.0);
  EXPECT_NE(hash(s), with);
}

TEST(TrajectoryHash, GoesOn) {
  TrajectoryHash h;
  h.add(state());
  const std::string one = h.text();
  EXPECT_EQ(h.text(), one) << "telling it does not change it";
  h.add(state());
  EXPECT_NE(h.text(), one);
}

TEST(TextHash, IsThatOfXxHash) { EXPECT_EQ(text_hash(""), "2d06800538d394c2"); } // XXH3_64bits of nothing

} // namespace
} // namespace matrigrate::store
