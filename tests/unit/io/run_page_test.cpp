#include "io/run_page.hpp"

#include "markup.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace matrigrate::io {
namespace {

TEST(RunPage, HoldsReadOutsAndPictures) {
  std::vector<TrackRow> rows(3);
  for (std::size_t k = 0; k < rows.size(); ++k) rows[k].t = 60.0 * static_cast<double>(k);
  RunReport report{.title = "Run <1>",
                   .status = "Done: 2 min.",
                   .readouts = {},
                   .rows = rows,
                   .contact_sheet = "<svg>sheet</svg>",
                   .provenance = "commit 1234"};
  report.readouts.v_migr_abs = 4.5;
  const std::string html = run_page(report);
  for (const char* text : {"<svg>sheet</svg>", "Done: 2 min.", "<td>4.5</td>", "v_migr_abs_um_per_h", "commit 1234",
                           "Path of the centre of mass."})
    EXPECT_EQ(count(html, text), 1U) << text;
  EXPECT_EQ(count(html, "<h1>Run &lt;1&gt;</h1>"), 1U);
  EXPECT_EQ(count(html, "<svg"), 5U);
  EXPECT_EQ(count(html, "http"), count(html, "http://www.w3.org/2000/svg")) << "needs no network";
}

TEST(RunPage, NeedsNoRows) {
  RunReport report;
  report.contact_sheet = "<svg></svg>";
  EXPECT_NO_THROW(run_page(report));
}

} // namespace
} // namespace matrigrate::io
