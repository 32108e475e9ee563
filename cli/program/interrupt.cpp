#include "cli/program/interrupt.hpp"

#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <string_view>

namespace lober::cli {
namespace {

std::atomic<bool> interrupt_seen{false};
static_assert(std::atomic<bool>::is_always_lock_free, "the handler of a signal may set it");
bool on_terminal = false;

// Calls nothing but what the handler of a signal may call.
void say(std::string_view text) {
  if (::write(STDERR_FILENO, text.data(), text.size()) < 0) return;  // nobody listens
}

void on_interrupt(int) {
  if (interrupt_seen.exchange(true)) std::_Exit(130);
  if (on_terminal) say("\r\x1b[K");  // over the line of the progress
  say("lober: interrupted, ending; a second interrupt ends it at once\n");
}

}  // namespace

void watch_for_interrupt() {
  on_terminal = ::isatty(STDERR_FILENO) != 0;
  std::signal(SIGINT, on_interrupt);
}

const std::atomic<bool>& interrupt_flag() {
  return interrupt_seen;
}

bool interrupted() {
  return interrupt_seen.load(std::memory_order_relaxed);
}

}  // namespace lober::cli
