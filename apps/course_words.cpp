#include "apps/course_words.hpp"

#include <array>

namespace rigor {

namespace {

/// Letters of a-y and digits in lower case, z as s: "Renormalization" and "re-normalisation" are one.
std::string folded(std::string_view text) {
  std::string letters;
  for (const char c : text) {
    const char lower = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    if ((lower >= 'a' && lower <= 'z') || (lower >= '0' && lower <= '9'))
      letters += lower == 'z' ? 's' : lower;
  }
  return letters;
}

}  // namespace

std::vector<std::string> names_of(const CourseWord& word) {
  std::vector<std::string> names;
  std::string_view rest = word.names;
  while (!rest.empty()) {
    const std::size_t comma = rest.find(", ");
    names.emplace_back(rest.substr(0, comma));
    rest = comma == std::string_view::npos ? std::string_view{} : rest.substr(comma + 2);
  }
  return names;
}

bool speaks_of(std::string_view text, std::string_view written) {
  const std::string sought = folded(written);
  return !sought.empty() && folded(text).find(sought) != std::string::npos;
}

std::span<const CourseWord> course_words() {  // NOLINT(readability-function-size): a table.
  static constexpr std::array words = {
      // Bodies and their motion
      CourseWord{"state vector, X(t), Y(t)", "`State`: position, quaternion, linear and angular momentum",
                 "always", "architecture.md#four-kinds-of-data"},
      CourseWord{"Euler angles, roll pitch yaw",
                 "`rpy` of a pose in the scene, taken to a quaternion; never integrated",
                 "`rpy` of a body or shape", "scene.md#how-values-are-written"},
      CourseWord{"quaternion", "the orientation of the state, 13 numbers a body",
                 "`method.orientation: quaternion`", "methods.md#motion"},
      CourseWord{"rotation matrix, Gram-Schmidt", "18 numbers a body, made orthogonal after each step",
                 "`method.orientation: matrix`", "methods.md#motion"},
      CourseWord{"renormalisation, quaternion drift",
                 "quaternions are normalised after each step; the report keeps the largest drift", "always",
                 "methods.md#motion"},
      CourseWord{"inertia tensor, principal axes, Ibody",
                 "principal moments and frame from the shapes, or `inertia` of the body",
                 "`inertia`, `density`", "methods.md#bodies"},
      CourseWord{"mass properties, divergence theorem",
                 "Mirtich's integrals over faces and edges; `rigor mass` shows them", "always",
                 "methods.md#bodies"},
      CourseWord{"point sampling, Monte Carlo", "a cross-check of mass properties with standard deviations",
                 "`rigor mass --samples`", "methods.md#bodies"},
      CourseWord{"ODE solver, Runge-Kutta, Euler's method, midpoint method", "the integrators",
                 "`method.integrator`", "methods.md#motion"},
      CourseWord{"gyroscopic torque, torque-free rotation",
                 "closed form by elliptic functions, or the integrator's", "`method.integrator: exact`",
                 "theory/free_rotation.md"},
      CourseWord{"environment forces, apply_env_forces",
                 "gravity, springs, dampers, drag, constant forces and torques", "`world`, `forces`",
                 "methods.md#motion"},
      // Collision detection
      CourseWord{"broad phase, I-COLLIDE, sweep and prune, bounding boxes",
                 "a tree of boxes or sorted lists of their ends", "`method.broad_phase`",
                 "theory/broad_phase.md"},
      CourseWord{"GJK, Minkowski difference", "distance of convex shapes with a lower and an upper bound",
                 "`method.distance: gjk`", "theory/distance.md"},
      CourseWord{"Lin-Canny, V-Clip, closest features, Voronoi region, coherence",
                 "a walk over the features of two convex polyhedra, from the last pair on",
                 "`method.distance: lin-canny`", "theory/feature_walk.md"},
      CourseWord{"DEEP, penetration depth",
                 "a climb over the faces of the difference with a proof that no other is less deep",
                 "`method.distance: lin-canny`", "theory/feature_walk.md#depth-the-climb"},
      CourseWord{"EPA, expanding polytope", "penetration of convex shapes, curved ones to the exact maximum",
                 "`method.distance: gjk`",
                 "theory/distance.md#overlapping-an-expanding-polytope-with-exact-maxima"},
      CourseWord{"RAPID, OBB tree", "a tree of oriented boxes, and triangles by exact signs", "shape `mesh`",
                 "theory/meshes.md#the-tree"},
      CourseWord{"PQP, proximity query, RSS, swept sphere",
                 "distance of two meshes by branch and bound, boxes in place of swept spheres",
                 "shape `mesh`", "theory/meshes.md"},
      CourseWord{"SWIFT++, convex surface decomposition",
                 "convex patches of a surface, or convex pieces of a solid", "`rigor convert`, shape `mesh`",
                 "theory/decomposition.md"},
      CourseWord{"convex decomposition, convex pieces",
                 "exact by cuts, or fewer pieces with a bound of what they stand out", "`rigor convert`",
                 "theory/decomposition.md"},
      CourseWord{"continuous collision detection, CCD, tunnelling",
                 "the whole span is searched, by bounds that hold for the true motion: nothing tunnels",
                 "`method.toi`", "theory/time_of_impact.md#why-no-contact-is-skipped"},
      CourseWord{"time of impact, collision time, findCollisionTime, Compute_Time_Step",
                 "the first contact of each pair, in a queue of events", "`method.toi`",
                 "theory/time_of_impact.md"},
      CourseWord{"conservative advancement", "steps that cannot miss a contact", "`method.toi: conservative`",
                 "theory/time_of_impact.md#three-refinements"},
      CourseWord{"interval arithmetic, motion bounds",
                 "bounds of second order along a direction, fixed or turning, in place of intervals",
                 "always", "theory/time_of_impact.md#a-lower-bound-of-the-gap"},
      CourseWord{"bisection", "halves the step until the pair is within the tolerance",
                 "`method.toi: bisection`", "theory/time_of_impact.md#three-refinements"},
      CourseWord{"ratio of distances, regula falsi, false position",
                 "the step is divided as the signed distances of its two ends are, by the Illinois rule",
                 "`method.toi: ratio`", "theory/time_of_impact.md#three-refinements"},
      CourseWord{"collision envelope, collision epsilon", "pairs closer than this touch",
                 "`method.contact_tolerance`", "scene.md#method"},
      CourseWord{"contact region, contact set, contact manifold",
                 "all points of the region where two bodies touch, each with its normal and gap", "always",
                 "methods.md#distance-and-contacts"},
      CourseWord{"vertex-face contact, edge-edge contact",
                 "the kinds of a point of contact; others by the separating direction", "always",
                 "methods.md#distance-and-contacts"},
      // Impacts
      CourseWord{"colliding contact, separating contact, v_rel",
                 "by the normal velocity u_n and `method.resting_velocity`", "`method.resting_velocity`",
                 "theory/events.md#colliding-resting-separating"},
      CourseWord{"impulse, collision impulse, Apply_Impulses",
                 "impacts are solved until no contact approaches", "`method.impact`", "methods.md#impacts"},
      CourseWord{"collision matrix, K matrix", "the Delassus operator A of a contact", "always",
                 "theory/impact.md#collision-coordinates"},
      CourseWord{"Newton's hypothesis, coefficient of restitution", "u_n after is -e times u_n before",
                 "`method.impact: newton`", "theory/impact.md#where-the-impact-ends"},
      CourseWord{"Poisson's hypothesis", "the impulse of restitution is e times that of compression",
                 "`method.impact: poisson`", "theory/impact.md#where-the-impact-ends"},
      CourseWord{"Stronge's hypothesis, energetic restitution",
                 "the work of restitution is -e^2 times that of compression", "`method.impact: stronge`",
                 "theory/impact.md#where-the-impact-ends"},
      CourseWord{"Chatterjee-Ruina, algebraic law, tangential restitution",
                 "one algebraic step in place of the integrated impact",
                 "`tangential_restitution` of a material", "theory/impact.md#two-other-laws"},
      CourseWord{"compression phase, restitution phase",
                 "the impact is integrated in its normal impulse; `rigor impact` draws it", "`method.impact`",
                 "theory/impact.md"},
      CourseWord{"stable sticking, diverging ray, invariant direction",
                 "slip that ends and starts again, without the quartic", "always",
                 "theory/impact.md#sticking-and-the-one-direction-that-leads-away"},
      CourseWord{"Coulomb friction, friction cone, static friction, dynamic friction",
                 "the exact cone; `static_friction` above the dynamic one in time stepping",
                 "`friction` of a material", "methods.md#lasting-contact"},
      CourseWord{"friction pyramid", "four directions in place of the cone, for comparison",
                 "`method.cone: pyramid`", "methods.md#time-stepping"},
      CourseWord{"simultaneous impacts, multiple collisions, Newton's cradle",
                 "one law for all impacts of an instant", "`method.simultaneous`",
                 "theory/simultaneous_impacts.md"},
      CourseWord{"generalised reflections",
                 "velocities are reflected about what approaches until nothing does",
                 "`method.simultaneous: reflections`", "theory/simultaneous_impacts.md#reflections"},
      CourseWord{"projection on velocities, velocity-level projection",
                 "the nearest velocities that the contacts allow; Newton's restitution at each contact can "
                 "add energy",
                 "`method.simultaneous: projection`", "theory/simultaneous_impacts.md#projection-and-moreau"},
      CourseWord{"energy-consistent restitution, Moreau's law",
                 "the projection, passed beyond by e: the energy never grows",
                 "`method.simultaneous: moreau`", "theory/simultaneous_impacts.md#projection-and-moreau"},
      CourseWord{
          "velocity-level LCP, energy gain, gain of energy",
          "Newton's law on all contacts in one complementarity problem; can add energy: 1.27368 times as "
          "much in a scene",
          "`method.simultaneous: lcp`, `scenes/energy_gain.yaml`",
          "theory/simultaneous_impacts.md#lcp-newtons-law-on-all-contacts-at-once"},
      CourseWord{"impact without collision, Painleve's paradox",
                 "no finite force exists: resolved by an impulse, and reported", "always",
                 "theory/resting.md#painlevés-paradox"},
      // Contact that lasts
      CourseWord{"penalty method", "contacts are springs and dampers, not impulses",
                 "`method.scheme: penalty`", "theory/penalty.md"},
      CourseWord{
          "local penalty method",
          "`penalty: local`, a spring at each contact by itself in sub-steps; the course's local method "
          "applies impulses pair by pair, which is the scheme impulse-based",
          "`method.penalty: local`, `method.scheme: impulse-based`",
          "theory/penalty.md#the-courses-local-method"},
      CourseWord{"global penalty method", "all springs of a step in one implicit system",
                 "`method.penalty: global`", "theory/penalty.md#all-springs-together-penalty-global"},
      CourseWord{"impulse-based simulation", "every contact is a train of collisions",
                 "`method.scheme: impulse-based`", "theory/impulse_based.md"},
      CourseWord{"micro-collisions, creep",
                 "patched so that nothing creeps down a slope, or plain so that it does",
                 "`method.micro_collisions`, `scenes/ramp_creep.yaml`",
                 "theory/impulse_based.md#what-it-does-well-and-what-it-does-not"},
      CourseWord{"hybrid simulation", "impulses for brief contacts, constraints for lasting ones",
                 "`method.scheme: hybrid`", "theory/hybrid.md"},
      CourseWord{"constraint-based method, analytical method, non-penetration constraint",
                 "contact forces from constraints, from event to event", "`method.scheme: event-driven`",
                 "theory/resting.md"},
      CourseWord{"time stepping", "velocities and impulses of a step from one problem",
                 "`method.scheme: time-stepping`", "theory/time_stepping.md"},
      CourseWord{"resting contact, contact forces",
                 "forces and accelerations by Coulomb's law at acceleration level", "`method.resting`",
                 "theory/resting.md"},
      CourseWord{"contact space, LCP, linear complementarity problem", "forces f with a = A f + b",
                 "`method.resting: contact-space`", "theory/resting.md#the-two-questions"},
      CourseWord{"Dantzig's algorithm, driveToZero, fdirection", "Baraff's pivots", "`method.lcp: dantzig`",
                 "theory/resting.md"},
      CourseWord{"Lemke's algorithm", "complementary pivots with a covering vector", "`method.lcp: lemke`",
                 "theory/resting.md"},
      CourseWord{"motion space, Gauss' principle of least constraint, Wilhelmsen's algorithm",
                 "nearest accelerations, by the active sets of Goldfarb and Idnani",
                 "`method.resting: motion-space`", "theory/resting.md#the-two-questions"},
      CourseWord{"bilateral constraint, equality constraint, Lagrange multipliers",
                 "joints, solved together with the contacts", "`joints`", "theory/joints.md"},
      CourseWord{"constraint drift, Baumgarte stabilisation",
                 "positions are put back on the joints after each step, without springs", "always",
                 "methods.md#joints"},
      CourseWord{"articulated bodies, multibody, linear-time Lagrange multipliers",
                 "elimination along the trees of joints", "`joints`", "theory/constrained_mass.md"},
      CourseWord{"Zeno, series of bounces, inelastic collapse",
                 "slow bounces under a pressing force end at once, with the momentum of the series",
                 "`method.resting_velocity`", "theory/events.md#the-end-of-a-series-of-bounces"},
      CourseWord{"event queue, heap, priority queue",
                 "contacts, ends of windows and steps in the order of their times", "always",
                 "architecture.md#the-loop"},
      CourseWord{
          "platter, turntable",
          "scenes of a ball that rolls on a turning disk: closed circles, and with rolling friction spirals",
          "`scenes/turntable.yaml`, `scenes/platter.yaml`", "methods.md#lasting-contact"},
      CourseWord{"rolling friction", "moments that resist rolling and spinning",
                 "`rolling_friction`, `torsional_friction`", "scene.md#material"},
  };
  return words;
}

}  // namespace rigor
