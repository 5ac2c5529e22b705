// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/record/live_board.h"

#include "ui/record/health_words.h"
#include "ui/record/live_map.h"
#include "ui/record/live_picture_area.h"
#include "ui/views/action_button.h"
#include "ui/views/card.h"

#include <QAction>
#include <QLocale>
#include <QPushButton>
#include <QScrollArea>
#include <QSplitter>
#include <QVBoxLayout>
#include <algorithm>

namespace odo {

LiveBoard::LiveBoard(const QList<QAction *> &tools, QWidget *parent)
    : QWidget(parent), m_pictures(new QSplitter), m_mapCard(new Card(tr("Top-down map"))), m_map(new LiveMap), m_health(new FactList)
{
    setTarget({});
    m_mapCard->setContent(m_map);
    auto *scroll = scrolled(m_health, tr("How cameras, map and disk do"));
    scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    auto *healthCard = new Card(tr("Health"));
    healthCard->setContent(scroll);
    for (QAction *tool : tools)
        healthCard->addToHeader(actionButton(tool, tool->iconText()));
    auto *below = new QSplitter;
    below->addWidget(m_mapCard);
    below->addWidget(healthCard);
    below->setSizes({500, 420});
    auto *all = new QSplitter(Qt::Vertical);
    all->addWidget(m_pictures);
    all->addWidget(below);
    all->setSizes({330, 390});
    for (QSplitter *each : {m_pictures, below, all}) {
        each->setHandleWidth(8);
        each->setChildrenCollapsible(false);
    }
    auto *layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(all);
}

void LiveBoard::setCameras(const RunningCameras &running)
{
    const auto &cameras = running.cameras();
    while (m_areas.size() > cameras.size()) {
        delete m_cards.back();
        m_cards.pop_back();
        m_areas.pop_back();
    }
    while (m_areas.size() < cameras.size()) {
        auto *area = new LivePictureArea;
        auto *card = new Card({});
        card->setContent(area);
        m_pictures->addWidget(card);
        connect(
            area, &LivePictureArea::shownSizeChanged, this,
            [this, view = m_areas.size()](const QSize &pixels) { Q_EMIT shownSizeChanged(view, pixels); });
        m_areas.push_back(area);
        m_cards.push_back(card);
    }
    for (std::size_t v = 0; v < cameras.size(); ++v) {
        const QString title = tr("Camera %1").arg(QString::fromStdString(cameras[v].name));
        m_cards[v]->setTitle(title);
        m_areas[v]->setAccessibleName(tr("Live picture of %1").arg(title));
        m_cards[v]->setBadge(cameras[v].floorView ? Badge{}
                                                  : Badge{tr("not registered"), BadgeState::Warning});
        if (running.isOpening())
            m_areas[v]->setWords(tr("Opening the camera…"));
        Q_EMIT shownSizeChanged(v, (QSizeF(m_areas[v]->size()) * devicePixelRatioF()).toSize());
    }
}

void LiveBoard::setTarget(const std::optional<BroadcastTarget> &target)
{
    m_mapCard->setRemark(target ? tr("live, sent to %1").arg(QString::fromStdString(target->address) + u':' + QString::number(target->port)) : tr("live"));
}

void LiveBoard::setFloor(const TrialScenePtr &floor)
{
    for (std::size_t v = 0; v < m_areas.size(); ++v)
        m_areas[v]->setFloor(floor, v);
    m_map->setFloor(floor);
}

void LiveBoard::setRobots(const std::vector<RobotRecord> &robots)
{
    m_map->setRobots(robots);
    for (LivePictureArea *area : m_areas)
        area->setRobots(robots);
}

void LiveBoard::setPicture(const LivePicture &picture)
{
    if (picture.view < m_areas.size())
        m_areas[picture.view]->setPicture(picture);
}

void LiveBoard::addMoment(const LiveMoment &moment)
{
    m_map->addPosition(moment.robot, moment.position);
    if (!moment.position.point.valid)
        return;
    for (LivePictureArea *area : m_areas)
        area->addPlace(moment.robot, moment.position.point.position);
}

void LiveBoard::forgetWays()
{
    m_map->forgetWays();
    for (LivePictureArea *area : m_areas)
        area->forgetWays();
}

void LiveBoard::setHealth(const CaptureHealth &health, const std::vector<WantedCamera> &cameras,
                          const LiveFigures &live, const CaptureHealth &before)
{
    m_health->setFacts(healthFacts(health, cameras, live, m_map->robots(), before));
    for (std::size_t v = 0; v < std::min(m_areas.size(), health.views.size()); ++v) {
        const ViewHealth &view = health.views[v];
        const bool delivers = view.state == ViewHealth::State::Delivering;
        m_areas[v]->setWords(delivers ? QString()
                             : view.state == ViewHealth::State::Starting
                                 ? tr("Waiting for the first picture…")
                                 : tr("No picture now"));
        m_cards[v]->setRemark(
            delivers ? tr("%1 frames/s").arg(locale().toString(view.framesPerSecond, 'f', 1)) : QString());
    }
}

} // namespace odo
