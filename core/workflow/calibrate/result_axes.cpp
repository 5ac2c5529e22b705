// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/workflow/calibrate/result_axes.h"

#include "core/geometry/homography.h"
#include "core/project/project.h"
#include "core/project/repositories.h"
#include "core/workflow/calibrate/cameras.h"
#include "core/workflow/calibrate/register_job.h"
#include "core/workflow/trial_sources.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace odo {

namespace {

using Eigen::Matrix2d;
using Eigen::Vector2d;

constexpr double exactM = 1e-6;         // what storing and transforming leaves
constexpr double samePositionM = 0.005; // of markers that were measured twice
constexpr double nearShare = 0.01;      // of the layout's extent: what registering all cameras together moves

AxesTransform identity()
{
    return {1, 0, Vector2d::Zero()};
}

bool isIdentity(const AxesTransform &axes)
{
    return axes.scale == 1 && axes.turnRad == 0 && axes.shiftM.isZero(0);
}

AxesTransform chained(const AxesTransform &newFromMiddle, const AxesTransform &middleFromOld)
{
    return {newFromMiddle.scale * middleFromOld.scale, newFromMiddle.turnRad + middleFromOld.turnRad,
            newFromMiddle * middleFromOld.shiftM};
}

AxesTransform inverse(const AxesTransform &axes)
{
    AxesTransform back{1 / axes.scale, -axes.turnRad, Vector2d::Zero()};
    back.shiftM = -(back * axes.shiftM);
    return back;
}

bool hasSamePixels(const RegistrationRecord &one, const RegistrationRecord &other)
{
    return !one.pixels.empty() && one.camera == other.camera && one.intrinsics == other.intrinsics &&
           std::ranges::equal(one.pixels, other.pixels, [](const MarkerPixel &a, const MarkerPixel &b) {
               return a.label == b.label && a.pixel == b.pixel;
           });
}

/// Between two registrations of a camera from the same pixels: nullopt where more than the axes differs.
std::optional<AxesTransform> axesBetween(const RegistrationRecord &older, const RegistrationRecord &newer)
{
    if (!hasSamePixels(older, newer))
        return std::nullopt;
    const RigidTransform &from = older.registration.worldFromCamera, &to = newer.registration.worldFromCamera;
    const Eigen::Quaterniond turn = to.rotation * from.rotation.conjugate();
    const double scale = to.translation.z() / from.translation.z();
    if (turn.vec().head<2>().norm() > 1e-9 || !(scale > 0))
        return std::nullopt;
    AxesTransform axes{std::abs(scale - 1) < 1e-12 ? 1 : scale, 2 * std::atan2(turn.z(), turn.w()),
                       Vector2d::Zero()};
    axes.shiftM = to.translation.head<2>() - axes * from.translation.head<2>();
    return axes;
}

/// The axes that a layout has had, from the registrations of its cameras.
class AxesHistory
{
public:
    /// The present axes alone.
    static Result<AxesHistory> of(Project &project, RecordId layout)
    {
        AxesHistory history;
        history.m_layout = ODO_TRY(project.layouts().get(layout)).layout;
        history.m_axes.push_back({identity(), std::numeric_limits<RecordId>::max()});
        return history;
    }

    /// Adds those before them.
    Result<void> findAll(Project &project, RecordId layout)
    {
        const auto cameras = ODO_TRY(project.cameras().all());
        for (const CameraRecord &camera : cameras) {
            auto all = ODO_TRY(project.cameras().allRegistrations(camera.id));
            std::erase_if(all, [&](const RegistrationRecord &each) { return each.layout != layout; });
            std::ranges::move(all, std::back_inserter(m_registrations));
        }
        // A camera was registered in each of them.
        for (std::size_t i = 0; i < m_axes.size() && i < m_registrations.size(); ++i)
            ODO_TRY(findBefore(project, m_axes[i]));
        return {};
    }

    /// Whether it is in the present axes, as most are.
    Result<bool> holdsExactly(Project &project, const RegistrationRecord &registration) const
    {
        return misfitM(ODO_TRY(floorViewOf(project, registration)), registration, identity()) < exactM;
    }

    Result<std::optional<AxesTransform>> presentFrom(Project &project,
                                                     const RegistrationRecord &registration) const
    {
        const FloorView view = ODO_TRY(floorViewOf(project, registration));
        for (const auto &[presentFrom, before] : m_axes) {
            if (misfitM(view, registration, presentFrom) < exactM)
                return std::optional(presentFrom);
        }
        // Registered together with others, it does not fit as exactly.
        const AxesTransform *best = nullptr;
        double leastM = nearShare * extentM();
        for (const auto &[presentFrom, before] : m_axes) {
            const double misfit = misfitM(view, registration, presentFrom);
            if (misfit < leastM) {
                leastM = misfit;
                best = &presentFrom;
            }
        }
        return best ? std::optional(*best) : std::nullopt;
    }

private:
    struct Axes
    {
        AxesTransform presentFrom;
        RecordId before = 0; ///< the registration with which they ended
    };

