#include "apps/run_record.hpp"

#include "apps/provenance.hpp"
#include "io/trajectory_hash.hpp"
#include "parameters/write.hpp"

#include <fmt/chrono.h>
#include <fmt/format.h>

namespace matrigrate::apps {

namespace {

using Json = nlohmann::ordered_json;
using Clock = std::chrono::system_clock;

/// ISO 8601, UTC: "2026-01-31T12:00:00Z".
std::string utc(Clock::time_point time) {
  return fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(Clock::to_time_t(time)));
}

} // namespace

std::string configuration_hash(const Parameters& p) {
  Parameters q = p;
  q.run.threads = RunParameters{}.threads;
  return io::text_hash(to_toml(q));
}

std::string run_title(const Parameters& p) { return fmt::format("Migration run, seed {}", p.run.seed); }

Json to_json(const RunRecord& record, const Parameters& p) {
  const Clock::time_point now = record.end.value_or(Clock::now());
  const io::LostFrames& lost = record.lost_frames;
  Json json{{"status", record.status},
            {"exit_code", record.exit_code ? Json(*record.exit_code) : Json()},
            {"reason", record.reason},
            {"seed", p.run.seed},
            {"steps", record.steps},
            {"t_s", record.t},
            {"duration_s", p.run.duration},
            {"wall_time_s", record.earlier_wall_time + std::chrono::duration<double>(now - record.start).count()},
            {"ms_per_step",
             record.steps > 0 ? Json(1e3 * record.march_wall_time / static_cast<double>(record.steps)) : Json()},
            {"trajectory_hash", record.trajectory_hash},
            {"configuration_hash", record.configuration_hash},
            {"frames_lost", lost.count},
            {"frames_lost_s", lost.count > 0 ? Json{lost.first, lost.last} : Json()},
            {"command_line", record.command_line},
            {"start", utc(record.start)},
            {"end", record.end ? Json(utc(*record.end)) : Json()},
            {"lineage", record.lineage}};
  json.update(provenance());
  return json;
}

} // namespace matrigrate::apps
