#pragma once

#include "rigor/core/range.hpp"

#include <cstddef>
#include <limits>

/// What a scene may hold. A number beyond these limits is almost certainly a mistake (in a unit, a sign, an
/// exponent), or double precision could not resolve it. docs/scene.md repeats them; a test compares the two.
namespace rigor::limits {

inline constexpr double infinity = std::numeric_limits<double>::infinity();

inline constexpr Range position{-1e9, 1e9};       ///< [m], each component.
inline constexpr Range size{1e-9, 1e9};           ///< [m], radii and full lengths.
inline constexpr Range length{0, 1e9};            ///< [m], lengths that may vanish.
inline constexpr Range speed{-1e8, 1e8};          ///< [m/s], each component.
inline constexpr Range angular_speed{-1e8, 1e8};  ///< [rad/s], each component.
inline constexpr Range gravity{-1e6, 1e6};        ///< [m/s²], each component.
inline constexpr Range mass{0, 1e30, true};       ///< [kg].
inline constexpr Range density{0, 1e12, true};    ///< [kg/m³].
inline constexpr Range moment{0, 1e40};           ///< [kg m²].
inline constexpr Range product{-1e40, 1e40};      ///< [kg m²].
inline constexpr Range friction{0, 1000};
inline constexpr Range restitution{0, 1};
inline constexpr Range force{-1e15, 1e15};    ///< [N] or [N m], each component.
inline constexpr Range coefficient{0, 1e15};  ///< Stiffness, damping, drag, in their units.
inline constexpr Range gravity_scale{-1e3, 1e3};
inline constexpr Range time{-1e9, 1e9};       ///< [s].
inline constexpr Range interval{1e-12, 1e9};  ///< [s], of steps and outputs.
inline constexpr Range ratio{-1e6, 1e6};      ///< Of a gear; not 0.

/// Bodies of a scene file; models built in C++ are limited by memory only.
inline constexpr std::size_t body_count = 100000;
/// Heights of a height field.
inline constexpr std::size_t height_count = 1000000;
/// Joints of a scene.
inline constexpr std::size_t joint_count = 100000;
/// Messages after which the search for mistakes ends.
inline constexpr std::size_t message_count = 20;
/// Bytes of a name.
inline constexpr std::size_t name_length = 200;
/// |q| - 1 of an orientation as written; it is normalised afterwards.
inline constexpr double quaternion_error = 1e-3;
/// Cosine of the angle between axes that are meant to be perpendicular; the second is then made exactly so.
inline constexpr double perpendicular_error = 1e-3;
/// Relative violation of I1 + I2 ≥ I3 that the rounding of written numbers may cause.
inline constexpr double triangle_error = 1e-9;

}  // namespace rigor::limits
