#pragma once

#include "rigor/view/3d/framing.hpp"
#include "rigor/view/3d/image.hpp"
#include "rigor/view/3d/key_moments.hpp"
#include "rigor/view/3d/occlusion.hpp"
#include "rigor/view/3d/renderer.hpp"

#include <span>
#include <vector>

namespace rigor {

/// Size of a picture [px].
struct PictureSize {
  int width = 1280, height = 720;
};
inline constexpr int least_picture_side = 16, most_picture_side = 16384;

/// Makes pictures of one recording, all through the same camera; moments of which it shows nothing that moves
/// have one of their own, to which films pan. What stands still between a camera and the bodies that move is
/// drawn as glass.
class PictureRenderer {
 public:
  /// The recording must outlive this object.
  PictureRenderer(const Recording& recording, const CameraOptions& options, const PictureSize& size);

  const Camera& camera() const { return camera_; }
  /// The same camera, or one that frames this moment alone, seen in the same direction, if that shows nothing
  /// that moves: small bodies fly farther than a picture can show them. Where the user placed the camera it
  /// stays.
  Camera camera_of_moment(std::size_t frame) const;
  /// The cameras of a film of these output times: those of the moments, with a pan of about a second in place
  /// of each jump, where 30 pictures are a second.
  std::vector<Camera> cameras_of_film(std::span<const std::size_t> frames) const;
  /// The scene at an output time, without text.
  Image draw(std::size_t frame) { return draw(frame, camera_of_moment(frame)); }
  Image draw(std::size_t frame, const Camera& camera);
  /// The same with the scene's name, the time and the names of the moving bodies if they are few: these stand
  /// in the corner where they cover the least of the motion, the same one in all pictures.
  Image picture(std::size_t frame) { return picture(frame, camera_of_moment(frame)); }
  Image picture(std::size_t frame, const Camera& camera);
  /// All moments side by side in one picture, each of the size given to this object, with their times and
  /// captions below them and the name of the scene above.
  Image sheet(const std::vector<KeyMoment>& moments);

 private:
  bool shows_nothing(std::size_t frame) const;
  Camera own_camera(std::size_t frame) const;
  void place_legend(const std::vector<Pose>& poses);
  void put_glass(const std::vector<std::size_t>& shapes);

  const Recording& recording_;
  PictureSize size_;
  CameraOptions options_;
  DrawnScene scene_;
  Camera camera_;
  Renderer renderer_;
  std::vector<std::size_t> glass_;  ///< Shapes that are glass for the common camera.
  PictureBox legend_{};             ///< Empty if there is no legend.
};

/// Number of columns of a sheet with that many pictures.
int sheet_columns(std::size_t count);
/// Size of one picture of a sheet of the given width: 16 to 9, three side by side.
PictureSize sheet_tile(int sheet_width);

/// "t = 0.25 s", with enough digits to tell the output times of the recording apart.
std::string time_text(const Recording& recording, std::size_t frame);

}  // namespace rigor
