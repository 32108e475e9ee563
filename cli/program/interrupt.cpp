#include "cli/program/interrupt.hpp"

#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstdlib>
#include <string_view>

#include "cli/program/terminal.hpp"

namespace lober::cli {
namespace {

std::atomic<bool> interrupt_seen{false};
static_assert(std::atomic<bool>::is_always_lock_free, "the handler of a signal may set it");

constexpr std::string_view blanks =
    "                                                                                                    "
    "                                                                                                    ";

// Calls nothing but what the handler of a signal may call.
void say(std::string_view text) {
  if (::write(STDERR_FILENO, text.data(), text.size()) < 0) return;  // nobody listens
}

void on_interrupt(int) {
  if (interrupt_seen.exchange(true)) std::_Exit(130);
  // Over the line of the progress.
  if (const std::size_t length = std::min(status_line_length(), blanks.size()); length != 0) {
    say("\r");
    say(blanks.substr(0, length));
    say("\r");
  }
  say("lober: interrupted, ending; a second interrupt ends it at once\n");
}

}  // namespace

void watch_for_interrupt() {
  std::signal(SIGINT, on_interrupt);
}

const std::atomic<bool>& interrupt_flag() {
  return interrupt_seen;
}

bool interrupted() {
  return interrupt_seen.load(std::memory_order_relaxed);
}

}  // namespace lober::cli
