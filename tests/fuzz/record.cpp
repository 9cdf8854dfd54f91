#include "target.hpp"

#include "base/failure.hpp"
#include "run/run_record.hpp"

#include <string_view>

/// A run.json from anywhere: it is refused, or all that is shown of a record can be taken from it.
int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace matrigrate::run;
  try {
    const nlohmann::ordered_json record = parse_record({reinterpret_cast<const char*>(data), size});
    scenario_name(record, "folder");
    status_of(record);
    for (const nlohmann::ordered_json& entry : lineage_of(record)) text_of(entry, "kind");
    run_facts({}, record, "scenario");
  } catch (const matrigrate::InputOutputError&) { // refused
  }
  return 0;
}
