#include "rigor/geometry/shape/shape.hpp"

namespace rigor {
namespace {

struct Name {
  const char* operator()(const Sphere&) const { return "sphere"; }
  const char* operator()(const Box&) const { return "box"; }
  const char* operator()(const Capsule&) const { return "capsule"; }
  const char* operator()(const Cylinder&) const { return "cylinder"; }
  const char* operator()(const Cone&) const { return "cone"; }
  const char* operator()(const Ellipsoid&) const { return "ellipsoid"; }
  const char* operator()(const HalfSpace&) const { return "plane"; }
  const char* operator()(const Cavity&) const { return "cavity"; }
  const char* operator()(const Convex&) const { return "convex"; }
  const char* operator()(const Mesh&) const { return "mesh"; }
  template <class Own>
  const char* operator()(const Own&) const {
    return Own::type_name;
  }
};

struct Unbounded {
  bool operator()(const Sphere&) const { return false; }
  bool operator()(const Box&) const { return false; }
  bool operator()(const Capsule&) const { return false; }
  bool operator()(const Cylinder&) const { return false; }
  bool operator()(const Cone&) const { return false; }
  bool operator()(const Ellipsoid&) const { return false; }
  bool operator()(const HalfSpace&) const { return true; }
  bool operator()(const Cavity&) const { return true; }
  bool operator()(const Convex&) const { return false; }
  bool operator()(const Mesh&) const { return false; }
  template <class Own>
  bool operator()(const Own&) const {
    return Own::is_unbounded;
  }
};

}  // namespace

const char* shape_type_name(const Shape& shape) {
  return std::visit(Name{}, shape);
}

bool is_unbounded(const Shape& shape) {
  return std::visit(Unbounded{}, shape);
}

}  // namespace rigor
