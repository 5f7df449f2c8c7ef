#pragma once

#include <rigor/rigor.hpp>

#include <pybind11/eigen.h>
#include <pybind11/functional.h>
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <memory>
#include <string>
#include <vector>

// What the files of the Python module share.
namespace rigor::python {

namespace py = pybind11;

/// A read-only array over numbers that `owner` keeps alive: no copy.
inline py::array view(const double* numbers, std::vector<py::ssize_t> shape, py::handle owner) {
  py::array array(py::dtype::of<double>(), std::move(shape), numbers, owner);
  py::detail::array_proxy(array.ptr())->flags &= ~py::detail::npy_api::NPY_ARRAY_WRITEABLE_;
  return array;
}

/// An array of one's own.
inline py::array_t<double> copied(const std::vector<double>& numbers) {
  return py::array_t<double>(static_cast<py::ssize_t>(numbers.size()), numbers.data());
}

/// An index as Python gives it, where it may name something else too; what no int holds is as far out of
/// range as can be.
int index_of(const py::handle& given);
/// A text of Python, which may hold what is none in UTF-8.
std::string text_of(const py::handle& given);
/// A function of Python that is called, and let go of, without the lock of the interpreter.
std::shared_ptr<py::object> shared_function(const py::object& function);
/// A pose as Python gives it: None, a position (3), position and quaternion w x y z (7), or a matrix (4 x 4).
Pose pose_of(const py::object& given);
/// Position and quaternion w x y z: 7 numbers.
py::array_t<double> pose_numbers(const Pose& pose);

/// A shape in Python.
struct Solid {
  Shape shape;
};

void bind_errors(py::module_& module);
void bind_simulation(py::module_& module);
void bind_run(py::module_& module);
void bind_batch(py::module_& module);
void bind_study(py::module_& module);
void bind_geometry(py::module_& module);

}  // namespace rigor::python
