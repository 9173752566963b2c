#pragma once
// Functions of the C library that fail on request; the shared library failing_calls replaces the originals
// with them. A program run with the library preloaded (LD_PRELOAD) reads the fault from its environment when
// its main() starts; a test that is linked with the library calls fail().

#include <array>

namespace glint::faults {

/// The calls, by kind; the names of the kinds are in `kind_names`.
enum class Kind { Open, Read, Write, Fsync, Close, Rename, Stat, Lock, Mode, Unlink, Thread };
inline constexpr std::array kind_names{"open", "read", "write", "fsync",  "close", "rename",
                                       "stat", "lock", "mode",  "unlink", "thread"};
inline constexpr int kinds = int(kind_names.size());

/// In seconds; a run that takes longer has hung.
inline constexpr unsigned longest_run_s = 10;

/// Which calls of a kind fail, and how. The first of several failing writes still writes half of its bytes,
/// as on a full disk.
struct Fault {
    Kind kind = Kind::Open;
    long first = 0;  // counted from 0
    long count = 1;  // the number of consecutive failures
    int error = 0;   // errno; 0: the kind's most common one
};

/// Restarts the count of calls at 0 and makes the given ones fail. Affects all threads, so only one test at a
/// time may use it.
void fail(const Fault& fault);
/// Ends the failures.
void stop();
/// The number of calls of a kind since fail().
long calls(Kind kind);
/// Whether the fault has happened.
bool has_failed();

}  // namespace glint::faults
