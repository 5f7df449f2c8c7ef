#include "binding.hpp"

#include <rigor/core/range.hpp>
#include <rigor/geometry/mesh/mesh_check.hpp>
#include <rigor/model/limits.hpp>

#include <cmath>
#include <limits>

namespace rigor::python {

namespace {

using Vertices = py::array_t<double, py::array::c_style | py::array::forcecast>;

/// The number of a vertex; -1 where it is none.
int index_of_vertex(double given) {
  const bool is_index = given >= 0 && given <= std::numeric_limits<int>::max() && given == std::floor(given);
  return is_index ? static_cast<int>(given) : -1;
}

double positive(const char* what, double value) {
  const std::string fault = range_error(what, value, limits::size, "m");
  if (!fault.empty()) throw InputError(fault);
  return value;
}

Vec3 positive(const char* what, const Vec3& values) {
  return Vec3(positive(what, values.x()), positive(what, values.y()), positive(what, values.z()));
}

std::vector<Vec3> points_of(const Vertices& points) {
  if (points.ndim() != 2 || points.shape(1) != 3) throw InputError("points must be an array of shape (n, 3)");
  std::vector<Vec3> list;
  for (py::ssize_t i = 0; i < points.shape(0); ++i) list.emplace_back(Vec3::Map(points.data(i, 0)));
  return list;
}

Solid make_convex(const Vertices& points) {
  std::variant<ConvexHull, std::string> hull = make_convex_hull(points_of(points));
  if (const std::string* error = std::get_if<std::string>(&hull)) throw InputError("convex: " + *error);
  return {Convex{std::make_shared<const ConvexHull>(std::move(std::get<ConvexHull>(hull)))}};
}

Solid make_solid_mesh(const Vertices& vertices, const Vertices& triangles, bool may_be_open) {
  if (triangles.ndim() != 2 || triangles.shape(1) != 3)
    throw InputError("triangles must be an array of shape (n, 3)");
  TriangleMesh mesh;
  mesh.vertices = points_of(vertices);
  for (py::ssize_t i = 0; i < triangles.shape(0); ++i) {
    const double* const corners = triangles.data(i, 0);
    mesh.triangles.push_back(
        {index_of_vertex(corners[0]), index_of_vertex(corners[1]), index_of_vertex(corners[2])});
  }
  MeshCheckOptions options;
  options.may_be_open = may_be_open;
  std::vector<std::string> messages;
  for (const MeshDefect& defect : find_mesh_defects(mesh, options)) {
    if (defect.is_error) messages.push_back("mesh: " + defect.text);
  }
  if (!messages.empty()) throw InputError(std::move(messages));
  return {make_mesh(std::make_shared<const TriangleMesh>(std::move(mesh)))};
}

Solid make_plane(const Vec3& normal, double offset) {
  if (!(normal.allFinite() && normal.norm() > 0 && std::isfinite(offset)))
    throw InputError("a plane needs a normal that is not zero and a finite offset");
  return {HalfSpace{normal.normalized(), offset}};
}

void require_pair(const Solid& a, const Solid& b) {
  if (is_unbounded(a.shape) && is_unbounded(b.shape))
    throw InputError("two shapes without an end have no distance; one of them must be bounded");
}

py::dict contact_of(const ContactPoint& point) {
  return py::dict(py::arg("point_a") = point.p_WA, py::arg("point_b") = point.p_WB,
                  py::arg("normal") = point.n_W, py::arg("gap") = point.gap);
}

std::optional<double> contact_time(const Solid& a, const Solid& b, const py::object& pose_a,
                                   const py::object& pose_b, const Vec3& v_a, const Vec3& w_a,
                                   const Vec3& v_b, const Vec3& w_b, double t_end) {
  require_pair(a, b);
  if (!(v_a.allFinite() && w_a.allFinite() && v_b.allFinite() && w_b.allFinite() && t_end > 0 &&
        t_end <= 1e9))
    throw InputError("velocities must be finite, and t_end > 0 s and at most 1e9 s");
  const TwistMotion of_a(pose_of(pose_a), v_a, w_a), of_b(pose_of(pose_b), v_b, w_b);
  const TimeOfContact found =
      find_time_of_contact({&a.shape, Pose(), &of_a}, {&b.shape, Pose(), &of_b}, 0, t_end);
  if (!found.is_complete)
    throw InputError("the search gave up at t = " + number_text(found.lower) +
                     " s: the bodies glide along each other");
  if (!found.is_contact) return std::nullopt;
  return found.upper;
}

void bind_shapes(py::module_& module) {
  py::class_<Solid>(module, "Shape", "A shape in its own frame; full lengths in m.")
      .def("__repr__",
           [](const Solid& s) { return std::string("<Shape ") + shape_type_name(s.shape) + ">"; });
  module.def(
      "sphere", [](double r) { return Solid{Sphere{positive("radius", r)}}; }, py::arg("radius"));
  module.def(
      "box", [](const Vec3& size) { return Solid{Box{0.5 * positive("size", size)}}; }, py::arg("size"),
      "Full lengths of the edges.");
  module.def(
      "capsule",
      [](double r, double l) {
        return Solid{Capsule{positive("radius", r), 0.5 * positive("length", l)}};
      },
      py::arg("radius"), py::arg("length"), "Along z; length of the cylindrical part.");
  module.def(
      "cylinder",
      [](double r, double l) {
        return Solid{Cylinder{positive("radius", r), 0.5 * positive("length", l)}};
      },
      py::arg("radius"), py::arg("length"), "Along z.");
  module.def(
      "cone",
      [](double r, double l) {
        return Solid{Cone{positive("radius", r), 0.5 * positive("length", l)}};
      },
      py::arg("radius"), py::arg("length"), "Along z, its apex at length / 2.");
  module.def(
      "ellipsoid", [](const Vec3& radii) { return Solid{Ellipsoid{positive("radii", radii)}}; },
      py::arg("radii"));
  module.def("plane", &make_plane, py::arg("normal"), py::arg("offset") = 0.0,
             "All points with normal · p <= offset.");
  module.def("convex", &make_convex, py::arg("points"), "The convex hull of points (n x 3).");
  module.def("mesh", &make_solid_mesh, py::arg("vertices"), py::arg("triangles"),
             py::arg("may_be_open") = false,
             "Triangles (n x 3 indices), counter-clockwise seen from outside.");
}

}  // namespace

void bind_geometry(py::module_& module) {
  bind_shapes(module);
  py::class_<DistanceResult>(module, "Distance", "Signed distance with the bounds that prove it.")
      .def_readonly("distance", &DistanceResult::distance, "[m]; minus the depth of an overlap.")
      .def_readonly("lower", &DistanceResult::lower, "Proven lower bound [m].")
      .def_readonly("upper", &DistanceResult::upper, "Proven upper bound [m].")
      .def_readonly("point_a", &DistanceResult::p_WA, "Witness point on a [m].")
      .def_readonly("point_b", &DistanceResult::p_WB, "Witness point on b [m].")
      .def_readonly("normal", &DistanceResult::n_W, "Unit, from a to b.")
      .def("__float__", [](const DistanceResult& d) { return d.distance; });
  module.def(
      "distance",
      [](const Solid& a, const Solid& b, const py::object& pose_a, const py::object& pose_b) {
        require_pair(a, b);
        return signed_distance(a.shape, pose_of(pose_a), b.shape, pose_of(pose_b));
      },
      py::arg("a"), py::arg("b"), py::arg("pose_a") = py::none(), py::arg("pose_b") = py::none(),
      "Signed distance of two shapes [m].");
  module.def(
      "contacts",
      [](const Solid& a, const Solid& b, const py::object& pose_a, const py::object& pose_b,
         double tolerance) {
        require_pair(a, b);
        if (!(tolerance >= 0 && tolerance < 1e9)) throw InputError("tolerance must be at least 0 m");
        py::list list;
        for (const ContactPoint& point :
             contact_set(a.shape, pose_of(pose_a), b.shape, pose_of(pose_b), tolerance))
          list.append(contact_of(point));
        return list;
      },
      py::arg("a"), py::arg("b"), py::arg("pose_a") = py::none(), py::arg("pose_b") = py::none(),
      py::arg("tolerance") = 1e-6, "All points closer than the tolerance [m], as dicts.");
  module.def(
      "mass",
      [](const Solid& shape, double density) {
        if (is_unbounded(shape.shape)) throw InputError("a shape without an end has no mass");
        if (!(density > 0 && density <= 1e12)) throw InputError("density must be > 0 and at most 1e12 kg/m³");
        const MassProperties properties = mass_properties(shape.shape, density);
        return py::dict(py::arg("mass") = properties.mass, py::arg("center") = properties.center,
                        py::arg("inertia") = properties.inertia,
                        py::arg("error_bound") = properties.error_bound);
      },
      py::arg("shape"), py::arg("density") = 1000.0,
      "Mass [kg], centre of mass [m], inertia about it (3 x 3) [kg m²], as a dict.");
  module.def(
      "time_of_contact", &contact_time, py::arg("a"), py::arg("b"), py::arg("pose_a") = py::none(),
      py::arg("pose_b") = py::none(), py::arg("velocity_a") = Vec3(Vec3::Zero()),
      py::arg("angular_velocity_a") = Vec3(Vec3::Zero()), py::arg("velocity_b") = Vec3(Vec3::Zero()),
      py::arg("angular_velocity_b") = Vec3(Vec3::Zero()), py::arg("t_end") = 1.0,
      "First time in [0, t_end] at which the moving shapes touch [s], or None if they provably do not.");
  module.def(
      "ray",
      [](const Solid& shape, const Vec3& origin, const Vec3& direction, const py::object& pose) {
        if (!(origin.allFinite() && direction.allFinite() && direction.norm() > 0))
          throw InputError("a ray needs a finite origin and a direction that is not zero");
        std::vector<std::pair<double, Vec3>> hits;
        for (const RayHit& hit : find_ray_hits(shape.shape, pose_of(pose), {origin, direction}))
          hits.emplace_back(hit.fraction, hit.p_W);
        return hits;
      },
      py::arg("shape"), py::arg("origin"), py::arg("direction"), py::arg("pose") = py::none(),
      "All crossings of a ray: pairs of fraction and point [m].");
}

}  // namespace rigor::python
