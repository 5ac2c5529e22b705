// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/internal/round_markers.h"
#include "core/calibration/marker_layout.h"
#include "core/geometry/camera_model.h"

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <set>
#include <vector>

namespace odo {

struct PlanePose;

/// The ways to give the shapes of an image to the labels of a layout that a camera above the floor can have
/// seen: each four labels that span much with each four shapes in the right sense of rotation, as a pose; the
/// other labels are given the shapes that this pose puts near them, and the pose is refined to all. For one
/// image, one thread.
class AssignmentSearch
{
public:
    static constexpr int nothing = -1;
    using Assignment = std::vector<int>; ///< a candidate for each label of the layout, or nothing

    struct Solution
    {
        Assignment assignment;
        std::size_t matched = 0;
        bool sizesAgree = true; ///< the markers have one size on the floor
        double rmsPx = 0;
    };

    /// Both must outlive this. intrinsicsKnown: false leaves the focal length free.
    AssignmentSearch(const MarkerLayout &layout, const CameraModel &camera, bool intrinsicsKnown);

    /// The largest of the shapes become candidates.
    void addShapes(const std::vector<RoundMarker> &shapes);
    /// Labels that are known: the candidate near the pixel, or the pixel itself.
    void fix(const std::vector<MarkerPixel> &hints);

    std::size_t count() const { return m_candidates.size(); }
    const Eigen::Vector2d &pixel(int candidate) const
    {
        return m_candidates[static_cast<std::size_t>(candidate)].pixel;
    }

    /// All assignments that fit, best first: by the number of markers, then by sizes that agree, then by the
    /// misfit.
    std::vector<Solution> solutions();

private:
    using Four = std::array<int, 4>;
    struct Candidate
    {
        Eigen::Vector2d pixel, ray;
        double areaPx = 0; ///< 0: not known
    };

    const Eigen::Vector2d &position(int label) const
    {
        return m_layout.markers[static_cast<std::size_t>(label)].pointInWorld;
    }
    bool add(const Eigen::Vector2d &pixel, double areaPx);
    double flatness(const Four &four) const;
    std::vector<Four> labelQuadruples() const;
    bool mayBe(int label, int candidate) const;
    void tryShapes(const Four &labels);
    bool isSeenFromAbove(const Four &labels, const Four &chosen, std::size_t i, std::size_t j,
                         std::size_t k) const;
    void tryPose(const Four &labels, const Four &chosen);
    bool isPoseLike(const Eigen::Matrix3d &map, const std::array<Eigen::Vector2d, 4> &from,
                    const std::array<Eigen::Vector2d, 4> &to) const;
    Assignment completed(const Eigen::Matrix3d &map, const Four &labels, const Four &chosen) const;
    static std::size_t matchedBy(const Assignment &assignment);
    void refine();
    bool sizesAgree(const Assignment &assignment, const PlanePose &pose) const;

    const MarkerLayout &m_layout;
    const CameraModel &m_camera;
    const bool m_known;
    double m_extentPx = 0;
    std::vector<Candidate> m_candidates;
    Assignment m_fixed;
    std::set<Assignment> m_seen;
    std::vector<Assignment> m_rough;
    std::vector<Solution> m_solutions;
};

} // namespace odo
