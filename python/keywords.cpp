// SPDX-License-Identifier: BSD-3-Clause
#include "python/keywords.hpp"

namespace alignability::python {

std::string type_name(py::handle value) { return py::type::handle_of(value).attr("__qualname__").cast<std::string>(); }

}  // namespace alignability::python
