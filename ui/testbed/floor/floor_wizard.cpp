// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/testbed/floor/floor_wizard.h"

#include "core/calibration/intrinsics_influence.h"
#include "ui/models/shown_message.h"
#include "ui/testbed/floor/still_image.h"
#include "ui/views/widgets/labels.h"

#include <QComboBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QVBoxLayout>
#include <algorithm>

namespace odo {

namespace {

enum Page { SourcePage, MarkersPage };

std::optional<Intrinsics> intrinsicsOf(const std::vector<FloorCamera> &cameras, const QString &name)
{
    const auto found = std::ranges::find(cameras, name, &FloorCamera::name);
    if (found == cameras.end() || !found->intrinsics)
        return std::nullopt;
    return found->intrinsics->calibration.intrinsics;
}

} // namespace

FloorWizard::FloorWizard(std::vector<FloorCamera> cameras, const QString &current,
                         std::vector<LayoutRecord> layouts, const LiveCameras &live, KeepImage keep,
                         QWidget *parent)
    : StepDialog(tr("Register camera to the floor"), tr("&Save"), parent), m_cameras(std::move(cameras)),
      m_layouts(std::move(layouts)), m_source(new FloorSourcePage(m_cameras, current, m_layouts, live)),
      m_markers(new MarkerPage), m_keep(std::move(keep))
{
    addStep(tr("The camera and its markers"), m_source);
    addStep(tr("The markers in the image"), m_markers);
    resize(1120, 680);
    connect(m_source, &FloorSourcePage::completeChanged, this, &FloorWizard::updateButtons);
    connect(m_markers, &MarkerPage::completeChanged, this, &FloorWizard::updateButtons);
    connect(&m_task, &BackgroundTask::finished, this, &FloorWizard::showImage);
    turnTo(SourcePage);
}

FloorWizard::~FloorWizard() = default;

QString FloorWizard::camera() const
{
    return m_source->camera();
}

QString FloorWizard::missing(int step) const
{
    if (step == SourcePage)
        return m_source->missing();
    return m_markers->registration() ? QString() : tr("There is no registration to save yet.");
}

bool FloorWizard::isBusy(int step) const
{
    return isSaving() || (step == SourcePage && m_task.isRunning());
}

QString FloorWizard::unsaved() const
{
    return step() != SourcePage && m_markers->registration() ? tr("the registration") : QString();
}

void FloorWizard::next()
{
    if (step() == MarkersPage)
        return saveAndAccept([keep = m_keep, name = camera(), frame = m_image->frame](const JobControl &) {
            return keep(name, frame);
        });
    turnTo(MarkersPage);
    beginMarkers();
}

void FloorWizard::back()
{
    m_task.cancel();
    turnTo(SourcePage);
}

void FloorWizard::showNotSaved(const Error &error)
{
    m_markers->showNotSaved(error);
}

void FloorWizard::beginMarkers()
{
    m_markers->wait(tr("Detecting the markers…"));
    m_image = std::make_shared<StillImage>();
    m_task.start([image = m_image, origin = m_source->origin(),
                  layout = m_layouts.at(std::size_t(m_source->layout())).layout,
                  intrinsics = intrinsicsOf(m_cameras, camera())](const JobControl &control) -> Result<void> {
        *image = ODO_TRY(takeStillImage(origin, layout, intrinsics, control));
        return {};
    });
}

void FloorWizard::showImage(const std::optional<Error> &error)
{
    if (step() == MarkersPage) {
        if (error)
            m_markers->showFailure(*error);
        else
            m_markers->begin(m_image, m_layouts.at(std::size_t(m_source->layout())).layout,
                             intrinsicsOf(m_cameras, camera()));
    }
    updateButtons();
}

RegistrationRecord FloorWizard::result() const
{
    RegistrationRecord record;
    record.layout = m_layouts.at(std::size_t(m_source->layout())).id;
    const auto found = std::ranges::find(m_cameras, camera(), &FloorCamera::name);
    if (found != m_cameras.end() && found->intrinsics)
        record.intrinsics = found->intrinsics->id;
    record.pixels = m_markers->pixels();
    record.registration = *m_markers->registration();
    record.assumedIntrinsics = record.registration.intrinsics;
    return record;
}

void FloorWizard::done(int result)
{
    m_task.cancel();
    StepDialog::done(result);
}

FloorSourcePage::FloorSourcePage(const std::vector<FloorCamera> &cameras, const QString &current,
                                 const std::vector<LayoutRecord> &layouts, const LiveCameras &live,
                                 QWidget *parent)
    : QWidget(parent), m_cameras(cameras), m_camera(new QComboBox), m_layout(new QComboBox),
      m_image(new ImageChoice(live, tr("Image or video of the markers"))), m_intrinsics(new QLabel),
      m_badge(new BadgeLabel({}))
{
    m_camera->setEditable(true); // a camera that was never calibrated may be new here
    for (const FloorCamera &camera : m_cameras)
        m_camera->addItem(camera.name);
    m_camera->setCurrentText(current);
    for (const LayoutRecord &layout : layouts)
        m_layout->addItem(QString::fromStdString(layout.layout.name));
    m_intrinsics->setObjectName(QStringLiteral("quiet"));
    m_intrinsics->setWordWrap(true);
    auto *intro = new QLabel(tr("Markers with known floor positions determine the camera position. Four are "
                                "enough; a fifth checks them. Do not move the camera afterwards."));
    intro->setWordWrap(true);
    auto *form = new QFormLayout;
    form->addRow(tr("C&amera"), m_camera);
    form->addRow(QString(), m_badge);
    form->addRow(QString(), m_intrinsics);
    form->addRow(tr("Marker &layout"), m_layout);
    auto *where = new QLabel(tr("Image of the markers"));
    where->setStyleSheet(QStringLiteral("font-weight: 600"));
    auto *layout = new QVBoxLayout(this);
    layout->addWidget(intro);
    layout->addSpacing(8);
    layout->addLayout(form);
    layout->addSpacing(12);
    layout->addWidget(where);
    layout->addWidget(m_image);
    layout->addStretch(1);
    connect(m_camera, &QComboBox::editTextChanged, this, &FloorSourcePage::showCamera);
    connect(m_image, &ImageChoice::changed, this, &FloorSourcePage::completeChanged);
    showCamera();
}

const FloorCamera *FloorSourcePage::known() const
{
    const auto found = std::ranges::find(m_cameras, camera(), &FloorCamera::name);
    return found == m_cameras.end() ? nullptr : &*found;
}

void FloorSourcePage::showCamera()
{
    const FloorCamera *camera = known();
    m_badge->setBadge(camera ? camera->badge : Badge());
    m_image->setRecording(camera ? camera->newestRecording : std::nullopt);
    m_intrinsics->setText(
        camera && camera->intrinsics
            ? tr("Its lens is calibrated.")
            : tr("Its lens is not calibrated. Odograph estimates it from the markers, as far as they "
                 "determine it."));
    Q_EMIT completeChanged();
}

QString FloorSourcePage::camera() const
{
    return m_camera->currentText().trimmed();
}
int FloorSourcePage::layout() const
{
    return m_layout->currentIndex();
}

ImageOrigin FloorSourcePage::origin() const
{
    return m_image->origin();
}
void FloorSourcePage::setFile(const QString &file)
{
    m_image->setFile(file);
}
QString FloorSourcePage::missing() const
{
    if (camera().isEmpty())
        return tr("Name the camera, such as A.");
    if (layout() < 0)
        return tr("Add a marker layout first.");
    return m_image->isComplete() ? QString() : tr("Choose an image or a video of the markers.");
}

} // namespace odo
