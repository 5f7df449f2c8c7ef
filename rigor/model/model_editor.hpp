#pragma once

#include "rigor/model/body_builder.hpp"
#include "rigor/model/model_builder.hpp"

#include <array>
#include <map>
#include <memory>
#include <set>
#include <span>
#include <string>
#include <unordered_set>
#include <utility>
#include <vector>

namespace rigor {

/// Whether a place of a Model has no body: places that a ModelEditor keeps for bodies to come. They are
/// fixed, without shapes and without a name.
bool is_vacant(const Body& body);

/// Changes a Model in place while a simulation goes on (decision 22). The Model keeps its number of places:
/// who goes leaves a vacant place, who comes takes the lowest one. So indices stay what they are, and a
/// change costs what it concerns, not what there is.
///
/// What a caller describes is checked as a ModelBuilder does; an InputError changes nothing. Indices must be
/// those of bodies and joints that are there.
class ModelEditor {
 public:
  /// A copy of the Model with this many places, at least as many as it has.
  ModelEditor(const Model& model, int places);
  /// The Model as it is now; the same object through all changes.
  std::shared_ptr<const Model> model() const { return model_; }
  bool is_full() const { return vacant_.empty(); }

  /// Adds a body in a Model that is not full; without a name it is called by its place. A kinematic body with
  /// a velocity is where it is described at the time t [s].
  int add_body(BodyDescription description, double t);
  void remove_body(int body);
  /// Another body in the place of one, of the same name. Its joints hold it where they held the one before;
  /// those that move nothing any more go.
  void replace_body(int body, BodyDescription description, double t);
  void set_filter(int body, std::uint32_t group, std::uint32_t mask);

  /// A joint between two bodies, or world_body, that are at these poses X_WB now. Its description names no
  /// bodies; its anchors and axes are in W now, and its coordinates are 0 here.
  int add_joint(const ModelBuilder::JointDescription& description, std::array<int, 2> bodies,
                const std::array<Pose, 2>& poses);
  /// A gear between two joints.
  int add_gear(const ModelBuilder::JointDescription& description, std::array<int, 2> joints);
  /// Removes a joint with its gears. Joints that go keep their numbers, and so do the others, until
  /// take_joint_changes(): many that go at once cost little more than one, but in scenes with gears, where
  /// each looks at all joints.
  void remove_joint(int joint);
  /// The laws along a coordinate of a joint. Returns whether others act than before: if not, only their
  /// numbers have changed, which is no change of joints.
  bool set_axis(int joint, int coordinate, const JointAxis& laws);
  /// Whether two bodies may collide, whatever their groups.
  void exclude_pair(int a, int b, bool is_excluded);

  int add_material(const Material& material);
  void set_material(int material, const Material& to);
  void set_pair(int a, int b, const PairCoefficients& coefficients);
  bool is_in_use(int material) const;
  /// Removes a material that is not in use; its number is given to the next one that comes.
  void remove_material(int material);
  void set_gravity(const Vec3& g_W);

  /// What joints did since the last call: of each joint the number that it had before, -1 if it is new, and
  /// the bodies that joints or exclusions concern. Nothing if none changed.
  struct JointChanges {
    bool is_any = false;
    std::vector<int> was;
    std::vector<int> bodies;
  };
  JointChanges take_joint_changes();
  /// The numbers of the joints that went since the last call of this, as they have them until the joints'
  /// changes are taken.
  std::vector<int> take_leaving_joints() { return std::exchange(left_, {}); }

 private:
  Body make(BodyDescription description, int place, double t);
  void put(int place, Body body);
  void count_materials(const Body& body, int by);
  void clear(int place);
  void drop_ties_of(int body);
  void drop_idle_joints();
  bool is_leaving(std::size_t joint) const { return joint < leaves_.size() && leaves_[joint] != 0; }
  void let_go(std::size_t joint);
  void erase_leaving();
  int append_joint(Joint joint, bool collides);
  void begin_joint_changes();
  void change_exclusion(int a, int b, int by);
  void check_cavities(const Body& body, int place) const;

  std::shared_ptr<Model> model_;
  MaterialTable materials_;
  std::vector<int> free_materials_;
  std::vector<int> material_uses_;  ///< How many shapes of bodies that are there have each material.
  ShapeMemory memory_;
  SharedShapes shared_;
  std::set<int> vacant_;
  std::unordered_set<std::string> joint_names_;
  long joints_named_ = 0;
  std::vector<int> tie_counts_;                    ///< Of each body: joints, forces and exclusions.
  std::map<std::pair<int, int>, int> exclusions_;  ///< How often each pair is excluded.
  std::map<double, int> radii_;                    ///< Of bounded bodies, with their number.
  std::set<int> cavity_bodies_;
  JointChanges changes_;
  std::vector<char> leaves_;  ///< Whether each joint goes when its changes are taken; empty if none does.
  std::vector<int> left_;     ///< See take_leaving_joints().
  int gear_count_ = 0;
};

}  // namespace rigor
