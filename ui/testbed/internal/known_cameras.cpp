// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/testbed/internal/known_cameras.h"

#include "core/project/project.h"
#include "core/project/repositories.h"
#include "core/workflow/trial_sources.h"
#include "ui/models/camera_lists.h"
#include "ui/models/number_text.h"
#include "ui/models/shown_message.h"

#include <QCoreApplication>
#include <QLocale>

namespace odo {

namespace {

Result<std::optional<std::filesystem::path>> newestFile(Project &project, RecordId camera)
{
    const auto recording = ODO_TRY(project.trials().newestRecording(camera));
    return recording ? std::optional(project.resolve(*recording)) : std::nullopt;
}

} // namespace

Result<std::vector<FloorCamera>> floorCameras(Project &project)
{
    const auto rows = ODO_TRY(loadCameraRows(project));
    std::vector<FloorCamera> cameras;
    for (const CameraRow &row : rows) {
        const auto recording = ODO_TRY(newestFile(project, row.camera.id));
        cameras.push_back({QString::fromStdString(row.camera.name), row.intrinsics, recording,
                           cameraBadge(row.registration)});
    }
    return cameras;
}

Result<std::vector<CheckCamera>> checkCameras(Project &project)
{
    const auto rows = ODO_TRY(loadCameraRows(project));
    std::vector<CheckCamera> cameras;
    for (const CameraRow &row : rows) {
        if (!row.registration)
            continue;
        const auto view = ODO_TRY(floorViewOf(project, *row.registration));
        const auto layout = ODO_TRY(project.layouts().get(row.registration->layout));
        const auto recording = ODO_TRY(newestFile(project, row.camera.id));
        cameras.push_back({QString::fromStdString(row.camera.name), view, layout.layout, recording,
                           row.camera.deviceUri, cameraBadge(row.registration), *row.registration});
    }
    return cameras;
}

namespace {

class TestbedStateWords
{
    Q_DECLARE_TR_FUNCTIONS(TestbedState)
};

QString lensName(LensModel model)
{
    switch (model) {
    case LensModel::Standard:
        return TestbedStateWords::tr("standard");
    case LensModel::Rational:
        return TestbedStateWords::tr("rational");
    case LensModel::Fisheye:
        break;
    }
    return TestbedStateWords::tr("fisheye");
}

void addIntrinsics(QList<Fact> &facts, const IntrinsicsRecord &record)
{
    const QLocale locale;
    const Intrinsics &intrinsics = record.calibration.intrinsics;
    facts.append({TestbedStateWords::tr("Image size"),
                  QStringLiteral("%1×%2").arg(intrinsics.widthPx).arg(intrinsics.heightPx),
                  {}});
    facts.append({TestbedStateWords::tr("Calibration"),
                  TestbedStateWords::tr("%1, f = %2 px")
                      .arg(lensName(intrinsics.model), locale.toString(intrinsics.fxPx, 'f', 1)),
                  {}});
    facts.append({TestbedStateWords::tr("Origin"),
                  QStringLiteral("%1, %2").arg(shownWords(record.origin), shortDate(record.made)),
                  {}});
    if (record.calibration.rmsPx > 0)
        facts.append({TestbedStateWords::tr("Board error"),
                      TestbedStateWords::tr("%1 px in %2 images")
                          .arg(locale.toString(record.calibration.rmsPx, 'f', 2))
                          .arg(record.calibration.imagesUsed()),
                      {}});
    if (record.calibration.crossValidationPx > 0)
        facts.append({TestbedStateWords::tr("Held-out error"),
                      TestbedStateWords::tr("%1 px").arg(
                          locale.toString(record.calibration.crossValidationPx, 'f', 2)),
                      {}});
    if (!record.calibration.verdict.isEmpty())
        facts.append({TestbedStateWords::tr("Verdict"), shownWords(record.calibration.verdict), {}});
}

void addRegistration(QList<Fact> &facts, const RegistrationRecord &record)
{
    const QLocale locale;
    const FloorRegistration &registration = record.registration;
    facts.append({TestbedStateWords::tr("On the floor"),
                  TestbedStateWords::tr("registered %1").arg(shortDate(record.made)), cameraBadge(record)});
    if (record.lastCheck)
        facts.append({TestbedStateWords::tr("Last check"),
                      QStringLiteral("%1: %2").arg(shortDate(record.lastCheck->made),
                                                   shownWords(record.lastCheck->words)),
                      {}});
    const Eigen::Vector3d position = registration.worldFromCamera.translation;
    facts.append({TestbedStateWords::tr("Position"),
                  TestbedStateWords::tr("x %1 m, y %2 m, %3 m high")
                      .arg(locale.toString(position.x(), 'f', 2), locale.toString(position.y(), 'f', 2),
                           locale.toString(position.z(), 'f', 2)),
                  {}});
    QStringList errors;
    for (const MarkerError &marker : registration.markers)
        errors << QStringLiteral("%1 %2").arg(QString::fromStdString(marker.label),
                                              lengthText(marker.errorM));
    facts.append({TestbedStateWords::tr("Markers"), errors.join(QStringLiteral(", ")), {}});
    if (!registration.verdict.isEmpty())
        facts.append({TestbedStateWords::tr("Verdict"), shownWords(registration.verdict), {}});
}

} // namespace

Result<TrialScenePtr> newestImage(Project &project, const CameraRow &camera)
{
    const auto recording = ODO_TRY(project.trials().newestRecording(camera.camera.id));
    if (!recording)
        return TrialScenePtr();
    auto scene = std::make_shared<TrialScene>();
    SceneView view{camera.camera.name, *recording, project.resolve(*recording), {}, {}, Nanoseconds{0}};
    if (camera.registration) {
        const Result<FloorView> floorView = floorViewOf(project, *camera.registration);
        const Result<LayoutRecord> layout = project.layouts().get(camera.registration->layout);
        if (!floorView || !layout)
            return tl::unexpected(floorView ? layout.error() : floorView.error());
        view.floorView = *floorView;
        view.registration = camera.registration->registration;
        scene->layout = layout->layout;
    }
    const TrialRecord trial = ODO_TRY(project.trials().get(recording->trial));
    scene->trial = trial;
    scene->views.push_back(std::move(view));
    return scene;
}

namespace {

bool isLensEstimated(const CameraRow &camera)
{
    return camera.registration && camera.registration->intrinsics == 0 &&
           intrinsicsSourceOf(camera.registration->assumedIntrinsics, false) == IntrinsicsSource::Floor;
}

} // namespace

QList<Fact> cameraFacts(const CameraRow &camera)
{
    QList<Fact> facts;
    // What is wrong comes first, so that nobody has to scroll for it.
    const auto check = camera.registration ? camera.registration->lastCheck : std::nullopt;
    if (check && check->outcome != RegistrationCheck::Outcome::Still)
        facts.append({TestbedStateWords::tr("Warning"), shownWords(check->words), {}});
    for (const Message &warning : camera.warnings)
        facts.append({TestbedStateWords::tr("Warning"), shownWords(warning), {}});
    if (camera.intrinsics)
        addIntrinsics(facts, *camera.intrinsics);
    else
        facts.append({TestbedStateWords::tr("Calibration"),
                      isLensEstimated(camera)
                          ? TestbedStateWords::tr("not calibrated: estimated from the markers")
                          : TestbedStateWords::tr("not calibrated"),
                      {}});
    if (camera.registration)
        addRegistration(facts, *camera.registration);
    else
        facts.append({TestbedStateWords::tr("On the floor"),
                      TestbedStateWords::tr("not registered: cannot measure positions yet"),
                      {}});
    return facts;
}

Result<std::vector<SketchedCamera>> sketchedCameras(Project &project, const std::vector<CameraRow> &cameras,
                                                    RecordId layout)
{
    std::vector<SketchedCamera> sketched;
    for (const CameraRow &row : cameras) {
        if (!row.registration || row.registration->layout != layout)
            continue;
        const FloorView view = ODO_TRY(floorViewOf(project, *row.registration));
        const Intrinsics &intrinsics = view.camera().intrinsics();
        const Eigen::Vector3d position = view.cameraInWorld();
        const auto aim = view.floorFromPixel({intrinsics.widthPx / 2.0, intrinsics.heightPx / 2.0}, 0);
        sketched.push_back({QString::fromStdString(row.camera.name), position,
                            aim.value_or(Eigen::Vector2d(position.head<2>()))});
    }
    return sketched;
}

} // namespace odo
