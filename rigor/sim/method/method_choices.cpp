#include "rigor/sim/method/method.hpp"

#include <array>
#include <vector>

namespace rigor {

namespace {

/// All but the laws of impact, which have tables of their own.
std::span<const MethodChoice> own_choices() {  // NOLINT(readability-function-size): a table.
  // Within a key, in the order of the enumerators.
  static constexpr std::array choices = {
      MethodChoice{"scheme", "event-driven", "advances from event to event; every impact at its own time",
                   "Baraff, Analytical Methods for Dynamic Simulation of Non-penetrating Rigid Bodies, 1989"},
      MethodChoice{"scheme", "time-stepping", "fixed steps, velocities and impulses solved together",
                   "Stewart and Trinkle, An Implicit Time-Stepping Scheme for Rigid Body Dynamics, 1996"},
      MethodChoice{"scheme", "penalty", "contacts are stiff springs and dampers",
                   "Moore and Wilhelms, Collision Detection and Response for Computer Animation, 1988"},
      MethodChoice{"scheme", "impulse-based", "every contact is a train of small impacts",
                   "Mirtich, Impulse-based Dynamic Simulation of Rigid Body Systems, 1996"},
      MethodChoice{"scheme", "hybrid", "constraints for lasting contacts, impulses for brief ones",
                   "Mirtich, Hybrid Simulation: Combining Constraints and Impulses, 1995"},
      MethodChoice{"scheme", "auto", "the one that suits the scene; the audit says which and why",
                   "the table of docs/choosing.md"},

      MethodChoice{
          "integrator", "exact", "ballistic arcs and torque-free rotation in closed form",
          "van Zon and Schofield, Numerical Implementation of the Exact Dynamics of Free Rigid Bodies, 2007"},
      MethodChoice{"integrator", "euler", "explicit Euler, order 1",
                   "Hairer, Norsett and Wanner, Solving Ordinary Differential Equations I, 1993"},
      MethodChoice{"integrator", "semi-implicit-euler", "symplectic Euler, order 1",
                   "Hairer, Lubich and Wanner, Geometric Numerical Integration, 2006"},
      MethodChoice{"integrator", "midpoint", "explicit midpoint rule, order 2",
                   "Hairer, Norsett and Wanner, Solving Ordinary Differential Equations I, 1993"},
      MethodChoice{"integrator", "rk4", "classical Runge-Kutta, order 4",
                   "Hairer, Norsett and Wanner, Solving Ordinary Differential Equations I, 1993"},
      MethodChoice{"integrator", "dopri5", "embedded Runge-Kutta 5(4) with step control",
                   "Dormand and Prince, A Family of Embedded Runge-Kutta Formulae, 1980"},
      MethodChoice{"integrator", "dop853", "embedded Runge-Kutta 8(5,3) with step control",
                   "Hairer, Norsett and Wanner, Solving Ordinary Differential Equations I, 1993"},
      MethodChoice{"integrator", "lie-rk4", "Runge-Kutta of order 4 on the rotation group",
                   "Munthe-Kaas, High Order Runge-Kutta Methods on Manifolds, 1999"},

      MethodChoice{"orientation", "quaternion", "13 numbers per body",
                   "Baraff, An Introduction to Physically Based Modeling: Rigid Body Simulation, 1997"},
      MethodChoice{"orientation", "matrix", "18 numbers per body, Gram-Schmidt after each step",
                   "Baraff, An Introduction to Physically Based Modeling: Rigid Body Simulation, 1997"},

      MethodChoice{"broad_phase", "tree", "boxes of the bodies in a dynamic tree",
                   "Goldsmith and Salmon, Automatic Creation of Object Hierarchies for Ray Tracing, 1987"},
      MethodChoice{"broad_phase", "sweep-and-prune", "endpoints of the boxes in sorted lists",
                   "Cohen, Lin, Manocha and Ponamgi, I-COLLIDE: An Interactive and Exact Collision Detection "
                   "System, 1995"},

      MethodChoice{"distance", "gjk", "support points and simplices, with bounds",
                   "Gilbert, Johnson and Keerthi, A Fast Procedure for Computing the Distance Between "
                   "Complex Objects, "
                   "1988"},
      MethodChoice{"distance", "lin-canny", "walk over the features of convex polyhedra",
                   "Lin and Canny, A Fast Algorithm for Incremental Distance Calculation, 1991"},

      MethodChoice{"toi", "conservative", "steps that cannot miss a contact, from distance and speed bounds",
                   "Mirtich, Impulse-based Dynamic Simulation of Rigid Body Systems, 1996"},
      MethodChoice{"toi", "ratio", "regula falsi between the signed distances of two times",
                   "Dowell and Jarratt, A Modified Regula Falsi Method, 1971"},
      MethodChoice{"toi", "bisection", "halves the step until the pair is within the tolerance",
                   "Baraff, An Introduction to Physically Based Modeling: Rigid Body Simulation, 1997"},

      MethodChoice{"resting", "contact-space", "contact forces from a complementarity problem",
                   "Baraff, Fast Contact Force Computation for Nonpenetrating Rigid Bodies, 1994"},
      MethodChoice{"resting", "motion-space", "nearest admissible accelerations (Gauss)",
                   "Redon, Kheddar and Coquillart, Gauss' Least Constraints Principle and Rigid Body "
                   "Simulations, 2002"},

      MethodChoice{"lcp", "dantzig", "pivots that keep solved contacts solved",
                   "Baraff, Fast Contact Force Computation for Nonpenetrating Rigid Bodies, 1994"},
      MethodChoice{"lcp", "lemke", "complementary pivots with a covering vector",
                   "Lemke, Bimatrix Equilibrium Points and Mathematical Programming, 1965"},

      MethodChoice{"micro_collisions", "patched", "slow ones reverse the velocity: nothing creeps on slopes",
                   "Mirtich, Impulse-based Dynamic Simulation of Rigid Body Systems, 1996"},
      MethodChoice{"micro_collisions", "plain", "all by the law of impact: what rests on a slope creeps",
                   "Mirtich and Canny, Impulse-based Simulation of Rigid Bodies, 1995"},

      MethodChoice{"penalty", "local", "a spring and a damper at each contact by itself, in sub-steps",
                   "Moore and Wilhelms, Collision Detection and Response for Computer Animation, 1988"},
      MethodChoice{"penalty", "global", "all springs solved together, implicitly",
                   "Moore and Wilhelms, Collision Detection and Response for Computer Animation, 1988"},

      MethodChoice{"penalty_law", "linear", "force in proportion to depth and its rate",
                   "Moore and Wilhelms, Collision Detection and Response for Computer Animation, 1988"},
      MethodChoice{
          "penalty_law", "hunt-crossley", "Hertzian force, damped in proportion to it",
          "Hunt and Crossley, Coefficient of Restitution Interpreted as Damping in Vibroimpact, 1975"},

      MethodChoice{"solver", "exact", "exact Coulomb cone",
                   "De Saxce and Feng, The Bipotential Method, 1998"},
      MethodChoice{"solver", "pgs", "projected Gauss-Seidel",
                   "Jourdan, Alart and Jean, A Gauss-Seidel Like Algorithm to Solve Frictional Contact "
                   "Problems, 1998"},
      MethodChoice{"solver", "substep", "many small steps of one iteration",
                   "Macklin et al., Small Steps in Physics Simulation, 2019"},

      MethodChoice{"cone", "exact", "Coulomb's cone, friction opposite to the slip",
                   "De Saxce and Feng, The Bipotential Method, 1998"},
      MethodChoice{"cone", "convex", "a convex problem; sliding contacts separate by h mu |u_t|",
                   "Anitescu, Optimization-based Simulation of Nonsmooth Rigid Multibody Dynamics, 2006"},
      MethodChoice{"cone", "pyramid", "friction in the directions of a frame, wrong in between",
                   "Stewart and Trinkle, An Implicit Time-Stepping Scheme for Rigid Body Dynamics, 1996"},

      MethodChoice{"last_resort", "substep", "auto goes on by solver substep where exact steps take too long",
                   "docs/theory/handover.md"},
      MethodChoice{"last_resort", "none", "auto goes on by exact steps, however long they take",
                   "docs/theory/handover.md"},

      MethodChoice{"sleeping", "false", "solver substep moves all bodies in every step",
                   "docs/theory/bulk.md, section 7"},
      MethodChoice{"sleeping", "true",
                   "groups of bodies that have come to rest are left alone until disturbed",
                   "docs/theory/bulk.md, section 7"},
  };
  return choices;
}

template <typename Rule>
void add_rules(std::string_view key, std::span<const Rule> rules, std::vector<MethodChoice>& choices) {
  for (const Rule& rule : rules) choices.push_back({key, rule.name, rule.meaning, rule.source});
}

std::vector<MethodChoice> all_choices() {
  std::vector<MethodChoice> choices;
  for (const MethodChoice& choice : own_choices()) {
    // The laws of impact stand before the choices of resting contact.
    if (choice.key == "resting" && choices.back().key != "resting") {
      add_rules("impact", restitution_rules(), choices);
      add_rules("simultaneous", simultaneous_rules(), choices);
    }
    choices.push_back(choice);
  }
  return choices;
}

}  // namespace

std::span<const MethodChoice> method_choices() {
  static const std::vector<MethodChoice> choices = all_choices();
  return choices;
}

}  // namespace rigor
