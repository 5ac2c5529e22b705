// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/history/internal/own_metrics_dialog.h"

#include "ui/models/number_text.h"
#include "ui/models/shown_message.h"
#include "ui/views/widgets/command_keys.h"
#include "ui/views/widgets/labels.h"

#include <QDialogButtonBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QSettings>
#include <QTableWidget>
#include <QVBoxLayout>
#include <algorithm>
#include <set>

namespace odo {

namespace {

const QString ownMetricsKey = QStringLiteral("results/ownMetrics");
const QString nameKey = QStringLiteral("name"), ownUnitKey = QStringLiteral("unit"),
              formulaKey = QStringLiteral("formula");
enum OwnColumn { OwnName, OwnUnit, OwnFormula, OwnCount };

} // namespace

std::vector<OwnMetric> storedOwnMetrics()
{
    std::vector<OwnMetric> metrics;
    for (const QVariant &each : QSettings().value(ownMetricsKey).toList()) {
        const QVariantMap words = each.toMap();
        metrics.push_back({words.value(nameKey).toString().toStdString(),
                           words.value(ownUnitKey).toString().toStdString(),
                           words.value(formulaKey).toString().toStdString()});
    }
    return metrics;
}

void storeOwnMetrics(const std::vector<OwnMetric> &metrics)
{
    QVariantList list;
    for (const OwnMetric &metric : metrics)
        list << QVariantMap{{nameKey, QString::fromStdString(metric.name)},
                            {ownUnitKey, QString::fromStdString(metric.unit)},
                            {formulaKey, QString::fromStdString(metric.formula)}};
    QSettings().setValue(ownMetricsKey, list);
}

OwnMetricsDialog::OwnMetricsDialog(const ResultTable &table, const std::vector<OwnMetric> &metrics,
                                   QWidget *parent)
    : QDialog(parent), m_rows(new QTableWidget(0, OwnCount)), m_remove(plainButton(tr("&Remove"))),
      m_problem(new QLabel), m_buttons(new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel))
{
    setWindowTitle(tr("Own metrics"));
    std::set<std::string> own;
    for (const OwnMetric &metric : metrics)
        own.insert(metric.name);
    m_table.variables = table.variables;
    QStringList names;
    for (const TrialTableColumn &column : table.columns)
        if (!own.contains(column.metric)) {
            m_table.columns.push_back(column);
            const QString unit = column.unit == "1" ? QString() : QString::fromStdString(column.unit);
            names << QString::fromStdString(column.metric) +
                         (unit.isEmpty() ? QString() : QStringLiteral(" (%1)").arg(unit));
        }
    for (const std::string &variable : table.variables)
        names << QString::fromStdString(variable);
    auto *words =
        new QLabel(tr("A formula uses metrics in the units below, variables of the trials that are numbers, "
                      "+ - * / ^, brackets, sqrt, abs, exp, ln, sin, cos, min, max and pi. Names with blanks "
                      "are in braces: 0.5 * {robot mass} * max_speed^2."));
    showAsWords(*words);
    m_rows->setHorizontalHeaderLabels({tr("Name"), tr("Unit"), tr("Formula")});
    m_rows->setAccessibleName(tr("Own metrics"));
    m_rows->verticalHeader()->hide();
    m_rows->horizontalHeader()->setHighlightSections(false);
    m_rows->horizontalHeader()->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
    m_rows->horizontalHeader()->setSectionResizeMode(OwnFormula, QHeaderView::Stretch);
    constexpr int nameLetters = 26;
    m_rows->setColumnWidth(OwnName, nameLetters * m_rows->fontMetrics().averageCharWidth());
    m_rows->setTabKeyNavigation(false);
    for (const OwnMetric &metric : metrics)
        addRow(metric);
    auto *add = plainButton(tr("&Add"));
    auto *side = new QHBoxLayout;
    side->addWidget(add);
    side->addWidget(m_remove);
    side->addStretch(1);
    auto *known = new QPlainTextEdit(names.join(QStringLiteral(", ")));
    known->setReadOnly(true);
    known->setTabChangesFocus(true);
    known->setAccessibleName(tr("Names for formulas"));
    showAsWords(*m_problem);
    m_problem->setObjectName(QStringLiteral("problem"));
    auto *layout = new QVBoxLayout(this);
    layout->addWidget(words);
    layout->addWidget(m_rows, 2);
    layout->addLayout(side);
    layout->addWidget(m_problem);
    layout->addWidget(known, 1);
    layout->addWidget(m_buttons);
    connect(add, &QPushButton::clicked, this, [this] {
        addRow({});
        m_rows->setCurrentCell(m_rows->rowCount() - 1, OwnName);
        m_rows->setFocus();
        m_rows->editItem(m_rows->currentItem());
    });
    connect(m_remove, &QPushButton::clicked, this, [this] {
        m_rows->removeRow(m_rows->currentRow());
        check();
    });
    connect(m_rows, &QTableWidget::itemChanged, this, &OwnMetricsDialog::check);
    connect(m_rows, &QTableWidget::currentCellChanged, this, &OwnMetricsDialog::check);
    connect(m_buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(m_buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    constexpr QSize usual(620, 460);
    resize(usual);
    check();
}

void OwnMetricsDialog::addRow(const OwnMetric &metric)
{
    const int row = m_rows->rowCount();
    m_rows->insertRow(row);
    int column = OwnName;
    for (const std::string &text : {metric.name, metric.unit, metric.formula})
        m_rows->setItem(row, column++, new QTableWidgetItem(QString::fromStdString(text)));
    check();
}

/// Rows without any text are none.
std::vector<OwnMetric> OwnMetricsDialog::metrics() const
{
    std::vector<OwnMetric> metrics;
    const auto text = [this](int row, int column) {
        const QTableWidgetItem *item = m_rows->item(row, column);
        return item ? item->text().simplified().toStdString() : std::string();
    };
    for (int row = 0; row < m_rows->rowCount(); ++row)
        if (const OwnMetric metric{text(row, OwnName), text(row, OwnUnit), text(row, OwnFormula)};
            !metric.name.empty() || !metric.formula.empty())
            metrics.push_back(metric);
    return metrics;
}

void OwnMetricsDialog::check()
{
    ResultTable table = m_table;
    const Result<void> fine = addOwnMetrics(table, metrics());
    m_problem->setText(fine ? QString() : breakable(errorInWords(fine.error())));
    m_problem->setVisible(!fine);
    m_buttons->button(QDialogButtonBox::Ok)->setEnabled(fine.has_value());
    m_remove->setEnabled(m_rows->currentRow() >= 0);
}

} // namespace odo