    double extentM() const
    {
        std::vector<Vector2d> points;
        for (const Marker &marker : m_layout.markers)
            points.push_back(marker.pointInWorld);
        return extentOf(points);
    }

    /// How far the errors that its markers would have in these axes are from those that were stored.
    double misfitM(const FloorView &view, const RegistrationRecord &registration,
                   const AxesTransform &presentFrom) const
    {
        const AxesTransform thenFromPresent = inverse(presentFrom);
        double misfit = 0;
        for (const MarkerError &error : registration.registration.markers) {
            const auto marker = std::ranges::find(m_layout.markers, error.label, &Marker::label);
            const auto pixel = std::ranges::find(registration.pixels, error.label, &MarkerPixel::label);
            if (marker == m_layout.markers.end() || pixel == registration.pixels.end())
                continue;
            const auto seen = view.floorFromPixel(pixel->pixel, 0);
            if (!seen)
                return std::numeric_limits<double>::infinity();
            misfit = std::max(
                misfit, std::abs((*seen - thenFromPresent * marker->pointInWorld).norm() - error.errorM));
        }
        return misfit;
    }

    /// Adds the axes from which registrations were carried into these.
    Result<void> findBefore(Project &project, Axes axes)
    {
        for (const RegistrationRecord &newer : m_registrations) {
            if (newer.id >= axes.before)
                continue;
            for (const RegistrationRecord &older : m_registrations) {
                const auto between =
                    older.id < newer.id ? axesBetween(older, newer) : std::optional<AxesTransform>();
                if (!between || isIdentity(*between))
                    continue;
                const AxesTransform before = chained(axes.presentFrom, *between);
                if (isKnown(before))
                    continue;
                const FloorView view = ODO_TRY(floorViewOf(project, newer));
                if (misfitM(view, newer, axes.presentFrom) <= nearShare * extentM())
                    m_axes.push_back({before, newer.id});
            }
        }
        return {};
    }

    bool isKnown(const AxesTransform &axes) const
    {
        return std::ranges::any_of(m_axes, [&](const Axes &known) {
            return std::ranges::all_of(m_layout.markers, [&](const Marker &marker) {
                return (axes * marker.pointInWorld - known.presentFrom * marker.pointInWorld).norm() < exactM;
            });
        });
    }

    MarkerLayout m_layout; ///< in the present axes
    std::vector<RegistrationRecord> m_registrations;
    std::vector<Axes> m_axes; ///< the present ones first
};

/// The registration of the first view that has one.
Result<std::optional<RegistrationRecord>> firstRegistration(Project &project, const AnalysisRecord &analysis)
{
    const auto first = std::ranges::find_if(analysis.registrations, [](RecordId id) { return id != 0; });
    if (first == analysis.registrations.end())
        return std::nullopt;
    auto registration = ODO_TRY(project.cameras().registration(*first));
    return std::optional(std::move(registration));
}

bool isSameCourse(const Task &one, const Task &other)
{
    const auto isNear = [](const Vector2d &a, const Vector2d &b) { return (a - b).norm() < exactM; };
    const auto isSameGate = [&](const Gate &a, const Gate &b) {
        return a.name == b.name && a.role == b.role && isNear(a.from, b.from) && isNear(a.to, b.to);
    };
    const auto isSameZone = [&](const Zone &a, const Zone &b) {
        return a.name == b.name && a.rule == b.rule && std::ranges::equal(a.corners, b.corners, isNear);
    };
    return std::ranges::equal(one.gates, other.gates, isSameGate) &&
           std::ranges::equal(one.zones, other.zones, isSameZone) && one.path.closed == other.path.closed &&
           std::ranges::equal(one.path.points, other.path.points, isNear) &&
           one.limits.maxSpeedMps == other.limits.maxSpeedMps &&
           one.limits.maxAccelMps2 == other.limits.maxAccelMps2;
}

bool shareMarkers(const MarkerLayout &one, const MarkerLayout &other)
{
    return std::ranges::count_if(one.markers, [&](const Marker &marker) {
               const auto same = std::ranges::find(other.markers, marker.label, &Marker::label);
               return same != other.markers.end() &&
                      (same->pointInWorld - marker.pointInWorld).norm() < samePositionM;
           }) >= 2;
}

} // namespace

