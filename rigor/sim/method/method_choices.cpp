#include "rigor/sim/method/method.hpp"

#include <array>

namespace rigor {

std::span<const MethodChoice> method_choices() {
  // Within a key, in the order of the enumerators.
  static constexpr std::array choices = {
      MethodChoice{"scheme", "event-driven", "goes from event to event; every impact at its own time",
                   "Baraff, Analytical Methods for Dynamic Simulation of Non-penetrating Rigid Bodies, 1989",
                   true},
      MethodChoice{"scheme", "time-stepping", "fixed steps, velocities and impulses solved together",
                   "Stewart and Trinkle, An Implicit Time-Stepping Scheme for Rigid Body Dynamics, 1996",
                   true},
      MethodChoice{"scheme", "penalty", "contacts are stiff springs and dampers",
                   "Moore and Wilhelms, Collision Detection and Response for Computer Animation, 1988", true},
      MethodChoice{"scheme", "impulse-based", "every contact is a train of small impacts",
                   "Mirtich, Impulse-based Dynamic Simulation of Rigid Body Systems, 1996", true},
      MethodChoice{"scheme", "hybrid", "constraints for lasting contacts, impulses for brief ones",
                   "Mirtich, Hybrid Simulation: Combining Constraints and Impulses, 1995", true},
      MethodChoice{"scheme", "auto", "the one that suits the scene; the audit says which and why",
                   "the table of docs/choosing.md", true},

      MethodChoice{
          "integrator", "exact", "ballistic arcs and torque-free rotation in closed form",
          "van Zon and Schofield, Numerical Implementation of the Exact Dynamics of Free Rigid Bodies, 2007",
          true},
      MethodChoice{"integrator", "euler", "explicit Euler, order 1",
                   "Hairer, Norsett and Wanner, Solving Ordinary Differential Equations I, 1993", true},
      MethodChoice{"integrator", "semi-implicit-euler", "symplectic Euler, order 1",
                   "Hairer, Lubich and Wanner, Geometric Numerical Integration, 2006", true},
      MethodChoice{"integrator", "midpoint", "explicit midpoint rule, order 2",
                   "Hairer, Norsett and Wanner, Solving Ordinary Differential Equations I, 1993", true},
      MethodChoice{"integrator", "rk4", "classical Runge-Kutta, order 4",
                   "Hairer, Norsett and Wanner, Solving Ordinary Differential Equations I, 1993", true},
      MethodChoice{"integrator", "dopri5", "embedded Runge-Kutta 5(4) with step control",
                   "Dormand and Prince, A Family of Embedded Runge-Kutta Formulae, 1980", true},
      MethodChoice{"integrator", "dop853", "embedded Runge-Kutta 8(5,3) with step control",
                   "Hairer, Norsett and Wanner, Solving Ordinary Differential Equations I, 1993", true},
      MethodChoice{"integrator", "lie-rk4", "Runge-Kutta of order 4 on the rotation group",
                   "Munthe-Kaas, High Order Runge-Kutta Methods on Manifolds, 1999", true},

      MethodChoice{"orientation", "quaternion", "13 numbers a body",
                   "Baraff, An Introduction to Physically Based Modeling: Rigid Body Simulation, 1997", true},
      MethodChoice{"orientation", "matrix", "18 numbers a body, Gram-Schmidt after each step",
                   "Baraff, An Introduction to Physically Based Modeling: Rigid Body Simulation, 1997", true},

      MethodChoice{"broad_phase", "tree", "boxes of the bodies in a dynamic tree",
                   "Goldsmith and Salmon, Automatic Creation of Object Hierarchies for Ray Tracing, 1987",
                   true},
      MethodChoice{"broad_phase", "sweep-and-prune", "ends of the boxes in sorted lists",
                   "Cohen, Lin, Manocha and Ponamgi, I-COLLIDE: An Interactive and Exact Collision Detection "
                   "System, 1995",
                   true},

      MethodChoice{"distance", "gjk", "support points and simplices, with bounds",
                   "Gilbert, Johnson and Keerthi, A Fast Procedure for Computing the Distance Between "
                   "Complex Objects, "
                   "1988",
                   true},
      MethodChoice{"distance", "lin-canny", "walk over the features of convex polyhedra",
                   "Lin and Canny, A Fast Algorithm for Incremental Distance Calculation, 1991", true},

      MethodChoice{"toi", "conservative", "steps that cannot miss a contact, from distance and speed bounds",
                   "Mirtich, Impulse-based Dynamic Simulation of Rigid Body Systems, 1996", true},
      MethodChoice{"toi", "ratio", "regula falsi between the signed distances of two times",
                   "Dowell and Jarratt, A Modified Regula Falsi Method, 1971", true},
      MethodChoice{"toi", "bisection", "halves the step until the pair is within the tolerance",
                   "Baraff, An Introduction to Physically Based Modeling: Rigid Body Simulation, 1997", true},

      MethodChoice{"impact", "newton", "relative normal velocity after is -e times before",
                   "Newton, Philosophiae Naturalis Principia Mathematica, 1687", true},
      MethodChoice{"impact", "poisson", "impulse of restitution is e times that of compression",
                   "Routh, Dynamics of a System of Rigid Bodies, 1905", true},
      MethodChoice{"impact", "stronge", "work of restitution is -e^2 times that of compression",
                   "Stronge, Rigid Body Collisions with Friction, 1990", true},

      MethodChoice{"simultaneous", "reflections", "repeated reflections until nothing approaches",
                   "Smith, Kaufman, Vouga, Tamstorf and Grinspun, Reflections on Simultaneous Impact, 2012",
                   true},
      MethodChoice{"simultaneous", "lcp", "all impacts of an instant in one complementarity problem",
                   "Glocker and Pfeiffer, Multiple Impacts with Friction in Rigid Multibody Systems, 1995",
                   true},
      MethodChoice{"simultaneous", "sequential", "one impact after the other, the fastest first",
                   "Hahn, Realistic Animation of Rigid Bodies, 1988", true},
      MethodChoice{"simultaneous", "projection",
                   "nearest admissible velocities, Newton's -e u_n at each contact; can gain energy",
                   "Redon, Kheddar and Coquillart, Gauss' Least Constraints Principle and Rigid Body "
                   "Simulations, 2002",
                   true},
      MethodChoice{"simultaneous", "moreau",
                   "projection on velocities, passed beyond by e; the energy never grows",
                   "Moreau, Unilateral Contact and Dry Friction in Finite Freedom Dynamics, 1988", true},

      MethodChoice{"resting", "contact-space", "contact forces from a complementarity problem",
                   "Baraff, Fast Contact Force Computation for Nonpenetrating Rigid Bodies, 1994", true},
      MethodChoice{"resting", "motion-space", "nearest admissible accelerations (Gauss)",
                   "Redon, Kheddar and Coquillart, Gauss' Least Constraints Principle and Rigid Body "
                   "Simulations, 2002",
                   true},

      MethodChoice{"lcp", "dantzig", "pivots that keep solved contacts solved",
                   "Baraff, Fast Contact Force Computation for Nonpenetrating Rigid Bodies, 1994", true},
      MethodChoice{"lcp", "lemke", "complementary pivots with a covering vector",
                   "Lemke, Bimatrix Equilibrium Points and Mathematical Programming, 1965", true},

      MethodChoice{"micro_collisions", "patched", "slow ones reverse the velocity: nothing creeps on slopes",
                   "Mirtich, Impulse-based Dynamic Simulation of Rigid Body Systems, 1996", true},
      MethodChoice{"micro_collisions", "plain", "all by the law of impact: what rests on a slope creeps",
                   "Mirtich and Canny, Impulse-based Simulation of Rigid Bodies, 1995", true},

      MethodChoice{"penalty", "local", "a spring and a damper at each contact by itself, in sub-steps",
                   "Moore and Wilhelms, Collision Detection and Response for Computer Animation, 1988", true},
      MethodChoice{"penalty", "global", "all springs solved together, implicitly",
                   "Moore and Wilhelms, Collision Detection and Response for Computer Animation, 1988", true},

      MethodChoice{"penalty_law", "linear", "force in proportion to depth and its rate",
                   "Moore and Wilhelms, Collision Detection and Response for Computer Animation, 1988", true},
      MethodChoice{
          "penalty_law", "hunt-crossley", "force as of two balls, damped in proportion to it",
          "Hunt and Crossley, Coefficient of Restitution Interpreted as Damping in Vibroimpact, 1975", true},

      MethodChoice{"solver", "exact", "exact Coulomb cone", "De Saxce and Feng, The Bipotential Method, 1998",
                   true},
      MethodChoice{
          "solver", "pgs", "projected Gauss-Seidel",
          "Jourdan, Alart and Jean, A Gauss-Seidel Like Algorithm to Solve Frictional Contact Problems, 1998",
          true},
      MethodChoice{"solver", "substep", "many small steps of one iteration",
                   "Macklin et al., Small Steps in Physics Simulation, 2019", true},

      MethodChoice{"cone", "exact", "Coulomb's cone, friction against the slip",
                   "De Saxce and Feng, The Bipotential Method, 1998", true},
      MethodChoice{"cone", "convex", "a convex problem; what slides lifts off by h mu |u_t|",
                   "Anitescu, Optimization-based Simulation of Nonsmooth Rigid Multibody Dynamics, 2006",
                   true},
      MethodChoice{"cone", "pyramid", "friction in the directions of a frame, wrong in between",
                   "Stewart and Trinkle, An Implicit Time-Stepping Scheme for Rigid Body Dynamics, 1996",
                   true},

      MethodChoice{"sleeping", "false", "solver substep moves all bodies in every step",
                   "docs/theory/bulk.md, section 7", true},
      MethodChoice{"sleeping", "true",
                   "groups of bodies that have come to rest are left alone until disturbed",
                   "docs/theory/bulk.md, section 7", true},
  };
  return choices;
}

}  // namespace rigor
