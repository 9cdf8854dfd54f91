#pragma once

#include <sys/stat.h>
#include <sys/types.h>

#include <array>
#include <chrono>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

/// What systems have otherwise, or not at all. CMake compiles one of two files: platform_linux.cpp, or
/// platform_portable.cpp, which keeps to POSIX and flock and says less. Test of both: tests/unit/base/platform_test.cpp
namespace matrigrate::platform {

/// To be called first in main(). @param called_as  argv[0]; it may be null
void begin(const char* called_as);

/// Calls a function at the end of the program with its exit code; does nothing where the system does not tell that
/// code.
void at_exit(void (*see)(int code, void* nothing));

/// The file of this program, as a command for Child. On Linux it stays the same if the file is replaced meanwhile.
std::string this_program();

/// The same by its name, for commands on other machines. @throws InputOutputError if it is not known
std::filesystem::path program_file();

/// Asks the system to send SIGTERM to this process when its parent ends; does nothing where the system cannot. May be
/// called between fork and exec.
void end_with_parent();

/// True if a process catches a signal and does not block it.
/// @param age  since it was started: where the system does not tell, a command needs a second before it catches signals
bool catches(pid_t id, int signal, std::chrono::nanoseconds age);

/// Sends a signal so that its receiver can tell it from one of a terminal, where the system can. @return  whether it
/// was sent
bool pass_on(pid_t id, int signal);

enum class Lock { alone, shared };

/// Locks an open file for this process and for those that inherit its descriptor, without waiting.
/// @return  0, or the error; EWOULDBLOCK if another process has it locked
int lock(int descriptor, Lock kind);

/// Changes whenever contents or attributes of a file do: both times of the file, as exactly as the system tells them.
std::array<std::int64_t, 4> times_of(const struct stat& status);

/// Gives memory that was freed back to the system, where it can be told to.
void give_back_memory();

/// What the system says about the processor after a word at the start of a line; empty where it says nothing.
std::string processor(std::string_view word);

} // namespace matrigrate::platform