Task transformed(const Task &task, const AxesTransform &newFromOld)
{
    Task result = task;
    for (Gate &gate : result.gates) {
        gate.from = newFromOld * gate.from;
        gate.to = newFromOld * gate.to;
    }
    for (Vector2d &point : result.path.points)
        point = newFromOld * point;
    for (Zone &zone : result.zones) {
        for (Vector2d &corner : zone.corners)
            corner = newFromOld * corner;
    }
    return result;
}

Profile transformed(Profile profile, const AxesTransform &newFromOld)
{
    const Matrix2d turn = Eigen::Rotation2Dd(newFromOld.turnRad).toRotationMatrix();
    for (Sample &sample : profile.samples) {
        if (sample.position)
            sample.position = newFromOld * *sample.position;
        sample.covariance = turn * sample.covariance * turn.transpose();
        sample.commonCovariance = turn * sample.commonCovariance * turn.transpose();
        if (sample.heading)
            sample.heading->radians += newFromOld.turnRad;
    }
    for (std::size_t i = 0; i < profile.points.size(); ++i) {
        ProfilePoint &point = profile.points[i];
        point.position = newFromOld * point.position;
        point.velocity = turn * point.velocity;
        point.acceleration = turn * point.acceleration;
        // How their errors belong together is not stored.
        Matrix2d covariance = Vector2d(point.sigmaXM, point.sigmaYM).cwiseAbs2().asDiagonal();
        covariance = turn * covariance * turn.transpose();
        point.sigmaXM = std::sqrt(covariance(0, 0));
        point.sigmaYM = std::sqrt(covariance(1, 1));
        if (point.body)
            point.body->radians += newFromOld.turnRad;
    }
    return profile;
}

Result<std::optional<AxesTransform>> presentAxesOf(Project &project, const RegistrationRecord &registration)
{
    auto history = ODO_TRY(AxesHistory::of(project, registration.layout));
    if (ODO_TRY(history.holdsExactly(project, registration)))
        return identity();
    ODO_TRY(history.findAll(project, registration.layout));
    return history.presentFrom(project, registration);
}

Result<bool> bringToPresentAxes(Project &project, const TrialRecord &trial, AnalysisRecord &analysis)
{
    const auto registration = ODO_TRY(firstRegistration(project, analysis));
    if (!registration)
        return true;
    const auto presentFrom = ODO_TRY(presentAxesOf(project, *registration));
    if (!presentFrom || presentFrom->scale != 1)
        return false;
    if (isIdentity(*presentFrom))
        return true;
    for (Profile *part : {&analysis.outside.before, &analysis.profile, &analysis.outside.after})
        *part = transformed(std::move(*part), *presentFrom);
    if (analysis.task != 0 && !trial.task.empty()) {
        const auto then = ODO_TRY(project.tasks().get(analysis.task));
        const auto now = ODO_TRY(project.tasks().find(trial.task));
        if (isSameCourse(transformed(then.task, *presentFrom), now.task))
            analysis.task = now.id;
    }
    return true;
}

Result<RecordId> layoutOf(Project &project, const AnalysisRecord &analysis)
{
    const auto registration = ODO_TRY(firstRegistration(project, analysis));
    return registration ? registration->layout : 0;
}

Result<bool> haveCommonAxes(Project &project, const AnalysisRecord &one, const AnalysisRecord &other)
{
    const RecordId a = ODO_TRY(layoutOf(project, one)), b = ODO_TRY(layoutOf(project, other));
    if (a == 0 || b == 0 || a == b || (one.task != 0 && one.task == other.task))
        return true;
    const auto first = ODO_TRY(project.layouts().get(a)), second = ODO_TRY(project.layouts().get(b));
    if (shareMarkers(first.layout, second.layout))
        return true;
    const auto cameras = ODO_TRY(project.cameras().all());
    return std::ranges::any_of(cameras, [&](const CameraRecord &camera) {
        return isLayoutOfReference(first.layout.name, camera.name) ||
               isLayoutOfReference(second.layout.name, camera.name);
    });
}

Result<bool> haveSameRegistrations(Project &project, const AnalysisRecord &one, const AnalysisRecord &other)
{
    if (one.registrations.size() != other.registrations.size())
        return false;
    for (std::size_t i = 0; i < one.registrations.size(); ++i) {
        const RecordId a = one.registrations[i], b = other.registrations[i];
        if (a == b)
            continue;
        if (a == 0 || b == 0)
            return false;
        const auto first = ODO_TRY(project.cameras().registration(std::min(a, b)));
        const auto second = ODO_TRY(project.cameras().registration(std::max(a, b)));
        if (!axesBetween(first, second))
            return false;
    }
    return true;
}

} // namespace odo
