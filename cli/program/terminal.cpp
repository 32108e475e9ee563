#include "cli/program/terminal.hpp"

#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cstdio>
#include <mutex>

namespace lober::cli {
namespace {

std::mutex writing;
std::atomic<std::size_t> drawn_length{0};  // written under the mutex

// Bytes are at least as many as characters.
void wipe() {
  const std::size_t length = drawn_length.exchange(0);
  if (length == 0) return;
  std::fputs(("\r" + std::string(length, ' ') + "\r").c_str(), stderr);
}

}  // namespace

bool is_error_terminal() {
  return isatty(STDERR_FILENO) != 0;
}
bool is_output_terminal() {
  return isatty(STDOUT_FILENO) != 0;
}

std::size_t error_terminal_width() {
  winsize size{};
  return ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col != 0 ? size.ws_col : 80;
}

std::string printable(std::string_view text) {
  std::string clean(text);
  std::replace_if(
      clean.begin(), clean.end(), [](unsigned char c) { return c < 0x20 || c == 0x7F; }, '?');
  return clean;
}

void draw_status_line(const std::string& text) {
  const std::lock_guard lock(writing);
  const std::size_t before = drawn_length.exchange(text.size());
  std::string line = "\r" + text;
  if (before > text.size()) line.append(before - text.size(), ' ');
  std::fputs(line.c_str(), stderr);
}

void wipe_status_line() {
  const std::lock_guard lock(writing);
  wipe();
}

void write_above_status_line(const std::function<void()>& write) {
  const std::lock_guard lock(writing);
  wipe();
  write();
}

std::size_t status_line_length() {
  return drawn_length.load(std::memory_order_relaxed);
}

}  // namespace lober::cli
