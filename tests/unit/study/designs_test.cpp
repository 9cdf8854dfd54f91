#include "study/design/designs.hpp"

#include "unit/study/studies.hpp"

#include "parameters/schema.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <iterator>
#include <map>
#include <set>

namespace matrigrate::study {
namespace {

const std::string numbers = "ecm.youngs_modulus = [\"50 Pa\", \"400 Pa\"]\n"
                            "protrusion.initiation_rate = [\"1e-5 1/s\", \"1e-3 1/s\", \"log\"]\n"
                            "protrusion.number = [1, 4]\n";
const std::string choices = "ecm.lattice = [\"square\", \"hexagonal\"]\nadhesion.rupture = [true, false]\n";

std::string value(const FactorSet& set, const std::string& key) {
  for (const Setting& s : set.settings)
    if (s.key == key) return s.value;
  return {};
}

TEST(OneAtATime, VariesEachFactorAloneFromTheBase) {
  const Study s = read("[one_at_a_time]\necm.lattice = [\"square\", \"hexagonal\"]\nadhesion.rupture = [true]\n"
                       "ecm.youngs_modulus = [50, \"0.2 kPa\", 400]\n");
  std::vector<std::string> labels;
  for (const FactorSet& set : s.sets) labels.push_back(set.label);
  EXPECT_EQ(labels, (std::vector<std::string>{"base", "lattice hexagonal", "rupture true", "youngs_modulus 50 Pa",
                                              "youngs_modulus 400 Pa"}))
      << "the base's own values are not run twice";
  ASSERT_EQ(s.steps.size(), 4U);
  for (std::size_t k = 0; k < 4; ++k) {
    EXPECT_EQ(s.steps[k].from, 0U);
    EXPECT_EQ(s.steps[k].to, k + 1);
    ASSERT_EQ(s.sets[k + 1].settings.size(), 1U);
    EXPECT_EQ(s.steps[k].factor, s.sets[k + 1].settings[0].key);
  }
  EXPECT_TRUE(s.sets[0].settings.empty());
  EXPECT_EQ(s.points[1].parameters.ecm.lattice, Lattice::hexagonal);
  EXPECT_EQ(s.points[4].parameters.ecm.youngs_modulus, 0.4);
  EXPECT_EQ(s.points[4].parameters.ecm.lattice, Lattice::square);
  EXPECT_TRUE(s.common_random_numbers) << "effects are differences";
  EXPECT_FALSE(
      read("common_random_numbers = false\n[one_at_a_time]\nadhesion.rupture = [true]\n").common_random_numbers);
  EXPECT_FALSE(read("[sweep]\nadhesion.rupture = [true]\n").common_random_numbers);
  EXPECT_EQ(s.comparisons.pairs, Pairs::none);
}

TEST(OneAtATime, StandsBesideOtherDesigns) {
  const Study s = read("[one_at_a_time]\nadhesion.rupture = [true]\n[sweep]\necm.youngs_modulus = [50, 100]\n");
  ASSERT_EQ(s.sets.size(), 4U);
  ASSERT_EQ(s.steps.size(), 1U);
  EXPECT_EQ(s.sets[s.steps[0].from].label, "base");
  EXPECT_EQ(s.sets[s.steps[0].to].label, "rupture true");
}

TEST(OneAtATime, EachFault) {
  EXPECT_EQ(fault_of("[one_at_a_time]\n"), "f.toml:3:1: one_at_a_time: has no list of values of a parameter");
  EXPECT_EQ(fault_of("[one_at_a_time]\nadhesion.rupture = [false]\n"),
            "f.toml:4:21: adhesion.rupture: has no other value than that of the base, false");
  EXPECT_TRUE(fault_of("[one_at_a_time]\necm.lattice = [\"sqare\"]\n").ends_with("did you mean square?"))
      << fault_of("[one_at_a_time]\necm.lattice = [\"sqare\"]\n");
  EXPECT_TRUE(fault_of("[one_at_a_time]\necm.latice = [\"square\"]\n").ends_with("did you mean ecm.lattice?"));
  EXPECT_EQ(fault_of("[sweep]\necm.lattice = [\"square\"]\n[one_at_a_time]\necm.lattice = [\"hexagonal\"]\n"),
            "f.toml:6:15: ecm.lattice: stands in two designs, [sweep] and [one_at_a_time]");
  EXPECT_EQ(fault_of("[morris]\nadhesion.rupture = [false, true]\n[one_at_a_time]\nadhesion.rupture = [true]\n"),
            "f.toml:4:20: adhesion.rupture: stands in two designs, [one_at_a_time] and [morris]");
}

TEST(Morris, EachTrajectoryChangesEachFactorOnceByDelta) {
  const Study s = read("[morris]\ntrajectories = 20\nlevels = 4\n" + numbers + choices);
  EXPECT_TRUE(s.common_random_numbers);
  ASSERT_EQ(s.steps.size(), 20U * 5U);
  std::map<std::size_t, std::set<std::string>> changed;
  std::map<std::size_t, std::size_t> last;
  std::set<std::string> directions;
  for (const Step& step : s.steps) {
    EXPECT_TRUE(changed[step.trajectory].insert(step.factor).second) << "once in a trajectory";
    const auto before = last.find(step.trajectory);
    EXPECT_EQ(step.from, before == last.end() ? step.from : before->second) << "a path";
    last[step.trajectory] = step.to;
    const FactorSet& from = s.sets[step.from];
    const FactorSet& to = s.sets[step.to];
    ASSERT_EQ(from.settings.size(), 5U);
    for (std::size_t f = 0; f < 5; ++f)
      EXPECT_EQ(from.settings[f] == to.settings[f], from.settings[f].key != step.factor) << "that factor alone";
    const bool number = step.factor != "ecm.lattice" && step.factor != "adhesion.rupture";
    EXPECT_NEAR(std::abs(step.size), number ? 4.0 / (2.0 * 3.0) : 1.0, 2e-6);
    directions.insert(step.factor + (step.size > 0.0 ? " up" : " down"));
  }
  EXPECT_EQ(changed.size(), 20U);
  EXPECT_EQ(directions.size(), 10U) << "each up and down";
}

TEST(Morris, MeetsAllLevels) {
  const Study s = read("[morris]\ntrajectories = 30\n" + numbers);
  std::map<std::string, std::set<std::string>> met;
  for (const FactorSet& set : s.sets)
    for (const Setting& one : set.settings) met[one.key].insert(one.value);
  EXPECT_EQ(met["ecm.youngs_modulus"],
            (std::set<std::string>{"\"50 Pa\"", "\"166.667 Pa\"", "\"283.333 Pa\"", "\"400 Pa\""}));
  EXPECT_EQ(met["protrusion.number"], (std::set<std::string>{"1", "2", "3", "4"}));
  EXPECT_EQ(met["protrusion.initiation_rate"].size(), 4U);
  EXPECT_TRUE(met["protrusion.initiation_rate"].contains("\"4.64159e-05 1/s\"")) << "by thirds of the logarithm";
}

TEST(Morris, MoreTrajectoriesOrFactorsLeaveTheOthersAsTheyAre) {
  const Study few = read("[morris]\ntrajectories = 3\n" + numbers);
  const Study many = read("[morris]\ntrajectories = 8\n" + numbers);
  ASSERT_GT(many.sets.size(), few.sets.size());
  for (std::size_t i = 0; i < few.sets.size(); ++i) {
    EXPECT_EQ(few.sets[i].label, many.sets[i].label);
    EXPECT_EQ(few.sets[i].settings, many.sets[i].settings);
  }
  for (std::size_t k = 0; k < few.steps.size(); ++k) EXPECT_EQ(few.steps[k], many.steps[k]);
  const Study wide = read("[morris]\ntrajectories = 3\n" + numbers + choices);
  for (std::size_t t = 1; t <= 3; ++t) {
    const auto start = [&](const Study& s) {
      for (const Step& step : s.steps)
        if (step.trajectory == t) return value(s.sets[step.from], "ecm.youngs_modulus");
      return std::string();
    };
    EXPECT_EQ(start(few), start(wide)) << "keyed by the name of the parameter";
  }
  EXPECT_NE(read("seed = 2\n[morris]\ntrajectories = 3\n" + numbers).sets[0].settings, few.sets[0].settings);
}

TEST(Morris, ASetThatTwoTrajectoriesMeetIsRunOnce) {
  const Study s = read("[morris]\ntrajectories = 10\n" + choices);
  EXPECT_EQ(s.sets.size(), 4U) << "2 x 2 choices";
  EXPECT_EQ(s.steps.size(), 20U);
}

TEST(Morris, IntegersAreRoundedAndStepsAreThoseOfTheRoundedValues) {
  const Study s = read("[morris]\ntrajectories = 12\nprotrusion.number = [1, 3]\n"); // levels 1, 1.67, 2.33, 3
  for (const Step& step : s.steps) {
    const int change =
        std::stoi(value(s.sets[step.to], step.factor)) - std::stoi(value(s.sets[step.from], step.factor));
    EXPECT_DOUBLE_EQ(step.size, change / 2.0);
    EXPECT_NE(change, 0);
  }
}

TEST(Morris, EachFault) {
  const std::string number = "protrusion.number = [1, 4]\n";
  EXPECT_EQ(fault_of("[morris]\nlevels = 3\n" + number).substr(0, 62),
            "f.toml:4:10: morris.levels: 3 is odd; allowed are even numbers");
  EXPECT_EQ(fault_of("[morris]\nlevels = 0\n" + number),
            "f.toml:4:10: morris.levels: 0 is out of range; allowed is >= 2 and <= 100");
  EXPECT_EQ(fault_of("[morris]\ntrajectories = 1\n" + number),
            "f.toml:4:16: morris.trajectories: 1 is out of range; allowed is >= 2 and <= 100000");
  EXPECT_EQ(fault_of("[morris]\ntrajectories = 4\n"), "f.toml:3:1: morris: has no range of a parameter");
  EXPECT_EQ(fault_of("[morris]\nprotrusion.number = [4, 1]\n"), "f.toml:4:21: protrusion.number: 4 is not below 1");
  EXPECT_EQ(fault_of("[morris]\necm.lattice = [\"square\"]\n"),
            "f.toml:4:15: ecm.lattice: has 1 value, but two values are expected, each \"square\" or \"hexagonal\"");
  EXPECT_EQ(fault_of("[morris]\necm.lattice = \"square\"\n"),
            "f.toml:4:15: ecm.lattice: is a string, but two values are expected, each \"square\" or \"hexagonal\"");
  EXPECT_TRUE(fault_of("[morris]\necm.lattice = [\"square\", \"hexagon\"]\n").ends_with("did you mean hexagonal?"));
  EXPECT_EQ(fault_of("[morris]\nadhesion.rupture = [true, true]\n"),
            "f.toml:4:20: adhesion.rupture: true is listed twice");
  EXPECT_TRUE(fault_of("[morris]\ntrajectoris = 4\n" + number).starts_with("f.toml:4:1: morris.trajectoris: "));
  EXPECT_TRUE(fault_of("[morris]\necm.radius = [100.00001, 100.00002]\n").ends_with("give a wider range"));
  EXPECT_EQ(fault_of("[morris]\ntrajectories = 20000\n" + number),
            "f.toml:3:1: morris: makes 40000 points; with 3 replicates these are 120000 runs; allowed are 100000");
  EXPECT_EQ(faults_of("replicates = 0\n[morris]\nlevels = 3\ntrajectories = 1\nprotrusion.number = [4, 1]\n"
                      "ecm.lattice = [\"square\"]\n")
                .size(),
            6U)
      << "all at once: no scenario, replicates, levels, trajectories, a range, a choice";
}

TEST(Designs, TheResolvedFormGivesTheSameRunsAndSteps) {
  const Study s =
      read(std::string() + "title = \"x\"\n[one_at_a_time]\nadhesion.rupture = [true]\n[morris]\ntrajectories = 5\n"
           + numbers
           + "[[conditions]]\nlabel = \"soft\"\necm.viscosity = 500\n[[conditions]]\nlabel = \"thick\"\n"
             "ecm.viscosity = 2000\n[[targets]]\nreadout = \"f_mat\"\nlow = 0.4\nhigh = 0.5\nerror = 0.1\n"
             "at = \"thick\"\n[[targets]]\nreadout = \"n_protrusions\"\nvalue = 12\nerror = 1\nweight = 2\n");
  ASSERT_EQ(s.points.size(), 2 * s.sets.size());
  const std::string text = to_toml(s, "x.toml");
  std::string other = text;
  other.replace(other.find("scenario = \"x.toml\""), 19, "preset = \"baseline\"");
  const Study t = parse_study(other, "f.toml", ".");
  EXPECT_EQ(to_toml(t, "x.toml"), text);
  EXPECT_EQ(t.steps, s.steps);
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
  std::ifstream in(MATRIGRATE_SOURCE_DIR "/docs/studies.md");
  const std::string text{std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
  const auto block = [&](const std::string& part) { // the fenced one that holds it
    const std::size_t at = text.find(part);
    const std::size_t begin = text.find('\n', text.rfind("\n```", at) + 1);
    return at == std::string::npos ? std::string() : text.substr(begin, text.find("\n```", at) - begin);
  };
  EXPECT_EQ(parse_study(block("title = \"Matrix stiffness\""), "f.toml", ".").runs(), 36U);
  const std::string closures = block("[one_at_a_time]  ");
  const Study s = parse_study(closures, "f.toml", ".");
  EXPECT_EQ(s.sets.size(), 7U);
  EXPECT_EQ(s.targets.size(), 2U);
  EXPECT_EQ(read(block("trajectories = 10 ")).steps.size(), 30U);
}

TEST(Designs, EachFaultOfSteps) {
  const std::string points =
      "[[points]]\nlabel = \"a\"\n[[points]]\nlabel = \"b\"\nadhesion.rupture = true\n[[steps]]\n";
  const std::string good = "design = \"morris\"\nfactor = \"adhesion.rupture\"\ntrajectory = 1\n";
  EXPECT_EQ(read(points + good + "from = \"a\"\nto = \"b\"\nsize = -0.5\n").steps,
            (std::vector<Step>{{Design::morris, "adhesion.rupture", 1, 0, 1, -0.5}}));
  EXPECT_EQ(fault_of(points + good + "from = \"c\"\nto = \"b\"\nsize = 1\n"),
            "f.toml:12:8: steps.from: \"c\" is not the label of a point");
  EXPECT_EQ(fault_of(points + good + "from = \"a\"\nto = \"b\"\nsize = 0\n"),
            "f.toml:14:8: steps.size: is 0, but a step changes its factor");
  EXPECT_EQ(fault_of(points + good + "from = \"a\"\nto = \"b\"\nsice = 1\nsize = 1\n"),
            "f.toml:14:1: steps.sice: there is no such key; did you mean size?");
  EXPECT_EQ(faults_of("preset = \"baseline\"\nreplicates = 3\n" + points + "design = \"moris\"\n").size(), 4U);
  EXPECT_EQ(fault_of("steps = 3\n"), "f.toml:3:9: steps: is no list of steps; write [[steps]] and its factor below");
}

} // namespace
} // namespace matrigrate::study
