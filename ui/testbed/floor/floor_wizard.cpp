// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/testbed/floor/floor_wizard.h"

#include "ui/testbed/floor/marker_page.h"
#include "ui/testbed/floor/still_picture.h"
#include "ui/views/widgets/labels.h"

#include <QComboBox>
#include <QFormLayout>
#include <QLabel>
#include <QVBoxLayout>
#include <algorithm>

namespace odo {

namespace {

enum Page { SourcePage, MarkersPage };

std::optional<Intrinsics> lensOf(const std::vector<FloorCamera> &cameras, const QString &name)
{
    const auto found = std::ranges::find(cameras, name, &FloorCamera::name);
    if (found == cameras.end() || !found->intrinsics)
        return std::nullopt;
    return found->intrinsics->calibration.intrinsics;
}

} // namespace

FloorWizard::FloorWizard(std::vector<FloorCamera> cameras, const QString &current,
                         std::vector<LayoutRecord> layouts, const LiveCameras &live, KeepPicture keep,
                         QWidget *parent)
    : StepDialog(tr("Register camera to the floor"), tr("&Save"), parent), m_cameras(std::move(cameras)),
      m_layouts(std::move(layouts)), m_source(new FloorSourcePage(m_cameras, current, m_layouts, live)),
      m_markers(new MarkerPage), m_keep(std::move(keep))
{
    addStep(tr("The camera and its markers"), m_source);
    addStep(tr("The markers in the picture"), m_markers);
    resize(1120, 680);
    connect(m_source, &FloorSourcePage::completeChanged, this, &FloorWizard::updateButtons);
    connect(m_markers, &MarkerPage::completeChanged, this, &FloorWizard::updateButtons);
    connect(&m_task, &BackgroundTask::finished, this, &FloorWizard::showPicture);
    turnTo(SourcePage);
}

FloorWizard::~FloorWizard() = default;

QString FloorWizard::camera() const
{
    return m_source->camera();
}

bool FloorWizard::isComplete(int step) const
{
    return step == SourcePage ? m_source->isComplete() && !m_task.isRunning()
                              : m_markers->registration().has_value() && !isSaving();
}

void FloorWizard::next()
{
    if (step() == MarkersPage)
        return saveAndAccept([keep = m_keep, name = camera(), frame = m_picture->frame](const JobControl &) {
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
    m_markers->wait(tr("Looking for the markers…"));
    m_picture = std::make_shared<StillPicture>();
    m_task.start([picture = m_picture, origin = m_source->origin(),
                  layout = m_layouts.at(std::size_t(m_source->layout())).layout,
                  lens = lensOf(m_cameras, camera())](const JobControl &control) -> Result<void> {
        auto taken = ODO_TRY(takeStillPicture(origin, layout, lens, control));
        *picture = std::move(taken);
        return {};
    });
}

void FloorWizard::showPicture(const std::optional<Error> &error)
{
    if (step() == MarkersPage) {
        if (error)
            m_markers->showFailure(*error);
        else
            m_markers->begin(m_picture, m_layouts.at(std::size_t(m_source->layout())).layout,
                             lensOf(m_cameras, camera()));
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
      m_picture(new PictureChoice(live, tr("Picture or video of the markers"))), m_lens(new QLabel),
      m_badge(new BadgeLabel({}))
{
    m_camera->setEditable(true); // one whose lens was never measured may be new here
    for (const FloorCamera &camera : m_cameras)
        m_camera->addItem(camera.name);
    m_camera->setCurrentText(current);
    for (const LayoutRecord &layout : layouts)
        m_layout->addItem(QString::fromStdString(layout.layout.name));
    m_lens->setObjectName(QStringLiteral("quiet"));
    m_lens->setWordWrap(true);
    auto *intro = new QLabel(tr("Markers whose places on the floor are known tell where the camera stands. "
                                "Four are enough, a fifth checks "
                                "them. Afterwards the camera must not be moved."));
    intro->setWordWrap(true);
    auto *form = new QFormLayout;
    form->addRow(tr("C&amera"), m_camera);
    form->addRow(QString(), m_badge);
    form->addRow(QString(), m_lens);
    form->addRow(tr("Marker &layout"), m_layout);
    auto *where = new QLabel(tr("Where the markers are seen"));
    where->setStyleSheet(QStringLiteral("font-weight: 600"));
    auto *layout = new QVBoxLayout(this);
    layout->addWidget(intro);
    layout->addSpacing(8);
    layout->addLayout(form);
    layout->addSpacing(12);
    layout->addWidget(where);
    layout->addWidget(m_picture);
    layout->addStretch(1);
    connect(m_camera, &QComboBox::editTextChanged, this, &FloorSourcePage::showCamera);
    connect(m_picture, &PictureChoice::changed, this, &FloorSourcePage::completeChanged);
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
    m_picture->setRecording(camera ? camera->newestRecording : std::nullopt);
    m_lens->setText(camera && camera->intrinsics
                        ? tr("Its lens is measured.")
                        : tr("Its lens was not measured: it is taken as free of distortion, and its focal "
                             "length is estimated from the markers where they tell it."));
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

PictureOrigin FloorSourcePage::origin() const
{
    return m_picture->origin();
}
void FloorSourcePage::setFile(const QString &file)
{
    m_picture->setFile(file);
}
bool FloorSourcePage::isComplete() const
{
    return !camera().isEmpty() && layout() >= 0 && m_picture->isComplete();
}

} // namespace odo
