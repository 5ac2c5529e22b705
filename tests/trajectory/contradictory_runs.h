// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/trajectory/filmed_solid.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <numbers>
#include <string>

namespace odo::test {

/// What is wrong with a run.
enum class Wrong { Nothing, CameraBefore, CameraDuring, BothCameras, Offset, Height, Exchanged };

inline std::string nameOf(Wrong wrong)
{
    switch (wrong) {
    case Wrong::CameraBefore:
        return "camera moved before";
    case Wrong::CameraDuring:
        return "camera moved during";
    case Wrong::BothCameras:
        return "both cameras moved";
    case Wrong::Offset:
        return "offset";
    case Wrong::Height:
        return "height";
    case Wrong::Exchanged:
        return "exchanged";
    case Wrong::Nothing:
        break;
    }
    return "untouched";
}

/// A robot's run before two cameras, drawn at random: its course, form, registrations with errors as they are
/// stated, and what is wrong with it.
struct DrawnRun
{
    Wrong wrong = Wrong::Nothing;
    double size = 0;              ///< px, s or m
    std::size_t movedView = 0;    ///< of CameraBefore and CameraDuring
    double movedAtS = 0;          ///< of CameraDuring
    std::vector<ViewTrack> views; ///< as they were measured and registered
    RobotShape told;
    Course course;
};

class RunDrawer
{
public:
    explicit RunDrawer(unsigned seed) : m_random(seed) {}

    /// With the same seed all but what is wrong is the same. share: 0 to 1, of the largest size of an error.
    DrawnRun draw(Wrong wrong, double share)
    {
        m_wrong = std::mt19937(m_random());
        DrawnRun run;
        run.wrong = wrong;
        run.course = drawCourse();
        const SolidShape shape = drawShape();
        run.told.lengthM = shape.lengthM;
        run.told.widthM = shape.widthM;
        // one whose height is not told may take up a part of what is wrong
        if (uniform(m_random) < 0.5 || wrong == Wrong::Height)
            run.told.heightM = shape.topM;
        const std::array truth{cameraA(), cameraB()};
        const std::array registered{withError(truth[0]), withError(truth[1])};
        const double offsetS = 0.03 * uniform(m_random);
        run.movedView = m_random() % 2;
        run.movedAtS = 1.5 + 7 * uniform(m_random);
        std::array moved = truth;
        if (wrong == Wrong::CameraBefore || wrong == Wrong::CameraDuring || wrong == Wrong::BothCameras)
            run.size = moveCameras(run, share, moved);
        for (std::size_t v = 0; v < 2; ++v) {
            const double startS = v == 0 ? 0 : offsetS;
            const double fromS = wrong == Wrong::CameraDuring ? run.movedAtS : -1;
            ViewTrack track =
                filmed(v == 0 ? "A" : "B", truth[v], moved[v], fromS, startS, shape, run.course);
            track.floorView = registered[v];
            run.views.push_back(std::move(track));
        }
        run.views[1].startOffsetSigmaS = wrong == Wrong::Offset ? 0 : 0.001; // told, or measured
        const double sign = m_wrong() % 2 == 0 ? 1 : -1;
        if (wrong == Wrong::Offset) {
            run.size = sign * 0.1 * share;
            run.views[1].startOffset += fromSeconds(run.size);
        }
        if (wrong == Wrong::Height) {
            run.size = sign * 0.08 * share;
            if (*run.told.heightM + run.size < 0.01)
                run.size = -run.size;
            *run.told.heightM += run.size;
        }
        if (wrong == Wrong::Exchanged)
            std::swap(run.views[0].floorView, run.views[1].floorView);
        return run;
    }

private:
    Course drawCourse()
    {
        const double turn = 2 * std::numbers::pi * uniform(m_random);
        switch (m_random() % 3) {
        case 0:
            return figureEight(0.8 + 0.3 * uniform(m_random), 0.4 + 0.2 * uniform(m_random),
                               6 + 6 * uniform(m_random));
        case 1: { // straight on
            const Eigen::Vector2d along = Eigen::Rotation2Dd(turn) * Eigen::Vector2d::UnitX();
            const double speed = 0.12 + 0.1 * uniform(m_random);
            return [=](double t) { return Truth{speed * (t - 5) * along, speed * along, {0, 0}}; };
        }
        default: { // two seconds' drive and one second's rest in turn
            const double reach = 0.25 + 0.25 * uniform(m_random);
            return [=](double t) {
                const double part = std::floor(t / 3), into = std::min(1.0, (t - 3 * part) / 2),
                             w = std::numbers::pi * into;
                Truth truth;
                truth.position.x() = -1.2 + reach * (2 * part + 1 - std::cos(w));
                truth.velocity.x() = into < 1 ? reach * std::numbers::pi / 2 * std::sin(w) : 0;
                return truth;
            };
        }
        }
    }

