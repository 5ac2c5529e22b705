// SPDX-License-Identifier: GPL-3.0-or-later
// Precompiled after the headers that most sources include: it makes the compiler lay out, once, the matrices
// and owners that stand in our own headers. Each source would do it anew.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <atomic>
#include <memory>

namespace odo::precompiled {

template <typename Matrix>
constexpr bool knows = sizeof(Matrix) + sizeof(decltype(Matrix::Zero())) > 0;

static_assert(knows<Eigen::Vector2d> && knows<Eigen::Vector3d> && knows<Eigen::Matrix<double, 6, 1>> &&
              knows<Eigen::VectorXd>);
static_assert(knows<Eigen::Matrix2d> && knows<Eigen::Matrix3d> && knows<Eigen::Matrix<double, 6, 6>> &&
              knows<Eigen::Matrix<double, 2, 3>> && knows<Eigen::MatrixXd>);
static_assert(sizeof(Eigen::Quaterniond) + sizeof(std::shared_ptr<std::atomic<bool>>) +
                  sizeof(std::shared_ptr<const void>) >
              0);

} // namespace odo::precompiled
