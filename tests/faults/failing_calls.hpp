// The n-th call of the system that writes files fails, or is the last thing the process does.
#pragma once

namespace cover::testing {

/// Counts the calls that make, write, sync, rename or remove files from now on. The `at`-th of them
/// (from 1 on; 0: none) fails with errno `error`; with `error` 0 the process ends before it, and
/// where it is a write, after half of it.
///
/// Syncs succeed without being done: the disk is not what is tested.
/// Threads: one.
void fail_call(int at, int error);

/// Lets all calls be as they are again. The result is how many were counted.
int end_of_failures();

/// How a process ends that is told to die.
constexpr int kKilled = 137;

}  // namespace cover::testing
