#include "study_report/run_shapes.hpp"

#include "base/file.hpp"
#include "simulation/start.hpp"
#include "store/checkpoint.hpp"
#include "tables/csv.hpp"
#include "unit/study_plan/studies.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <numbers>

#include <unistd.h>

namespace matrigrate::study {
namespace {

/// A ring of eight particles, all but the first close to its circle; the first one a spike to the right.
observe::Floats ring(double x, double y) {
  observe::Floats all;
  for (int i = 0; i < 8; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / 8.0;
    const double radius = i == 0 ? 6.0 : 2.0;
    all.push_back(static_cast<float>(x + radius * std::cos(angle)));
    all.push_back(static_cast<float>(y + radius * std::sin(angle)));
  }
  return all;
}

/// Frames each 300 s, the cell moved by (1, 0) um in each.
observe::Film film(std::size_t frames) {
  observe::Film film{.head = {.radius = 4.0, .spacing = 2.0, .reference = {0.0F, 0.0F, 2.0F, 0.0F, 500.0F, 0.0F}},
                     .frames = {}};
  for (std::size_t k = 0; k < frames; ++k) {
    observe::Frame frame{.t = 300.0 * static_cast<double>(k), .matrix = {}, .outline = {}, .protrusions = {}};
    frame.matrix = {.displacement = observe::Floats(6, 0.0F),
                    .velocity = observe::Floats(6, 0.0F),
                    .f_degr = {1.0F, 0.0F, 1.0F},
                    .pressure = observe::Floats(3, 0.0F),
                    .von_mises = observe::Floats(3, 0.0F),
                    .fibre_von_mises = {30.0F, 0.0F, 7.0F}};
    frame.outline = {.x = ring(static_cast<double>(k), 0.0),
                     .f_mat = observe::Floats(8, 0.0F),
                     .curvature = observe::Floats(8, 0.0F),
                     .force = observe::Floats(8, 0.0F),
                     .front = observe::Bytes(8, 1),
                     .protrusion = observe::Bytes(8, observe::of_none),
                     .phase = observe::Bytes(8, observe::of_none)};
    film.frames.push_back(std::move(frame));
  }
  return film;
}

class RunShapes : public ::testing::Test {
protected:
  RunShapes() { std::filesystem::remove_all(folder); }
  ~RunShapes() override { std::filesystem::remove_all(folder); }
  std::filesystem::path made(const Result& r) const {
    std::filesystem::create_directories(run_folder(folder, r.run));
    return run_folder(folder, r.run);
  }

  std::filesystem::path folder = std::filesystem::temp_directory_path() / fmt::format("run-shapes-{}", ::getpid());
  Study study = read("[sweep]\necm.youngs_modulus = [50, 400]\n");
};

TEST_F(RunShapes, AreTheOutlinesAtTheEndOfThreeRuns) {
  const std::vector<Result> results = results_of("f_mat", {{0.1, 0.2, 0.3, 0.4}, {0.5}});
  Parameters p;
  p.ecm.radius = 30.0;
  const State cell = initial_state(p);
  for (const Result& r : results) {
    State state = cell;
    for (std::size_t i = 0; i < state.cells[0].cortex.size(); ++i)
      state.cells[0].cortex.x[i] = {static_cast<double>(r.run.replicate), static_cast<double>(i)};
    store::write_checkpoint(made(r),
                            {.state = state, .scenario = "", .configuration_hash = "", .program = "", .memory = ""});
  }
  const std::string csv = shapes_csv(study, results, folder);
  const store::CsvTable table = store::read_csv(csv);
  const std::size_t shown = (cell.cells[0].cortex.size() + 1) / 2;
  ASSERT_EQ(table.rows.size(), 4 * shown) << "three replicates of the first point, one of the other";
  EXPECT_EQ(table.rows[1], (std::vector<std::string>{"1", "1.00", "2.00", "youngs_modulus 50 Pa"})) << "every second";
  EXPECT_EQ(table.rows[2 * shown], (std::vector<std::string>{"3", "3.00", "0.00", "youngs_modulus 50 Pa"}));
  EXPECT_EQ(table.rows.back()[3], "youngs_modulus 400 Pa");
}

TEST_F(RunShapes, FibreStressIsThatOfTheSolidNearTheCell) {
  const std::string csv = fibre_stress_csv(film(1));
  EXPECT_TRUE(csv.starts_with("what,x_um,y_um,von_mises_Pa\nmatrix,0.00,0.00,30.0\nmatrix,2.00,0.00,\noutline,6.00"))
      << csv << "fluid has none, and a particle far away is left out";
  EXPECT_EQ(store::read_csv(csv).rows.size(), 2U + 8U);
  EXPECT_NE(fibre_stress_svg(csv, 2.0).find("Eq. 11"), std::string::npos);
  EXPECT_EQ(store::read_csv(fibre_stress_csv({})).rows.size(), 0U);
}

} // namespace
} // namespace matrigrate::study
