// Messages on standard error. spdlog writes them; only log.cpp includes it, which takes longer to compile than a
// command.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace lober::cli {

/// Before the first message: what each of them begins with. Shows warnings and errors.
void begin_log(const char* program);
/// Shows what log_info says too (--verbose).
void show_all_messages();

/// Messages of the engine get the names of options (option_names.hpp).
void log_info(std::string_view message);
void log_warning(std::string_view message);
void log_error(std::string_view message);
/// Remarks on a result (Outcome::remarks), as warnings.
void log_remarks(std::span<const std::string> remarks);
/// Everything is on its way before the process may end.
void flush_log();

}  // namespace lober::cli
