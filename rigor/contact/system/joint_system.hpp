#pragma once

#include "rigor/contact/system/contact.hpp"
#include "rigor/dynamics/joint_rows.hpp"
#include "rigor/solver/linear/constrained_mass.hpp"

#include <optional>
#include <utility>
#include <vector>

namespace rigor {

/// For each body of the model the joints, ascending, that hold it; gears hold the bodies of both their
/// joints.
std::vector<std::vector<int>> joints_by_body(const Model& model);

/// Position and velocity of a joint's body: the world, or one of a list (ascending model indices).
BodyMotion motion_of(int body, const std::vector<int>& bodies, const std::vector<BodyKinetics>& kinetics);

/// The joints among a list of bodies at an instant, with their equations G V = rate solved in the metric of
/// the mass matrix. Rows are those of the joints, in order, each followed by those of its motors without a
/// limit of force.
class JointSystem {
 public:
  /// Which of the redundant rows count; a choice made once holds all through a step of an integrator.
  using RowChoice = ConstrainedMass::RowChoice;

  /// How rows are made.
  struct RowRules {
    const RowChoice* choice = nullptr;  ///< Without it the rows are chosen here.
    /// Motors without a limit of force run no faster than to be at the limit of their coordinate after this
    /// time [s], and stand there: the limit is as strong as they are.
    double motor_horizon = 0;
    bool without_motors = false;  ///< Those motors hold nothing: their rows are empty.
  };

  /// `joints` by model index; `bodies` must hold all their bodies but the world.
  JointSystem(const Model& model, std::vector<int> joints, const std::vector<int>& bodies,
              const std::vector<BodyKinetics>& kinetics, const RowRules& rules);
  JointSystem(const Model& model, std::vector<int> joints, const std::vector<int>& bodies,
              const std::vector<BodyKinetics>& kinetics)
      : JointSystem(model, std::move(joints), bodies, kinetics, RowRules{}) {}

  /// The same joints at another instant; `bodies` may be another list that holds all their bodies. What was
  /// factored at the same poses and with the same choice of rows is kept.
  void update(const Model& model, const std::vector<int>& bodies, const std::vector<BodyKinetics>& kinetics,
              const RowRules& rules);
  /// The next update() factors, also at the same poses.
  void forget_factors() { solver_->forget(); }

  const std::vector<int>& joints() const { return joints_; }
  const RowChoice& choice() const { return solver_->choice(); }
  /// Whether the i-th body of the list is dynamic and held by a joint.
  bool holds(std::size_t body) const { return node_of_[body] >= 0; }
  /// The places of the held bodies in the list.
  const std::vector<std::size_t>& held_bodies() const { return bodies_of_nodes_; }

  /// The equations on the held bodies.
  const ConstrainedMass& equations() const { return *solver_; }

  /// Residuals g of the positions [m or none]; zero for motors.
  const VecX& residuals() const { return residuals_; }
  /// G V - rate [m/s or 1/s].
  const VecX& rate_errors() const { return rate_errors_; }
  /// Part of G V̇ + bias that does not depend on accelerations.
  const VecX& biases() const { return biases_; }
  /// Largest |g| of the i-th joint.
  double residual(std::size_t i) const;
  /// Largest |g| and the joint that has it.
  std::pair<double, int> largest_residual() const;

  /// Largest |G a + bias| under these accelerations, one per body of the list, and the joint that has it:
  /// rows that followed from others may contradict them where bodies move.
  std::pair<double, int> largest_contradiction(const std::vector<Vec6>& a) const;

  /// What held bodies do under wrenches (or impulses): M a = f + Gᵀ λ, G a = c.
  struct Response {
    std::vector<Vec6> a;  ///< One per body of the list; zero if it is not held.
    VecX lambda;          ///< Forces (impulses) of the rows.
  };
  Response respond(const std::vector<Vec6>& f, const VecX& c) const;
  /// Accelerations of the held bodies, 6 per body in the order of held_bodies(), for many wrenches at c = 0:
  /// one column each.
  MatX respond(const MatX& f) const;

  /// Wrench of the rows' forces λ on each body of the list, prescribed ones too: Gᵀ λ.
  std::vector<Vec6> wrenches(const VecX& lambda) const;
  /// The part that prescribed bodies and the world exert on held bodies, not these on each other.
  std::vector<Vec6> external_wrenches(const VecX& lambda) const;
  /// The forces of least norm that make the same wrenches: where redundant joints hold, others would do as
  /// well. Torques count as forces at the arm `length` [m].
  VecX least_norm(const VecX& lambda, double length) const;
  /// Forces of one joint's rows (without motors) as the wrench on body B about the joint's anchor on B [N],
  /// [N m].
  Wrench reaction(std::size_t joint, const VecX& lambda) const;
  /// Whether motors without a limit have rows.
  bool has_motors() const;
  /// Forces of the joint's motors without a limit, in the order of its coordinates [N] or [N m].
  std::vector<double> motor_forces(std::size_t joint, const VecX& lambda) const;
  /// What prescribed bodies supply through the rows: -λ · (rate of prescribed bodies) [W].
  double power_of_prescribed(const VecX& lambda) const;
  /// What motors supply: λ · (rate of their coordinates), where G V - rate is `rate_errors` [W].
  double power_of_motors(const VecX& lambda, const VecX& rate_errors) const;

 private:
  struct Item {
    JointRows rows;             ///< With the rows of motors.
    int own = 0;                ///< Rows of the joint itself.
    Vec6 rate = Vec6::Zero();   ///< Wanted; not zero for motors only.
    int first = 0;              ///< Its first row in the stacked vectors.
    bool is_grounded = false;   ///< Whether the world or a prescribed body is part of it.
    std::array<int, 4> ends{};  ///< Places of A and B of the joint, or of both joints of a gear; -1: world.
    int end_count = 2;
    std::array<std::size_t, JointRows::most_sides> places{};  ///< Of its bodies in the list.
    Vec3 arm = Vec3::Zero();  ///< From the centre of B (of A if B is the world) to the anchor.
    int side_B = -1;
  };
  /// Takes over how the bodies move; whether anything is new.
  bool take_motions(const std::vector<BodyKinetics>& kinetics);
  void make_rows(const Model& model, int joint, Item& item) const;
  void find_ends(const Model& model);
  void find_nodes(const std::vector<BodyKinetics>& kinetics);
  void make_solver();
  void stack();
  /// Adds Gᵀ λ of one joint's rows.
  static void add_wrenches(const Item& item, const VecX& lambda, std::vector<Vec6>& wrenches);
  void factor(const std::vector<BodyKinetics>& kinetics, const RowChoice* choice);

  std::vector<int> joints_, bodies_;
  double motor_horizon_ = 0;
  bool without_motors_ = false;
  std::vector<Item> items_;
  std::vector<int> node_of_;  ///< Of each body of the list; -1: not held or prescribed.
  std::vector<std::size_t> bodies_of_nodes_;
  std::vector<BodyMotion> motions_;  ///< Of each body of the list.
  std::vector<Vec6> velocities_;     ///< Of each body of the list.
  std::optional<ConstrainedMass> solver_;
  std::vector<Mat6> masses_;  ///< Of the nodes.
  std::vector<Mat6> rows_;    ///< Of the joints that have any, a block for each of their nodes.
  VecX residuals_, rate_errors_, biases_;
};

}  // namespace rigor
