#pragma once

#include <compare>
#include <string>
#include <string_view>
#include <variant>

namespace rigor {

/// A body of a Simulation by its handle, the index in the scene: Simulation::body() gives it for a name.
struct BodyHandle {
  /// In the scene, from 0.
  int index = -1;
  /// By index.
  auto operator<=>(const BodyHandle& other) const = default;
};
/// A joint of a Simulation, likewise.
struct JointHandle {
  /// In the scene, from 0.
  int index = -1;
  /// By index.
  auto operator<=>(const JointHandle& other) const = default;
};

/// What names a body or a joint in a call: its handle, which costs nothing, or its name, which is looked up.
template <class Handle>
class Reference {
 public:
  /// By its handle: nothing is looked up.
  Reference(Handle handle) : value_(handle) {}  // NOLINT(google-explicit-constructor)
  /// By its name, which must outlive this.
  Reference(std::string_view name) : value_(name) {}  // NOLINT(google-explicit-constructor)
  /// By its name.
  Reference(const char* name) : value_(std::string_view(name)) {}  // NOLINT(google-explicit-constructor)
  /// By its name.
  Reference(const std::string& name)
      : value_(std::string_view(name)) {}  // NOLINT(google-explicit-constructor)

  /// Null if it is a name.
  const Handle* handle() const { return std::get_if<Handle>(&value_); }
  /// Empty if it is a handle.
  std::string_view name() const {
    const std::string_view* name = std::get_if<std::string_view>(&value_);
    return name ? *name : std::string_view();
  }

 private:
  std::variant<Handle, std::string_view> value_;
};
using BodyReference = Reference<BodyHandle>;
using JointReference = Reference<JointHandle>;

}  // namespace rigor
