// SPDX-License-Identifier: BSD-3-Clause
#include "python/long_work.hpp"

namespace alignability::python {

namespace py = pybind11;

LongWork::LongWork(py::object progress) : progress_(std::move(progress)) {
  if (!progress_.is_none() && PyCallable_Check(progress_.ptr()) == 0) {
    throw py::type_error("progress must be a function of (done, total) or None");
  }
}

ProgressCallback LongWork::progress() {
  if (progress_.is_none()) return {};
  return [this](Progress progress) { report(progress); };
}

void LongWork::watch(const std::function<bool(std::chrono::milliseconds)>& is_done) {
  constexpr std::chrono::milliseconds kPatience(50);
  const py::gil_scoped_release release;
  while (!is_done(kPatience)) {
    const py::gil_scoped_acquire acquire;
    if (PyErr_CheckSignals() != 0) stop_with(py::error_already_set());
  }
}

void LongWork::stop_with(py::error_already_set error) {
  if (!raised_) raised_.emplace(std::move(error));
  stop_.request_stop();
}

void LongWork::report(Progress progress) {
  const py::gil_scoped_acquire acquire;
  if (raised_) return;
  try {
    progress_(progress.done, progress.total);
  } catch (py::error_already_set& error) {
    stop_with(std::move(error));
  }
}

}  // namespace alignability::python
