#include "study_plan/names.hpp"
#include "unit/study_plan/studies.hpp"

#include <gtest/gtest.h>

namespace matrigrate::study {
namespace {

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
