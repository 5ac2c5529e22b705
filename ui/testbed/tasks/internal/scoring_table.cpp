// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/testbed/tasks/internal/scoring_table.h"

#include "ui/models/number_text.h"
#include "ui/models/results.h"
#include "ui/views/widgets/command_keys.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLocale>
#include <QPushButton>
#include <QTableWidget>
#include <algorithm>
#include <cmath>
#include <limits>

namespace odo {
namespace {

struct ScoringColumn
{
    enum { Metric, Full, None, Points, Count };
};

double numberOf(const QString &text)
{
    return typedNumber(text).value_or(std::numeric_limits<double>::quiet_NaN());
}

QString textOfNumber(double number)
{
    QLocale locale;
    locale.setNumberOptions(QLocale::OmitGroupSeparator);
    return std::isfinite(number) ? locale.toString(number, 'g', 8) : QString();
}

QString metricWords(const std::string &metric)
{
    const QString unit = boundUnit(metric).unit;
    return unit.isEmpty() ? metricName(metric) : QStringLiteral("%1, %2").arg(metricName(metric), unit);
}

} // namespace

ScoringTable::ScoringTable(const std::vector<std::string> &metrics, QWidget *parent)
    : QWidget(parent), m_metrics(metrics), m_table(new QTableWidget(0, ScoringColumn::Count)),
      m_remove(plainButton(tr("Remo&ve line"))), m_words(new QLabel)
{
    auto *intro = new QLabel(
        tr("Each line gives all its points if the metric reaches the first bound, none at the second bound "
           "or worse, and a proportional share between them. Negative points are a penalty."));
    intro->setWordWrap(true);
    m_table->setHorizontalHeaderLabels({tr("Metric"), tr("All points at"), tr("None at"), tr("Points")});
    m_table->setAccessibleName(tr("Lines of the scoring"));
    m_table->verticalHeader()->hide();
    m_table->setTabKeyNavigation(false);
    m_table->setSelectionMode(QAbstractItemView::SingleSelection);
    m_table->horizontalHeader()->setHighlightSections(false);
    m_table->horizontalHeader()->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
    m_table->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    m_table->horizontalHeader()->setSectionResizeMode(ScoringColumn::Metric, QHeaderView::Stretch);
    m_words->setWordWrap(true);
    m_words->setTextFormat(Qt::PlainText);
    m_words->setObjectName(QStringLiteral("quiet"));
    m_words->setAccessibleName(tr("What the lines mean"));
    auto *add = plainButton(tr("&Add line"));
    auto *buttons = new QHBoxLayout;
    for (QPushButton *button : {add, m_remove})
        buttons->addWidget(button);
    buttons->addStretch(1);
    auto *layout = new QVBoxLayout(this);
    layout->addWidget(intro);
    layout->addWidget(m_table, 1);
    layout->addLayout(buttons);
    layout->addWidget(m_words);
    connect(add, &QPushButton::clicked, this, &ScoringTable::add);
    connect(m_remove, &QPushButton::clicked, this, &ScoringTable::remove);
    connect(m_table, &QTableWidget::cellChanged, this, &ScoringTable::readRow);
    setCriteria({});
}

void ScoringTable::setCriteria(const std::vector<Criterion> &criteria)
{
    m_criteria = criteria;
    showAll();
}

void ScoringTable::showAll()
{
    m_isShowing = true;
    const int row = std::max(0, m_table->currentRow());
    m_table->setRowCount(static_cast<int>(m_criteria.size()));
    for (int i = 0; i < m_table->rowCount(); ++i)
        show(i);
    m_table->setCurrentCell(std::min(row, m_table->rowCount() - 1), std::max(0, m_table->currentColumn()));
    m_remove->setEnabled(!m_criteria.empty());
    m_isShowing = false;
    showWords();
}

void ScoringTable::show(int row)
{
    const Criterion &line = m_criteria[static_cast<std::size_t>(row)];
    const double factor = boundUnit(line.metric).factor;
    m_table->setItem(row, ScoringColumn::Full, new QTableWidgetItem(textOfNumber(factor * line.fullAt)));
    m_table->setItem(row, ScoringColumn::None, new QTableWidgetItem(textOfNumber(factor * line.noneAt)));
    m_table->setItem(row, ScoringColumn::Points, new QTableWidgetItem(textOfNumber(line.points)));
    auto *metricBox = qobject_cast<QComboBox *>(m_table->cellWidget(row, ScoringColumn::Metric));
    if (!metricBox) {
        metricBox = new QComboBox;
        metricBox->setAccessibleName(tr("Scored metric"));
        for (const std::string &metric : m_metrics)
            metricBox->addItem(metricWords(metric), QString::fromStdString(metric));
        m_table->setCellWidget(row, ScoringColumn::Metric, metricBox);
        connect(metricBox, &QComboBox::activated, this, [this, row] { readRow(row); });
    }
    if (metricBox->findData(QString::fromStdString(line.metric)) < 0)
        metricBox->addItem(metricWords(line.metric), QString::fromStdString(line.metric));
    metricBox->setCurrentIndex(metricBox->findData(QString::fromStdString(line.metric)));
}

void ScoringTable::readRow(int row)
{
    if (m_isShowing)
        return;
    Criterion &line = m_criteria[static_cast<std::size_t>(row)];
    line.metric = qobject_cast<QComboBox *>(m_table->cellWidget(row, ScoringColumn::Metric))
                      ->currentData()
                      .toString()
                      .toStdString();
    const double factor = boundUnit(line.metric).factor;
    line.fullAt = numberOf(m_table->item(row, ScoringColumn::Full)->text()) / factor;
    line.noneAt = numberOf(m_table->item(row, ScoringColumn::None)->text()) / factor;
    line.points = numberOf(m_table->item(row, ScoringColumn::Points)->text());
    showWords();
    Q_EMIT changed();
}

void ScoringTable::showWords()
{
    QStringList words;
    double most = 0;
    for (const Criterion &line : m_criteria) {
        if (!checkScoring({line}))
            continue;
        words << QStringLiteral("%1: %2").arg(metricName(line.metric), criterionText(line));
        most += std::max(0.0, line.points);
    }
    if (words.isEmpty())
        words << tr("Without a line, runs of the task are not scored.");
    else
        words << tr("Total: %1 points.").arg(QLocale().toString(most, 'g', 6));
    m_words->setText(words.join(u'\n'));
}

void ScoringTable::add()
{
    const bool isTimed = std::ranges::find(m_metrics, std::string("gate_time")) != m_metrics.end();
    m_criteria.push_back(isTimed ? Criterion{"gate_time", 5, 20, 10}
                                 : Criterion{m_metrics.front(), 1, 0, 10});
    showAll();
    m_table->setCurrentCell(m_table->rowCount() - 1, ScoringColumn::Full);
    Q_EMIT changed();
}

void ScoringTable::remove()
{
    const int row = m_table->currentRow();
    if (row < 0)
        return;
    m_criteria.erase(m_criteria.begin() + row);
    showAll();
    Q_EMIT changed();
}

} // namespace odo
