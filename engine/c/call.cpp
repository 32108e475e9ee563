#include "engine/c/call.hpp"

#include <exception>
#include <new>
#include <utility>

#include "lober/base/error.hpp"
#include "lober/base/threads.hpp"
#include "lober/base/version.hpp"

namespace lober::detail::c {
namespace {

thread_local std::string last_message;

int failed(int status, const char* text) noexcept {
  try {
    last_message = text;
  } catch (...) {
    last_message.clear();  // no memory for it
  }
  return status;
}

}  // namespace

int guarded(const std::function<void()>& function) noexcept {
  try {
    refuse_in_progress_function();
    function();
    return LOBER_OK;
  } catch (const WithResult& reason) {
    return failed(reason.status, reason.text.c_str());
  } catch (const UsageError& error) {
    return failed(LOBER_USAGE_ERROR, error.what());
  } catch (const Cancelled& error) {
    return failed(LOBER_CANCELLED, error.what());
  } catch (const Error& error) {
    return failed(LOBER_DATA_ERROR, error.what());
  } catch (const std::bad_alloc&) {
    return failed(LOBER_OUT_OF_MEMORY, "out of memory");
  } catch (const std::exception& error) {
    return failed(LOBER_INTERNAL_ERROR, error.what());
  } catch (...) {
    return failed(LOBER_INTERNAL_ERROR, "an exception of a kind that lober does not throw");
  }
}

int operation(const char* options, lober_result** result,
              const std::function<std::function<void(lober_result&)>(Options&)>& prepare) noexcept {
  if (result) *result = nullptr;
  return guarded([&] {
    if (!result) throw UsageError("result is a null pointer");
    Options given(options);
    const int threads = given.threads();
    const std::function<void(lober_result&)> work = prepare(given);
    given.require_all_known();
    auto made = std::make_unique<lober_result>();
    try {
      run_with_threads(threads, [&] { work(*made); });
    } catch (const WithResult&) {
      *result = made.release();
      throw;
    }
    *result = made.release();
  });
}

std::span<const Point> points_of(const double* points, std::size_t count, const char* name) {
  if (!points && count > 0) throw UsageError(std::string(name) + ": no points are given");
  static_assert(sizeof(Point) == 2 * sizeof(double) && alignof(Point) == alignof(double));
  return {reinterpret_cast<const Point*>(points), count};
}

ClosedCurve closed_curve(const double* points, std::size_t count, const char* name) {
  return ClosedCurve::borrow(points_of(points, count, name));
}

}  // namespace lober::detail::c

const char* lober_message(void) {
  return lober::detail::c::last_message.c_str();
}

int lober_interface_version(void) {
  return LOBER_INTERFACE_VERSION;
}

const char* lober_version(void) {
  return lober::version();
}
