#include "study_results/results.hpp"

#include "base/failure.hpp"
#include "observe/readout_table.hpp"
#include "tables/table.hpp"
#include "unit/study_plan/studies.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace matrigrate::study {
namespace {

const std::string sweep = "[sweep]\necm.youngs_modulus = [50, 200]\n";

/// Three runs a point; the last one has failed.
std::vector<Result> made(const Study& study) {
  std::vector<Result> all = results_of("f_mat", {{0.1, 0.2, 0.3}, {0.4, 0.5, 0.6}});
  all[1].run.seed = 9007199254740991; // the largest there is
  all[1].standing.trajectory_hash = "0123456789abcdef";
  for (Result& r : all)
    for (const ReadOutSpec& spec : readout_table())
      if (spec.is_always || spec.is_count())
        r.readouts[readout_column(spec.name)] = spec.name == "duration_s" ? 21600.0 : 2.0;
  all.back().standing.status = RunState::failed;
  all.back().standing.cause = FailureCause::rim;
  all.back().standing.reason = "the cell has reached the clamped rim, at (1, 2) um";
  all.back().readouts.assign(all.back().readouts.size(), NAN);
  EXPECT_EQ(all.size(), study.runs());
  return all;
}

TEST(ReadResults, GivesBackWhatWasWritten) {
  const Study study = read(sweep);
  const std::vector<Result> all = made(study);
  const std::string csv = results_csv(study, all);
  const std::vector<Result> again = read_results(study, csv, "r.csv");
  EXPECT_EQ(results_csv(study, again), csv);
  EXPECT_EQ(again[1].run.seed, all[1].run.seed);
  EXPECT_EQ(again[1].standing.trajectory_hash, "0123456789abcdef");
  EXPECT_EQ(again[5].standing.reason, all[5].standing.reason);
  EXPECT_EQ(again[5].standing.cause, FailureCause::rim);
  EXPECT_FALSE(again[1].standing.cause);
  EXPECT_EQ(sample(again, 1, "f_mat"), (std::vector<double>{0.4, 0.5}));
}

TEST(ReadResults, TakesTablesThatASpreadsheetHasSaved) {
  const Study study = read(sweep);
  const std::string csv = results_csv(study, made(study));
  std::string saved = "\xef\xbb\xbf";
  for (const char c : csv) saved += c == '\n' ? std::string("\r\n") : std::string(1, c);
  EXPECT_EQ(results_csv(study, read_results(study, saved, "r.csv")), csv);
}

TEST(ReadResults, RefusesResultsOfAnotherStudy) {
  const Study study = read(sweep);
  const std::string csv = results_csv(study, made(study));
  const auto message = [](const Study& of, const std::string& text) {
    try {
      read_results(of, text, "r.csv");
    } catch (const InputOutputError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_EQ(message(read("[sweep]\necm.youngs_modulus = [50, 400]\n"), csv),
            "r.csv: line 5, column 2 (label): \"youngs_modulus 200 Pa\" is no point of the study\n"
            "  line 6, column 2 (label): \"youngs_modulus 200 Pa\" is no point of the study\n"
            "  line 7, column 2 (label): \"youngs_modulus 200 Pa\" is no point of the study");
  EXPECT_EQ(message(study, csv.substr(0, csv.rfind('\n', csv.size() - 2) + 1)), "r.csv: holds 5 runs; the study has 6");
  EXPECT_TRUE(message(study, "a,b\n").starts_with("r.csv: has no column run\n  has no column label\n"));
}

TEST(ReadResults, RefusesFieldsThatCannotBe) {
  const Study study = read(sweep);
  const std::string csv = results_csv(study, made(study));
  const auto fault = [&](const std::string& from, const std::string& to) {
    std::string text = csv;
    text.replace(text.find(from), from.size(), to);
    try {
      read_results(study, text, "r.csv");
    } catch (const InputOutputError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  for (const char* bad : {"\"1,5\"", "0x10", "abc", "nan", "inf", "1e400", "0.1 ", "+0.1"}) {
    const std::string said = fault(",0.1,", std::string(",") + bad + ",");
    EXPECT_TRUE(said.starts_with("r.csv: line 2, column ") && said.find("(f_mat): \"") != std::string::npos)
        << bad << said;
  }
  EXPECT_NE(fault("9007199254740991", "9007199254740991x").find("is no whole number"), std::string::npos);
  EXPECT_NE(fault(",f_mat,", ",f_mat_um,").find("r.csv: has no column f_mat\n  line 1, column "), std::string::npos);
  EXPECT_NE(fault(",n_protrusions,", ",f_mat,").find(": f_mat is there twice"), std::string::npos);
  EXPECT_NE(
      fault("youngs_modulus 50 Pa,50,", "youngs_modulus 50 Pa,200,")
          .find("line 2, column 3 (ecm.youngs_modulus_Pa): is \"200\"; the point \"youngs_modulus 50 Pa\" has 50"),
      std::string::npos)
      << fault("youngs_modulus 50 Pa,50,", "youngs_modulus 50 Pa,200,");
  const auto refused = [&](std::string_view readout, double value) {
    std::vector<Result> changed = made(study);
    changed[1].readouts[readout_column(readout)] = value;
    try {
      read_results(study, results_csv(study, changed), "r.csv");
    } catch (const InputOutputError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  for (const char* name : {"duration_s", "v_migr_abs_um_per_h", "n_protrusions"})
    EXPECT_TRUE(refused(name, NAN).ends_with("is empty; every run that is done has it")) << name;
  EXPECT_EQ(refused("tau_prot_min", NAN), "") << "no adhesion may have ended";
  EXPECT_TRUE(refused("v_migr_abs_um_per_h", -1.0).ends_with("is -1; allowed are 0 to 1e+12"));
  EXPECT_TRUE(refused("l_prot_um", 1e308).ends_with("is 1e+308; allowed are 0 to 1e+12"));
  EXPECT_TRUE(refused("f_mat", 7.0).ends_with("(f_mat): is 7; allowed are 0 to 1"));
  EXPECT_TRUE(refused("n_protrusions", 2.5).ends_with("(n_protrusions): is 2.5; it is a count"));
  EXPECT_EQ(refused("msd_slope", -0.1) + refused("migration_index_x", -0.5), "");
  EXPECT_NE(fault(",done,", ",finished,").find("\"finished\" is no status of a run"), std::string::npos);
}

/// The table without some of its columns.
std::string without(const std::string& csv, const std::vector<std::string>& columns) {
  const store::CsvTable table = store::read_csv(csv);
  std::string text;
  const auto add = [&](const std::vector<std::string>& row) {
    std::vector<store::Field> fields;
    for (std::size_t k = 0; k < row.size(); ++k)
      if (std::ranges::find(columns, table.header[k]) == columns.end()) fields.emplace_back(std::string_view(row[k]));
    text += store::csv_line(fields);
  };
  add(table.header);
  for (const auto& row : table.rows) add(row);
  return text;
}

TEST(ReadResults, TakesTablesFromBeforeAReadOutCame) {
  const Study study = read(sweep);
  const std::string csv = results_csv(study, made(study));
  EXPECT_NO_THROW(read_results(study, without(csv, {"migration_index_x"}), "r.csv"));
  for (const char* name : {"duration_s", "f_mat", "share_ruptured_across", "share_2_or_3_protrusions"})
    EXPECT_THROW(read_results(study, without(csv, {name}), "r.csv"), InputOutputError) << name;
}

TEST(ReadResults, RefusesADurationThatIsNotTheStudys) {
  const Study study = read(sweep);
  std::vector<Result> all = made(study);
  const std::size_t column = readout_column("duration_s");
  for (Result& r : all)
    if (r.standing.done()) r.readouts[column] = 21600.0;
  EXPECT_NO_THROW(read_results(study, results_csv(study, all), "r.csv"));
  all[1].readouts[column] = 60.0;
  EXPECT_THROW(read_results(study, results_csv(study, all), "r.csv"), InputOutputError);
}

} // namespace
} // namespace matrigrate::study
