#include "tables/state_json.hpp"

#include "base/failure.hpp"
#include "base/file.hpp"
#include "store/run_memory.hpp"

#include <gtest/gtest.h>

#include <unistd.h>

#include <filesystem>
#include <string>

namespace matrigrate::store {
namespace {

std::string nested(std::size_t levels) { return std::string(levels, '[') + std::string(levels, ']'); }

TEST(JsonText, RefusesTooManyLevels) {
  EXPECT_TRUE(parse_json(nested(max_json_levels)).is_array());
  EXPECT_TRUE(parse_json(nested(max_json_levels + 1)).is_discarded());
  EXPECT_TRUE(parse_json(R"({"a": )" + nested(200000) + "}").is_discarded());
  EXPECT_THROW(parse_memory(nested(200000), {}), InputOutputError);
  const std::string in_a_text = "[\"\\\"" + std::string(200000, '[') + "\"]";
  EXPECT_TRUE(parse_json(in_a_text).is_array()) << "brackets in a text are no levels";
}

TEST(JsonText, TellsWhatIsNoObject) {
  const auto file = std::filesystem::temp_directory_path() / ("json_text_" + std::to_string(::getpid()) + ".json");
  const auto refusal = [&](const std::string& text) -> std::string {
    write_file(file, text);
    try {
      read_json_object(file, 1U << 20U);
    } catch (const InputOutputError& error) {
      return error.what();
    }
    return "accepted";
  };
  EXPECT_EQ(refusal("{\"a\": 1}"), "accepted");
  EXPECT_EQ(refusal("[1]"), file.string() + ": is no JSON object, but of type array");
  EXPECT_EQ(refusal("\"a\""), file.string() + ": is no JSON object, but of type string");
  EXPECT_EQ(refusal("{"), file.string() + ": is no JSON");
  EXPECT_EQ(refusal(nested(200000)), file.string() + ": has brackets nested more than 100 levels deep");
  std::filesystem::remove(file);
}

} // namespace
} // namespace matrigrate::store
