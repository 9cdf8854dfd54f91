#include "program.hpp"

#include "tables/table.hpp"

#include <set>

namespace matrigrate {
namespace {

/// The tracks of a study of a cell in a small disc, followed for a few steps.
class ExportStudy : public Program {
protected:
  void SetUp() override {
    Program::SetUp();
    write("s.toml", "[ecm]\nradius = \"40 um\"\n[run]\nduration = \"8 s\"\n[output]\ntrack_interval = \"2 s\"\n"
                    "report = false\n");
    write("e.toml",
          "title = \"Stiffness\"\nscenario = \"s.toml\"\nreplicates = 2\n[[points]]\nlabel = \"soft, or so\"\n"
          "ecm.youngs_modulus = \"0.05 kPa\"\n[[points]]\nlabel = \"=stiff\"\necm.youngs_modulus = \"100 Pa\"\n");
  }

  store::CsvTable table(const std::string& name) const { return store::read_csv(text_of(folder / name)); }

  void refuses(const std::string& arguments, const std::string& words) const {
    const Ended ended = run(arguments);
    EXPECT_EQ(ended.code, 5) << arguments;
    EXPECT_TRUE(contains(ended.err, words)) << ended.err;
  }
};

TEST_F(ExportStudy, PutsTheTracksOfAllRunsInOneFile) {
  ASSERT_EQ(run("study run e.toml").code, 0);
  const Ended ended = run("export e-study --tracks");
  ASSERT_EQ(ended.code, 0) << ended.err;
  EXPECT_EQ(ended.out, "exported the tracks of 4 of 4 runs to e-study/export/tracks.csv\n");
  const store::CsvTable all = table("e-study/export/tracks.csv");
  const store::CsvTable results = table("e-study/results.csv");
  ASSERT_EQ(std::vector(all.header.begin(), all.header.begin() + 5),
            (std::vector<std::string>{"run", "label", "ecm.youngs_modulus_Pa", "replicate", "seed"}));
  std::size_t at = 0;
  for (const std::vector<std::string>& of_run : results.rows) { // in the order of results.csv, bit by bit
    const store::CsvTable own = table("e-study/runs/" + of_run[0] + "/tracks.csv");
    EXPECT_EQ(std::vector(all.header.begin() + 5, all.header.end()), own.header);
    for (const std::vector<std::string>& row : own.rows) {
      ASSERT_LT(at, all.rows.size());
      EXPECT_EQ(std::vector(all.rows[at].begin(), all.rows[at].begin() + 5),
                std::vector(of_run.begin(), of_run.begin() + 5));
      EXPECT_EQ(std::vector(all.rows[at].begin() + 5, all.rows[at].end()), row);
      ++at;
    }
  }
  EXPECT_EQ(at, all.rows.size());
  EXPECT_EQ(all.rows.size(), 4U * 5U);
  EXPECT_EQ(all.rows[0][1], "soft, or so");
  EXPECT_EQ(all.rows[0][2], "50");
}

TEST_F(ExportStudy, LeavesWhatOnlyANucleusHasEmptyElsewhere) {
  write("e.toml", "title = \"Nucleus\"\nscenario = \"s.toml\"\nreplicates = 1\n[[points]]\nlabel = \"a\"\n"
                  "nucleus.radius = \"0 um\"\n[[points]]\nlabel = \"b\"\nnucleus.radius = \"5 um\"\n");
  ASSERT_EQ(run("study run e.toml").code, 0);
  ASSERT_EQ(run("export e-study --tracks").code, 0);
  const store::CsvTable all = table("e-study/export/tracks.csv");
  ASSERT_EQ(all.header.back(), "nucleus_aspect_ratio");
  ASSERT_EQ(all.rows.size(), 2U * 5U);
  EXPECT_EQ(all.rows.front().back(), "");
  EXPECT_EQ(all.rows.front().size(), all.header.size());
  EXPECT_NEAR(std::stod(all.rows.back().back()), 1.0, 1e-6);
}

TEST_F(ExportStudy, ReplacesNothingByItself) {
  ASSERT_EQ(run("study run e.toml").code, 0);
  ASSERT_EQ(run("export e-study --tracks -o here").code, 0);
  const std::string before = text_of(folder / "here/tracks.csv");
  write("here/tracks.csv", "mine");
  refuses("export e-study --tracks -o here", "here/tracks.csv: exists; --tracks --force replaces this kind of export");
  EXPECT_EQ(text_of(folder / "here/tracks.csv"), "mine");
  ASSERT_EQ(run("export e-study --tracks -o here --force").code, 0);
  EXPECT_EQ(text_of(folder / "here/tracks.csv"), before);
}

TEST_F(ExportStudy, TakesTheRunsThatAreDone) {
  ASSERT_EQ(run("study run e.toml").code, 0);
  const std::string first = table("e-study/results.csv").rows[0][0];
  std::filesystem::remove_all(folder / "e-study/runs" / first);
  const Ended ended = run("export e-study --tracks");
  ASSERT_EQ(ended.code, 0) << ended.err;
  EXPECT_TRUE(contains(ended.out, "of 3 of 4 runs")) << ended.out;
  std::set<std::string> runs;
  for (const std::vector<std::string>& row : table("e-study/export/tracks.csv").rows) runs.insert(row[0]);
  EXPECT_EQ(runs.size(), 3U);
  EXPECT_FALSE(runs.contains(first));
}

TEST_F(ExportStudy, RefusesWhatItCannotExport) {
  ASSERT_EQ(run("study run e.toml").code, 0);
  for (const char* kind : {"--panel 0", "--png", "--tracks --fields"})
    refuses(std::string("export e-study ") + kind, "e-study: is the folder of a study; name one of its runs");
  const std::string damaged = "e-study/runs/" + table("e-study/results.csv").rows[1][0] + "/tracks.csv";
  const std::string whole = text_of(folder / damaged);
  write(damaged, whole.substr(0, whole.size() - 9));
  const std::string changed = " is damaged: tracks.csv: has been cut or changed since the run ended";
  refuses("export e-study --tracks", changed);
  for (const std::string& text : {whole + "1,2\n", "other" + whole}) {
    write(damaged, text);
    refuses("export e-study --tracks", changed);
  }
  std::filesystem::remove(folder / damaged);
  refuses("export e-study --tracks", " is damaged: tracks.csv: ");
  std::filesystem::remove_all(folder / "e-study/runs");
  refuses("export e-study --tracks",
          "e-study: none of its 4 runs is done; matrigrate study run e-study/study.resolved.toml computes them");
  EXPECT_FALSE(exists("e-study/export"));
}

} // namespace
} // namespace matrigrate
