#pragma once

namespace matrigrate::apps {

/// From here on a sudden end of the program gives exit code 4 and one line on standard error. Sudden ends are the
/// signals of a fault of the program or a library (SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT), and a library that calls
/// exit() with a code that the program does not use. A cause is the end of memory, for which not every library is
/// prepared. No file is touched: files are replaced at once, so they are whole, and a run can be resumed from its last
/// checkpoint as after SIGKILL. A stack overflow is caught in the thread that calls this function; in other threads it
/// ends the program by its signal.
///
/// Does nothing where the signal itself is wanted, with its core: if MATRIGRATE_CORE_DUMP is in the environment, or if
/// someone else handles SIGSEGV already, as sanitizers do. Debuggers see the signal first. Test:
/// tests/apps/sudden_end_test.cpp
void give_sudden_ends_an_exit_code();

} // namespace matrigrate::apps
