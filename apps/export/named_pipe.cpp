#include "apps/export/named_pipe.hpp"

#include "base/failure.hpp"

#include <fmt/format.h>

#include <fcntl.h>
#include <poll.h>
#include <sys/ioctl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <system_error>
#include <thread>
#include <utility>

namespace matrigrate::apps {

namespace {

constexpr int patience = 100;     ///< after which the child is looked at [ms]
constexpr int capacity = 1 << 20; ///< asked for [bytes]

bool is_ready(int descriptor, short what) {
  pollfd one{.fd = descriptor, .events = what, .revents = 0};
  return ::poll(&one, 1, patience) > 0 && (one.revents & what) != 0;
}

} // namespace

NamedPipe::NamedPipe(std::filesystem::path path) : m_path(std::move(path)), m_descriptor(-1) {
  // Open both ways, so that it neither waits for the child to open it nor ends while the child has not.
  if (::mkfifo(m_path.c_str(), S_IRUSR | S_IWUSR) == 0)
    m_descriptor = ::open(m_path.c_str(), O_RDWR | O_NONBLOCK | O_CLOEXEC);
  if (m_descriptor < 0)
    throw InputOutputError(
        fmt::format("{}: no pipe can be made: {}", m_path.string(), std::generic_category().message(errno)));
  ::fcntl(m_descriptor, F_SETPIPE_SZ, capacity); // faster; without it, it works too
}

NamedPipe::~NamedPipe() { close(); }

void NamedPipe::close() {
  if (m_descriptor >= 0) ::close(std::exchange(m_descriptor, -1));
}

bool NamedPipe::finish(Child& child) {
  for (int left = 0; ::ioctl(m_descriptor, FIONREAD, &left) == 0 && left > 0;) {
    if (child.ended()) return false;
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  close();
  return true;
}

bool NamedPipe::write(std::string_view bytes, Child& child) {
  while (!bytes.empty()) {
    if (!is_ready(m_descriptor, POLLOUT)) {
      if (child.ended()) return false;
      continue;
    }
    const ssize_t written = ::write(m_descriptor, bytes.data(), bytes.size());
    if (written > 0) bytes.remove_prefix(static_cast<std::size_t>(written));
  }
  return true;
}

bool NamedPipe::read(std::string& append_to, Child& child) {
  std::array<char, 1 << 16> piece{};
  while (true) {
    const bool over = child.ended().has_value(); // what it wrote before is read first
    if (is_ready(m_descriptor, POLLIN)) {
      const ssize_t size = ::read(m_descriptor, piece.data(), piece.size());
      if (size > 0) {
        append_to.append(piece.data(), static_cast<std::size_t>(size));
        return true;
      }
    }
    if (over) return false;
  }
}

} // namespace matrigrate::apps
