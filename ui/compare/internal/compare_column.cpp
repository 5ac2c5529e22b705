// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/compare/internal/compare_column.h"

#include "core/project/names.h"
#include "ui/models/comparison_scene.h"
#include "ui/models/shown_names.h"
#include "ui/models/timeline.h"
#include "ui/models/verdict_mark.h"
#include "ui/views/curves/comparison_curves.h"
#include "ui/views/widgets/card.h"
#include "ui/views/widgets/fact_list.h"
#include "ui/views/widgets/form_fields.h"
#include "ui/views/widgets/table_list.h"
#include "ui/views/widgets/theme.h"

#include <QAction>
#include <QComboBox>
#include <QCoreApplication>
#include <QDoubleSpinBox>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QMenu>
#include <QSignalBlocker>
#include <QStyledItemDelegate>
#include <QTableView>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>
#include <functional>

namespace odo {

namespace {

constexpr int usualWidth = 528, leastWidth = 340, nameWidth = 88; ///< the last: of a run in a heading

/// Mutes a difference that is not significant; its sign ≈ says the same.
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

/// A time difference of the second run in words; "later" or "earlier" only if it is significant.
NamedMetric timeNumber(const std::optional<CurveValue> &value, const QString &later, const QString &earlier,
                       const QString &neither)
{
    const QString unit = QStringLiteral("s");
    if (!value)
        return {neither, {QStringLiteral("–"), {}, {}}};
    if (!Difference{value->value, value->sigma}.isSignificant())
        return {neither, numberText(value->value, value->sigma, unit)};
    return {value->value > 0 ? later : earlier, numberText(std::abs(value->value), value->sigma, unit)};
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
    table->setMinimumHeight(2 * (table->fontMetrics().height() + 9)); // its heading and a row
    table->setTextElideMode(Qt::ElideRight);
    table->verticalHeader()->setDefaultSectionSize(table->fontMetrics().height() + 9);
    // Numbers are shown whole; a long name of a metric is cut, and then the table scrolls.
    constexpr int leastColumn = 76;
    table->horizontalHeader()->setMinimumSectionSize(leastColumn);
    table->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    table->horizontalHeader()->setSectionResizeMode(DifferenceModel::NameColumn, QHeaderView::Stretch);
    return table;
}

/// Enter, a double click, Shift+F1 or the context menu explain the selected row.
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
      m_sectorCard(new Card(tr("Sectors"))), m_metricCard(new Card(tr("Metrics"))),
      m_verdictCard(new Card(tr("Verdict"))), m_verdicts(new FactList), m_others(new QComboBox(this)),
      m_metricGrid(new MetricGrid), m_sectors(new DifferenceModel(this)), m_metrics(new DifferenceModel(this))
{
    m_others->setAccessibleName(tr("Run compared with the first one"));
    m_others->setToolTip(m_others->accessibleName());
    m_others->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    m_others->setMinimumContentsLength(14);
    m_others->hide();
    m_result->addToHeader(m_others);
    connect(m_others, &QComboBox::currentIndexChanged, this, &CompareColumn::showRun);
    auto *runs = new Card(tr("Runs"));
    runs->setContent(chooser);
    runs->setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Maximum);
    m_result->setContent(m_metricGrid);
    m_result->setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Maximum);
    QTableView *sectors = tableOf(m_sectors, tr("Times from gate to gate")),
               *metrics = tableOf(m_metrics, tr("Metrics of both runs"));
    explainBy(*sectors, [this](int row) { explainSectorAt(row); });
    explainBy(*metrics, [this](int row) { explainMetricAt(row); });
    m_sectorCard->setContent(sectors);
    m_metricCard->setContent(metrics);
    m_sectorCard->setRemark(tr("s · drag the gates on the map"));
    m_metricCard->setRemark(tr("grey: not significant"));
    auto *layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(8);
    m_verdictCard->setContent(m_verdicts);
    m_verdictCard->setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Maximum);
    layout->addWidget(runs);
    layout->addWidget(m_verdictCard);
    layout->addWidget(m_result);
    layout->addWidget(m_sectorCard, 2);
    layout->addWidget(m_metricCard, 4);
    setMinimumWidth(leastWidth);
    setMaximumWidth(usualWidth);
    m_metricGrid->setChoosable(howComputedWords());
    connect(m_metricGrid, &MetricGrid::chosen, this, &CompareColumn::explainMetric);
    connect(&m_timeline, &Timeline::currentChanged, this, &CompareColumn::showMetrics);
}

