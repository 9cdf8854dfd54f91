#include "apps/program.hpp"

#include <nlohmann/json.hpp>

namespace matrigrate {
namespace {

using nlohmann::json;

class TracksVerb : public Program {
protected:
  void SetUp() override {
    Program::SetUp();
    std::filesystem::copy(MATRIGRATE_TRACK_FILES, folder / "files");
  }
};

TEST_F(TracksVerb, PrintsWhatItUnderstoodAndTheReadouts) {
  const Ended ended = run("tracks files/uncalibrated.csv --pixel '0.65 um' --interval '2 min'");
  ASSERT_EQ(ended.code, 0) << ended.err;
  EXPECT_EQ(ended.out.substr(0, ended.out.find("\n\n") + 1),
            "6 tracks, 84 positions, every 120 s\n"
            "layout trackmate: track TRACK_ID, time FRAME x 120 s, place POSITION_X and POSITION_Y x 0.65 um\n"
            "the movie was not calibrated (POSITION_T counts frames): times are FRAME x 120 s\n");
  EXPECT_TRUE(contains(ended.out, "speed_um_per_h ")) << ended.out;
  EXPECT_EQ(ended.err, "");
}

TEST_F(TracksVerb, PrintsJson) {
  const Ended ended = run("tracks files/trackmate.csv --json");
  ASSERT_EQ(ended.code, 0) << ended.err;
  const json found = json::parse(ended.out);
  EXPECT_EQ(found.at("layout"), "trackmate");
  EXPECT_EQ(found.at("columns").at("t"), "POSITION_T");
  EXPECT_EQ(found.at("interval_s"), 120.0);
  EXPECT_EQ(found.at("rows").size(), 84U);
  EXPECT_EQ(found.at("rows").at(1), json::parse(R"(["0", 120.0, 232.702, 69.601])"));
  EXPECT_NEAR(found.at("readouts").at("speed_um_per_h").at("value").get<double>(), 50.8352, 1e-3);
  EXPECT_EQ(found.at("readouts").at("speed_um_per_h").at("unit"), "um/h");
  EXPECT_TRUE(found.at("readouts").at("persistence_min").at("value").is_null()) << "not defined";
}

TEST_F(TracksVerb, WritesThePlainFormAndKeepsWhatIsThere) {
  const std::string options = "tracks files/celltrackscolab.csv --pixel 1 --interval 120 -o plain.csv";
  ASSERT_EQ(run(options).code, 0);
  const std::string plain = text_of(folder / "plain.csv");
  EXPECT_EQ(plain.substr(0, plain.find('\n', 25) + 1), "track,t_s,x_um,y_um\ngelA_movie1_0,0,230.865,70.367\n");
  const Ended again = run(options);
  EXPECT_EQ(again.code, 5);
  EXPECT_EQ(again.err, "matrigrate: plain.csv: exists; --force replaces it\n");
  ASSERT_EQ(run(options + " --force").code, 0);
  const json first = json::parse(run("tracks files/celltrackscolab.csv --pixel 1 --interval 120 --json").out);
  const json second = json::parse(run("tracks plain.csv --json").out);
  EXPECT_EQ(first.at("rows"), second.at("rows"));
  EXPECT_EQ(first.at("readouts"), second.at("readouts"));
  EXPECT_EQ(run("tracks plain.csv -o plain.csv --force").code, 5);
  EXPECT_EQ(text_of(folder / "plain.csv"), plain);
}

TEST_F(TracksVerb, ReadsWhatThisProgramWrites) {
  write("s.toml", "[ecm]\nradius = \"40 um\"\n[run]\nduration = \"16 s\"\n[output]\ntrack_interval = \"2 s\"\n");
  ASSERT_EQ(run("run s.toml -o r").code, 0);
  ASSERT_EQ(run("export r --tracks -o e").code, 0);
  const std::string options = " --json --fewest 1";
  const json own = json::parse(run("tracks r/tracks.csv" + options).out).at("rows");
  EXPECT_EQ(own.size(), 9U);
  const auto positions = [](json rows) {
    for (json& row : rows) row.erase(0); // the name of the track
    return rows;
  };
  for (const char* file : {"tracks_celltrackr.csv", "tracks_trackmate.csv", "tracks_trackmate.xml"}) {
    const Ended ended = run(std::string("tracks e/") + file + options);
    ASSERT_EQ(ended.code, 0) << file << ended.err;
    EXPECT_EQ(positions(json::parse(ended.out).at("rows")), positions(own)) << file;
  }
}

TEST_F(TracksVerb, ReadsTheTablesOfAStudy) {
  write("s.toml", "[ecm]\nradius = \"40 um\"\n[run]\nduration = \"16 s\"\n[output]\ntrack_interval = \"2 s\"\n");
  write("st.toml", "title = \"Two\"\nscenario = \"s.toml\"\nreplicates = 1\n[sweep]\nprotrusion.number = [1, 2]\n");
  ASSERT_EQ(run("study run st.toml -o st --quiet").code, 0);
  ASSERT_EQ(run("export st --tracks").code, 0);
  for (const char* file : {"tracks.csv", "tracks_spots.csv"}) {
    const Ended ended = run(std::string("tracks st/export/") + file + " --json");
    ASSERT_EQ(ended.code, 0) << file << ended.err;
    EXPECT_EQ(json::parse(ended.out).at("tracks"), 2) << file;
    EXPECT_EQ(json::parse(ended.out).at("positions"), 18) << file;
  }
  EXPECT_EQ(run("tracks st/export/tracks.csv -o ''").code, 2);
}

TEST_F(TracksVerb, FaultsAreToldAllAtOnceAndNothingIsWritten) {
  const Ended ended = run("tracks files/uncalibrated.csv -o plain.csv --json");
  EXPECT_EQ(ended.code, 3);
  EXPECT_EQ(ended.out, "");
  EXPECT_TRUE(contains(
      ended.err, "files/uncalibrated.csv: POSITION_X and POSITION_Y are in pixel: give --pixel UM, um per pixel\n"))
      << ended.err;
  EXPECT_TRUE(contains(ended.err, "give --interval S, s from frame to frame")) << ended.err;
  EXPECT_TRUE(contains(run("tracks files/uncalibrated.csv --records").err, "give {pixel UM}, um per pixel\n"));
  EXPECT_TRUE(!exists("plain.csv"));
  EXPECT_EQ(run("tracks nowhere.csv").code, 5);
  EXPECT_EQ(run("tracks files").code, 5);
}

TEST_F(TracksVerb, OptionsThatAreWrongAreUsage) {
  const auto refused = [&](const std::string& options, const std::string& message) {
    const Ended ended = run("tracks files/trackmate.csv " + options);
    EXPECT_EQ(ended.code, 2) << options;
    EXPECT_TRUE(contains(ended.err, message)) << ended.err;
  };
  refused("--pixel 0", "--pixel: 0 is out of range");
  refused("--pixel '2 s'", "--pixel: \"2 s\": is a time, but a length is expected");
  refused("--interval fast", "--interval: \"fast\":");
  refused("--time-unit sek", "--time-unit: there is no \"sek\"; there are ms, s, min, h, d");
  refused("--layout trackmat", "did you mean trackmate?");
  refused("--splits keep", "--splits: there is no \"keep\"; there are refuse, cut and drop");
  refused("--jitter 0.5", "--jitter: 0.5 is out of range");
  refused("--columns trak=a", "did you mean track?");
  refused("--columns x=a,x=b", "x is named twice");
}

TEST_F(TracksVerb, DrawsGroupsBesideARun) {
  std::filesystem::create_directory(folder / "model");
  write("model/run.json", R"({"status":"done"})");
  std::string rows = "track,t_s,x_um,y_um\n";
  for (int k = 0; k <= 40; ++k) rows += "1," + std::to_string(60 * k) + "," + std::to_string(0.5 * k) + ",0\n";
  write("model/tracks.csv", rows);
  const std::string command = "tracks files/trackmate.csv --beside model";
  const Ended ended = run(command + " --error '0.2 um'");
  ASSERT_EQ(ended.code, 0) << ended.err;
  EXPECT_TRUE(contains(ended.out, "trackmate 50.4")) << ended.out;
  EXPECT_TRUE(contains(ended.out, "open beside.html\n")) << ended.out;
  EXPECT_TRUE(contains(text_of(folder / "beside.html"), "\"matrigrate-study\""));
  EXPECT_EQ(run(command).err, "matrigrate: beside.html: exists; --force replaces it, -o names another file\n");
  const auto refused = [&](const std::string& options, int code, const std::string& message) {
    const Ended other = run("tracks " + options + " -o other.html");
    EXPECT_EQ(other.code, code) << options;
    EXPECT_TRUE(contains(other.err, message)) << other.err;
    EXPECT_TRUE(!exists("other.html"));
  };
  refused("files/trackmate.csv files/trackmate.csv --beside model", 3, "has the same positions as files/trackmate.csv");
  refused("files/trackmate.csv --beside model --json", 2, "--json prints the read-outs of one file");
  EXPECT_EQ(run("tracks files/trackmate.csv --beside model -o files/trackmate.csv --force").code, 5)
      << "measured data stay";
  write("model/run.json", R"({"status":"failed"})");
  refused("files/trackmate.csv --beside model", 3, "its run is failed, not done");
  write("model/run.json", R"({"status":"done"})");
  refused("files/trackmate.csv --beside files", 5, "files: is the folder of neither a run");
  refused("files/trackmate.csv files/celltrackscolab.csv", 2, "several files are for --beside");
  refused("files/trackmate.csv --beside model --error '-1 um'", 2, "--error: -1 um is no localisation error");
}

} // namespace
} // namespace matrigrate
