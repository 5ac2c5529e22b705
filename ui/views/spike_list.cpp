// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/spike_list.h"

#include "ui/models/spike_model.h"
#include "ui/models/timeline.h"

#include <QHeaderView>
#include <QTableView>

namespace odo {

SpikeList::SpikeList(Timeline &timeline, QWidget *parent)
    : Card(tr("Spikes"), parent), m_timeline(timeline), m_model(new SpikeModel(this)),
      m_table(new QTableView(this))
{
    m_table->setModel(m_model);
    m_table->setAccessibleName(tr("Spikes with time and reason"));
    m_table->setFrameShape(QFrame::NoFrame);
    m_table->setShowGrid(false);
    m_table->setSelectionBehavior(QAbstractItemView::SelectRows);
    m_table->setSelectionMode(QAbstractItemView::SingleSelection);
    m_table->setEditTriggers(QAbstractItemView::NoEditTriggers);
    m_table->setTabKeyNavigation(false);
    m_table->setWordWrap(false);
    m_table->verticalHeader()->hide();
    m_table->verticalHeader()->setDefaultSectionSize(m_table->fontMetrics().height() + 9);
    m_table->horizontalHeader()->setHighlightSections(false);
    m_table->horizontalHeader()->setSectionResizeMode(SpikeModel::TimeColumn, QHeaderView::ResizeToContents);
    m_table->horizontalHeader()->setSectionResizeMode(SpikeModel::ReasonColumn, QHeaderView::Stretch);
    m_table->horizontalHeader()->setSectionResizeMode(SpikeModel::StateColumn, QHeaderView::ResizeToContents);
    setContent(m_table);
    connect(m_table->selectionModel(), &QItemSelectionModel::currentRowChanged, this,
            [this](const QModelIndex &row) {
                const Nanoseconds time(row.data(SpikeModel::TimeRole).toLongLong());
                if (row.isValid() &&
                    time != m_timeline.currentTime()) { // else it was the time that chose the row
                    m_timeline.pause();
                    m_timeline.setCurrentTime(time);
                }
            });
    connect(&m_timeline, &Timeline::currentChanged, this, &SpikeList::followTime);
}

void SpikeList::setScene(TrialScenePtr scene)
{
    m_model->setScene(std::move(scene));
    setRemark(m_model->summary());
    followTime();
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
