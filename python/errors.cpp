// SPDX-License-Identifier: BSD-3-Clause
#include "core/input_error.hpp"
#include "core/progress.hpp"
#include "python/bindings.hpp"

namespace alignability::python {
namespace {

// A message may hold the name of a file in whatever encoding.
py::str text(const std::string& bytes) {
  PyObject* const decoded = PyUnicode_DecodeUTF8(bytes.data(), static_cast<Py_ssize_t>(bytes.size()), "surrogateescape");
  if (decoded == nullptr) throw py::error_already_set();
  return py::reinterpret_steal<py::str>(decoded);
}

void raise(const InputError& error, py::handle type) {
  py::object raised = type(text(error.what()));
  raised.attr("file") = text(error.file().string());
  raised.attr("line") = error.position().line;
  raised.attr("column") = error.position().column;
  PyErr_SetObject(type.ptr(), raised.ptr());
}

}  // namespace

void bind_errors(py::module_& module) {
  // Owned by the interpreter until it ends: errors may come as long as it lives.
  static py::handle input_error;
  input_error = PyErr_NewExceptionWithDoc("alignability.InputError",
                                          "What was given is wrong. The text reads like a compiler's message, file:line:column; `file`, "
                                          "`line` and `column`, counted from 1, have its parts, 0 where there is no place.",
                                          PyExc_ValueError, nullptr);
  if (!input_error) throw py::error_already_set();
  module.attr("InputError") = input_error;
  py::register_exception_translator([](std::exception_ptr thrown) {
    try {
      if (thrown) std::rethrow_exception(thrown);
    } catch (const InputError& error) {
      raise(error, input_error);
    } catch (const Interrupted&) {
      PyErr_SetNone(PyExc_KeyboardInterrupt);
    }
  });
}

}  // namespace alignability::python
