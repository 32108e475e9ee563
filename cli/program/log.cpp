#include "cli/program/log.hpp"

#include <spdlog/sinks/stdout_sinks.h>
#include <spdlog/spdlog.h>

#include <string>

#include "cli/program/option_names.hpp"
#include "cli/program/terminal.hpp"

namespace lober::cli {

void begin_log(const char* program) {
  spdlog::set_default_logger(spdlog::stderr_logger_mt(program));
  spdlog::set_pattern("%n: %v");
  spdlog::set_level(spdlog::level::warn);
}

void show_all_messages() {
  spdlog::set_level(spdlog::level::info);
}

void log_info(std::string_view message) {
  write_above_status_line([&] { spdlog::info("{}", with_option_names(message)); });
}
void log_warning(std::string_view message) {
  write_above_status_line([&] { spdlog::warn("{}", with_option_names(message)); });
}
void log_error(std::string_view message) {
  write_above_status_line([&] { spdlog::error("{}", with_option_names(message)); });
}

void log_remarks(std::span<const std::string> remarks) {
  for (const std::string& remark : remarks) log_warning("warning: " + remark);
}

void flush_log() {
  spdlog::default_logger()->flush();
}

}  // namespace lober::cli