QSize CompareColumn::sizeHint() const
{
    return {usualWidth, QWidget::sizeHint().height()};
}

void CompareColumn::setScene(ComparisonScenePtr scene)
{
    m_scene = std::move(scene);
    for (Card *card : {m_result, m_sectorCard, m_metricCard})
        card->setVisible(m_scene != nullptr);
    showVerdicts();
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

/// Of the runs whose results are not beyond doubt.
void CompareColumn::showVerdicts()
{
    QList<Fact> facts;
    for (std::size_t run = 0; m_scene && run < m_scene->runCount(); ++run) {
        const TrialVerdict &verdict = m_scene->scenes[run]->verdict;
        if (verdict.level() != CheckLevel::Pass)
            facts.append(
                {QString::fromStdString(m_scene->name(run)), verdictText(verdict), verdictBadge(verdict)});
    }
    m_verdicts->setFacts(facts);
    m_verdictCard->setHidden(facts.isEmpty());
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
    for (std::size_t station = comparison.distancesM.size(); station-- > 0 && !m_end;) {
        m_endM = comparison.distanceM(station);
        m_end = differenceAt(*m_scene, m_other, m_endM);
    }
    setGates(m_gates);
    showMetrics();
}

void CompareColumn::setGates(const std::vector<PathGate> &gates)
{
    m_gates = gates;
    m_sectorTimes = sectorTimes(m_scene->compared.comparison, gates);
    m_sectors->setSectors(m_sectorTimes, m_other);
}

void CompareColumn::showMetrics()
{
    if (!m_scene || !isVisible())
        return;
    m_hereM = m_scene->distanceAt(0, m_timeline.currentTime());
    m_here = differenceAt(*m_scene, m_other, m_hereM);
    m_metricGrid->setMetrics(
        {timeNumber(m_end, tr("Behind at finish"), tr("Ahead at finish"), tr("Gap at finish")),
         timeNumber(m_here, tr("Behind at cursor"), tr("Ahead at cursor"), tr("Gap at cursor"))});
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

void CompareColumn::explainMetric(std::size_t index)
{
    const std::optional<CurveValue> &value = index == 0 ? m_end : m_here;
    if (m_scene && value)
        showExplanation(window(), explainTimeDifference(*m_scene, m_other, index == 0 ? m_endM : m_hereM,
                                                        {value->value, value->sigma}));
}

namespace {

constexpr int automatic = -1;
constexpr int mostOffered = 60; ///< of further runs, the newest: a longer menu serves nobody

QToolButton *flatButton(const QString &icon, const QString &name)
{
    auto *button = new QToolButton;
    button->setIcon(themeIcon(icon));
    button->setToolTip(name);
    button->setAccessibleName(name);
    button->setFocusPolicy(Qt::StrongFocus);
    button->setProperty("flat", true);
    return button;
}

QComboBox *runList(const QString &name)
{
    auto *list = new QComboBox;
    list->setAccessibleName(name);
    list->setToolTip(name);
    list->setFocusPolicy(Qt::TabFocus); // as Review's list of trials
    list->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    list->setMinimumContentsLength(12);
    return list;
}

} // namespace

QString alignmentWords(AlignBy by)
{
    switch (by) {
    case AlignBy::StartGate:
        return RunChooser::tr("start gate");
    case AlignBy::MotionOnset:
        return RunChooser::tr("onset of motion");
    case AlignBy::Distance:
        return RunChooser::tr("distance");
    case AlignBy::ByHand:
        break;
    }
    return RunChooser::tr("by hand");
}

RunChooser::RunChooser(QWidget *parent)
    : QWidget(parent), m_first(runList(tr("First run"))), m_second(runList(tr("Second run"))),
      m_align(runList(tr("How to align the runs"))),
      m_swap(flatButton(QStringLiteral("swap"), tr("Swap the two runs"))),
      m_more(flatButton(QStringLiteral("add"), tr("Add more runs"))), m_menu(new QMenu(this)),
      m_shiftName(new QLabel(tr("&Shift"))), m_positionName(new QLabel(tr("Distan&ce"))),
      m_shift(new NumberBox), m_position(new NumberBox)
{
    m_more->setPopupMode(QToolButton::InstantPopup);
    m_more->setMenu(m_menu);
    m_align->addItem(tr("Automatic"), automatic);
    for (const AlignBy by : {AlignBy::StartGate, AlignBy::MotionOnset, AlignBy::Distance, AlignBy::ByHand}) {
        QString words = alignmentWords(by);
        words[0] = words[0].toUpper();
        m_align->addItem(words, static_cast<int>(by));
    }
    m_shift->setRange(-largestOffsetS, largestOffsetS);
    m_shift->setDecimals(3);
    m_shift->setSingleStep(0.01);
    m_shift->setSuffix(tr(" s"));
    m_shift->setKeyboardTracking(false);
    m_shift->setAccessibleName(tr("Time shift of the second run; positive: later"));
    m_shift->setToolTip(m_shift->accessibleName());
    m_shiftName->setBuddy(m_shift);
    m_position->setRange(0, 10000);
    m_position->setDecimals(2);
    m_position->setSingleStep(0.1);
    m_position->setSuffix(tr(" m"));
    m_position->setSpecialValueText(tr("first common point"));
    m_position->setKeyboardTracking(false);
    m_position->setAccessibleName(tr("Distance along the path at which the runs are aligned"));
    m_position->setToolTip(m_position->accessibleName());
    m_positionName->setBuddy(m_position);
    const auto named = [](const QString &text, QWidget *buddy) {
        auto *label = new QLabel(text);
        label->setBuddy(buddy);
        return label;
    };
    auto *grid = new QGridLayout(this);
    grid->setContentsMargins(10, 8, 10, 10);
    grid->setHorizontalSpacing(8);
    grid->setVerticalSpacing(6);
    grid->setColumnStretch(1, 1);
    grid->addWidget(named(tr("F&irst"), m_first), 0, 0);
    grid->addWidget(m_first, 0, 1);
    grid->addWidget(m_swap, 0, 2);
    grid->addWidget(named(tr("Seco&nd"), m_second), 1, 0);
    grid->addWidget(m_second, 1, 1);
    grid->addWidget(m_more, 1, 2);
    grid->addWidget(named(tr("&Align by"), m_align), 2, 0);
    grid->addWidget(m_align, 2, 1, 1, 2);
    grid->addWidget(m_shiftName, 3, 0);
    grid->addWidget(m_shift, 3, 1, 1, 2);
    grid->addWidget(m_positionName, 4, 0);
    grid->addWidget(m_position, 4, 1, 1, 2);
    showShift();

    for (QComboBox *list : {m_first, m_second})
        connect(list, &QComboBox::activated, this, &RunChooser::runsChanged);
    connect(m_swap, &QToolButton::clicked, this, &RunChooser::swap);
    connect(m_menu, &QMenu::aboutToShow, this, &RunChooser::fillMenu);
    connect(m_align, &QComboBox::activated, this, [this] {
        showShift();
        Q_EMIT alignmentChanged();
    });
    for (QDoubleSpinBox *number : {m_shift, m_position})
        connect(number, &QDoubleSpinBox::valueChanged, this, &RunChooser::alignmentChanged);
}

void RunChooser::setChoices(QList<RunChoice> choices)
{
    const std::vector<CompareSettings::Run> before = runs();
    m_menu->close(); // its entries number the choices of before
    m_menu->clear();
    m_choices = std::move(choices);
    QStringList words;
    words.reserve(m_choices.size());
    for (const RunChoice &choice : std::as_const(m_choices))
        words << choice.words;
    for (QComboBox *list : {m_first, m_second}) {
        const QSignalBlocker quiet(list);
        list->setModel(new NameListModel(words, words, list)); // the one before goes with it
    }
    setRuns(before);
}

void RunChooser::setRuns(const std::vector<CompareSettings::Run> &wanted)
{
    QList<int> indices = paletteIndicesOf(m_choices, wanted);
    m_first->setCurrentIndex(indices.isEmpty() ? -1 : indices.takeFirst());
    m_second->setCurrentIndex(indices.isEmpty() ? -1 : indices.takeFirst());
    m_further = indices;
}

std::vector<CompareSettings::Run> RunChooser::runs() const
{
    std::vector<CompareSettings::Run> chosen;
    for (const QComboBox *list : {m_first, m_second})
        if (list->currentIndex() >= 0 && list->currentIndex() < m_choices.size())
            chosen.push_back(m_choices[list->currentIndex()].run);
    for (const int choice : m_further)
        if (choice != m_first->currentIndex() && choice != m_second->currentIndex())
            chosen.push_back(m_choices[choice].run);
    return chosen;
}

std::optional<AlignBy> RunChooser::alignBy() const
{
    const int by = m_align->currentData().toInt();
    return by == automatic ? std::nullopt : std::optional(static_cast<AlignBy>(by));
}

double RunChooser::shiftS() const
{
    return m_shift->value();
}

std::optional<double> RunChooser::stationM() const
{
    return m_position->value() > 0 ? std::optional(m_position->value()) : std::nullopt;
}

void RunChooser::alignAutomatically()
{
    const QSignalBlocker quiet(m_shift), alsoQuiet(m_position);
    m_align->setCurrentIndex(0);
    m_shift->setValue(0);
    m_position->setValue(0);
    showShift();
}

void RunChooser::setAlignedBy(AlignBy by)
{
    m_align->setItemText(0, tr("Automatic: %1").arg(alignmentWords(by)));
}

void RunChooser::swap()
{
    const int first = m_first->currentIndex();
    m_first->setCurrentIndex(m_second->currentIndex());
    m_second->setCurrentIndex(first);
    Q_EMIT runsChanged();
}

void RunChooser::toggleFurther(int choice, bool isWanted)
{
    m_further.removeAll(choice);
    if (isWanted)
        m_further << choice;
    Q_EMIT runsChanged();
}

void RunChooser::fillMenu()
{
    m_menu->clear();
    const int oldest = std::max(0, static_cast<int>(m_choices.size()) - mostOffered);
    for (int i = 0; i < m_choices.size(); ++i) {
        if (i == m_first->currentIndex() || i == m_second->currentIndex())
            continue;
        if (i < oldest && !m_further.contains(i))
            continue;
        QAction *action = m_menu->addAction(m_choices[i].words);
        action->setCheckable(true);
        action->setChecked(m_further.contains(i));
        connect(action, &QAction::toggled, this, [this, i](bool on) { toggleFurther(i, on); });
    }
    if (m_menu->isEmpty())
        m_menu->addAction(tr("No more runs"))->setEnabled(false);
}

void RunChooser::showShift()
{
    const bool byHand = alignBy() == AlignBy::ByHand;
    m_shift->setVisible(byHand);
    m_shiftName->setVisible(byHand);
    const bool byPosition = alignBy() == AlignBy::Distance;
    m_position->setVisible(byPosition);
    m_positionName->setVisible(byPosition);
}

} // namespace odo
