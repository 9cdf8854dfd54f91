#include "run/folder_lock.hpp"

#include "base/failure.hpp"

#include <fmt/format.h>

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>
#include <thread>

namespace matrigrate::run {

using namespace std::chrono_literals;

FolderLock::FolderLock(const std::filesystem::path& folder, Kind kind, std::chrono::milliseconds patience) {
  const std::filesystem::path file = folder / ".lock";
  m_descriptor = ::open(file.c_str(), O_RDWR | O_CREAT, 0666); // kept open in commands, on purpose
  if (m_descriptor < 0)
    throw InputOutputError(
        fmt::format("{}: cannot be written: {}", file.string(), std::generic_category().message(errno)));
  const auto start = std::chrono::steady_clock::now();
  while (const int error = platform::lock(m_descriptor, kind)) {
    const bool patient = std::chrono::steady_clock::now() - start < patience;
    if ((error == EWOULDBLOCK && patient) || error == EINTR) {
      std::this_thread::sleep_for(50ms);
      continue;
    }
    ::close(m_descriptor);
    if (error != EWOULDBLOCK)
      throw InputOutputError(
          fmt::format("{}: cannot be locked: {}", file.string(), std::generic_category().message(error)));
    throw InputOutputError(
        fmt::format("{}: another process is working in this folder; wait for it to end, or end it", folder.string()));
  }
}

FolderLock::~FolderLock() { ::close(m_descriptor); }

} // namespace matrigrate::run
