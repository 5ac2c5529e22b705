// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/project.h"
#include "core/project/repositories.h"

#include <QTemporaryDir>
#include <QTest>
#include <bit>

// What the tests of the repositories share: a project that is closed and opened again, and whether what was
// read is what was stored.
namespace odo::test {

/// A new project in a folder of its own.
class StoredProject
{
public:
    StoredProject()
    {
        auto created = Project::create(file(), "Class 8b – été");
        if (!created)
            qFatal("%s", created.error().message().c_str());
        m_project = std::move(*created);
    }
    Project *operator->() const { return m_project.get(); }
    Project &operator*() const { return *m_project; }
    void reopen()
    {
        m_project.reset();
        auto opened = Project::open(file(), Project::Access::ReadWrite);
        if (!opened)
            qFatal("%s", opened.error().message().c_str());
        m_project = std::move(*opened);
    }

private:
    std::filesystem::path file() const
    {
        return std::filesystem::path(m_folder.path().toStdString()) / "Прогон 1.odo";
    }

    QTemporaryDir m_folder;
    std::unique_ptr<Project> m_project;
};

inline RobotRecord robotNamed(const std::string &name)
{
    RobotRecord robot;
    robot.name = name;
    return robot;
}

/// Equal to the last bit, so that -0 and NaN count too.
inline bool same(double a, double b)
{
    return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

template <class A, class B>
bool sameMatrix(const Eigen::MatrixBase<A> &a, const Eigen::MatrixBase<B> &b)
{
    if (a.rows() != b.rows() || a.cols() != b.cols())
        return false;
    for (Eigen::Index r = 0; r < a.rows(); ++r) {
        for (Eigen::Index c = 0; c < a.cols(); ++c) {
            if (!same(a(r, c), b(r, c)))
                return false;
        }
    }
    return true;
}

inline bool sameIntrinsics(const Intrinsics &a, const Intrinsics &b)
{
    return a.widthPx == b.widthPx && a.heightPx == b.heightPx && same(a.fxPx, b.fxPx) &&
           same(a.fyPx, b.fyPx) && same(a.cxPx, b.cxPx) && same(a.cyPx, b.cyPx) && a.model == b.model &&
           a.distortion == b.distortion && sameMatrix(a.covariance, b.covariance);
}

inline bool sameObservation(const Observation &a, const Observation &b)
{
    return a.frame == b.frame && a.time == b.time && a.found == b.found &&
           a.duplicateFrame == b.duplicateFrame && a.touchesBorder == b.touchesBorder &&
           sameMatrix(a.ellipse.centrePx, b.ellipse.centrePx) &&
           same(a.ellipse.semiMajorPx, b.ellipse.semiMajorPx) &&
           same(a.ellipse.semiMinorPx, b.ellipse.semiMinorPx) &&
           same(a.ellipse.angleRad, b.ellipse.angleRad) &&
           sameMatrix(a.centreCovariancePx2, b.centreCovariancePx2) &&
           sameMatrix(a.lastingCovariancePx2, b.lastingCovariancePx2) && same(a.areaPx, b.areaPx) &&
           same(a.score, b.score) && a.supportPx == b.supportPx;
}

inline bool sameSample(const Sample &a, const Sample &b)
{
    return a.time == b.time && a.frame == b.frame && a.position.has_value() == b.position.has_value() &&
           (!a.position || sameMatrix(*a.position, *b.position)) && sameMatrix(a.covariance, b.covariance) &&
           sameMatrix(a.commonCovariance, b.commonCovariance) && a.views == b.views &&
           a.viewDisagreementM == b.viewDisagreementM && a.flags == b.flags && a.heading == b.heading;
}

inline bool samePoint(const ProfilePoint &a, const ProfilePoint &b)
{
    return sameMatrix(a.position, b.position) && sameMatrix(a.velocity, b.velocity) &&
           sameMatrix(a.acceleration, b.acceleration) && same(a.sigmaXM, b.sigmaXM) &&
           same(a.sigmaYM, b.sigmaYM) && same(a.speedMps, b.speedMps) &&
           same(a.sigmaSpeedMps, b.sigmaSpeedMps) && same(a.accelMps2, b.accelMps2) &&
           same(a.sigmaAccelMps2, b.sigmaAccelMps2) && a.valid == b.valid && a.body == b.body;
}

} // namespace odo::test
