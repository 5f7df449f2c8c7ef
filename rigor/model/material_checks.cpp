#include "rigor/model/material_checks.hpp"

#include "rigor/core/quoted.hpp"
#include "rigor/model/limits.hpp"

namespace rigor {

namespace {

/// What materials and pairs have in common.
template <class Coefficients>
void check_surface(const Coefficients& surface, Findings& findings) {
  findings.check("friction", surface.friction, limits::friction, "");
  findings.check("restitution", surface.restitution, limits::restitution, "");
  findings.check("tangential_restitution", surface.tangential_restitution, limits::restitution, "");
  findings.check("rolling_friction", surface.rolling_friction, limits::length, "m");
  findings.check("torsional_friction", surface.torsional_friction, limits::length, "m");
  if (!surface.static_friction) return;
  findings.check("static_friction", *surface.static_friction, limits::friction, "");
  findings.require(!(*surface.static_friction < surface.friction),
                   "static_friction is " + number_text(*surface.static_friction) +
                       ", must be at least friction, " + number_text(surface.friction));
}

}  // namespace

void check_material(const Material& material, Findings& findings) {
  findings.check_name(material.name);
  findings.check("density", material.density, limits::density, "kg/m³");
  check_surface(material, findings);
}

void check_coefficients(const PairCoefficients& pair, Findings& findings) {
  check_surface(pair, findings);
}

}  // namespace rigor
