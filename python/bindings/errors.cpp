#include "python/bindings/errors.hpp"

#include <exception>
#include <string>

#include "lober/base/agreement.hpp"
#include "lober/base/error.hpp"

namespace py = pybind11;

namespace lober::python {
namespace {

void raise(const char* type, const std::exception& error) {
  const py::object class_of = py::module_::import("lober.errors").attr(type);
  const std::string what = error.what();  // may quote bytes of a file
  const auto text = py::reinterpret_steal<py::object>(
      PyUnicode_DecodeUTF8(what.data(), static_cast<Py_ssize_t>(what.size()), "replace"));
  PyErr_SetObject(class_of.ptr(), text.ptr());
}

void raise_not_simple(const NotSimpleError& error) {
  const py::object class_of = py::module_::import("lober.errors").attr("NotSimpleError");
  const py::object made =
      class_of(error.what(), error.curve, error.segment1, error.segment2, py::make_tuple(error.at.x, error.at.y));
  PyErr_SetObject(class_of.ptr(), made.ptr());
}

}  // namespace

void bind_errors(py::module_&) {
  py::register_exception_translator([](std::exception_ptr thrown) {
    try {
      if (thrown) std::rethrow_exception(thrown);
    } catch (const NotSimpleError& error) {
      raise_not_simple(error);
    } catch (const DataError& error) {
      raise("DataError", error);
    } catch (const UsageError& error) {
      raise("UsageError", error);
    } catch (const DisagreementError& error) {
      raise("DisagreementError", error);
    } catch (const Cancelled& error) {
      raise("Cancelled", error);
    } catch (const Error& error) {
      raise("Error", error);
    }
  });
}

}  // namespace lober::python
