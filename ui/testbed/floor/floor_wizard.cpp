// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/testbed/floor/floor_wizard.h"

#include "ui/testbed/floor/floor_source_page.h"
#include "ui/testbed/floor/marker_page.h"

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

FloorWizard::FloorWizard(std::vector<FloorCamera> cameras, const QString &current, std::vector<LayoutRecord> layouts,
                         const LiveCameras &live, KeepPicture keep, QWidget *parent)
    : StepDialog(tr("Register camera to the floor"), tr("&Save"), parent), m_cameras(std::move(cameras)), m_layouts(std::move(layouts)),
      m_source(new FloorSourcePage(m_cameras, current, m_layouts, live)), m_markers(new MarkerPage), m_keep(std::move(keep))
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

QString FloorWizard::camera() const { return m_source->camera(); }

bool FloorWizard::isComplete(int step) const
{
    return step == SourcePage ? m_source->isComplete() && !m_task.isRunning() : m_markers->registration().has_value() && !isSaving();
}

void FloorWizard::next()
{
    if (step() == MarkersPage)
        return saveAndAccept([keep = m_keep, name = camera(), frame = m_picture->frame](const JobControl &) { return keep(name, frame); });
    turnTo(MarkersPage);
    beginMarkers();
}

void FloorWizard::back()
{
    m_task.cancel();
    turnTo(SourcePage);
}

void FloorWizard::showNotSaved(const Error &error) { m_markers->showNotSaved(error); }

void FloorWizard::beginMarkers()
{
    m_markers->wait(tr("Looking for the markers…"));
    m_picture = std::make_shared<StillPicture>();
    m_task.start([picture = m_picture, origin = m_source->origin(), layout = m_layouts.at(std::size_t(m_source->layout())).layout,
                  lens = lensOf(m_cameras, camera())](const JobControl &control) -> Result<void> {
        auto taken = takeStillPicture(origin, layout, lens, control);
        if (!taken)
            return tl::unexpected(taken.error());
        *picture = std::move(*taken);
        return {};
    });
}

void FloorWizard::showPicture(const std::optional<Error> &error)
{
    if (step() == MarkersPage) {
        if (error)
            m_markers->showFailure(*error);
        else
            m_markers->begin(m_picture, m_layouts.at(std::size_t(m_source->layout())).layout, lensOf(m_cameras, camera()));
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

} // namespace odo
