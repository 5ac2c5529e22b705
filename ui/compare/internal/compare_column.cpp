// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/compare/internal/compare_column.h"

#include "ui/compare/internal/run_chooser.h"
#include "ui/models/comparison_scene.h"
#include "ui/models/timeline.h"
#include "ui/views/curves/comparison_curves.h"
#include "ui/views/widgets/card.h"
#include "ui/views/widgets/fact_list.h"
#include "ui/views/widgets/figure_grid.h"
#include "ui/views/widgets/table_list.h"
#include "ui/views/widgets/theme.h"

#include <QAction>
#include <QComboBox>
#include <QHeaderView>
#include <QSignalBlocker>
#include <QStyledItemDelegate>
#include <QTableView>
#include <QVBoxLayout>
#include <cmath>
#include <functional>

namespace odo {

namespace {

constexpr int columnWidth = 528, nameWidth = 88; ///< of a run in a heading

/// Mutes a difference that is within the error; its sign ≈ says the same.
class DifferenceDelegate : public QStyledItemDelegate
{
public:
    using QStyledItemDelegate::QStyledItemDelegate;

protected:
    void initStyleOption(QStyleOptionViewItem *option, const QModelIndex &index) const override
    {
        QStyledItemDelegate::initStyleOption(option, index);
        const bool isSignificant = index.data(DifferenceModel::SignificantRole).toBool();
        if (index.column() != DifferenceModel::DifferenceColumn)
            return;
        if (!isSignificant)
            for (const auto role : {QPalette::Text, QPalette::HighlightedText})
                option->palette.setColor(role, ThemeColours::of(option->palette).muted);
    }
};

/// A time difference of the second run in words; where it is within its error neither later nor earlier is
/// said.
NamedFigure timeFigure(const std::optional<CurveValue> &value, const QString &later, const QString &earlier,
                       const QString &neither)
{
    const QString unit = QStringLiteral("s");
    if (!value)
        return {neither, {QStringLiteral("–"), {}, {}}};
    if (!Difference{value->value, value->sigma}.isSignificant())
        return {neither, figureText(value->value, value->sigma, unit)};
    return {value->value > 0 ? later : earlier, figureText(std::abs(value->value), value->sigma, unit)};
}

QTableView *tableOf(DifferenceModel *model, const QString &name)
{
    auto *table = new QTableView;
    table->setModel(model);
    table->setItemDelegate(new DifferenceDelegate(table));
    table->setAccessibleName(name);
    showAsList(*table);
    table->setProperty("dense", true);
    table->setSelectionMode(QAbstractItemView::SingleSelection);
    table->setWordWrap(false);
    table->setTextElideMode(Qt::ElideRight);
    table->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    table->verticalHeader()->setDefaultSectionSize(table->fontMetrics().height() + 9);
    table->horizontalHeader()->setMinimumSectionSize(40);
    // Numbers are shown whole; a long name of a figure is cut.
    table->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    table->horizontalHeader()->setSectionResizeMode(DifferenceModel::NameColumn, QHeaderView::Stretch);
    return table;
}

/// Enter, a double click, Shift+F1 or the context menu tell how the chosen row came about.
void explainBy(QTableView &table, const std::function<void(int)> &explain)
{
    auto *how = new QAction(howComputedWords(), &table);
    how->setObjectName(QStringLiteral("howComputed"));
    how->setShortcut(QKeySequence(Qt::SHIFT | Qt::Key_F1));
    how->setShortcutContext(Qt::WidgetWithChildrenShortcut);
    table.addAction(how);
    table.setContextMenuPolicy(Qt::ActionsContextMenu);
    const auto ofCurrent = [&table, explain] {
        if (table.currentIndex().isValid())
            explain(table.currentIndex().row());
    };
    QObject::connect(how, &QAction::triggered, &table, ofCurrent);
    QObject::connect(&table, &QTableView::activated, &table, ofCurrent);
}

} // namespace

CompareColumn::CompareColumn(Timeline &timeline, QWidget *chooser, QWidget *parent)
    : QWidget(parent), m_timeline(timeline), m_result(new Card(tr("Time difference"))),
      m_sectorCard(new Card(tr("Sectors"))), m_metricCard(new Card(tr("Figures"))),
      m_others(new QComboBox(this)), m_figures(new FigureGrid), m_sectors(new DifferenceModel(this)),
      m_metrics(new DifferenceModel(this))
{
    m_others->setAccessibleName(tr("Run that is shown against the first"));
    m_others->setToolTip(m_others->accessibleName());
    m_others->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    m_others->setMinimumContentsLength(14);
    m_others->hide();
    m_result->addToHeader(m_others);
    connect(m_others, &QComboBox::currentIndexChanged, this, &CompareColumn::showRun);
    auto *runs = new Card(tr("Runs"));
    runs->setContent(chooser);
    runs->setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Maximum);
    m_result->setContent(m_figures);
    m_result->setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Maximum);
    QTableView *sectors = tableOf(m_sectors, tr("Times from gate to gate")),
               *metrics = tableOf(m_metrics, tr("Figures of both runs"));
    explainBy(*sectors, [this](int row) { explainSectorAt(row); });
    explainBy(*metrics, [this](int row) { explainMetricAt(row); });
    m_sectorCard->setContent(sectors);
    m_metricCard->setContent(metrics);
    m_sectorCard->setRemark(tr("s · drag the gates on the map"));
    m_metricCard->setRemark(tr("grey: within the error"));
    auto *layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(8);
    layout->addWidget(runs);
    layout->addWidget(m_result);
    layout->addWidget(m_sectorCard, 2);
    layout->addWidget(m_metricCard, 4);
    setFixedWidth(columnWidth);
    m_figures->setChoosable(howComputedWords());
    connect(m_figures, &FigureGrid::chosen, this, &CompareColumn::explainFigure);
    connect(&m_timeline, &Timeline::currentChanged, this, &CompareColumn::showFigures);
}

