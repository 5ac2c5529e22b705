// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/testbed/internal/testbed_tools.h"

#include "core/exchange/calibration_file.h"
#include "core/exchange/labelled_points.h"
#include "core/project/project.h"
#include "core/project/repositories.h"
#include "core/workflow/calibrate/calibrate_job.h"
#include "core/workflow/calibrate/cameras.h"
#include "core/workflow/calibrate/register_job.h"
#include "core/workflow/certificate/set_up_advice.h"
#include "ui/models/camera_lists.h"
#include "ui/models/shown_message.h"
#include "ui/testbed/check/accuracy_dialog.h"
#include "ui/testbed/check/camera_position_dialog.h"
#include "ui/testbed/check/length_wizard.h"
#include "ui/testbed/check/revisions_dialog.h"
#include "ui/testbed/floor/floor_wizard.h"
#include "ui/testbed/floor/layout_dialog.h"
#include "ui/testbed/internal/known_cameras.h"
#include "ui/testbed/lens/lens_wizard.h"
#include "ui/testbed/targets/target_dialog.h"
#include "ui/testbed/together/joint_dialogs.h"
#include "ui/views/widgets/command_keys.h"
#include "ui/views/widgets/form_fields.h"
#include "ui/views/widgets/theme.h"

#include <QAction>
#include <QFileDialog>
#include <QFileInfo>
#include <QInputDialog>
#include <QString>
#include <algorithm>
#include <array>
#include <string_view>

class QAction;
class QObject;

