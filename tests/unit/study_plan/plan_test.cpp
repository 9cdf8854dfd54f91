#include "parameters/schema.hpp"
#include "parameters/write.hpp"
#include "study_plan/names.hpp"
#include "study_plan/read_study.hpp"
#include "study_plan/sweep.hpp"
#include "unit/study_plan/studies.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <set>
#include <string>

namespace matrigrate::study {
namespace {

std::vector<Run> runs_of(const Study& s) {
  return planned_runs(s, [](const Parameters& p) { return matrigrate::to_toml(p); });
}

/// Seeds by label and replicate.
std::map<std::pair<std::string, std::size_t>, std::uint64_t> seeds(const Study& s) {
  std::map<std::pair<std::string, std::size_t>, std::uint64_t> found;
  for (const Run& run : runs_of(s)) found[{s.points[run.point].label, run.replicate}] = run.seed;
  return found;
}

TEST(Plan, SeedsDoNotDependOnOtherPointsOrReplicates) {
  const auto few = seeds(read("[sweep]\necm.youngs_modulus = [50, 100]\n"));
  const auto many = seeds(parse_study("preset = \"baseline\"\nreplicates = 5\n[sweep]\necm.youngs_modulus = [\"0.1 "
                                      "kPa\", 400, 50]\n",
                                      "f.toml", "."));
  EXPECT_EQ(many.size(), 15U);
  for (const auto& [run, seed] : few) EXPECT_EQ(many.at(run), seed);
  EXPECT_NE(seeds(read("seed = 2\n[sweep]\necm.youngs_modulus = [50, 100]\n")), few);
}

TEST(Plan, SeedsDifferAndFitIntoADouble) {
  std::set<std::uint64_t> all;
  for (const auto& [run, seed] : seeds(read("[sweep]\necm.youngs_modulus = [50, 100]\nprotrusion.number = [0, 1]\n"))) {
    all.insert(seed);
    EXPECT_LE(seed, (std::uint64_t{1} << 53U) - 1);
  }
  EXPECT_EQ(all.size(), 12U);
  EXPECT_EQ(run_seed(1, {{"a", "1"}, {"b", "2"}}, 1), run_seed(1, {{"b", "2"}, {"a", "1"}}, 1));
}

TEST(Plan, SeedsDoNotDependOnTheFolderOfAFile) {
  const auto seed = [](const std::string& file) { return run_seed(1, {{"ecm.fields.youngs_modulus", file}}, 1); };
  EXPECT_EQ(seed("\"/a/E.csv column=b hash=12\""), seed("\"/b/c/E.csv column=b hash=12\""));
  EXPECT_NE(seed("\"/a/E.csv column=b hash=12\""), seed("\"/a/E.csv column=b hash=34\""));
}

TEST(Plan, CommonRandomNumbersAreTheSameAtEachPoint) {
  const Study s = read("common_random_numbers = true\n[sweep]\necm.youngs_modulus = [50, 100]\n");
  const auto runs = runs_of(s);
  for (std::size_t i = 0; i < runs.size(); i += 2) EXPECT_EQ(runs[i].seed, runs[i + 1].seed);
  EXPECT_NE(runs[0].seed, runs[2].seed);
  EXPECT_NE(runs[0].hash, runs[1].hash);
}

TEST(Plan, RunsComeReplicateByReplicate) {
  const auto runs = runs_of(read("[sweep]\necm.youngs_modulus = [50, 100]\n"));
  ASSERT_EQ(runs.size(), 6U);
  EXPECT_EQ(runs[1].point, 1U);
  EXPECT_EQ(runs[1].replicate, 1U);
  EXPECT_EQ(runs[2].replicate, 2U);
}

TEST(Sweep, AHypercubeMeetsEachStripOnce) {
  for (const std::size_t n : {1, 7, 50}) {
    std::set<std::size_t> strips;
    for (const double place : stratified(n, 3)) strips.insert(static_cast<std::size_t>(place * static_cast<double>(n)));
    EXPECT_EQ(strips.size(), n);
    EXPECT_LT(*strips.rbegin(), n);
  }
  EXPECT_EQ(stratified(9, 3), stratified(9, 3));
  EXPECT_NE(stratified(9, 3), stratified(9, 4));
}

TEST(Sweep, AHypercubeStaysInItsRanges) {
  const std::string one = "[latin_hypercube]\nsamples = 20\necm.youngs_modulus = [\"50 Pa\", \"400 Pa\"]\n";
  const Study s = read(one);
  const Study t =
      read(one + "protrusion.initiation_rate = [\"1e-5 1/s\", \"1e-3 1/s\", \"log\"]\nprotrusion.number = [1, 4]\n");
  ASSERT_EQ(t.points.size(), 20U);
  std::size_t low = 0;
  for (std::size_t i = 0; i < t.points.size(); ++i) {
    const Parameters& p = t.points[i].parameters;
    EXPECT_EQ(p.ecm.youngs_modulus, s.points[i].parameters.ecm.youngs_modulus) << "whatever else is sampled";
    EXPECT_GE(p.ecm.youngs_modulus, 0.05);
    EXPECT_LE(p.ecm.youngs_modulus, 0.4);
    EXPECT_GE(p.protrusion.number, 1);
    EXPECT_LE(p.protrusion.number, 4);
    low += p.protrusion.initiation_rate < 1e-4 ? 1 : 0;
  }
  EXPECT_EQ(low, 10U) << "half of a logarithmic range lies below its middle";
}

TEST(Sweep, AHypercubeMeetsEachStripOnceAlsoWhenItsValuesAreRounded) {
  for (const auto& [low, high] : {std::pair(200.0, 200.01), std::pair(50.0, 400.0)}) {
    const Study s = read(
        fmt::format("[latin_hypercube]\nsamples = 2000\necm.youngs_modulus = [\"{} Pa\", \"{} Pa\"]\n", low, high));
    ASSERT_EQ(s.points.size(), 2000U);
    std::set<long> strips;
    std::size_t usual = 0;
    for (const Point& point : s.points) {
      const std::string digits = point.settings.front().value; // "\"200.003 Pa\""
      strips.insert(std::lround(std::floor((std::stod(digits.substr(1)) - low) / (high - low) * 2000.0)));
      usual += digits.size() <= std::string("\"200.003 Pa\"").size() ? 1 : 0;
    }
    EXPECT_EQ(strips.size(), 2000U) << low;
    EXPECT_EQ(*strips.begin(), 0);
    EXPECT_EQ(*strips.rbegin(), 1999);
    if (high == 400.0) {
      EXPECT_GT(usual, 1980U) << "six digits, but near the ends of strips";
    }
  }
  const std::string fault = fault_of("[latin_hypercube]\nsamples = 2000\necm.youngs_modulus = [\"200 Pa\", "
                                     "\"200.0000000000002 Pa\"]\n");
  EXPECT_TRUE(fault.ends_with("the range is too narrow for 2000 different values; take fewer samples or a wider range"))
      << fault;
  const std::string repeated = fault_of("[latin_hypercube]\nsamples = 100\nprotrusion.number = [1, 4]\n");
  EXPECT_TRUE(repeated.ends_with("is the same as another point, and so are 95 more")) << repeated;
}

TEST(Sweep, EachFaultOfAHypercube) {
  EXPECT_TRUE(fault_of("[latin_hypercube]\necm.radius = [50, 60]\n").ends_with("is missing; write samples = 50"));
  EXPECT_TRUE(fault_of("[latin_hypercube]\nsamples = 3\n").ends_with("has no range of a parameter"));
  EXPECT_TRUE(fault_of("[latin_hypercube]\nsamples = 3\necm.radius = [60, 50]\n")
                  .ends_with("\"60 um\" is not below \"50 um\""));
  EXPECT_TRUE(
      fault_of("[latin_hypercube]\nsamples = 3\necm.radius = 50\n").ends_with("or [\"150 um\", \"150 um\", \"log\"]"));
  EXPECT_TRUE(fault_of("[latin_hypercube]\nsamples = 3\nadhesion.rupture = [false, true]\n")
                  .ends_with("is no number, and has no range"));
  EXPECT_TRUE(fault_of("[latin_hypercube]\nsamples = 3\nprotrusion.number = [0, 3, \"log\"]\n")
                  .ends_with("a logarithmic range must start above 0"));
}

const std::string numbers = "ecm.youngs_modulus = [\"50 Pa\", \"400 Pa\"]\n"
                            "protrusion.initiation_rate = [\"1e-5 1/s\", \"1e-3 1/s\", \"log\"]\n"
                            "protrusion.number = [1, 4]\n";
TEST(Designs, ThoseThatAreNoMoreAreRefusedWithWhatReplacesThem) {
  EXPECT_EQ(
      fault_of("[one_at_a_time]\nadhesion.rupture = [true]\n"),
      "f.toml:3:2: one_at_a_time: is no design any more; list the base and each value alone as [[points]], or draw "
      "ranges by [latin_hypercube], of which matrigrate.calibrate.fit tells how much each parameter matters");
  EXPECT_EQ(fault_of("[morris]\ntrajectories = 4\necm.youngs_modulus = [100, 200]\n"),
            "f.toml:3:2: morris: is no design any more; draw the ranges by [latin_hypercube], of which "
            "matrigrate.calibrate.fit tells how much each parameter matters");
  EXPECT_EQ(fault_of("[[outcomes]]\nreadout = \"l_prot_um\"\n"),
            "f.toml:3:3: outcomes: have gone; write [[targets]], or give the numbers by condition to "
            "matrigrate.calibrate.fit");
  const std::string resolved = "[[points]]\nlabel = \"base\"\n[[points]]\nlabel = \"b\"\nadhesion.rupture = true\n";
  EXPECT_EQ(fault_of(resolved + "[[steps]]\nfactor = \"adhesion.rupture\"\nfrom = \"base\"\nto = \"b\"\n"),
            "f.toml:8:3: steps: belong to a design that is no more; leave them out: the points and their runs stay. A "
            "[latin_hypercube] and matrigrate.calibrate.fit tell how much each parameter matters");
  EXPECT_EQ(read(resolved).points.size(), 2U);
  EXPECT_EQ(
      faults_of("preset = \"baseline\"\nreplicates = 3\n[morris]\nlevels = 3\n[sweep]\necm.latice = [1]\n").size(), 2U)
      << "with all other faults";
}

TEST(Designs, TheResolvedFormGivesTheSameRuns) {
  const Study s =
      read(std::string("title = \"x\"\n[sweep]\nadhesion.rupture = [true]\n[latin_hypercube]\nsamples = 5\n") + numbers
           + "[[conditions]]\nlabel = \"soft\"\necm.viscosity = 500\n[[conditions]]\nlabel = \"thick\"\n"
             "ecm.viscosity = 2000\n[[targets]]\nreadout = \"f_mat\"\nlow = 0.4\nhigh = 0.5\nerror = 0.1\n"
             "at = \"thick\"\n[[targets]]\nreadout = \"n_protrusions\"\nvalue = 12\nerror = 1\nweight = 2\n");
  ASSERT_EQ(s.points.size(), 2 * s.sets.size());
  const std::string text = to_toml(s, "x.toml");
  std::string other = text;
  other.replace(other.find("scenario = \"x.toml\""), 19, "preset = \"baseline\"");
  const Study t = parse_study(other, "f.toml", ".");
  EXPECT_EQ(to_toml(t, "x.toml"), text);
  ASSERT_EQ(t.points.size(), s.points.size());
  const auto fingerprint = [](const Parameters& p) { return value_text(*find_row("ecm.viscosity"), p); };
  const auto a = planned_runs(s, fingerprint);
  const auto b = planned_runs(t, fingerprint);
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_EQ(a[i].seed, b[i].seed);
    EXPECT_TRUE(same(parameters_of(s, a[i]), parameters_of(t, b[i])));
  }
}

TEST(Designs, TheStudiesOfTheDocumentsAreGood) {
  const auto block = [](const std::string& page, const std::string& part) { // the fenced one that holds it
    std::ifstream in(MATRIGRATE_SOURCE_DIR "/docs/" + page);
    const std::string text{std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
    const std::size_t at = text.find(part);
    const std::size_t begin = text.find('\n', text.rfind("\n```", at) + 1);
    return at == std::string::npos ? std::string() : text.substr(begin, text.find("\n```", at) - begin);
  };
  EXPECT_EQ(parse_study(block("studies.md", "title = \"Matrix stiffness\""), "f.toml", ".").runs(), 36U);
  const Study s = parse_study(block("how-to/fit.md", "title = \"Cells against measured speeds\""), "f.toml", ".");
  EXPECT_EQ(s.sets.size(), 4U);
  EXPECT_EQ(s.targets.size(), 2U);
}

/// A study that version 0.2.0 wrote out, beside its scenario.
class EarlierPoints : public testing::Test {
protected:
  void SetUp() override {
    std::string name = (std::filesystem::temp_directory_path() / "matrigrate-points-XXXXXX").string();
    ASSERT_NE(::mkdtemp(name.data()), nullptr);
    folder = name;
  }
  void TearDown() override { std::filesystem::remove_all(folder); }

  /// @param more  rules of who computes
  Study read(const std::string& scenario, const std::string& points, std::span<const Rule> more = {}) const {
    std::ofstream(folder / "scenario.resolved.toml")
        << "version = \"0.2.5\"\n[ecm.fields]\nattractant = \"exp(x/50)\"\nligand = \"1\"\n"
        << scenario;
    return parse_study("# A study with all its points written out. Running this file again adds nothing.\n"
                       "scenario = \"scenario.resolved.toml\"\nreplicates = 1\n"
                           + points,
                       "s.toml", folder, {.overrides = {}, .replicates = {}, .more = more});
  }

  std::filesystem::path folder;
};

TEST_F(EarlierPoints, SayByLawsWhatTheySaidByCuesAndProfiles) {
  const Study s =
      read("[cues]\nchemotaxis = 5\nhaptotaxis = 0\nguidance = 0\n",
           "[[points]]\nlabel = \"a\"\n\"cues.chemotaxis\" = 20\n[[points]]\nlabel = \"b\"\n\"cues.chemotaxis\" = 0\n"
           "[[points]]\nlabel = \"c\"\n\"cues.haptotaxis\" = 2\n[[points]]\nlabel = \"d\"\n"
           "\"actomyosin.curvature_profile\" = \"triangle\"\n[[points]]\nlabel = \"e\"\n"
           "\"actomyosin.curvature_profile\" = \"half_gaussian\"\n");
  ASSERT_EQ(s.points.size(), 5U);
  const auto laws = [&](std::size_t k) { return s.points[k].parameters.laws; };
  EXPECT_EQ(laws(0).initiation_bias, "exp(20*occupancy)");
  EXPECT_EQ(laws(1).initiation_bias, "1");
  EXPECT_EQ(laws(2).initiation_bias, "exp(5*occupancy)*exp(2*ligand)") << "chemotaxis as in the scenario";
  EXPECT_EQ(laws(3).initiation_bias, "exp(5*occupancy)");
  EXPECT_EQ(laws(3).curvature_factor, "max(0, 1 - abs(kappa - kappa_0)/kappa_w)");
  EXPECT_EQ(laws(4).curvature_factor, *find_row("laws.curvature_factor")->before);
}

TEST_F(EarlierPoints, KeepReadingsThatHaveGoneForWhoReads) {
  const std::string points =
      "[[points]]\nlabel = \"place\"\n\"adhesion.hold\" = \"place\"\n[[points]]\nlabel = \"matter\"\n"
      "\"adhesion.hold\" = \"matter\"\n";
  const Study s = read("", points);
  ASSERT_EQ(s.points.size(), 2U);
  EXPECT_EQ(s.points[0].parameters.origin.gone.at("adhesion.hold"), "\"place\"");
  EXPECT_TRUE(s.points[1].parameters.origin.gone.empty());
  EXPECT_NE(values_text(s.points[0].parameters), values_text(s.points[1].parameters));
  try {
    read("", points, rules());
    FAIL() << "to compute it is refused";
  } catch (const ConfigurationError& error) {
    EXPECT_EQ(std::string(error.what()).find("s.toml:4:1: adhesion.hold: \"place\" has gone"), 0U) << error.what();
  }
}

TEST_F(EarlierPoints, AStudyThatSomebodyWroteIsRefusedThem) {
  std::ofstream(folder / "s.toml") << "version = \"0.2.5\"\n";
  EXPECT_THROW(
      parse_study("scenario = \"s.toml\"\nreplicates = 1\n[[points]]\nadhesion.hold = \"place\"\n", "e.toml", folder),
      ConfigurationError);
}

TEST(Names, AreTheLastWordsWhereTheseDiffer) {
  const Names names({"ecm.youngs_modulus", "protrusion.force", "protrusion.number"});
  EXPECT_EQ(names.of("ecm.youngs_modulus"), "youngs_modulus");
  EXPECT_EQ(names.of("protrusion.force"), "force");
  EXPECT_EQ(names.of("protrusion.number"), "n_prot");
}

TEST(Names, AreWholePathsWhereTwoEndAlike) {
  const Names names({"ecm.youngs_modulus", "protrusion.force", "actomyosin.force"});
  EXPECT_EQ(names.of("ecm.youngs_modulus"), "youngs_modulus");
  EXPECT_EQ(names.of("protrusion.force"), "protrusion.force");
  EXPECT_EQ(names.of("actomyosin.force"), "actomyosin.force");
}

TEST(Names, InFullHaveThePapersLetters) {
  EXPECT_EQ(Names::whole("polarization.rate"), "polarization.rate (r_pol)");
  EXPECT_EQ(Names::whole("adhesion.rupture"), "adhesion.rupture");
}

std::vector<std::string> labels(const Study& s) {
  std::vector<std::string> all;
  for (const Point& point : s.points) all.push_back(point.label);
  return all;
}

using Labels = std::vector<std::string>;

TEST(Names, TellTheAxesOfASweepApart) {
  const Study s = read("[sweep]\nprotrusion.force = [0.2]\nactomyosin.force = [0.4, 0.2]\n");
  EXPECT_EQ(labels(s), (Labels{"protrusion.force 0.2 nN, actomyosin.force 0.4 nN",
                               "protrusion.force 0.2 nN, actomyosin.force 0.2 nN"}));
}

TEST(Names, TellPointsAndConditionsFromASweep) {
  const std::string sweep = "[sweep]\nprotrusion.force = [0.2]\n";
  EXPECT_EQ(labels(read(sweep + "[[points]]\nactomyosin.force = 1\n")),
            (Labels{"protrusion.force 0.2 nN", "actomyosin.force 1 nN"}));
  EXPECT_EQ(labels(read(sweep + "[[conditions]]\nlabel = \"weak\"\nactomyosin.force = 0.1\n")),
            (Labels{"weak: protrusion.force 0.2 nN"}));
}

TEST(Names, TellTheFactorsOfAHypercubeApart) {
  const Study s = read("[latin_hypercube]\nsamples = 2\nprotrusion.force = [0.1, 0.2]\nactomyosin.force = [1, 2]\n");
  EXPECT_EQ(s.points[0].label, "sample 1");
  const std::string text = point_text(s, 0);
  EXPECT_TRUE(text.starts_with("protrusion.force 0.1")) << text;
  EXPECT_NE(text.find(" nN, actomyosin.force 1"), std::string::npos) << text;
}

TEST(Names, KeepLabelsThatTheFileGives) {
  const Study s = read("[[points]]\nlabel = \"force 0.2 nN, force 0.4 nN\"\nprotrusion.force = 0.2\n"
                       "actomyosin.force = 0.4\n[[points]]\nactomyosin.force = 1\n");
  EXPECT_EQ(labels(s), (Labels{"force 0.2 nN, force 0.4 nN", "actomyosin.force 1 nN"}));
}

} // namespace
} // namespace matrigrate::study