void CompareColumn::setScene(ComparisonScenePtr scene)
{
    m_scene = std::move(scene);
    for (Card *card : {m_result, m_sectorCard, m_metricCard})
        card->setVisible(m_scene != nullptr);
    if (!m_scene)
        return;
    {
        const QSignalBlocker quiet(m_others);
        m_others->clear();
        for (std::size_t run = 1; run < m_scene->runCount(); ++run)
            m_others->addItem(QString::fromStdString(m_scene->name(run)));
        if (m_other >= m_scene->runCount())
            m_other = 1;
        m_others->setCurrentIndex(static_cast<int>(m_other) - 1);
    }
    m_others->setVisible(m_scene->runCount() > 2);
    m_gates = m_scene->compared.gates;
    showRun();
}

void CompareColumn::showRun()
{
    if (!m_scene || m_others->currentIndex() < 0)
        return;
    m_other = static_cast<std::size_t>(m_others->currentIndex()) + 1;
    const QString first = QString::fromStdString(m_scene->name(0)),
                  other = QString::fromStdString(m_scene->name(m_other));
    // Names of trials often differ at their ends alone.
    const auto fitted = [this](const QString &name) {
        return fontMetrics().elidedText(name, Qt::ElideMiddle, nameWidth);
    };
    for (DifferenceModel *model : {m_sectors, m_metrics})
        model->setRunNames(fitted(first), fitted(other));
    m_metrics->setMetrics(m_scene->compared.metrics.at(m_other - 1));
    m_result->setRemark(m_scene->runCount() > 2 ? tr("of") : tr("of %1").arg(other));
    const RunComparison &comparison = m_scene->compared.comparison;
    m_end.reset();
    for (std::size_t station = comparison.waysM.size(); station-- > 0 && !m_end;) {
        m_endM = comparison.distanceM(station);
        m_end = differenceAt(*m_scene, m_other, m_endM);
    }
    setGates(m_gates);
    showFigures();
}

void CompareColumn::setGates(const std::vector<PathGate> &gates)
{
    m_gates = gates;
    m_sectorTimes = sectorTimes(m_scene->compared.comparison, gates);
    m_sectors->setSectors(m_sectorTimes, m_other);
}

void CompareColumn::showFigures()
{
    if (!m_scene || !isVisible())
        return;
    m_hereM = m_scene->distanceAt(0, m_timeline.currentTime());
    m_here = differenceAt(*m_scene, m_other, m_hereM);
    m_figures->setFigures(
        {timeFigure(m_end, tr("Later at the end"), tr("Earlier at the end"), tr("At the end")),
         timeFigure(m_here, tr("Later here"), tr("Earlier here"), tr("Here"))});
}

void CompareColumn::explainMetricAt(int row)
{
    const auto &metrics = m_scene->compared.metrics.at(m_other - 1);
    showExplanation(window(),
                    explainDifference(*m_scene, m_other, metrics.at(static_cast<std::size_t>(row))));
}

void CompareColumn::explainSectorAt(int row)
{
    showExplanation(window(),
                    explainSector(*m_scene, m_other, m_sectorTimes.at(static_cast<std::size_t>(row))));
}

void CompareColumn::explainFigure(std::size_t figure)
{
    const std::optional<CurveValue> &value = figure == 0 ? m_end : m_here;
    if (m_scene && value)
        showExplanation(window(), explainTimeDifference(*m_scene, m_other, figure == 0 ? m_endM : m_hereM,
                                                        {value->value, value->sigma}));
}

} // namespace odo
