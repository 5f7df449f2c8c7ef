#pragma once

#include <Eigen/Dense>

namespace rigor {

using Vec2 = Eigen::Vector2d;
using Vec3 = Eigen::Vector3d;
using Vec4 = Eigen::Vector4d;
using Mat2 = Eigen::Matrix2d;
using Mat3 = Eigen::Matrix3d;
using Vec6 = Eigen::Matrix<double, 6, 1>;
using Mat6 = Eigen::Matrix<double, 6, 6>;
using VecX = Eigen::VectorXd;
using MatX = Eigen::MatrixXd;
/// Unit quaternion q_WB; it maps coordinates in B to coordinates in W. The constructor takes (w, x, y, z).
using Quat = Eigen::Quaterniond;

}  // namespace rigor
