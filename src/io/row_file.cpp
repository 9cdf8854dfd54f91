#include "io/row_file.hpp"

#include "base/failure.hpp"
#include "base/file.hpp"
#include "io/table.hpp"

#include <fmt/format.h>

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cmath>
#include <stdexcept>
#include <system_error>
#include <utility>

namespace matrigrate::io {

namespace {

struct Text {
  std::string operator()(double value) const { return std::isnan(value) ? std::string() : fmt::format("{}", value); }
  std::string operator()(std::uint64_t value) const { return fmt::format("{}", value); }
  std::string operator()(std::string_view value) const { return quoted(value); }
};

[[noreturn]] void fail(const std::filesystem::path& path, int error) {
  throw InputOutputError(
      fmt::format("{}: cannot be written: {}", path.string(), std::generic_category().message(error)));
}

} // namespace

std::string csv_line(const std::vector<Field>& fields) {
  std::string line;
  for (std::size_t i = 0; i < fields.size(); ++i) {
    if (i > 0) line += ',';
    line += std::visit(Text{}, fields[i]);
  }
  return line + '\n';
}

RowFile::RowFile(std::filesystem::path path, const std::vector<std::string_view>& columns,
                 const std::vector<std::vector<Field>>& rows)
    : m_path(std::move(path)), m_columns(columns.size()) {
  std::string content = csv_line({columns.begin(), columns.end()});
  for (const std::vector<Field>& fields : rows) content += line_of(fields);
  write_file(m_path, content);
  m_size = static_cast<std::int64_t>(content.size());
  m_descriptor = ::open(m_path.c_str(), O_WRONLY | O_APPEND | O_CLOEXEC);
  if (m_descriptor < 0) fail(m_path, errno);
}

RowFile::~RowFile() { ::close(m_descriptor); }

std::string RowFile::line_of(const std::vector<Field>& fields) const {
  if (fields.size() != m_columns)
    throw std::invalid_argument(
        fmt::format("{}: a row of {} fields for {} columns", m_path.string(), fields.size(), m_columns));
  return csv_line(fields);
}

void RowFile::add(const std::vector<Field>& fields) { append(line_of(fields)); }

void RowFile::append(std::string_view line) {
  std::string_view left = line;
  while (!left.empty()) {
    const ssize_t written = ::write(m_descriptor, left.data(), left.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) {
      const int error = errno;
      // Where the part of a line cannot be taken back either, the first error is the one to tell.
      [[maybe_unused]] const int second = ::ftruncate(m_descriptor, m_size);
      fail(m_path, error);
    }
    left.remove_prefix(static_cast<std::size_t>(written));
  }
  m_size += static_cast<std::int64_t>(line.size());
}

} // namespace matrigrate::io
