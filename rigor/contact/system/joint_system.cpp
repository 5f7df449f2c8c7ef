#include "rigor/contact/system/joint_system.hpp"

#include "rigor/core/assert.hpp"
#include "rigor/core/index.hpp"
#include "rigor/core/sorted_unique.hpp"
#include "rigor/solver/linear/least_norm.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <utility>

namespace rigor {

namespace {

/// Where the body stands in the system, which has it.
std::size_t place_in_system(const std::vector<int>& bodies, int body) {
  RIGOR_ASSERT(holds(bodies, body));
  return place_of(bodies, body);
}

/// Place of a body among the sides of the rows, which get one more where it has none.
std::size_t side_of(JointRows& rows, int body) {
  const auto begin = rows.bodies.begin(), end = begin + rows.side_count;
  const auto found = std::find(begin, end, body);
  if (found != end) return at(found - begin);
  const std::size_t side = at(rows.side_count++);
  rows.bodies[side] = body;
  rows.J[side].setZero();
  return side;
}

/// The joint itself, or those that a gear ties.
std::vector<const Joint*> sources_of(const Model& model, int index) {
  const Joint& joint = model.joint(index);
  if (joint.type != JointType::gear) return {&joint};
  return {&model.joint(joint.first_joint), &model.joint(joint.second_joint)};
}

/// The rate that a motor without a limit of force holds at a value of its coordinate: its velocity, unless
/// that would take the coordinate beyond a limit within the horizon. A motor that stands at its limit, as
/// near as joints are held, stays there.
double motor_rate(const JointAxis& axis, double value, double length, double horizon) {
  constexpr double resolution = 1e-9;
  const double nearest = resolution * std::max(1.0, length), velocity = axis.motor->velocity;
  const double room = velocity < 0 ? value - axis.lower : axis.upper - value;
  if (std::isinf(room) || velocity == 0) return velocity;
  if (horizon > 0) return std::copysign(1.0, velocity) * std::min(std::abs(velocity), room / horizon);
  return room <= nearest ? 0 : velocity;
}

Mat6 mass_matrix(const BodyKinetics& body) {
  Mat6 M = Mat6::Zero();
  M.topLeftCorner<3, 3>().diagonal().setConstant(1 / body.inverse_mass);
  M.bottomRightCorner<3, 3>() = body.inertia;
  return M;
}

}  // namespace

std::vector<std::vector<int>> joints_by_body(const Model& model) {
  std::vector<std::vector<int>> result(at(model.body_count()));
  for (int j = 0; j < static_cast<int>(model.joints().size()); ++j) {
    for (const int body : model.bodies_of_joint(j)) result[at(body)].push_back(j);
  }
  return result;
}

BodyMotion motion_of(int body, const std::vector<int>& bodies, const std::vector<BodyKinetics>& kinetics) {
  if (body == world_body) return {};
  const BodyKinetics& of_body = kinetics[place_in_system(bodies, body)];
  return {of_body.x, of_body.R, of_body.v, of_body.w};
}

JointSystem::JointSystem(const Model& model, std::vector<int> joints, const std::vector<int>& bodies,
                         const std::vector<BodyKinetics>& kinetics, const RowRules& rules)
    : joints_(std::move(joints)), items_(joints_.size()) {
  update(model, bodies, kinetics, rules);
}

void JointSystem::update(const Model& model, const std::vector<int>& bodies,
                         const std::vector<BodyKinetics>& kinetics, const RowRules& rules) {
  // Which bodies there are and how they move. Often only the choice of rows is new.
  const bool is_another_list = bodies != bodies_;
  if (is_another_list) {
    bodies_ = bodies;
    find_ends(model);
  }
  const bool has_moved = take_motions(kinetics);
  const bool has_other_rules =
      rules.motor_horizon != motor_horizon_ || rules.without_motors != without_motors_;
  if (solver_ && !is_another_list && !has_moved && !has_other_rules) {
    solver_->factor(masses_, rows_, rules.choice);
    return;
  }

  // The rows of each joint; which bodies they tie and which blocks of G M⁻¹ Gᵀ that makes stays.
  motor_horizon_ = rules.motor_horizon;
  without_motors_ = rules.without_motors;
  for (std::size_t i = 0; i < items_.size(); ++i) make_rows(model, joints_[i], items_[i]);
  if (is_another_list) find_nodes(kinetics);
  if (!solver_) make_solver();

  // Their numbers at this instant.
  stack();
  factor(kinetics, rules.choice);
}

bool JointSystem::take_motions(const std::vector<BodyKinetics>& kinetics) {
  static_assert(sizeof(BodyMotion) == 18 * sizeof(double));
  bool is_new = motions_.size() != kinetics.size();
  motions_.resize(kinetics.size());
  velocities_.resize(kinetics.size());
  for (std::size_t b = 0; b < kinetics.size(); ++b) {
    const BodyMotion now{kinetics[b].x, kinetics[b].R, kinetics[b].v, kinetics[b].w};
    // Bit for bit: a zero of the other sign is another number.
    // NOLINTNEXTLINE(bugprone-suspicious-memory-comparison)
    if (!is_new && std::memcmp(&now, &motions_[b], sizeof(BodyMotion)) == 0) continue;
    is_new = true;
    motions_[b] = now;
    velocities_[b] << now.v, now.w;
  }
  return is_new;
}

void JointSystem::find_ends(const Model& model) {
  for (std::size_t i = 0; i < items_.size(); ++i) {
    std::size_t end = 0;
    for (const Joint* source : sources_of(model, joints_[i]))
      for (const int body : {source->body_A, source->body_B})
        items_[i].ends[end++] = body == world_body ? -1 : static_cast<int>(place_in_system(bodies_, body));
  }
}

/// The dynamic bodies that joints hold, in the order of the list, and where the sides of rows are in it.
void JointSystem::find_nodes(const std::vector<BodyKinetics>& kinetics) {
  node_of_.assign(bodies_.size(), -1);
  for (Item& item : items_) {
    for (int side = 0; side < item.rows.side_count; ++side) {
      const std::size_t place = place_in_system(bodies_, item.rows.bodies[at(side)]);
      item.places[at(side)] = place;
      if (kinetics[place].inverse_mass > 0) node_of_[place] = 0;
    }
  }

  // They are numbered as nodes of the constraint graph.
  bodies_of_nodes_.clear();
  for (std::size_t b = 0; b < node_of_.size(); ++b) {
    if (node_of_[b] < 0) continue;
    node_of_[b] = static_cast<int>(bodies_of_nodes_.size());
    bodies_of_nodes_.push_back(b);
  }

  // Whether the world or a prescribed body takes part.
  for (Item& item : items_) {
    const auto is_grounded = [&](int end) { return end < 0 || kinetics[at(end)].inverse_mass == 0; };
    const auto begin = item.ends.begin();
    item.is_grounded = std::any_of(begin, begin + item.end_count, is_grounded);
  }
}

void JointSystem::make_solver() {
  // The rows of each joint, one below the other.
  int rows = 0;
  for (Item& item : items_) {
    item.first = rows;
    rows += item.rows.size;
  }
  residuals_ = rate_errors_ = biases_ = VecX::Zero(rows);

  // One link per joint between the nodes that it ties.
  ConstraintGraph graph;
  graph.node_count = static_cast<int>(bodies_of_nodes_.size());
  std::size_t blocks = 0;
  for (const Item& item : items_) {
    if (item.rows.size == 0) continue;
    ConstraintGraph::Link link{item.rows.size, {}};
    for (int side = 0; side < item.rows.side_count; ++side) {
      const int node = node_of_[item.places[at(side)]];
      if (node >= 0) link.nodes.push_back(node);
    }
    blocks += link.nodes.size();
    graph.links.push_back(std::move(link));
  }
  rows_.resize(blocks);
  masses_.resize(bodies_of_nodes_.size());
  solver_.emplace(std::move(graph));
}

/// The rows of a joint and of its motors without a limit of force.
void JointSystem::make_rows(const Model& model, int index, Item& item) const {
  static const BodyMotion world;
  const Joint& joint = model.joint(index);
  const auto motion = [&](std::size_t end) -> const BodyMotion& {
    return item.ends[end] < 0 ? world : motions_[at(item.ends[end])];
  };
  if (joint.type == JointType::gear) {
    item.end_count = 4;
    item.rows = gear_rows(joint, model.joint(joint.first_joint), motion(0), motion(1),
                          model.joint(joint.second_joint), motion(2), motion(3));
    item.own = item.rows.size;
    return;
  }

  const BodyMotion &A = motion(0), &B = motion(1);
  update_joint_rows(joint, A, B, item.rows);
  item.own = item.rows.size;
  for (int k = 0; k < static_cast<int>(joint.axes.size()); ++k) {
    const JointAxis& axis = joint.axes[at(k)];
    if (!axis.motor || std::isfinite(axis.motor->max_force)) continue;
    const JointCoordinate coordinate = joint_coordinate(joint, k, A, B);
    const int row = item.rows.size++;
    for (Mat6& J : item.rows.J) J.row(row).setZero();
    item.rows.g[row] = item.rows.bias[row] = item.rate[row] = 0;
    // The row ties its bodies also without the motor: a distance joint may have no other.
    const auto place = [&](int body, const Vec6& J) {
      if (body == world_body) return;
      const std::size_t side = side_of(item.rows, body);
      if (!without_motors_) item.rows.J[side].row(row) = J.transpose();
    };
    place(joint.body_A, coordinate.J_A);
    place(joint.body_B, coordinate.J_B);
    if (without_motors_) continue;
    item.rows.bias[row] = coordinate.bias;
    item.rate[row] = motor_rate(axis, coordinate.value, model.length_scale(), motor_horizon_);
  }

  // The anchor on B, and B among the sides.
  item.arm = B.x + B.R * joint.X_BK.p - (joint.body_B == world_body ? A.x : B.x);
  for (int side = 0; side < item.rows.side_count; ++side)
    if (item.rows.bodies[at(side)] == joint.body_B) item.side_B = side;
}

void JointSystem::stack() {
  for (const Item& item : items_) {
    const int size = item.rows.size;

    // G V - rate.
    Vec6 rate = -item.rate;
    for (int side = 0; side < item.rows.side_count; ++side) {
      const std::size_t s = at(side);
      rate.head(size) += item.rows.J[s].topRows(size) * velocities_[item.places[s]];
    }
    rate_errors_.segment(item.first, size) = rate.head(size);
    residuals_.segment(item.first, size) = item.rows.g.head(size);
    biases_.segment(item.first, size) = item.rows.bias.head(size);
  }
}

void JointSystem::factor(const std::vector<BodyKinetics>& kinetics, const RowChoice* choice) {
  // G: the rows of each link on its nodes.
  std::size_t block = 0;
  for (const Item& item : items_) {
    if (item.rows.size == 0) continue;
    for (int side = 0; side < item.rows.side_count; ++side) {
      const std::size_t s = at(side);
      if (node_of_[item.places[s]] >= 0) rows_[block++] = item.rows.J[s];
    }
  }

  // The mass matrices, and the factors of both.
  for (std::size_t n = 0; n < masses_.size(); ++n) masses_[n] = mass_matrix(kinetics[bodies_of_nodes_[n]]);
  solver_->factor(masses_, rows_, choice);
}

double JointSystem::residual(std::size_t i) const {
  const Item& item = items_[i];
  return item.rows.size == 0 ? 0.0 : residuals_.segment(item.first, item.rows.size).cwiseAbs().maxCoeff();
}

std::pair<double, int> JointSystem::largest_residual() const {
  std::pair<double, int> largest{0, -1};
  for (std::size_t i = 0; i < items_.size(); ++i) {
    if (residual(i) > largest.first) largest = {residual(i), joints_[i]};
  }
  return largest;
}

std::pair<double, int> JointSystem::largest_contradiction(const std::vector<Vec6>& a) const {
  std::pair<double, int> largest{0, -1};
  for (std::size_t i = 0; i < items_.size(); ++i) {
    const Item& item = items_[i];
    Vec6 rate = Vec6::Zero();
    rate.head(item.rows.size) = biases_.segment(item.first, item.rows.size);
    for (int side = 0; side < item.rows.side_count; ++side)
      rate.head(item.rows.size) += item.rows.J[at(side)].topRows(item.rows.size) * a[item.places[at(side)]];
    const double size = rate.cwiseAbs().maxCoeff();
    if (size > largest.first) largest = {size, joints_[i]};
  }
  return largest;
}

JointSystem::Response JointSystem::respond(const std::vector<Vec6>& f, const VecX& c) const {
  // The wrenches on the held bodies.
  VecX stacked(6 * static_cast<Eigen::Index>(bodies_of_nodes_.size()));
  for (std::size_t n = 0; n < bodies_of_nodes_.size(); ++n)
    stacked.segment<6>(6 * static_cast<Eigen::Index>(n)) = f[bodies_of_nodes_[n]];

  // M a = f + Gᵀ λ, G a = c.
  ConstrainedMass::Solution solution = solver_->solve(stacked, c);

  // The accelerations in the order of the list.
  Response response{std::vector<Vec6>(node_of_.size(), Vec6::Zero()), std::move(solution.lambda)};
  for (std::size_t n = 0; n < bodies_of_nodes_.size(); ++n)
    response.a[bodies_of_nodes_[n]] = solution.a.segment<6>(6 * static_cast<Eigen::Index>(n));
  return response;
}

MatX JointSystem::respond(const MatX& f) const {
  return solver_->solve(f);
}

void JointSystem::add_wrenches(const Item& item, const VecX& lambda, std::vector<Vec6>& wrenches) {
  const int size = item.rows.size;
  for (int side = 0; side < item.rows.side_count; ++side) {
    const std::size_t s = at(side);
    wrenches[item.places[s]] += item.rows.J[s].topRows(size).transpose() * lambda.segment(item.first, size);
  }
}

std::vector<Vec6> JointSystem::wrenches(const VecX& lambda) const {
  std::vector<Vec6> result(node_of_.size(), Vec6::Zero());
  for (const Item& item : items_) add_wrenches(item, lambda, result);
  return result;
}

std::vector<Vec6> JointSystem::external_wrenches(const VecX& lambda) const {
  // Gᵀ λ of the grounded joints alone, on dynamic bodies.
  std::vector<Vec6> result(node_of_.size(), Vec6::Zero());
  for (const Item& item : items_) {
    if (item.is_grounded) add_wrenches(item, lambda, result);
  }
  for (std::size_t b = 0; b < result.size(); ++b) {
    if (node_of_[b] < 0) result[b].setZero();
  }
  return result;
}

VecX JointSystem::least_norm(const VecX& lambda, double length) const {
  // G of all rows. Rows without a force exert torques: λ = unit λ', all λ' in N.
  MatX G = MatX::Zero(lambda.size(), 6 * static_cast<Eigen::Index>(bodies_of_nodes_.size()));
  VecX unit = VecX::Ones(lambda.size());
  for (const Item& item : items_) {
    const int size = item.rows.size;
    VecX pull = VecX::Zero(size);
    for (int side = 0; side < item.rows.side_count; ++side) {
      const std::size_t s = at(side);
      pull += item.rows.J[s].topLeftCorner(size, 3).rowwise().norm();
      const int node = node_of_[item.places[s]];
      if (node >= 0) G.block(item.first, 6 * node, size, 6) += item.rows.J[s].topRows(size);
    }
    for (int row = 0; row < size; ++row) {
      if (pull[row] == 0) unit[item.first + row] = length;
    }
  }

  // λ' of least norm with (unit G)ᵀ λ' = Gᵀ λ.
  const MatX scaled = unit.asDiagonal() * G;
  const LeastNormSystem system(scaled * scaled.transpose());
  return unit.cwiseProduct(system.solve(scaled * (G.transpose() * lambda)));
}

Wrench JointSystem::reaction(std::size_t joint, const VecX& lambda) const {
  const Item& item = items_[joint];
  if (item.side_B < 0 && item.rows.side_count == 0) return {};
  // Where B is the world, the reaction is the opposite of what acts on A.
  const std::size_t s = at(std::max(item.side_B, 0));
  const double sign = item.side_B < 0 ? -1 : 1;

  // Gᵀ λ about the centre of mass, moved to the anchor.
  const Vec6 wrench =
      sign * (item.rows.J[s].topRows(item.own).transpose() * lambda.segment(item.first, item.own));
  const Vec3 f_W = wrench.head<3>(), tau_W = wrench.tail<3>();
  return {f_W, tau_W - item.arm.cross(f_W)};
}

bool JointSystem::has_motors() const {
  return std::any_of(items_.begin(), items_.end(),
                     [](const Item& item) { return item.own < item.rows.size; });
}

std::vector<double> JointSystem::motor_forces(std::size_t joint, const VecX& lambda) const {
  // The rows of motors come last.
  const Item& item = items_[joint];
  return {lambda.data() + item.first + item.own, lambda.data() + item.first + item.rows.size};
}

double JointSystem::power_of_prescribed(const VecX& lambda) const {
  double power = 0;
  for (const Item& item : items_) {
    const int size = item.rows.size;
    Vec6 rate = Vec6::Zero();
    for (int side = 0; side < item.rows.side_count; ++side) {
      const std::size_t s = at(side);

      // What prescribed bodies move.
      if (node_of_[item.places[s]] >= 0) continue;
      rate.head(size) -= item.rows.J[s].topRows(size) * velocities_[item.places[s]];
    }
    power += rate.head(size).dot(lambda.segment(item.first, size));
  }
  return power;
}

double JointSystem::power_of_motors(const VecX& lambda, const VecX& rate_errors) const {
  double power = 0;
  for (const Item& item : items_) {
    // The rows of motors come last.
    for (int row = item.own; row < item.rows.size; ++row) {
      power += lambda[item.first + row] * (item.rate[row] + rate_errors[item.first + row]);
    }
  }
  return power;
}

}  // namespace rigor
