#include "python/bindings/call.hpp"

#include <unistd.h>

namespace py = pybind11;

namespace lober::python {
namespace {

// The flag of the innermost call of the main thread.
std::atomic<std::atomic<bool>*> flag_of_main{nullptr};
struct sigaction handler_before;  // what SIGINT did before the outermost one
static_assert(std::atomic<std::atomic<bool>*>::is_always_lock_free, "the handler of a signal reads it");

void on_interrupt(int signal, siginfo_t* info, void* context) {
  if (std::atomic<bool>* const flag = flag_of_main.load()) flag->store(true);
  if ((handler_before.sa_flags & SA_SIGINFO) != 0) {
    handler_before.sa_sigaction(signal, info, context);
  } else {
    handler_before.sa_handler(signal);
  }
}

bool in_main_thread() {
  return gettid() == getpid();
}

bool has_handler(const struct sigaction& action) {
  return (action.sa_flags & SA_SIGINFO) != 0 || (action.sa_handler != SIG_DFL && action.sa_handler != SIG_IGN);
}

bool goes_on(const py::object& answer) {
  if (answer.is_none()) return true;
  const int truth = PyObject_IsTrue(answer.ptr());
  if (truth >= 0) return truth != 0;
  PyErr_Clear();
  throw UsageError("a progress function has to return True, False or None, not " +
                   py::type::of(answer).attr("__name__").cast<std::string>());
}

}  // namespace

Interrupt::Interrupt() {
  if (!in_main_thread()) return;
  around_ = flag_of_main.load();
  if (around_ == nullptr) {
    struct sigaction now {};
    if (sigaction(SIGINT, nullptr, &now) != 0 || !has_handler(now)) return;
    handler_before = now;
    struct sigaction ours {};
    ours.sa_sigaction = on_interrupt;
    ours.sa_flags = SA_SIGINFO | (now.sa_flags & SA_ONSTACK);
    ours.sa_mask = now.sa_mask;
    if (sigaction(SIGINT, &ours, nullptr) != 0) return;
    installed_ = true;
  }
  watching_ = true;
  flag_of_main.store(&flag_);
}

Interrupt::~Interrupt() {
  if (!watching_) return;
  // An interrupt ends the calls around this one too.
  if (around_ != nullptr && flag_.load()) around_->store(true);
  flag_of_main.store(around_);
  if (!installed_) return;
  // A handler that a callback has put in place of ours stays.
  struct sigaction now {};
  if (sigaction(SIGINT, nullptr, &now) == 0 && (now.sa_flags & SA_SIGINFO) != 0 && now.sa_sigaction == on_interrupt) {
    sigaction(SIGINT, &handler_before, nullptr);
  }
}

void Interrupt::raise() const {
  if (flag_.load() && PyErr_CheckSignals() != 0) throw py::error_already_set();
}

void Interrupt::raise_cancelled() const {
  raise();
  if (!flag_.load()) return;
  PyErr_SetNone(PyExc_KeyboardInterrupt);
  throw py::error_already_set();
}

bool ProgressCallback::operator()(double fraction) const {
  const py::gil_scoped_acquire acquired;
  return goes_on(callable_(fraction, py::none()));
}

bool ProgressCallback::operator()(const std::string& text) const {
  const py::gil_scoped_acquire acquired;
  return goes_on(callable_(py::none(), text));
}

bool ProgressCallback::operator()(double fraction, const std::string& text) const {
  const py::gil_scoped_acquire acquired;
  return goes_on(callable_(fraction, text));
}

}  // namespace lober::python
