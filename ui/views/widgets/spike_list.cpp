// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/widgets/spike_list.h"

#include "ui/models/scene_uncertainty.h"
#include "ui/models/timeline.h"

#include "ui/views/widgets/fact_list.h"
#include "ui/views/widgets/theme.h"

#include <QAction>
#include <QEvent>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QPainter>
#include <QStyledItemDelegate>
#include <QTableView>
#include <QToolButton>
#include <algorithm>

namespace odo {

namespace {

constexpr int padding = 9;

/// Rows as in the other panels: air around the text, a thin line below, a light ground for the chosen one.
class RowDelegate : public QStyledItemDelegate
{
public:
    using QStyledItemDelegate::QStyledItemDelegate;

    void paint(QPainter *painter, const QStyleOptionViewItem &option, const QModelIndex &index) const override
    {
        const ThemeColours colours = ThemeColours::of(option.palette);
        const bool chosen = option.state.testFlag(QStyle::State_Selected);
        painter->fillRect(option.rect, chosen ? colours.selection : colours.card);
        painter->fillRect(QRect(option.rect.left(), option.rect.bottom(), option.rect.width(), 1),
                          colours.grid);
        const bool focused = option.state.testFlag(QStyle::State_HasFocus);
        if (focused)
            painter->fillRect(QRect(option.rect.left(), option.rect.top(), 2, option.rect.height()),
                              colours.accent);
        painter->setFont(option.font);
        painter->setPen(index.data(SpikeModel::RestoredRole).toBool() ? colours.muted : colours.text);
        const QRect position = option.rect.adjusted(padding, 0, -padding / 2, 0);
        const QString text = index.data().toString();
        painter->drawText(position, index.data(Qt::TextAlignmentRole).value<Qt::Alignment>(),
                          option.fontMetrics.elidedText(text, Qt::ElideRight, position.width()));
    }
    QSize sizeHint(const QStyleOptionViewItem &option, const QModelIndex &index) const override
    {
        return {option.fontMetrics.horizontalAdvance(index.data().toString()) + 2 * padding,
                option.fontMetrics.height() + padding};
    }
};

} // namespace

SpikeList::SpikeList(Timeline &timeline, QWidget *parent)
    : Card(tr("Spikes"), parent), m_timeline(timeline), m_model(new SpikeModel(this)),
      m_table(new QTableView(this)), m_buttons(new QHBoxLayout),
      m_sameReason(new QAction(tr("Select all with this &reason"), this)),
      m_inRange(new QAction(tr("Select all in the selected ra&nge"), this))
{
    m_table->setModel(m_model);
    m_table->setAccessibleName(tr("Spikes with time and reason"));
    m_table->setFrameShape(QFrame::NoFrame);
    m_table->setItemDelegate(new RowDelegate(m_table));
    m_table->setShowGrid(false);
    m_table->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_table->setSelectionBehavior(QAbstractItemView::SelectRows);
    m_table->setSelectionMode(QAbstractItemView::ExtendedSelection);
    m_table->setEditTriggers(QAbstractItemView::NoEditTriggers);
    m_table->setTabKeyNavigation(false);
    m_table->setWordWrap(false);
    m_table->verticalHeader()->hide();
    m_table->verticalHeader()->setDefaultSectionSize(m_table->fontMetrics().height() + 9);
    m_table->horizontalHeader()->setHighlightSections(false);
    m_table->horizontalHeader()->setSectionResizeMode(SpikeModel::TimeColumn, QHeaderView::ResizeToContents);
    m_table->horizontalHeader()->setSectionResizeMode(SpikeModel::ReasonColumn, QHeaderView::Stretch);
    m_table->horizontalHeader()->setSectionResizeMode(SpikeModel::StateColumn, QHeaderView::ResizeToContents);
    auto *content = new QWidget;
    auto *layout = new QVBoxLayout(content);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(m_table, 1);
    layout->addLayout(m_buttons);
    m_buttons->setContentsMargins(padding, 4, padding, 6);
    m_buttons->setSpacing(4);
    setContent(content);
    auto *how = new QAction(howComputedWords(), this);
    how->setObjectName(QStringLiteral("howComputed"));
    how->setShortcut(QKeySequence(Qt::SHIFT | Qt::Key_F1));
    how->setShortcutContext(Qt::WidgetWithChildrenShortcut);
    m_table->addAction(how);
    m_table->setContextMenuPolicy(Qt::ActionsContextMenu);
    connect(how, &QAction::triggered, this, &SpikeList::explain);
    connect(m_table, &QTableView::activated, this, &SpikeList::explain); // Enter or a double click
    makeSelectActions();
    applyColours();
    connect(m_table->selectionModel(), &QItemSelectionModel::currentRowChanged, this,
            [this](const QModelIndex &row) {
                if (row.isValid())
                    Q_EMIT robotChosen(std::size_t(row.data(SpikeModel::RobotRole).toInt()));
                const Nanoseconds time(row.data(SpikeModel::TimeRole).toLongLong());
                if (row.isValid() &&
                    time != m_timeline.currentTime()) { // else it was the time that chose the row
                    m_timeline.pause();
                    m_timeline.setCurrentTime(time);
                }
            });
    connect(&m_timeline, &Timeline::currentChanged, this, &SpikeList::followTime);
}

void SpikeList::makeSelectActions()
{
    constexpr uint reasons = ~(flagBit(SampleFlag::ByHand) | flagBit(SampleFlag::Interpolated));
    m_sameReason->setObjectName(QStringLiteral("selectSameReason"));
    m_sameReason->setToolTip(tr("Select all spikes of this robot that have the reason of the selected one"));
    m_sameReason->setShortcut(Qt::Key_R);
    m_inRange->setObjectName(QStringLiteral("selectInRange"));
    m_inRange->setToolTip(tr("Select all spikes of this robot within the selection on the time line"));
    m_inRange->setShortcut(QKeySequence(Qt::SHIFT | Qt::Key_R));
    connect(m_sameReason, &QAction::triggered, this, [this] {
        const uint meant = m_table->currentIndex().data(SpikeModel::FlagsRole).toUInt() & reasons;
        selectRows([meant](const QModelIndex &row) {
            return (row.data(SpikeModel::FlagsRole).toUInt() & meant) != 0;
        });
    });
    connect(m_inRange, &QAction::triggered, this, [this] {
        if (const auto range = m_timeline.selection())
            selectRows([range](const QModelIndex &row) {
                return range->contains(Nanoseconds(row.data(SpikeModel::TimeRole).toLongLong()));
            });
    });
    m_table->addActions(selectActions());
    connect(m_table->selectionModel(), &QItemSelectionModel::selectionChanged, this, &SpikeList::showChosen);
    connect(&m_timeline, &Timeline::selectionChanged, this, &SpikeList::showChosen);
}

/// Of the robot of the current row, or else of the first that is meant.
template <class IsMeant>
void SpikeList::selectRows(const IsMeant &isMeant)
{
    QVariant robot = m_table->currentIndex().data(SpikeModel::RobotRole);
    QModelIndex first;
    QItemSelection meant;
    for (int row = 0; row < m_model->rowCount(); ++row) {
        const QModelIndex index = m_model->index(row, 0);
        if (index.data(SpikeModel::SampleIndexRole).toLongLong() < 0 || !isMeant(index) ||
            (robot.isValid() && robot != index.data(SpikeModel::RobotRole)))
            continue;
        robot = index.data(SpikeModel::RobotRole);
        first = first.isValid() ? first : index;
        meant.select(index, m_model->index(row, SpikeModel::ColumnCount - 1));
    }
    if (!first.isValid())
        return;
    if (!m_table->currentIndex().isValid())
        m_table->selectionModel()->setCurrentIndex(first, QItemSelectionModel::NoUpdate);
    m_table->selectionModel()->select(meant, QItemSelectionModel::ClearAndSelect);
}

void SpikeList::showChosen()
{
    const QModelIndex current = m_table->currentIndex();
    const QVariant robot = current.data(SpikeModel::RobotRole);
    std::vector<std::int64_t> frames;
    const QModelIndexList rows = m_table->selectionModel()->selectedRows();
    for (const QModelIndex &row : rows) {
        const qint64 sample = row.data(SpikeModel::SampleIndexRole).toLongLong();
        if (sample < 0 || row.data(SpikeModel::RobotRole) != robot)
            continue;
        const auto &samples = m_scene->robots.at(std::size_t(robot.toInt())).analysis->profile.samples;
        frames.push_back(samples.at(std::size_t(sample)).frame);
    }
    std::ranges::sort(frames);
    m_sameReason->setEnabled(current.isValid() &&
                             current.data(SpikeModel::SampleIndexRole).toLongLong() >= 0);
    m_inRange->setEnabled(m_timeline.selection().has_value() && m_model->rowCount() > 0);
    setRemark(frames.size() > 1 ? tr("%n selected", "", int(frames.size())) : m_model->summary());
    Q_EMIT samplesChosen(frames);
}

void SpikeList::setScene(TrialScenePtr scene)
{
    m_scene = scene;
    m_model->setScene(std::move(scene));
    followTime();
    showChosen();
}

void SpikeList::setActions(const QList<QAction *> &actions)
{
    for (QAction *action : actions) {
        auto *button = new QToolButton;
        button->setDefaultAction(action);
        button->setFocusPolicy(Qt::TabFocus);
        m_buttons->addWidget(button);
    }
    m_buttons->addStretch(1);
    m_table->addActions(actions);
}

void SpikeList::explain()
{
    const QModelIndex row = m_table->currentIndex();
    if (!row.isValid())
        return;
    const auto robot = static_cast<std::size_t>(row.data(SpikeModel::RobotRole).toInt());
    const qint64 sample = row.data(SpikeModel::SampleIndexRole).toLongLong();
    for (const Spike &spike : m_scene->robots.at(robot).analysis->profile.spikes)
        if (spike.sampleIndex == sample) {
            showExplanation(window(), explainSpike(*m_scene, robot, spike));
            return;
        }
}

void SpikeList::changeEvent(QEvent *event)
{
    Card::changeEvent(event);
    if (event->type() == QEvent::PaletteChange)
        applyColours();
}

void SpikeList::applyColours()
{
    const ThemeColours colours = ThemeColours::of(palette());
    m_table->horizontalHeader()->setStyleSheet(
        QStringLiteral(
            "QHeaderView::section { background: %1; color: %2; border: none; border-bottom: 1px solid %3;"
            " padding: 4px %4px; }")
            .arg(colours.card.name(), colours.muted.name(), colours.grid.name())
            .arg(padding));
}

void SpikeList::followTime()
{
    const QModelIndex current = m_table->currentIndex();
    const auto standsHere = [this](const QModelIndex &index) {
        return index.isValid() &&
               index.data(SpikeModel::TimeRole).toLongLong() == m_timeline.currentTime().count();
    };
    if (standsHere(current))
        return;
    QModelIndex found;
    for (int row = 0; row < m_model->rowCount() && !found.isValid(); ++row) {
        if (standsHere(m_model->index(row, 0)))
            found = m_model->index(row, 0);
    }
    m_table->setCurrentIndex(found);
}

} // namespace odo
