#include "run/folder_state.hpp"

#include "base/failure.hpp"
#include "base/file.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <initializer_list>
#include <string>
#include <utility>

namespace matrigrate::run {
namespace {

namespace fs = std::filesystem;

class Folder : public testing::Test {
protected:
  void SetUp() override { fs::create_directories(folder); }
  void TearDown() override { fs::remove_all(root); }

  void put(std::initializer_list<const char*> names) const {
    for (const char* name : names) write_file(folder / name, "{}\n");
  }

  /// Why it is refused; empty if it is taken.
  static std::string refusal(const fs::path& place, Use use) {
    try {
      require(look_at(place), use);
    } catch (const InputOutputError& error) {
      const std::string text = error.what();
      EXPECT_TRUE(text.starts_with(place.string() + ": ")) << text;
      return text.substr(place.string().size() + 2);
    }
    return {};
  }
  std::string refusal(Use use) const { return refusal(folder, use); }

  fs::path root = fs::temp_directory_path() / ("matrigrate-folder-state-" + std::to_string(::getpid()));
  fs::path folder = root / "a";
};

constexpr Use writers[] = {Use::run, Use::run_anew, Use::branch, Use::study, Use::exports, Use::results, Use::pictures};

TEST_F(Folder, IsFreeIfItIsMissingOrHoldsOnlyHiddenFiles) {
  put({".lock"});
  for (const Use use : writers) {
    EXPECT_EQ(refusal(use), "");
    EXPECT_EQ(refusal(root / "nowhere", use), "");
  }
  EXPECT_EQ(refusal(root / "nowhere", Use::resume), "there is no such folder");
  EXPECT_EQ(refusal(root / "nowhere", Use::see_files), "is no folder");
  EXPECT_EQ(refusal(Use::see_files), "");
}

TEST_F(Folder, IsNoFile) {
  put({"f"});
  for (const Use use : writers)
    EXPECT_TRUE(refusal(folder / "f", use).starts_with("is no folder; choose another one"))
        << refusal(folder / "f", use);
  EXPECT_EQ(refusal(folder / "f", Use::see_run), "holds no run: it has no run.json");
}

TEST_F(Folder, OfOtherFilesIsTakenByForceAlone) {
  put({"mine", "b"});
  for (const Use use : {Use::run, Use::branch, Use::study, Use::results, Use::pictures}) EXPECT_NE(refusal(use), "");
  for (const Use use : {Use::run_anew, Use::exports}) EXPECT_EQ(refusal(use), "");
  EXPECT_NE(refusal(Use::run).find("it holds b, mine; choose"), std::string::npos) << refusal(Use::run);
  EXPECT_EQ(refusal(Use::resume), "holds no checkpoint to resume from");
}

TEST_F(Folder, OfARunIsNoPlaceForAStudyOrExports) {
  put({"run.json"});
  for (const Use use : {Use::run, Use::branch, Use::study, Use::exports}) EXPECT_NE(refusal(use), "");
  for (const Use use : {Use::run_anew, Use::see_run, Use::see_either}) EXPECT_EQ(refusal(use), "");
  EXPECT_EQ(refusal(Use::see_study), "is no folder of a study: it has no study.resolved.toml");
  EXPECT_EQ(refusal(Use::resume), "holds no checkpoint to resume from");
  put({"checkpoint_prev.h5"});
  EXPECT_EQ(refusal(Use::resume), "");
}

TEST_F(Folder, WithCheckpointsAloneIsARunToo) {
  put({"checkpoint.h5"});
  EXPECT_NE(refusal(Use::run).find("whose run.json is missing or damaged; it can be resumed"), std::string::npos);
  EXPECT_NE(refusal(Use::study).find("is the folder of a run, and holds checkpoint.h5"), std::string::npos);
  EXPECT_EQ(refusal(Use::resume), "");
}

TEST_F(Folder, OfAStudyTakesNoRunEvenByForce) {
  put({"study.resolved.toml"});
  for (const Use use : {Use::run, Use::run_anew, Use::branch, Use::see_run, Use::resume}) EXPECT_NE(refusal(use), "");
  for (const Use use : {Use::study, Use::see_study, Use::see_either}) EXPECT_EQ(refusal(use), "");
  put({"run.json"});
  for (const Use use : {Use::run, Use::run_anew, Use::study}) EXPECT_NE(refusal(use), "") << "of both";
}

} // namespace
} // namespace matrigrate::run
