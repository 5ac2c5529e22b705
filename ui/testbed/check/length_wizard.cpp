// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/testbed/check/length_wizard.h"

#include "ui/testbed/check/length_page.h"
#include "ui/testbed/floor/picture_choice.h"
#include "ui/views/badge_label.h"

#include <QComboBox>
#include <QFormLayout>
#include <QLabel>
#include <QVBoxLayout>

namespace odo {
namespace {

enum Page { SourcePage, EndsPage };

} // namespace

LengthWizard::LengthWizard(std::vector<CheckCamera> cameras, const QString &current,
                           const LiveCameras &live, QWidget *parent)
    : StepDialog(tr("Check a known length"), tr("&Done"), parent), m_cameras(std::move(cameras)), m_camera(new QComboBox), m_badge(new BadgeLabel({})),
      m_choice(new PictureChoice(live, tr("Picture or video of the length"))), m_page(new LengthPage)
{
    addStep(tr("The camera and its picture"), makeSource(current));
    addStep(tr("Both ends of the length"), m_page);
    resize(1120, 680);
    connect(m_choice, &PictureChoice::changed, this, &LengthWizard::updateButtons);
    connect(m_camera, &QComboBox::currentIndexChanged, this, &LengthWizard::showCamera);
    connect(&m_task, &BackgroundTask::finished, this, [this](const std::optional<Error> &error) {
        if (step() == EndsPage && error)
            m_page->showFailure(*error);
        else if (step() == EndsPage)
            m_page->begin(m_picture, camera());
        updateButtons();
    });
    turnTo(SourcePage);
}

LengthWizard::~LengthWizard() = default;

QWidget *LengthWizard::makeSource(const QString &current)
{
    for (const CheckCamera &camera : m_cameras)
        m_camera->addItem(camera.name);
    m_camera->setCurrentIndex(std::max(0, m_camera->findText(current)));
    showCamera();
    auto *intro = new QLabel(tr("Lay something of known length on the floor, away from the markers, and see whether the camera measures it as "
                                "well as it promises. Nothing is changed by it."));
    intro->setWordWrap(true);
    auto *form = new QFormLayout;
    form->addRow(tr("C&amera"), m_camera);
    form->addRow(QString(), m_badge);
    auto *where = new QLabel(tr("Where the length is seen"));
    where->setStyleSheet(QStringLiteral("font-weight: 600"));
    auto *page = new QWidget;
    page->setFocusProxy(m_camera);
    auto *layout = new QVBoxLayout(page);
    layout->addWidget(intro);
    layout->addSpacing(8);
    layout->addLayout(form);
    layout->addSpacing(12);
    layout->addWidget(where);
    layout->addWidget(m_choice);
    layout->addStretch(1);
    return page;
}

void LengthWizard::showCamera()
{
    m_choice->setRecording(camera().newestRecording);
    m_badge->setBadge(camera().badge);
}

const CheckCamera &LengthWizard::camera() const { return m_cameras.at(std::size_t(m_camera->currentIndex())); }

bool LengthWizard::isComplete(int step) const
{
    return step == EndsPage || (m_choice->isComplete() && !m_task.isRunning());
}

void LengthWizard::next()
{
    if (step() == EndsPage)
        return accept();
    turnTo(EndsPage);
    takePicture();
}

void LengthWizard::back()
{
    m_task.cancel();
    turnTo(SourcePage);
}

void LengthWizard::takePicture()
{
    m_page->wait(tr("Getting the picture…"));
    m_picture = std::make_shared<StillPicture>();
    m_task.start([picture = m_picture, origin = m_choice->origin(),
                  lens = camera().view.camera().intrinsics()](const JobControl &control) -> Result<void> {
        auto taken = takeStillPicture(origin, {}, lens, control);
        if (!taken)
            return tl::unexpected(taken.error());
        *picture = std::move(*taken);
        return {};
    });
}

void LengthWizard::done(int result)
{
    m_task.cancel();
    StepDialog::done(result);
}

} // namespace odo