    SolidShape drawShape()
    {
        SolidShape shape;
        switch (m_random() % 3) {
        case 0:
            shape = {SolidShape::Form::Box, 0.26, 0.19, 0, 0.06};
            break;
        case 1:
            shape = {SolidShape::Form::Cylinder, 0.2, 0.2, 0, 0.12};
            break;
        default:
            shape = {SolidShape::Form::Box, 0.3, 0.2, 0.0, 0.2};
        }
        return shape;
    }

    FloorView withError(const FloorView &truth)
    {
        constexpr double angleRad = 1e-4, stationM = 3e-4;
        Eigen::Matrix<double, 6, 6> covariance = Eigen::Matrix<double, 6, 6>::Zero();
        covariance.diagonal() << Eigen::Vector3d::Constant(angleRad * angleRad),
            Eigen::Vector3d::Constant(stationM * stationM);
        const Eigen::Vector3d turn = angleRad * normal3(m_random), shift = stationM * normal3(m_random);
        RigidTransform pose = truth.worldFromCamera();
        pose.rotation = Eigen::AngleAxisd(turn.norm(), turn.normalized()) * pose.rotation;
        pose.translation += shift;
        return {truth.camera(), pose, covariance};
    }

    /// Half of them by up to 20 px in the image, half about any axis by up to 2°. Gives the shift of the
    /// image's middle, px.
    double moveCameras(DrawnRun &run, double share, std::array<FloorView, 2> &views)
    {
        double sizePx = 0;
        for (std::size_t v = 0; v < 2; ++v) {
            if (run.wrong != Wrong::BothCameras && v != run.movedView)
                continue;
            const double focalPx = views[v].camera().intrinsics().fxPx;
            Eigen::Vector3d axis = normal3(m_wrong).normalized(); // of the camera
            double angleRad = share * 2 * std::numbers::pi / 180;
            if (m_wrong() % 2 == 0) {
                const double way = 2 * std::numbers::pi * uniform(m_wrong);
                axis = {std::cos(way), std::sin(way), 0};
                angleRad = share * 20 / focalPx;
            }
            RigidTransform pose = views[v].worldFromCamera();
            pose.rotation = pose.rotation * Eigen::AngleAxisd(angleRad, axis);
            views[v] = FloorView(views[v].camera(), pose, Eigen::Matrix<double, 6, 6>::Zero());
            sizePx = std::max(sizePx, angleRad * focalPx);
        }
        return sizePx;
    }

    /// Its outlines with errors that change as it moves, beside white ones.
    ViewTrack filmed(const std::string &name, const FloorView &before, const FloorView &behind, double fromS,
                     double startS, const SolidShape &shape, const Course &course)
    {
        constexpr double framesPerSecond = 30, durationS = 10, whitePx = 0.06, slowPx = 0.12, lengthM = 0.1;
        ViewTrack track{name, before, fromSeconds(startS), {}};
        std::normal_distribution<double> noise;
        Eigen::Vector2d slow(slowPx * noise(m_random), slowPx * noise(m_random));
        for (int i = 0; i < int(durationS * framesPerSecond); ++i) {
            const double timeS = startS + i / framesPerSecond;
            const FloorView &view = timeS >= fromS ? behind : before;
            const Truth truth = course(timeS);
            const double alike = std::exp(-truth.velocity.norm() / framesPerSecond / lengthM);
            slow = alike * slow +
                   std::sqrt(1 - alike * alike) * slowPx * Eigen::Vector2d(noise(m_random), noise(m_random));
            const Eigen::Vector2d shift = slow + whitePx * Eigen::Vector2d(noise(m_random), noise(m_random));
            Observation observation;
            observation.frame = i;
            observation.time = fromSeconds(i / framesPerSecond);
            observation.score = 0.9;
            observation.centreCovariancePx2 =
                Eigen::Matrix2d::Identity() * (whitePx * whitePx + slowPx * slowPx);
            const auto moments = silhouetteMoments(view, shape, truth.position, headingOf(truth));
            observation.found = moments && isInside(moments->centrePx, view);
            if (observation.found) {
                observation.ellipse = ellipseOf(*moments);
                observation.areaPx = moments->areaPx2 * (1 + 0.003 * noise(m_random));
                observation.supportPx = *silhouetteSupport(view, shape, truth.position, headingOf(truth),
                                                           observation.ellipse.centrePx);
                observation.ellipse.centrePx += shift;
                for (float &reach : observation.supportPx)
                    reach += float(whitePx * noise(m_random));
            }
            track.observations.push_back(observation);
        }
        return track;
    }

    static bool isInside(const Eigen::Vector2d &pixel, const FloorView &view)
    {
        constexpr double margin = 60;
        const Intrinsics &lens = view.camera().intrinsics();
        return pixel.x() > margin && pixel.y() > margin && pixel.x() < lens.widthPx - margin &&
               pixel.y() < lens.heightPx - margin;
    }

    static double uniform(std::mt19937 &random)
    {
        return std::uniform_real_distribution<double>(0, 1)(random);
    }
    static Eigen::Vector3d normal3(std::mt19937 &random)
    {
        std::normal_distribution<double> normal;
        return {normal(random), normal(random), normal(random)};
    }

    std::mt19937 m_random, m_wrong;
};

} // namespace odo::test
