#include "rigor/io/scene/body_reader.hpp"

#include "rigor/io/scene/pose_reader.hpp"
#include "rigor/io/scene/shape_reader.hpp"
#include "rigor/math/splitmix64.hpp"
#include "rigor/model/limits.hpp"

#include <fmt/format.h>
#include <optional>
#include <string>
#include <utility>

namespace rigor {

namespace {

MotionType read_motion(const ObjectReader& body) {
  const std::string motion = body.text("motion").value_or("dynamic");
  if (motion == "static") return MotionType::fixed;
  return motion == "kinematic" ? MotionType::kinematic : MotionType::dynamic;
}

void read_mass(const ObjectReader& body, BodyDescription& description) {
  description.mass = body.number("mass");
  description.density = body.number("density");
  if (!body.has("inertia")) return;
  const ObjectReader inertia(*body.find("inertia"), key_table("inertia"), "inertia of " + body.whose(),
                             body.errors());
  GivenInertia given{inertia.number("mass").value_or(1)};
  given.center = inertia.vector("center").value_or(Vec3::Zero());
  const std::optional<Vec3> moments = inertia.vector("moments");
  const Vec3 products = inertia.vector("products").value_or(Vec3::Zero());
  // Moments that could not be read must not be reported as inconsistent with products that could.
  given.moments = moments.value_or(Vec3::Ones());
  if (moments) given.products = products;
  description.inertia = given;
}

std::vector<PathPoint> read_path(const ObjectReader& body) {
  std::vector<PathPoint> path;
  for (const YamlNode* const node : body.list("path")) {
    const std::string whose = fmt::format("path point {} of {}", path.size(), body.whose());
    const ObjectReader point(*node, key_table("path_point"), whose, body.errors());
    const double after_last = path.empty() ? 0 : path.back().time + 1;
    path.push_back(
        {point.number("time").value_or(after_last), read_position(point), read_orientation(point)});
  }
  return path;
}

/// FNV-1a hash, which gives each repeated body random numbers of its own.
std::uint64_t hash_of(const std::string& name) {
  std::uint64_t hash = 14695981039346656037u;
  for (const char c : name) hash = (hash ^ static_cast<unsigned char>(c)) * 1099511628211u;
  return hash;
}

}  // namespace

void BodyReader::read(const YamlNode& node, std::size_t index) {
  const ObjectReader body(node, key_table("body"), whose_text("body", node, index), errors_);
  if (node.kind != YamlNode::Kind::map) return;
  BodyDescription description;
  const std::optional<std::string> name = body.text("name");
  description.name = name.value_or("");
  description.motion = read_motion(body);
  description.p_WU = read_position(body);
  description.q_WU = read_orientation(body);
  description.velocity = body.vector("velocity").value_or(Vec3::Zero());
  description.angular_velocity = body.vector("angular_velocity").value_or(Vec3::Zero());
  read_mass(body, description);
  for (const YamlNode* const shape : body.list("shapes")) {
    description.shapes.push_back(
        read_shape(*shape, description.shapes.size(), body.whose(), files_, errors_));
  }
  description.group = static_cast<std::uint32_t>(body.number("group").value_or(description.group));
  description.mask = static_cast<std::uint32_t>(body.number("mask").value_or(description.mask));
  description.linear_drag = body.number("linear_drag").value_or(0);
  description.angular_drag = body.number("angular_drag").value_or(0);
  description.gravity_scale = body.number("gravity_scale").value_or(1);
  description.linear_damping = body.number("linear_damping").value_or(0);
  description.angular_damping = body.number("angular_damping").value_or(0);
  description.path = read_path(body);
  warn_of_unused(body, description);

  // The error for an unreadable name has been reported; nothing can refer to this body.
  if (!name) return;
  if (body.has("repeat")) {
    add_repeated(body, description);
  } else if (has_room(body, 1)) {
    builder_.add_body(std::move(description), errors_.where(node));
  }
}

void BodyReader::warn_of_unused(const ObjectReader& body, const BodyDescription& description) const {
  const bool has_mass = description.mass || description.density || description.inertia;
  if (description.motion != MotionType::dynamic && has_mass) {
    body.errors().add_warning(body.node(), body.whose() + ": it is not dynamic, so its mass is not used");
  }
  if (description.shapes.empty() && surroundings_.jointed_names.count(description.name) == 0) {
    body.errors().add_warning(body.node(), body.whose() + ": it has no shapes, so it touches nothing");
  }
}

bool BodyReader::has_room(const ObjectReader& body, double count) {
  body_count_ += count;
  const double most = static_cast<double>(limits::body_count);
  if (body_count_ <= most) return true;
  if (body_count_ - count <= most) {
    body.fail("repeat",
              fmt::format("with it the scene has {} bodies, must be at most {}", body_count_, most));
  }
  return false;
}

void BodyReader::add_repeated(const ObjectReader& body, const BodyDescription& description) {
  const ObjectReader repeat(*body.find("repeat"), key_table("repeat"), "repeat of " + body.whose(), errors_);
  const Vec3 count = repeat.vector("count").value_or(Vec3::Ones());
  const Vec3 spacing = repeat.vector("spacing").value_or(Vec3::Zero());
  const double jitter = repeat.number("jitter").value_or(0);
  if (!description.path.empty()) body.fail("repeat", "a body with a path cannot be repeated");
  if (!has_room(body, count.prod())) return;

  SplitMix64 random(surroundings_.seed ^ hash_of(description.name));
  for (int i = 0; i < static_cast<int>(count.x()); ++i) {
    for (int j = 0; j < static_cast<int>(count.y()); ++j) {
      for (int k = 0; k < static_cast<int>(count.z()); ++k) {
        BodyDescription copy = description;
        copy.name += fmt::format("[{},{},{}]", i, j, k);
        const Vec3 grid_point = Vec3(i, j, k).cwiseProduct(spacing);
        Vec3 shift;
        for (double& component : shift) component = jitter * random.symmetric();
        copy.p_WU += grid_point + shift;
        builder_.add_body(std::move(copy), errors_.where(body.node()));
      }
    }
  }
}

}  // namespace rigor
