#include "study_plan/read_study.hpp"

#include "unit/study_plan/studies.hpp"

#include "parameters/schema.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>

namespace matrigrate::study {
namespace {

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
  const Study s = parse_study(block("how-to/targets.md", "title = \"Cells against measured speeds\""), "f.toml", ".");
  EXPECT_EQ(s.sets.size(), 4U);
  EXPECT_EQ(s.targets.size(), 2U);
}

} // namespace
} // namespace matrigrate::study
