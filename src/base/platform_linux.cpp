#include "base/failure.hpp"
#include "base/platform.hpp"

#include <fmt/format.h>

#include <malloc.h>
#include <sys/file.h>
#include <sys/prctl.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <system_error>

namespace matrigrate::platform {

void begin(const char* /*called_as*/) {
  ::mallopt(M_MMAP_THRESHOLD, 4 << 20); // what is larger grows in place, and goes back to the system at once
  ::mallopt(M_TRIM_THRESHOLD, 8 << 20); // what each step takes and gives back stays
}

void at_exit(void (*see)(int, void*)) { ::on_exit(see, nullptr); }

std::string this_program() { return "/proc/self/exe"; }

std::filesystem::path program_file() {
  std::error_code error;
  std::filesystem::path file = std::filesystem::read_symlink(this_program(), error);
  if (error) throw InputOutputError(fmt::format("{}: cannot be read: {}", this_program(), error.message()));
  return file;
}

void end_with_parent() { ::prctl(PR_SET_PDEATHSIG, SIGTERM); }

bool catches(pid_t id, int signal, std::chrono::nanoseconds /*age*/) {
  std::ifstream status(fmt::format("/proc/{}/status", id));
  bool caught = false;
  for (std::string line; std::getline(status, line);) {
    const auto has = [&] {
      return ((std::stoull(line.substr(line.find(':') + 1), nullptr, 16) >> (signal - 1)) & 1U) != 0;
    };
    if (line.starts_with("SigBlk:") && has()) return false;
    if (line.starts_with("SigCgt:")) caught = has();
  }
  return caught;
}

bool pass_on(pid_t id, int signal) { return ::sigqueue(id, signal, {}) == 0; }

int lock(int descriptor, Lock kind) {
  return ::flock(descriptor, (kind == Lock::alone ? LOCK_EX : LOCK_SH) | LOCK_NB) == 0 ? 0 : errno;
}

std::array<std::int64_t, 4> times_of(const struct stat& status) {
  return {status.st_mtim.tv_sec, status.st_mtim.tv_nsec, status.st_ctim.tv_sec, status.st_ctim.tv_nsec};
}

void give_back_memory() { ::malloc_trim(0); }

std::string processor(std::string_view word) {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);)
    if (line.starts_with(word)) return line.substr(std::min(line.size(), line.find(':') + 2));
  return {};
}

} // namespace matrigrate::platform
