#include "binding.hpp"

namespace rigor::python {

namespace {

using Numbers = py::array_t<double, py::array::c_style | py::array::forcecast>;

/// One number, or `columns` numbers, for each world.
void require_shape(const Batch& batch, const Numbers& numbers, py::ssize_t columns, const char* what) {
  const bool fits =
      columns == 1 ? numbers.ndim() == 1 && numbers.shape(0) == batch.size()
                   : numbers.ndim() == 2 && numbers.shape(0) == batch.size() && numbers.shape(1) == columns;
  if (fits) return;
  throw InputError(std::string(what) + " must be an array of shape (" + std::to_string(batch.size()) +
                   (columns == 1 ? ",)" : ", " + std::to_string(columns) + ")"));
}

py::array_t<double> of_joint(Batch& batch, const std::string& joint, int coordinate, bool is_rate) {
  py::array_t<double> numbers(batch.size());
  double* out = numbers.mutable_data();
  const JointHandle handle = batch.world(0).joint(joint);
  const int count = static_cast<int>(batch.world(0).model().joint(handle.index).axes.size());
  if (coordinate < 0 || coordinate >= count)
    throw InputError("joint '" + joint + "' has " + std::to_string(count) + " coordinates");
  const py::gil_scoped_release release;
  batch.for_each([&](int i, Simulation& world) {
    const JointReaction motion = world.joint_motion(handle);
    out[i] = (is_rate ? motion.rates : motion.coordinates)[static_cast<std::size_t>(coordinate)];
  });
  return numbers;
}

}  // namespace

void bind_batch(py::module_& module) {
  py::class_<Batch>(module, "Batch")
      .def(py::init<const Scene&, int, int>(), py::arg("scene"), py::arg("count"), py::arg("threads") = 0)
      .def("__len__", &Batch::size)
      .def_property_readonly("threads", &Batch::threads, "Number of threads.")
      .def("step", &Batch::step, py::call_guard<py::gil_scoped_release>(), "One step of every world.")
      .def("advance_to", &Batch::advance_to, py::arg("t"), py::call_guard<py::gil_scoped_release>(),
           "Advances every world to t [s].")
      .def(
          "world", [](Batch& b, int i) -> Simulation& { return b.world(i); }, py::arg("index"),
          py::return_value_policy::reference_internal, "A world, as a Simulation.")
      .def_property_readonly("stops", &Batch::stops, "Why each world has stopped; empty where it has not.")
      .def_property_readonly(
          "states",
          [](const py::object& self) {
            Batch& batch = py::cast<Batch&>(self);
            const std::vector<double>& numbers = batch.states();
            return view(numbers.data(), {batch.size(), batch.world(0).body_count(), 13}, self);
          },
          "Position, quaternion w x y z, velocity, angular velocity (worlds x bodies x 13): a "
          "view that is refreshed each time it is asked for.")
      .def(
          "apply_forces",
          [](Batch& b, const std::string& body, const Numbers& forces) {
            require_shape(b, forces, 3, "forces");
            const BodyHandle handle = b.world(0).body(body);
            for (int i = 0; i < b.size(); ++i) b.world(i).apply_force(handle, Vec3::Map(forces.data(i, 0)));
          },
          py::arg("body"), py::arg("forces"),
          "A force [N] on a body in each world, until the next step ends.")
      .def(
          "set_motor_efforts",
          [](Batch& b, const std::string& joint, const Numbers& efforts, int k) {
            require_shape(b, efforts, 1, "efforts");
            const JointHandle handle = b.world(0).joint(joint);
            for (int i = 0; i < b.size(); ++i) b.world(i).set_motor_effort(handle, *efforts.data(i), k);
          },
          py::arg("joint"), py::arg("efforts"), py::arg("coordinate") = 0,
          "Of a joint's motor in each world.")
      .def(
          "joint_coordinates", [](Batch& b, const std::string& j, int k) { return of_joint(b, j, k, false); },
          py::arg("joint"), py::arg("coordinate") = 0, "In each world [rad] or [m].")
      .def(
          "joint_rates", [](Batch& b, const std::string& j, int k) { return of_joint(b, j, k, true); },
          py::arg("joint"), py::arg("coordinate") = 0, "In each world [rad/s] or [m/s].")
      .def(
          "reset",
          [](Batch& b, int i) {
            b.world(i).reset();
            b.clear_stop(i);
          },
          py::arg("index"), "Returns a world to t = 0.");
}

}  // namespace rigor::python
