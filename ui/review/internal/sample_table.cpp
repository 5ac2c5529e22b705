// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/review/internal/sample_table.h"

#include "ui/models/timeline.h"
#include "ui/review/internal/sample_model.h"
#include "ui/views/widgets/table_list.h"

#include <QAction>
#include <QApplication>
#include <QClipboard>
#include <QComboBox>
#include <QHeaderView>
#include <QMenu>
#include <QPushButton>
#include <QSettings>
#include <QSignalBlocker>
#include <QTableView>
#include <algorithm>

namespace odo {

namespace {

const QString sampleColumnsKey = QStringLiteral("review/dataColumns");

QStringList usualColumns()
{
    QStringList words;
    for (const SampleColumn column :
         {SampleColumn::Time, SampleColumn::PositionX, SampleColumn::PositionY, SampleColumn::Speed,
          SampleColumn::SigmaSpeed, SampleColumn::Acceleration, SampleColumn::Heading, SampleColumn::Flags})
        words << sampleColumnWord(column);
    return words;
}

} // namespace

SampleTable::SampleTable(Timeline &timeline, QWidget *parent)
    : Card(tr("Data"), parent), m_timeline(timeline), m_model(new SampleModel(this)),
      m_columns(QSettings().value(sampleColumnsKey, usualColumns()).toStringList()), m_robot(new QComboBox),
      m_columnMenu(new QMenu(this)), m_table(new QTableView)
{
    setObjectName(QStringLiteral("samples"));
    m_table->setModel(m_model);
    m_table->setAccessibleName(tr("Samples of the run"));
    showAsList(*m_table);
    m_table->setProperty("dense", true);
    m_table->setSelectionMode(QAbstractItemView::ExtendedSelection);
    m_table->setWordWrap(false);
    m_table->setContextMenuPolicy(Qt::ActionsContextMenu);
    m_table->horizontalHeader()->setStretchLastSection(true);
    m_table->horizontalHeader()->setResizeContentsPrecision(0); // of what is on screen, not of an hour
    auto *copyAction = new QAction(tr("&Copy with headings"), m_table);
    copyAction->setShortcut(QKeySequence::Copy);
    copyAction->setShortcutContext(Qt::WidgetShortcut);
    connect(copyAction, &QAction::triggered, this, &SampleTable::copy);
    m_table->addAction(copyAction);
    m_table->viewport()->installEventFilter(this);
    connect(m_table->selectionModel(), &QItemSelectionModel::currentRowChanged, this,
            &SampleTable::goToCurrent);
    connect(&m_timeline, &Timeline::currentChanged, this, &SampleTable::followTime);
    makeHeader();
    setContent(m_table);
    offerColumns();
    showColumns();
}

void SampleTable::makeHeader()
{
    m_robot->setAccessibleName(tr("Robot"));
    m_robot->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    m_robot->setMinimumContentsLength(8);
    m_robot->hide();
    connect(m_robot, &QComboBox::currentIndexChanged, this, &SampleTable::showRun);
    auto *columns = new QPushButton(tr("Columns"));
    columns->setAutoDefault(false);
    columns->setToolTip(tr("Which columns are shown"));
    columns->setAccessibleName(tr("Which columns are shown"));
    columns->setFocusPolicy(Qt::TabFocus);
    columns->setMenu(m_columnMenu);
    addToHeader(m_robot);
    addToHeader(columns);
}

void SampleTable::setScene(const TrialScenePtr &scene)
{
    m_scene = scene;
    m_isStale = true;
    if (isVisible())
        fill();
}

void SampleTable::showEvent(QShowEvent *event)
{
    if (m_isStale)
        fill();
    followTime();
    Card::showEvent(event);
}

/// However high the table becomes, the row of the present time is in it.
bool SampleTable::eventFilter(QObject *watched, QEvent *event)
{
    if (event->type() == QEvent::Resize && m_table->currentIndex().isValid())
        m_table->scrollTo(m_table->currentIndex());
    return Card::eventFilter(watched, event);
}

void SampleTable::fill()
{
    m_isStale = false;
    const QSignalBlocker quiet(m_robot);
    const QString before = m_robot->currentText();
    m_robot->clear();
    if (m_scene)
        for (const SceneRobot &robot : m_scene->robots)
            m_robot->addItem(QString::fromStdString(robot.robot.name));
    m_robot->setCurrentIndex(std::max(0, m_robot->findText(before)));
    m_robot->setVisible(m_robot->count() > 1);
    showRun();
}

void SampleTable::showRun()
{
    m_model->setRun(m_scene, static_cast<std::size_t>(std::max(0, m_robot->currentIndex())));
    const int count = m_model->rowCount();
    setRemark(count > 0 ? tr("%n sample(s)", "", count) : tr("Not tracked yet"));
    m_table->resizeColumnsToContents();
    followTime();
}

void SampleTable::offerColumns()
{
    for (int i = 0; i < int(SampleColumn::Count); ++i) {
        const auto column = static_cast<SampleColumn>(i);
        QAction *action = m_columnMenu->addAction(SampleModel::headingOf(column));
        action->setCheckable(true);
        action->setChecked(m_columns.contains(sampleColumnWord(column)));
        connect(action, &QAction::toggled, this, [this, column](bool isShown) {
            m_columns.removeAll(sampleColumnWord(column));
            if (isShown)
                m_columns << sampleColumnWord(column);
            QSettings().setValue(sampleColumnsKey, m_columns);
            showColumns();
        });
    }
}

void SampleTable::showColumns()
{
    for (int i = 0; i < int(SampleColumn::Count); ++i)
        m_table->setColumnHidden(i, !m_columns.contains(sampleColumnWord(static_cast<SampleColumn>(i))));
    m_table->resizeColumnsToContents();
}

std::vector<int> SampleTable::shownColumns() const
{
    std::vector<int> columns;
    for (int i = 0; i < int(SampleColumn::Count); ++i)
        if (!m_table->isColumnHidden(i))
            columns.push_back(i);
    return columns;
}

/// Several rows that a person has selected stay selected.
void SampleTable::followTime()
{
    if (!isVisible() || m_isStale || m_isFollowing)
        return;
    const int row = m_model->rowAt(m_timeline.currentTime());
    if (row < 0 || row == m_table->currentIndex().row())
        return;
    const std::vector<int> columns = shownColumns();
    const int column = columns.empty() ? 0 : columns.front(); // one that can be seen
    m_isFollowing = true;
    const bool isSelecting = m_table->selectionModel()->selectedRows().size() > 1;
    m_table->selectionModel()->setCurrentIndex(m_model->index(row, column),
                                               isSelecting ? QItemSelectionModel::NoUpdate
                                                           : QItemSelectionModel::ClearAndSelect |
                                                                 QItemSelectionModel::Rows);
    m_isFollowing = false;
}

void SampleTable::goToCurrent()
{
    const auto time = m_model->timeAt(m_table->currentIndex().row());
    if (m_isFollowing || !time)
        return;
    m_isFollowing = true;
    m_timeline.pause();
    m_timeline.setCurrentTime(*time);
    m_isFollowing = false;
}

void SampleTable::copy()
{
    std::vector<int> rows;
    for (const QModelIndex &index : m_table->selectionModel()->selectedRows())
        rows.push_back(index.row());
    std::ranges::sort(rows);
    if (rows.size() <= 1) { // the current one is always selected
        rows.clear();
        for (int row = 0; row < m_model->rowCount(); ++row)
            rows.push_back(row);
    }
    QApplication::clipboard()->setText(m_model->tabbed(rows, shownColumns()));
}

} // namespace odo
