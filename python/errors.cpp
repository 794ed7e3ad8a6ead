// lutlib::Error as a Python exception that keeps file and line.
#include "lutlib/error.h"
#include "python/parts.h"

namespace lutlib_python {
namespace {

// Both live as long as the process: the module holds them, and is never unloaded.
PyObject* error_type = nullptr;
PyObject* usage_error_type = nullptr;

void raise(PyObject* type, const lutlib::Error& error) {
    const lutlib::Where& where = error.where();
    const py::object exception = py::reinterpret_borrow<py::object>(type)(error.what());
    exception.attr("message") = error.message();
    exception.attr("file") = where.file.empty() ? py::object(py::none()) : py::str(where.file);
    exception.attr("line") = where.line == 0 ? py::object(py::none()) : py::int_(where.line);
    PyErr_SetObject(type, exception.ptr());
}

} // namespace

void declare_errors(py::module_& module) {
    error_type = PyErr_NewExceptionWithDoc(
        "lutlib.Error",
        "Input that cannot be used. `message` says what is wrong and what to do, `file` and `line` "
        "(from 1) where; they are None where there is no such place.",
        PyExc_ValueError, nullptr);
    usage_error_type = PyErr_NewExceptionWithDoc(
        "lutlib.UsageError",
        "An argument that cannot be: a name that is none, a size out of range.", error_type,
        nullptr);
    module.attr("Error") = py::reinterpret_borrow<py::object>(error_type);
    module.attr("UsageError") = py::reinterpret_borrow<py::object>(usage_error_type);
    py::register_exception_translator([](std::exception_ptr thrown) {
        try {
            std::rethrow_exception(thrown);
        } catch (const lutlib::UsageError& error) {
            raise(usage_error_type, error);
        } catch (const lutlib::Error& error) {
            raise(error_type, error);
        }
    });
}

} // namespace lutlib_python
