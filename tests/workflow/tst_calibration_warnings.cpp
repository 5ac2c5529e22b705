// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/project.h"
#include "core/project/repositories.h"
#include "core/workflow/calibrate/cameras.h"
#include "tests/support/registered_test.h"
#include "tests/support/said_error.h"

#include <QTemporaryDir>
#include <QTest>
#include <memory>

using namespace odo;
using namespace std::chrono_literals;

namespace {

const Instant january = std::chrono::sys_days(std::chrono::year(2026) / 1 / 10);

IntrinsicsRecord intrinsicsOf(RecordId camera, Instant made)
{
    IntrinsicsRecord record;
    record.camera = camera;
    record.made = made;
    record.origin = foreignWords("imported from A.yaml");
    record.calibration.intrinsics = CameraModel::assumed(640, 360).intrinsics();
    return record;
}

RegistrationRecord registrationOf(RecordId camera, RecordId layout, RecordId intrinsics, Instant made)
{
    RegistrationRecord record;
    record.camera = camera;
    record.layout = layout;
    record.intrinsics = intrinsics;
    record.made = made;
    record.assumedIntrinsics = record.registration.intrinsics = CameraModel::assumed(640, 360).intrinsics();
    record.registration.worldFromCamera.translation.z() = 2;
    record.registration.poseCovariance.setIdentity();
    for (const char *label : {"O", "U", "V", "D"}) {
        record.pixels.push_back({label, {100, 100}});
        record.registration.markers.push_back({label, 0, 0});
    }
    return record;
}

} // namespace

/// What is said of a camera whose calibration may be wrong.
class TestCalibrationWarnings : public QObject
{
    Q_OBJECT

    QTemporaryDir m_folder;
    std::unique_ptr<Project> m_project;
    CameraRecord m_camera;
    RecordId m_layout = 0;

    std::vector<std::string> warned(Instant now)
    {
        const auto warnings = calibrationWarnings(*m_project, m_camera, now);
        return warnings ? test::english(*warnings) : std::vector<std::string>{warnings.error().message()};
    }

private Q_SLOTS:
    void init()
    {
        m_project.reset();
        static int number = 0;
        auto project = Project::create(
            m_folder.filePath(QStringLiteral("%1.odo").arg(++number)).toStdString(), "lesson");
        QVERIFY2(project.has_value(), project ? "" : project.error().message().c_str());
        m_project = std::move(*project);
        m_camera = m_project->cameras().add({0, "A", {}}).value();
        m_layout = m_project->layouts()
                       .add({"floor", {{"O", {0, 0}}, {"U", {2, 0}}, {"V", {0, 1}}, {"D", {2, 1}}}})
                       .value()
                       .id;
    }
    void aLensThatWasNeverCalibrated()
    {
        const auto warnings = warned(january);
        QCOMPARE(warnings.size(), std::size_t(1));
        QCOMPARE(warnings[0],
                 std::string("The lens of camera 'A' is neither calibrated nor determined by the floor's "
                             "markers: calibrate it."));
    }
    void nothingOfALensThatTheMarkersDetermine()
    {
        RegistrationRecord record = registrationOf(m_camera.id, m_layout, 0, january);
        record.assumedIntrinsics.distortion = {0, 0, 0, 0, 0};
        record.assumedIntrinsics.covariance = Eigen::MatrixXd::Identity(9, 9);
        QVERIFY(m_project->cameras().addRegistration(record).has_value());
        QVERIFY(warned(january).empty());
    }
    void nothingOfAFreshOne()
    {
        const auto lens = m_project->cameras().addIntrinsics(intrinsicsOf(m_camera.id, january));
        QVERIFY2(lens.has_value(), lens ? "" : lens.error().message().c_str());
        QVERIFY(m_project->cameras()
                    .addRegistration(registrationOf(m_camera.id, m_layout, lens->id, january))
                    .has_value());
        QVERIFY(warned(january + std::chrono::days(90)).empty());
    }
    void oldOnesWithTheirAge()
    {
        const auto lens = m_project->cameras().addIntrinsics(intrinsicsOf(m_camera.id, january));
        QVERIFY(m_project->cameras()
                    .addRegistration(registrationOf(m_camera.id, m_layout, lens->id, january))
                    .has_value());
        const auto warnings = warned(january + std::chrono::days(91));
        QCOMPARE(warnings.size(), std::size_t(2));
        QCOMPARE(warnings[0],
                 std::string("The lens calibration of camera 'A' is 91 days old: if zoom, focus or the "
                             "camera's settings have changed since, calibrate it again."));
        QCOMPARE(warnings[1], std::string("The floor registration of camera 'A' is 91 days old: check that "
                                          "the camera has not moved, or "
                                          "register it again."));
    }
    void aRegistrationThatALensHasOvertaken()
    {
        QVERIFY(m_project->cameras()
                    .addRegistration(registrationOf(m_camera.id, m_layout, 0, january))
                    .has_value());
        const auto first = m_project->cameras().addIntrinsics(intrinsicsOf(m_camera.id, january));
        QCOMPARE(warned(january),
                 (std::vector<std::string>{
                     "The floor registration of camera 'A' was made before its lens was calibrated: "
                     "register it again."}));
        QVERIFY(m_project->cameras()
                    .addRegistration(registrationOf(m_camera.id, m_layout, first->id, january))
                    .has_value());
        QVERIFY(warned(january).empty());
        QVERIFY(m_project->cameras().addIntrinsics(intrinsicsOf(m_camera.id, january + 1h)).has_value());
        QCOMPARE(warned(january + 2h),
                 (std::vector<std::string>{"The floor registration of camera 'A' uses another lens "
                                           "calibration than the current one: register it again."}));
    }
};

ODOGRAPH_TEST(TestCalibrationWarnings, QCoreApplication)
#include "tst_calibration_warnings.moc"
