#pragma once
// Calls of the C library that fail when they are told to, in the place of its own: the shared library
// failing_calls. A program that is not told (LD_PRELOAD) reads what is to fail from its environment, from its
// main() on; a test that is linked with it says it itself.

#include <array>

namespace glint::faults {

/// The calls, by kind; a kind is named as in `kind_names`.
enum class Kind { Open, Read, Write, Fsync, Close, Rename, Stat, Lock, Mode, Unlink, Thread };
inline constexpr std::array kind_names{"open", "read", "write", "fsync",  "close", "rename",
                                       "stat", "lock", "mode",  "unlink", "thread"};
inline constexpr int kinds = int(kind_names.size());

/// A run that takes longer hangs: seconds.
inline constexpr unsigned longest_run_s = 10;

/// Which calls of a kind fail, and how. A write that is the first of several to fail still writes the half of
/// its bytes, as on a disk that is full.
struct Fault {
    Kind kind = Kind::Open;
    long first = 0;  // counted from 0
    long count = 1;  // how many in a row
    int error = 0;   // errno; 0: what the kind's calls fail with most
};

/// From here on calls are counted from 0, and that one fails. For one test at a time; all threads.
void fail(const Fault& fault);
/// Nothing fails any more.
void stop();
/// Calls of a kind since fail().
long calls(Kind kind);
/// Whether the fault has happened.
bool has_failed();

}  // namespace glint::faults
