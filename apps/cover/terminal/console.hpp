// Messages to the person at the terminal: results on stdout, everything else on stderr.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <spdlog/logger.h>

#include <cover/error.hpp>
#include <cover/report.hpp>

#include "commands/exit_code.hpp"

namespace cover::app {

/// How much is said, and where.
struct Verbosity {
  bool quiet = false;  ///< errors only
  int verbose = 0;  ///< 1: what is done; 2: also the details; below 0 as 0: a job file says false
  std::string log_file;  ///< also write everything there; empty: nowhere
};

/// stderr as `cover: warning: ...`, and the log file with times.
///
/// Throws spdlog::spdlog_ex if the log file cannot be written.
std::shared_ptr<spdlog::logger> make_logger(const Verbosity& verbosity);

/// Prints on stderr. Where nobody can read that, it is lost, and nothing else is.
void print_on_stderr(const std::string& text);

/// Prints `cover: error: <message>` and returns the exit code that belongs to the error.
int fail(spdlog::logger& log, const Error& error);

/// The notes of a report, at most a screenful of each kind, among which every sort of sentence
/// comes once before any comes again: changes of the input and warnings always, missed targets and
/// other methods with -v, all else with -vv.
void log_notes(spdlog::logger& log, std::span<const Note> notes);
/// Warnings that are known before there is a report, in the same way.
void log_warnings(spdlog::logger& log, const std::vector<std::string>& warnings);
/// Leaves out of `notes` the warnings that were told already.
std::vector<Note> not_yet_told(const std::vector<Note>& notes,
                               const std::vector<std::string>& told);

/// 1234567 as 1,234,567.
std::string grouped(std::size_t number);
/// 1 and "region" as "1 region", 1234 as "1,234 regions".
std::string plural(std::size_t count, std::string_view noun);

}  // namespace cover::app
