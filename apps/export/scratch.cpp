#include "apps/export/exports.hpp"
#include "base/failure.hpp"
#include "base/file.hpp"
#include "base/process.hpp"

#include <fmt/format.h>

#include <fcntl.h>
#include <unistd.h>

#include <chrono>
#include <fstream>
#include <thread>

namespace matrigrate::apps {

namespace {

std::filesystem::path drawing_folder(const std::filesystem::path& in) {
  std::filesystem::path folder = std::filesystem::absolute(in / ".drawing");
  if (std::filesystem::is_symlink(folder)) // what it leads to is not ours to remove
    throw InputOutputError(fmt::format("{}: is a symbolic link; remove it", folder.string()));
  make_folder(folder);
  return folder;
}

} // namespace

Scratch::Scratch(const std::filesystem::path& in) : path(drawing_folder(in)), lock(path, run::FolderLock::Kind::alone) {
  for (const auto& left : std::filesystem::directory_iterator(path))
    if (left.path().filename() != ".lock") std::filesystem::remove_all(left.path());
  std::filesystem::create_directory(path / "made");
}

Scratch::~Scratch() {
  std::error_code ignored;
  std::filesystem::remove_all(path, ignored);
}

int exit_code_of(const std::vector<std::string>& command, const std::filesystem::path& log) {
  const int output = ::open(log.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, S_IRUSR | S_IWUSR);
  Child child(command, output >= 0 ? output : STDERR_FILENO);
  if (output >= 0) ::close(output);
  while (!child.ended()) std::this_thread::sleep_for(std::chrono::milliseconds(5));
  return *child.ended();
}

void call(const std::vector<std::string>& command, const Scratch& scratch) {
  const std::filesystem::path log = scratch.path / "said.txt";
  const int code = exit_code_of(command, log);
  if (code == 0) return;
  std::ifstream said(log);
  std::string last = fmt::format("{} ended with exit code {}", command.front(), code);
  for (std::string line; std::getline(said, line);)
    if (!line.empty()) last = line;
  throw InputOutputError(last);
}

void move_made(const Scratch& scratch, const std::filesystem::path& to) {
  for (const auto& file : std::filesystem::directory_iterator(scratch.path / "made"))
    rename_file(file.path(), to / file.path().filename());
}

} // namespace matrigrate::apps
