// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/testbed/together/through_wizard.h"

#include "ui/testbed/floor/picture_choice.h"

namespace odo {
namespace {

enum Page { SourcePage, PointsPage };

} // namespace

ThroughWizard::ThroughWizard(const std::vector<FloorCamera> &cameras, const QString &current, const std::vector<CheckCamera> &registered,
                             const LiveCameras &live, KeepPicture keep, QWidget *parent)
    : StepDialog(tr("Register through another camera"), tr("&Save"), parent),
      m_source(new ThroughSourcePage(cameras, current, registered, live)), m_page(new SharedPointsPage), m_keep(std::move(keep))
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
    return step == SourcePage ? m_source->isComplete() && !m_task.isRunning() : m_page->registration().has_value() && !isSaving();
}

void ThroughWizard::next()
{
    if (step() == PointsPage)
        return saveAndAccept([keep = m_keep, name = camera(), frame = m_pictures->camera.frame](const JobControl &) { return keep(name, frame); });
    turnTo(PointsPage);
    takePictures();
}

void ThroughWizard::back()
{
    m_task.cancel();
    turnTo(SourcePage);
}

void ThroughWizard::showNotSaved(const Error &error) { m_page->showNotSaved(error); }

void ThroughWizard::takePictures()
{
    m_page->wait(tr("Getting the pictures…"));
    m_pictures = std::make_shared<PicturePair>();
    const auto &intrinsics = m_source->camera().intrinsics;
    const std::optional<Intrinsics> lens = intrinsics ? std::optional(intrinsics->calibration.intrinsics) : std::nullopt;
    m_task.start([pictures = m_pictures, lens, origin = m_source->picture().origin(), throughOrigin = m_source->throughPicture().origin(),
                  throughLens = m_source->through().view.camera().intrinsics(),
                  layout = m_source->through().layout](const JobControl &control) -> Result<void> {
        auto taken = takeStillPicture(origin, layout, lens, control);
        if (!taken)
            return tl::unexpected(taken.error());
        auto throughTaken = takeStillPicture(throughOrigin, layout, throughLens, control);
        if (!throughTaken)
            return tl::unexpected(throughTaken.error());
        *pictures = {std::move(*taken), std::move(*throughTaken)};
        return {};
    });
}

void ThroughWizard::done(int result)
{
    m_task.cancel();
    StepDialog::done(result);
}

} // namespace odo
