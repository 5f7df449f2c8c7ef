// The Python module rigor._rigor: errors, and the parts of the other files. Python's side of it is in
// rigor/*.py.

#include "binding.hpp"

#include <rigor/io/files/version.hpp>
#include <rigor/study/formula/time_formula.hpp>

#include <algorithm>
#include <limits>

namespace rigor::python {

int index_of(const py::handle& given) {
  int is_too_large = 0;
  const py::object whole = py::reinterpret_steal<py::object>(PyNumber_Index(given.ptr()));
  if (!whole) throw py::error_already_set();
  const long index = PyLong_AsLongAndOverflow(whole.ptr(), &is_too_large);
  constexpr long lowest = std::numeric_limits<int>::min(), highest = std::numeric_limits<int>::max();
  if (is_too_large != 0) return static_cast<int>(is_too_large > 0 ? highest : lowest);
  return static_cast<int>(std::clamp(index, lowest, highest));
}

std::string text_of(const py::handle& given) {
  Py_ssize_t length = 0;
  const char* const text = PyUnicode_AsUTF8AndSize(given.ptr(), &length);
  if (text == nullptr) throw py::error_already_set();
  return {text, static_cast<std::size_t>(length)};
}

std::shared_ptr<py::object> shared_function(const py::object& function) {
  if (PyCallable_Check(function.ptr()) == 0) throw py::type_error("a controller is a function, or None");
  // Whoever lets go of it last may not hold the lock.
  return {new py::object(function), [](py::object* own) {
            const py::gil_scoped_acquire lock;
            delete own;
          }};
}

Pose pose_of(const py::object& given) {
  if (given.is_none()) return Pose();
  const auto numbers = py::array_t<double, py::array::c_style | py::array::forcecast>::ensure(given);
  if (!numbers) {
    PyErr_Clear();
    throw InputError(
        "a pose is a position (3), a position and a quaternion w, x, y, z (7), or a 4 x 4 matrix");
  }
  const double* v = numbers.data();
  Pose pose;
  if (numbers.ndim() == 1 && (numbers.size() == 3 || numbers.size() == 7)) {
    pose.p = Vec3(v[0], v[1], v[2]);
    if (numbers.size() == 7) {
      const Quat q(v[3], v[4], v[5], v[6]);
      constexpr double error = 1e-3;
      if (!(std::abs(q.norm() - 1) <= error))
        throw InputError("the quaternion of the pose (w, x, y, z) must have norm 1");
      pose.R = rotation_matrix(q.normalized());
    }
  } else if (numbers.ndim() == 2 && numbers.shape(0) == 4 && numbers.shape(1) == 4) {
    const Eigen::Map<const Eigen::Matrix<double, 4, 4, Eigen::RowMajor>> matrix(v);
    pose.R = matrix.topLeftCorner<3, 3>();
    pose.p = matrix.topRightCorner<3, 1>();
    if (!((pose.R.transpose() * pose.R - Mat3::Identity()).cwiseAbs().maxCoeff() <= 1e-6 &&
          pose.R.determinant() > 0))
      throw InputError("the upper left part of the matrix of the pose is not a rotation");
  } else {
    throw InputError(
        "a pose is a position (3), a position and a quaternion w, x, y, z (7), or a 4 x 4 matrix");
  }
  if (!pose.p.allFinite()) throw InputError("the position of the pose is not finite");
  return pose;
}

py::array_t<double> pose_numbers(const Pose& pose) {
  const Quat q = quaternion_of(pose.R);
  return copied({pose.p.x(), pose.p.y(), pose.p.z(), q.w(), q.x(), q.y(), q.z()});
}

void bind_errors(py::module_& module) {
  static py::exception<InputError> input_error(module, "InputError", PyExc_ValueError);
  static py::exception<SimulationStopped> stopped(module, "SimulationStopped", PyExc_RuntimeError);
  input_error.attr("__doc__") =
      "Wrong input: what is wrong, where, and what is allowed; messages lists all of it.";
  stopped.attr("__doc__") = "The engine could not continue: when, and why.";
  py::register_exception_translator([](std::exception_ptr error) {
    try {
      if (error) std::rethrow_exception(error);
    } catch (const InputError& wrong) {
      py::object instance = static_cast<py::object&>(input_error)(std::string(wrong.what()));
      instance.attr("messages") = wrong.messages();
      PyErr_SetObject(input_error.ptr(), instance.ptr());
    } catch (const SimulationStopped& stop) {
      PyErr_SetString(stopped.ptr(), stop.what());
    } catch (const FileError& failure) {
      PyErr_SetString(PyExc_OSError, failure.what());
    } catch (const Interrupted&) {
      if (!PyErr_Occurred()) PyErr_SetString(PyExc_KeyboardInterrupt, "interrupted");
    }
  });
}

}  // namespace rigor::python

PYBIND11_MODULE(_rigor, module) {
  using namespace rigor::python;
  module.attr("__version__") = std::string(rigor::version);
  rigor::use_time_formulas();
  bind_errors(module);
  bind_run(module);
  bind_simulation(module);
  bind_batch(module);
  bind_study(module);
  py::module_ geometry = module.def_submodule("geometry", "Shapes and what can be asked of them.");
  bind_geometry(geometry);
}
