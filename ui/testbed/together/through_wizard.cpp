// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/testbed/together/through_wizard.h"

#include "ui/testbed/floor/still_picture.h"

#include <QComboBox>
#include <QFormLayout>
#include <QGroupBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QVBoxLayout>
#include <algorithm>

namespace odo {

ThroughSourcePage::ThroughSourcePage(const std::vector<FloorCamera> &cameras, const QString &current,
                                     const std::vector<CheckCamera> &registered, const LiveCameras &live,
                                     QWidget *parent)
    : QWidget(parent), m_cameras(cameras), m_registered(registered), m_camera(new QComboBox),
      m_through(new QComboBox),
      m_picture(new PictureChoice(live, tr("Picture or video of the camera to register"))),
      m_throughPicture(new PictureChoice(live, tr("Picture or video of the registered camera"))),
      m_same(new QLabel(tr("A camera cannot be registered through itself: choose two different ones.")))
{
    for (const FloorCamera &camera : m_cameras)
        m_camera->addItem(camera.name);
    for (const CheckCamera &camera : m_registered)
        m_through->addItem(camera.name);
    m_camera->setCurrentIndex(std::max(0, m_camera->findText(current)));
    if (m_through->currentText() == m_camera->currentText() && m_through->count() > 1)
        m_through->setCurrentIndex(1);
    m_camera->setAccessibleName(tr("Camera to register"));
    m_through->setAccessibleName(tr("Registered camera"));
    auto *intro = new QLabel(tr("A camera that sees no markers can be registered by points of the floor that "
                                "a registered camera sees as "
                                "well: corners of tiles, ends of tape, screws. Four are enough, six or more "
                                "spread over the common part "
                                "are better. Neither camera may be moved afterwards."));
    intro->setWordWrap(true);
    auto *form = new QFormLayout;
    form->addRow(tr("C&amera to register"), m_camera);
    form->addRow(tr("&Through camera"), m_through);
    form->addRow(QString(), m_same);
    auto *pictures = new QHBoxLayout;
    for (const auto &[title, choice] : {std::pair(tr("Its picture"), m_picture),
                                        std::pair(tr("The registered camera's picture"), m_throughPicture)}) {
        auto *box = new QGroupBox(title);
        auto *boxLayout = new QVBoxLayout(box);
        boxLayout->addWidget(choice);
        pictures->addWidget(box, 1);
    }
    setFocusProxy(m_camera);
    auto *layout = new QVBoxLayout(this);
    layout->addWidget(intro);
    layout->addSpacing(8);
    layout->addLayout(form);
    layout->addSpacing(12);
    layout->addLayout(pictures);
    layout->addStretch(1);
    for (QComboBox *box : {m_camera, m_through})
        connect(box, &QComboBox::currentIndexChanged, this, &ThroughSourcePage::showCameras);
    for (PictureChoice *choice : {m_picture, m_throughPicture})
        connect(choice, &PictureChoice::changed, this, &ThroughSourcePage::completeChanged);
    showCameras();
}

const FloorCamera &ThroughSourcePage::camera() const
{
    return m_cameras.at(std::size_t(m_camera->currentIndex()));
}
const CheckCamera &ThroughSourcePage::through() const
{
    return m_registered.at(std::size_t(m_through->currentIndex()));
}

void ThroughSourcePage::showCameras()
{
    m_picture->setRecording(camera().newestRecording);
    m_throughPicture->setRecording(through().newestRecording);
    m_same->setVisible(camera().name == through().name);
    Q_EMIT completeChanged();
}

bool ThroughSourcePage::isComplete() const
{
    return camera().name != through().name && m_picture->isComplete() && m_throughPicture->isComplete();
}

namespace {

enum Page { SourcePage, PointsPage };

} // namespace

ThroughWizard::ThroughWizard(const std::vector<FloorCamera> &cameras, const QString &current,
                             const std::vector<CheckCamera> &registered, const LiveCameras &live,
                             KeepPicture keep, QWidget *parent)
    : StepDialog(tr("Register through another camera"), tr("&Save"), parent),
      m_source(new ThroughSourcePage(cameras, current, registered, live)), m_page(new SharedPointsPage),
      m_keep(std::move(keep))
{
    addStep(tr("Two cameras and their pictures"), m_source);
    addStep(tr("The same points in both pictures"), m_page);
    resize(1180, 760);
    connect(m_source, &ThroughSourcePage::completeChanged, this, &ThroughWizard::updateButtons);
    connect(m_page, &SharedPointsPage::completeChanged, this, &ThroughWizard::updateButtons);
    connect(&m_task, &BackgroundTask::finished, this, [this](const std::optional<Error> &error) {
        if (step() == PointsPage && error)
            m_page->showFailure(*error);
        else if (step() == PointsPage)
            m_page->begin(m_pictures, m_source->camera(), m_source->through());
        updateButtons();
    });
    turnTo(SourcePage);
}

ThroughWizard::~ThroughWizard() = default;

bool ThroughWizard::isComplete(int step) const
{
    return step == SourcePage ? m_source->isComplete() && !m_task.isRunning()
                              : m_page->registration().has_value() && !isSaving();
}

void ThroughWizard::next()
{
    if (step() == PointsPage)
        return saveAndAccept([keep = m_keep, name = camera(), frame = m_pictures->camera.frame](
                                 const JobControl &) { return keep(name, frame); });
    turnTo(PointsPage);
    takePictures();
}

void ThroughWizard::back()
{
    m_task.cancel();
    turnTo(SourcePage);
}

void ThroughWizard::showNotSaved(const Error &error)
{
    m_page->showNotSaved(error);
}

void ThroughWizard::takePictures()
{
    m_page->wait(tr("Getting the pictures…"));
    m_pictures = std::make_shared<PicturePair>();
    const auto &intrinsics = m_source->camera().intrinsics;
    const std::optional<Intrinsics> lens =
        intrinsics ? std::optional(intrinsics->calibration.intrinsics) : std::nullopt;
    m_task.start([pictures = m_pictures, lens, origin = m_source->picture().origin(),
                  throughOrigin = m_source->throughPicture().origin(),
                  throughLens = m_source->through().view.camera().intrinsics(),
                  layout = m_source->through().layout](const JobControl &control) -> Result<void> {
        auto taken = ODO_TRY(takeStillPicture(origin, layout, lens, control));
        auto throughTaken = ODO_TRY(takeStillPicture(throughOrigin, layout, throughLens, control));
        *pictures = {std::move(taken), std::move(throughTaken)};
        return {};
    });
}

void ThroughWizard::done(int result)
{
    m_task.cancel();
    StepDialog::done(result);
}

} // namespace odo