namespace odo {

/// An action with a long text for the menu and a short one for its button beneath a table.
QAction *toolAction(const QString &icon, const QString &text, const QString &shortText, const QString &tip,
                    QObject *parent)
{
    auto *action = new QAction(themeIcon(icon), text, parent);
    action->setIconText(shortText);
    action->setToolTip(tip);
    return action;
}

namespace {

/// A verdict that is not at least "usable".
std::vector<Message> warningsIn(const Message &verdict)
{
    constexpr std::array bad{std::string_view("calibration.uncertain"), std::string_view("calibration.poor"),
                             std::string_view("calibration.poor_measure_again")};
    if (std::ranges::find(bad, std::string_view(verdict.code())) != bad.end())
        return {verdict};
    for (const MessageArgument &argument : verdict.arguments)
        for (const Message &part : argument.parts)
            if (!warningsIn(part).empty())
                return {verdict};
    return {};
}

/// Before a simulated camera somebody holds a board.
Result<std::shared_ptr<CameraSource>> openWithBoard(const QString &uri)
{
    const QString address = uri.startsWith(QLatin1String("sim:")) ? uri + QLatin1String("?board") : uri;
    auto camera = ODO_TRY(openCamera(address.toStdString()));
    return std::shared_ptr<CameraSource>(std::move(camera));
}

/// The image of a registration on its way into the project: written by the wizard's thread, read by this one
/// once the wizard is closed. Unless it is committed, its destructor deletes it.
class FloorImage
{
public:
    explicit FloorImage(const std::filesystem::path &mediaFolder) : m_media(mediaFolder) {}
    KeepImage keep()
    {
        return [this](const QString &camera, const Frame &frame) -> Result<void> {
            m_stored = ODO_TRY(m_media.writeFloor(camera.toStdString(), frame));
            return {};
        };
    }
    const StoredImage &stored() const { return m_stored; }
    void commit() { m_media.keep(); }

private:
    CalibrationMedia m_media;
    StoredImage m_stored;
};

} // namespace

TestbedTools::TestbedTools(Project &project, LiveCameras &live, QWidget &window)
    : QObject(&window), m_project(project), m_live(live), m_window(window)
{
    add(Calibrate, QStringLiteral("calibrate"), tr("&Calibrate camera…"), tr("Calibrate…"),
        tr("Calibrate a camera with images of a board"), &TestbedTools::calibrate);
    add(Register, QStringLiteral("register"), tr("&Register camera…"), tr("Register…"),
        tr("Determine a camera's position from the floor markers"), &TestbedTools::registerCamera);
    add(RegisterViaCamera, QStringLiteral("register"), tr("Register via anot&her camera…"),
        tr("Via another…"),
        tr("Determine the position of a camera that sees no markers, from floor points that another camera "
           "also sees"),
        &TestbedTools::startRegisterViaCamera);
    add(RegisterJointly, QStringLiteral("register"), tr("Re&gister all cameras (joint)…"),
        tr("All cameras (joint)…"),
        tr("Fit all cameras of the selected layout jointly to make them agree, and find wrongly measured "
           "markers"),
        &TestbedTools::registerTogether);
    add(ImportCalibration, QStringLiteral("import"), tr("&Import lens calibration…"),
        tr("Import calibration…"), tr("Import a camera's lens calibration from a ROS or OpenCV YAML file"),
        &TestbedTools::importCalibration);
    add(NewLayout, QStringLiteral("add"), tr("New marker &layout…"), tr("New layout…"),
        tr("Enter the marker positions, from scratch or based on the selected layout"),
        &TestbedTools::newLayout);
    add(ImportLayout, QStringLiteral("import"), tr("Import &marker layout…"), tr("Import layout…"),
        tr("Import the marker positions from a table"), &TestbedTools::importLayout);
    add(PrintTargets, QStringLiteral("print"), tr("Print &targets…"), tr("Print…"),
        tr("Calibration boards and floor markers, to scale"), &TestbedTools::printTargets);
    nameCommands({{action(Calibrate), "calibrate"},
                  {action(Register), "register"},
                  {action(RegisterViaCamera), "registerThrough"},
                  {action(RegisterJointly), "registerTogether"},
                  {action(ImportCalibration), "importLens"},
                  {action(NewLayout), "newLayout"},
                  {action(ImportLayout), "importLayout"},
                  {action(PrintTargets), "printTargets"}});
}

void TestbedTools::add(Tool tool, const QString &icon, const QString &text, const QString &shortText,
                       const QString &tip, void (TestbedTools::*slot)())
{
    Q_ASSERT(m_actions.size() == tool);
    QAction *action = toolAction(icon, text, shortText, tip, this);
    connect(action, &QAction::triggered, this, slot);
    m_actions.append(action);
}

void TestbedTools::setCurrent(const QString &camera, const std::optional<LayoutRecord> &layout)
{
    m_camera = camera;
    m_layout = layout;
    m_actions.at(Register)->setEnabled(layout.has_value());
    m_actions.at(RegisterViaCamera)->setEnabled(layout.has_value());
    m_actions.at(RegisterJointly)->setEnabled(layout.has_value());
}

void TestbedTools::registerAgain(const QString &camera)
{
    m_camera = camera;
    registerCamera();
}

QStringList TestbedTools::cameraNames() const
{
    QStringList names;
    for (const CameraRecord &camera : m_project.cameras().all().value_or(std::vector<CameraRecord>()))
        names << QString::fromStdString(camera.name);
    return names;
}

QStringList TestbedTools::layoutNames() const
{
    QStringList names;
    for (const LayoutRecord &layout : m_project.layouts().all().value_or(std::vector<LayoutRecord>()))
        names << QString::fromStdString(layout.layout.name);
    return names;
}

void TestbedTools::calibrateBy(const QStringList &stills)
{
    std::unique_ptr<CalibrationStorage> storage; // touched by the wizard's thread, and after it by this one
    LensWizard::Callbacks callbacks;
    callbacks.open = openWithBoard;
    callbacks.keepImages = [&storage, folder = m_project.mediaFolder()](const StoredIntrinsics &intrinsics,
                                                                        const JobControl &control) {
        storage = std::make_unique<CalibrationStorage>(folder, intrinsics.camera.toStdString(),
                                                       intrinsics.calibration, intrinsics.board);
        return storage->writeImages(intrinsics.images, control);
    };
    m_live.poll();
    LensWizard wizard(cameraNames(), m_camera, m_live, std::move(callbacks), &m_window);
    if (!stills.isEmpty())
        wizard.source().addFiles(stills);
    if (wizard.exec() != QDialog::Accepted)
        return;
    const auto stored = storage->commit(m_project);
    if (!stored)
        Q_EMIT failed(stored.error());
    else
        Q_EMIT changed(tr("Camera %1 is calibrated. %2")
                           .arg(wizard.result().camera, shownWords(stored->calibration.verdict)),
                       warningsIn(stored->calibration.verdict));
}

void TestbedTools::registerCamera()
{
    auto cameras = floorCameras(m_project);
    auto layouts = m_project.layouts().all();
    if (!cameras || !layouts) {
        Q_EMIT failed(cameras ? layouts.error() : cameras.error());
        return;
    }
    // The one that is chosen comes first, for the wizard begins with it.
    std::stable_partition(layouts->begin(), layouts->end(), [this](const LayoutRecord &layout) {
        return m_layout && layout.id == m_layout->id;
    });
    m_live.poll();
    FloorImage image(m_project.mediaFolder());
    FloorWizard wizard(std::move(*cameras), m_camera, std::move(*layouts), m_live, image.keep(), &m_window);
    if (wizard.exec() != QDialog::Accepted)
        return;
    Message verdict;
    const auto stored =
        m_project.change(registerChange(wizard.camera().toStdString()), [&]() -> Result<void> {
            RegistrationRecord registration = wizard.result();
            registration.image = image.stored();
            const auto record =
                ODO_TRY(storeRegistration(m_project, wizard.camera().toStdString(), std::move(registration)));
            verdict = record.registration.verdict;
            return {};
        });
    if (!stored)
        return Q_EMIT failed(stored.error());
    image.commit();
    Q_EMIT changed(tr("Camera %1 is registered. %2").arg(wizard.camera(), shownWords(verdict)),
                   warningsIn(verdict));
}

void TestbedTools::startRegisterViaCamera()
{
    const auto cameras = floorCameras(m_project);
    const auto registered = checkCameras(m_project);
    if (!cameras || !registered) {
        Q_EMIT failed(cameras ? registered.error() : cameras.error());
        return;
    }
    if (registered->empty() || cameras->size() < 2) {
        const Message what = ODO_TEXT("ui.registration_through_another", "registration via another camera");
        Q_EMIT failed(
            (registered->empty()
                 ? fail(ErrorCode::NotFound, what,
                        ODO_TEXT("ui.no_camera_registered", "no camera is registered yet"),
                        ODO_TEXT("ui.register_one_first", "register one that sees the markers first"))
                 : fail(ErrorCode::NotFound, what,
                        ODO_TEXT("ui.only_one_camera", "the project has only one camera"),
                        ODO_TEXT("ui.calibrate_other_first",
                                 "calibrate the other one, or import a trial with it, first")))
                .value());
        return;
    }
    m_live.poll();
    FloorImage image(m_project.mediaFolder());
    RegisterViaCameraWizard wizard(*cameras, m_camera, *registered, m_live, image.keep(), &m_window);
    if (wizard.exec() != QDialog::Accepted)
        return;
    RegisterViaCameraJob job({wizard.camera().toStdString(), wizard.reference().toStdString(),
                              wizard.page().points(), image.stored()});
    if (const auto done = runToEnd(job, m_project, {}); !done)
        return Q_EMIT failed(done.error());
    image.commit();
    Q_EMIT changed(
        tr("Camera %1 is registered via camera %2. %3")
            .arg(wizard.camera(), wizard.reference(), shownWords(job.record().registration.verdict)),
        warningsIn(job.record().registration.verdict));
}

void TestbedTools::registerTogether()
{
    const std::string layout = m_layout->layout.name;
    JointDialog dialog(
        QString::fromStdString(layout),
        [&](double tapeSigmaM) -> Result<std::shared_ptr<RegisterJointJob>> {
            auto job = std::make_shared<RegisterJointJob>(RegisterJointSettings{layout, tapeSigmaM});
            ODO_TRY(job->prepare(m_project));
            return job;
        },
        &m_window);
    if (dialog.exec() != QDialog::Accepted)
        return;
    if (const auto stored = dialog.job()->commit(m_project); !stored)
        Q_EMIT failed(stored.error());
    else
        Q_EMIT changed(tr("The cameras of layout %1 are registered jointly. %2")
                           .arg(QString::fromStdString(layout), shownWords(dialog.job()->joint().verdict)));
}

void TestbedTools::importCalibration()
{
    const QString file =
        QFileDialog::getOpenFileName(&m_window, tr("Lens calibration of a camera"), {},
                                     tr("Calibrations (*.yaml *.yml *.json *.toml *.ini *.xml *.txt);;"
                                        "All files (*)"));
    if (file.isEmpty())
        return;
    const Result<std::vector<std::string>> held = camerasInCalibration(pathOf(file));
    if (!held) {
        Q_EMIT failed(held.error());
        return;
    }
    const auto choose = [this](const QString &question, const QStringList &names, const QString &likely,
                               bool mayBeNew) {
        bool accepted = false;
        const QString chosen =
            QInputDialog::getItem(&m_window, tr("Import lens calibration"), question, names,
                                  std::max(0, int(names.indexOf(likely))), mayBeNew, &accepted);
        return accepted ? chosen.trimmed() : QString();
    };
    const QString camera = choose(tr("Camera:"), cameraNames(), m_camera, true);
    if (camera.isEmpty())
        return;
    QString entry;
    if (held->size() > 1) {
        QStringList names;
        for (const std::string &name : *held)
            names << QString::fromStdString(name);
        entry =
            choose(tr("The file holds several cameras. Which one is %1?").arg(camera), names, camera, false);
        if (entry.isEmpty())
            return;
    }
    const Result<IntrinsicsRecord> imported =
        importIntrinsics(m_project, camera.toStdString(), pathOf(file), entry.toStdString());
    if (!imported)
        Q_EMIT failed(imported.error());
    else
        Q_EMIT changed(
            tr("Lens calibration of camera %1 imported from %2.").arg(camera, QFileInfo(file).fileName()));
}

void TestbedTools::newLayout()
{
    LayoutDialog dialog(m_layout ? m_layout->layout : MarkerLayout(), layoutNames(), &m_window);
    if (dialog.exec() == QDialog::Accepted)
        store(dialog.layout());
}

void TestbedTools::importLayout()
{
    const QString file =
        QFileDialog::getOpenFileName(&m_window, tr("Positions of the markers (label,x_mm,y_mm)"), {},
                                     tr("Tables (*.csv *.txt);;All files (*)"));
    if (file.isEmpty())
        return;
    Result<MarkerLayout> layout = readLayoutCsv(pathOf(file));
    if (!layout) {
        Q_EMIT failed(layout.error());
        return;
    }
    // Shown before it is stored: a table in another unit is obvious at once.
    layout->name = QFileInfo(file).completeBaseName().toStdString();
    LayoutDialog dialog(*layout, layoutNames(), &m_window);
    if (dialog.exec() == QDialog::Accepted)
        store(dialog.layout());
}

void TestbedTools::store(MarkerLayout layout)
{
    const auto added =
        changing(m_project, addLayoutWords(layout.name), [&] { return m_project.layouts().add(layout); });
    if (!added)
        Q_EMIT failed(added.error());
    else
        Q_EMIT changed(tr("Layout %1 has %2 markers.")
                           .arg(QString::fromStdString(layout.name))
                           .arg(layout.markers.size()));
}

void TestbedTools::printTargets()
{
    QStringList labels;
    if (m_layout)
        for (const Marker &marker : m_layout->layout.markers)
            labels << QString::fromStdString(marker.label);
    TargetDialog(TargetKind::Checkerboard, labels, &m_window).exec();
}

CheckTools::CheckTools(Project &project, LiveCameras &live, QWidget &window)
    : QObject(&window), m_project(project), m_live(live), m_window(window)
{
    add(Moved, QStringLiteral("moved"), tr("&Check camera positions…"), tr("Check camera positions…"),
        tr("Check before the robots run that no camera has moved since its registration"),
        &CheckTools::checkCameraPosition);
    add(Length, QStringLiteral("length"), tr("Check a known &length…"), tr("Check a known length…"),
        tr("Measure an object of known length in a camera's image to check the camera's stated uncertainty"),
        &CheckTools::checkLength);
    add(Accuracy, QStringLiteral("accuracy"), tr("&Expected accuracy…"), tr("Accuracy…"),
        tr("Show the expected uncertainty everywhere on the floor, also with planned cameras"),
        &CheckTools::showAccuracy);
    add(Revisions, QStringLiteral("revisions"), tr("&Older calibrations…"), tr("Revisions…"),
        tr("Show all calibrations and registrations of a camera, switch to an older one, reanalyse trials"),
        &CheckTools::showRevisions);
    nameCommands({{action(Moved), "checkMoved"},
                  {action(Length), "checkLength"},
                  {action(Accuracy), "expectedAccuracy"},
                  {action(Revisions), "revisions"}});
}

void CheckTools::add(Tool tool, const QString &icon, const QString &text, const QString &shortText,
                     const QString &tip, void (CheckTools::*slot)())
{
    Q_ASSERT(m_actions.size() == tool);
    QAction *action = toolAction(icon, text, shortText, tip, this);
    connect(action, &QAction::triggered, this, slot);
    m_actions.append(action);
}

void CheckTools::setCurrent(const QString &camera, const std::optional<LayoutRecord> &layout,
                            bool isRegistered)
{
    m_camera = camera;
    m_layout = layout;
    m_actions.at(Moved)->setEnabled(isRegistered);
    m_actions.at(Length)->setEnabled(isRegistered);
    m_actions.at(Revisions)->setEnabled(!camera.isEmpty());
    m_actions.at(Accuracy)->setEnabled(layout.has_value());
}

void CheckTools::checkLength()
{
    auto cameras = checkCameras(m_project);
    if (!cameras) {
        Q_EMIT failed(cameras.error());
        return;
    }
    if (cameras->empty())
        return;
    m_live.poll();
    LengthWizard(std::move(*cameras), m_camera, m_live, &m_window).exec();
}

void CheckTools::showAccuracy()
{
    auto cameras = checkCameras(m_project);
    if (!cameras) {
        Q_EMIT failed(cameras.error());
        return;
    }
    std::erase_if(*cameras,
                  [this](const CheckCamera &camera) { return camera.layout.name != m_layout->layout.name; });
    const auto asked = readSetUpQuestion(m_project, {}); // nothing where no camera is registered
    AccuracyDialog(m_layout->layout, *cameras, asked ? asked->question : PlacementQuestion(), &m_window)
        .exec();
}

void CheckTools::checkCameraPosition()
{
    auto cameras = checkCameras(m_project);
    if (!cameras) {
        Q_EMIT failed(cameras.error());
        return;
    }
    m_live.poll();
    CameraPositionDialog dialog(m_project, std::move(*cameras), m_live, &m_window);
    dialog.exec();
    if (dialog.hasChecked())
        Q_EMIT changed(tr("Cameras checked: see their badges."));
    if (!dialog.toRegister().isEmpty())
        Q_EMIT registerRequested(dialog.toRegister());
}

void CheckTools::showRevisions()
{
    QStringList names;
    for (const CameraRecord &camera : m_project.cameras().all().value_or(std::vector<CameraRecord>()))
        names << QString::fromStdString(camera.name);
    RevisionsDialog dialog(m_project, names, m_camera, &m_window);
    dialog.exec();
    if (dialog.hasChanged())
        Q_EMIT changed(tr("The chosen calibrations and analyses are now current."));
}

} // namespace odo
