// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/review/review_column.h"

#include "ui/review/range_card.h"
#include "ui/review/trial_facts.h"
#include "ui/views/card.h"
#include "ui/views/fact_list.h"
#include "ui/views/result_panel.h"
#include "ui/views/spike_list.h"
#include "ui/views/theme_icon.h"

#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QVBoxLayout>

namespace odo {
namespace {

constexpr int columnWidth = 308;

bool isTracked(const TrialScene &scene)
{
    return std::any_of(scene.robots.begin(), scene.robots.end(),
                       [](const SceneRobot &robot) { return robot.analysis.has_value(); });
}

} // namespace

ReviewColumn::ReviewColumn(Timeline &timeline, QWidget *chooser, QWidget *parent)
    : QWidget(parent), m_track(makeTrackCard()), m_result(new ResultPanel), m_spikes(new SpikeList(timeline)),
      m_range(new RangeCard(timeline)), m_trial(new Card(tr("Trial"))), m_facts(new FactList(FactList::Badges::Beneath))
{
    auto *scroll = scrolled(m_facts, tr("Facts of the trial"));
    scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_trial->setContent(scroll);

    auto *layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(8);
    layout->addWidget(chooser);
    layout->addWidget(m_track);
    layout->addWidget(m_result);
    layout->addWidget(m_spikes, 2);
    layout->addWidget(m_range, 5);
    layout->addWidget(m_trial, 3);
    connect(m_range, &RangeCard::shownChanged, m_trial, &QWidget::setHidden);
    setFixedWidth(columnWidth);
    setScene(nullptr);
}

Card *ReviewColumn::makeTrackCard()
{
    auto *content = new QWidget;
    auto *text = new QLabel(
        tr("This trial has not been tracked yet. Tracking follows the robot through the videos and "
           "works out where it was and how fast."));
    text->setTextFormat(Qt::PlainText);
    text->setWordWrap(true);
    auto *button = new QPushButton(themeIcon(QStringLiteral("track"), Qt::white), tr("Track…"));
    button->setObjectName(QStringLiteral("trackButton"));
    button->setProperty("primary", true);
    button->setMinimumHeight(40);
    connect(button, &QPushButton::clicked, this, &ReviewColumn::trackRequested);
    auto *layout = new QVBoxLayout(content);
    layout->setContentsMargins(12, 10, 12, 12);
    layout->setSpacing(10);
    layout->addWidget(text);
    layout->addWidget(button);
    auto *card = new Card(tr("Result"));
    card->setContent(content);
    return card;
}

void ReviewColumn::setScene(const TrialScenePtr &scene)
{
    const bool tracked = scene && isTracked(*scene);
    m_track->setVisible(scene && !tracked);
    m_result->setVisible(tracked);
    m_spikes->setVisible(tracked);
    m_result->setScene(scene);
    m_spikes->setScene(scene);
    m_range->setScene(scene);
    m_facts->setFacts(scene ? trialFacts(*scene) : QList<Fact>());
}

} // namespace odo
