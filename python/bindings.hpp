// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pybind11/pybind11.h>

namespace alignability::python {

namespace py = pybind11;

// Each adds what its file binds to the module; in the order of module.cpp, so that types are there before defaults name them.
void bind_errors(py::module_& module);
void bind_maps(py::module_& module);
void bind_scene(py::module_& module);
void bind_score(py::module_& module);
void bind_build_map(py::module_& module);
void bind_problem(py::module_& module);
void bind_plan(py::module_& module);
void bind_risk(py::module_& module);
void bind_validate(py::module_& module);

}  // namespace alignability::python
