// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/review/review_column.h"

#include "ui/models/shown_names.h"
#include "ui/review/internal/range_card.h"
#include "ui/review/internal/trial_facts.h"
#include "ui/views/widgets/card.h"
#include "ui/views/widgets/command_keys.h"
#include "ui/views/widgets/fact_list.h"
#include "ui/views/widgets/figure_grid.h"
#include "ui/views/widgets/spike_list.h"
#include "ui/views/widgets/theme.h"

#include <QAction>
#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QToolButton>
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
      m_range(new RangeCard(timeline)), m_trial(new Card(tr("Trial"))),
      m_facts(new FactList(FactList::Badges::Beneath))
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

namespace {

QToolButton *buttonFor(QAction *action, QWidget *parent)
{
    auto *button = new QToolButton(parent);
    button->setDefaultAction(action);
    button->setProperty("flat", true);
    button->setFocusPolicy(Qt::TabFocus);
    button->setAccessibleName(action->text().remove(QLatin1Char('&')));
    return button;
}

} // namespace

TrialChooser::TrialChooser(QWidget *parent)
    : QWidget(parent), m_trials(new QComboBox(this)),
      m_previous(new QAction(themeIcon(QStringLiteral("previous")), tr("&Previous trial"), this)),
      m_next(new QAction(themeIcon(QStringLiteral("next")), tr("&Next trial"), this))
{
    m_trials->setAccessibleName(tr("Trial"));
    // chosen from by the mouse it takes no focus, and Space goes on playing
    m_trials->setFocusPolicy(Qt::TabFocus);
    m_trials->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    m_trials->setMinimumContentsLength(8);
    nameCommands({{m_previous, "previousTrial"}, {m_next, "nextTrial"}});
    m_previous->setShortcut(QKeySequence(Qt::CTRL | Qt::Key_PageUp));
    m_next->setShortcut(QKeySequence(Qt::CTRL | Qt::Key_PageDown));
    auto *layout = new QHBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(4);
    layout->addWidget(buttonFor(m_previous, this));
    layout->addWidget(m_trials, 1);
    layout->addWidget(buttonFor(m_next, this));
    connect(m_trials, &QComboBox::activated, this,
            [this](int index) { Q_EMIT chosen(m_trials->itemData(index).toString()); });
    connect(m_previous, &QAction::triggered, this, [this] { step(-1); });
    connect(m_next, &QAction::triggered, this, [this] { step(1); });
    updateActions();
}

void TrialChooser::setTrials(const QStringList &names, const QStringList &words)
{
    const QString current = m_trials->currentData().toString();
    m_trials->setModel(new NameListModel(names, words, m_trials)); // the one before goes with it
    setCurrent(current);
}

void TrialChooser::setCurrent(const QString &name)
{
    const auto *model = qobject_cast<NameListModel *>(m_trials->model());
    m_trials->setCurrentIndex(model ? model->indexOf(name) : -1);
    m_trials->setToolTip(m_trials->currentText().toHtmlEscaped());
    updateActions();
}

void TrialChooser::step(int by)
{
    const int index = m_trials->currentIndex() + by;
    if (index >= 0 && index < m_trials->count())
        Q_EMIT chosen(m_trials->itemData(index).toString());
}

void TrialChooser::updateActions()
{
    m_previous->setEnabled(m_trials->currentIndex() > 0);
    m_next->setEnabled(m_trials->currentIndex() >= 0 && m_trials->currentIndex() + 1 < m_trials->count());
    m_trials->setEnabled(m_trials->count() > 0);
}

} // namespace odo
