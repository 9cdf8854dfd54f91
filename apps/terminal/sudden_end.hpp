#pragma once

namespace matrigrate::apps {

/// From here on what ends the program at once ends it with exit code 4 and one line on standard error, as the end of
/// memory does; libraries are not all prepared for that. Such ends are signals that tell of a fault of the program or a
/// library (SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT), and a library that calls exit() with a code that is not of the
/// program's. No file is touched: what is there is whole, since files are replaced at once, and a run goes on from its
/// last checkpoint as after SIGKILL. A stack that is too deep is caught in the thread that calls this; in others it
/// ends the program by its signal.
///
/// Does nothing where the signal itself is wanted, with its core: if MATRIGRATE_CORE_DUMP is in the environment, or if
/// someone else handles SIGSEGV already, as sanitizers do. Debuggers see the signal first. Test:
/// tests/apps/sudden_end_test.cpp
void give_sudden_ends_an_exit_code();

} // namespace matrigrate::apps
