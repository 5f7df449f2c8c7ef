#include "rigor/sim/method/toi_choice.hpp"

#include "rigor/sim/method/method.hpp"
#include "rigor/sim/method/tolerances.hpp"

namespace rigor {

ToiOptions toi_choice(const Method& method) {
  ToiOptions options;
  options.refinement = method.toi == ToiMethod::ratio       ? ToiRefinement::ratio
                       : method.toi == ToiMethod::bisection ? ToiRefinement::bisection
                                                            : ToiRefinement::conservative;
  options.distance = method.distance == DistanceMethod::lin_canny ? ToiDistance::lin_canny : ToiDistance::gjk;
  options.contact_tolerance = method.contact_tolerance;
  options.time_tolerance = method.time_tolerance;
  options.rest_velocity = still_speed(method.resting_velocity);
  return options;
}

}  // namespace rigor
