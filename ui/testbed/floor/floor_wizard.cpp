// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/testbed/floor/floor_wizard.h"

#include "ui/testbed/floor/floor_source_page.h"
#include "ui/testbed/floor/marker_page.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QStackedWidget>
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

FloorWizard::FloorWizard(std::vector<FloorCamera> cameras, const QString &current, std::vector<LayoutRecord> layouts,
                         const std::vector<std::pair<QString, QString>> &live, QWidget *parent)
    : QDialog(parent), m_cameras(std::move(cameras)), m_layouts(std::move(layouts)),
      m_source(new FloorSourcePage(m_cameras, current, m_layouts, live)), m_markers(new MarkerPage), m_pages(new QStackedWidget),
      m_title(new QLabel), m_steps(new QLabel), m_back(new QPushButton(tr("< &Back"))), m_next(new QPushButton),
      m_cancel(new QPushButton(tr("Cancel")))
{
    setWindowTitle(tr("Register camera to the floor"));
    m_title->setStyleSheet(QStringLiteral("font-size: 16pt; font-weight: 600"));
    m_steps->setObjectName(QStringLiteral("quiet"));
    m_pages->addWidget(m_source);
    m_pages->addWidget(m_markers);
    auto *head = new QHBoxLayout;
    head->addWidget(m_title);
    head->addStretch(1);
    head->addWidget(m_steps);
    auto *buttons = new QHBoxLayout;
    buttons->addStretch(1);
    for (QPushButton *button : {m_back, m_next, m_cancel}) {
        button->setAutoDefault(false);
        buttons->addWidget(button);
    }
    m_next->setProperty("primary", true);
    auto *layout = new QVBoxLayout(this);
    layout->setContentsMargins(16, 12, 16, 12);
    layout->addLayout(head);
    layout->addSpacing(6);
    layout->addWidget(m_pages, 1);
    layout->addLayout(buttons);
    m_next->setDefault(true);
    resize(1120, 680);
    connect(m_next, &QPushButton::clicked, this, &FloorWizard::next);
    connect(m_back, &QPushButton::clicked, this, [this] {
        m_task.cancel();
        turnTo(SourcePage);
    });
    connect(m_cancel, &QPushButton::clicked, this, &QDialog::reject);
    connect(m_source, &FloorSourcePage::completeChanged, this, &FloorWizard::updateButtons);
    connect(m_markers, &MarkerPage::completeChanged, this, &FloorWizard::updateButtons);
    connect(&m_task, &BackgroundTask::finished, this, &FloorWizard::showPicture);
    turnTo(SourcePage);
}

FloorWizard::~FloorWizard() = default;

QString FloorWizard::camera() const { return m_source->camera(); }

void FloorWizard::turnTo(int page)
{
    m_title->setText(page == SourcePage ? tr("The camera and its markers") : tr("The markers in the picture"));
    m_steps->setText(tr("step %1 of 2").arg(page + 1));
    m_pages->setCurrentIndex(page);
    m_next->setText(page == SourcePage ? tr("&Next >") : tr("&Save"));
    updateButtons();
    m_pages->currentWidget()->setFocus();
}

void FloorWizard::updateButtons()
{
    const bool first = m_pages->currentIndex() == SourcePage;
    m_back->setEnabled(!first);
    m_next->setEnabled(first ? m_source->isComplete() && !m_task.isRunning() : m_markers->registration().has_value());
}

void FloorWizard::next()
{
    if (m_pages->currentIndex() == MarkersPage)
        return accept();
    turnTo(MarkersPage);
    beginMarkers();
}

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
    if (m_pages->currentIndex() == MarkersPage) {
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
    QDialog::done(result);
}

} // namespace odo
