#include "cli/interrupt.hpp"

#include <csignal>

namespace lober::cli {
namespace {

volatile std::sig_atomic_t seen = 0;

void on_interrupt(int) {
  seen = 1;
  std::signal(SIGINT, SIG_DFL);
}

}  // namespace

void watch_for_interrupt() {
  std::signal(SIGINT, on_interrupt);
}

bool interrupted() {
  return seen != 0;
}

}  // namespace lober::cli
