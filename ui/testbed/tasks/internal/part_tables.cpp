// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/testbed/tasks/internal/part_tables.h"

#include "core/base/units.h"
#include "ui/models/number_text.h"
#include "ui/views/widgets/command_keys.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLocale>
#include <QPushButton>
#include <QRegularExpression>
#include <QString>
#include <QTableWidget>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>
#include <limits>

namespace odo {

PartTable::PartTable(const QStringList &headings, const QString &name, QPushButton *remove, QWidget *parent)
    : QWidget(parent), m_table(new QTableWidget(0, static_cast<int>(headings.size()))),
      m_remove(remove), m_ofParts{remove}
{
    m_table->setHorizontalHeaderLabels(headings);
    m_table->setAccessibleName(name);
    m_table->verticalHeader()->hide();
    m_table->setTabKeyNavigation(false);
    m_table->setSelectionMode(QAbstractItemView::SingleSelection);
    m_table->horizontalHeader()->setHighlightSections(false);
    m_table->horizontalHeader()->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
    connect(m_remove, &QPushButton::clicked, this, &PartTable::removeCurrent);
    connect(m_table, &QTableWidget::cellChanged, this, &PartTable::takeEdit);
    connect(m_table, &QTableWidget::currentCellChanged, this, [this](int row) {
        if (!m_isShowing)
            Q_EMIT currentChanged(row);
    });
}

int PartTable::currentRow() const
{
    return m_table->currentRow();
}

void PartTable::setCurrent(int row)
{
    m_isShowing = true;
    m_table->setCurrentCell(row, std::max(0, m_table->currentColumn()));
    m_isShowing = false;
}

void PartTable::showAll()
{
    m_isShowing = true;
    const int current = m_table->currentRow();
    m_table->setRowCount(count());
    for (int row = 0; row < m_table->rowCount(); ++row)
        showRow(row);
    m_table->setCurrentCell(std::min(current, m_table->rowCount() - 1),
                            std::max(0, m_table->currentColumn()));
    for (QPushButton *button : m_ofParts)
        button->setEnabled(m_table->rowCount() > 0);
    m_isShowing = false;
}

void PartTable::showAdded(int row)
{
    showAll();
    setCurrent(row);
    Q_EMIT changed();
    Q_EMIT currentChanged(m_table->currentRow());
}

QComboBox *PartTable::choiceIn(int row, int column, const QString &name,
                               const std::vector<std::pair<QString, int>> &choices)
{
    auto *choice = qobject_cast<QComboBox *>(m_table->cellWidget(row, column));
    if (choice)
        return choice;
    choice = new QComboBox;
    for (const auto &[words, value] : choices)
        choice->addItem(words, value);
    choice->setAccessibleName(name);
    m_table->setCellWidget(row, column, choice);
    connect(choice, &QComboBox::activated, this, [this, row] { takeEdit(row); });
    return choice;
}

QLayout *PartTable::rowOf(const std::vector<QPushButton *> &buttons) const
{
    auto *row = new QHBoxLayout;
    for (QPushButton *button : buttons)
        row->addWidget(button);
    row->addStretch(1);
    return row;
}

void PartTable::takeEdit(int row)
{
    if (m_isShowing)
        return;
    readRow(row);
    Q_EMIT changed();
}

void PartTable::removeCurrent()
{
    const int row = m_table->currentRow();
    if (row < 0)
        return;
    eraseRow(row);
    showAll();
    Q_EMIT changed();
    Q_EMIT currentChanged(m_table->currentRow());
}

/// Positions on the floor as typed in tables: millimetres, without a grouping that could be read as a decimal
/// sign. A position that is no number is empty.
QString positionText(double metres)
{
    if (!std::isfinite(metres))
        return {};
    QLocale locale; // 2,750 could be read as 2.75
    locale.setNumberOptions(QLocale::OmitGroupSeparator);
    // 0.3 m is 300 mm, not 299.99999999999994
    const double mm = std::round(toMillimetres(metres) * 1000) / 1000;
    return locale.toString(mm + 0.0, 'f', QLocale::FloatingPointShortest);
}

/// Of 1200,5 or 1200.5 in millimetres; NaN for what is no number.
double positionOf(const QString &text)
{
    return fromMillimetres(typedNumber(text).value_or(std::numeric_limits<double>::quiet_NaN()));
}

namespace {

struct GateColumn
{
    enum { Name, Role, FromX, FromY, ToX, ToY, Count };
};
constexpr int leastColumn = 50;
constexpr GateRole roles[] = {GateRole::Start, GateRole::Split, GateRole::Finish, GateRole::StartFinish};

double &numberOf(Gate &gate, int column)
{
    switch (column) {
    case GateColumn::FromX:
        return gate.from.x();
    case GateColumn::FromY:
        return gate.from.y();
    case GateColumn::ToX:
        return gate.to.x();
    default:
        return gate.to.y();
    }
}

} // namespace

QString roleName(GateRole role)
{
    switch (role) {
    case GateRole::Start:
        return GateTable::tr("start");
    case GateRole::Finish:
        return GateTable::tr("finish");
    case GateRole::StartFinish:
        return GateTable::tr("start and finish");
    case GateRole::Split:
        break;
    }
    return GateTable::tr("split");
}

GateTable::GateTable(QWidget *parent)
    : PartTable({tr("Gate"), tr("Role"), tr("x₁, mm"), tr("y₁, mm"), tr("x₂, mm"), tr("y₂, mm")},
                tr("Gates in passing order"), plainButton(tr("Remo&ve")), parent),
      m_turn(plainButton(tr("Reverse directi&on")))
{
    // Numbers are shown whole, however long they are; a long name is cut.
    table().horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    table().horizontalHeader()->setSectionResizeMode(GateColumn::Name, QHeaderView::Stretch);
    table().horizontalHeader()->setMinimumSectionSize(leastColumn);
    table().setMinimumHeight(120);
    auto *add = plainButton(tr("&Add gate"));
    enableWithParts(m_turn);
    m_turn->setToolTip(tr("Robots pass the selected gate the other way"));
    auto *layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(&table(), 1);
    layout->addLayout(rowOf({add, removeButton(), m_turn}));
    connect(add, &QPushButton::clicked, this, &GateTable::add);
    connect(m_turn, &QPushButton::clicked, this, &GateTable::turn);
    setGates({});
}

void GateTable::setGates(const std::vector<Gate> &gates)
{
    m_gates = gates;
    showAll();
}

void GateTable::showRow(int row)
{
    Gate &gate = m_gates[static_cast<std::size_t>(row)];
    table().setItem(row, GateColumn::Name, new QTableWidgetItem(QString::fromStdString(gate.name)));
    for (int column = GateColumn::FromX; column < GateColumn::Count; ++column) {
        table().setItem(row, column, new QTableWidgetItem(positionText(numberOf(gate, column))));
        table().item(row, column)->setToolTip(positionText(numberOf(gate, column)));
    }
    std::vector<std::pair<QString, int>> choices;
    for (const GateRole role : roles)
        choices.emplace_back(roleName(role), static_cast<int>(role));
    QComboBox *role = choiceIn(row, GateColumn::Role, tr("Role of the gate"), choices);
    role->setCurrentIndex(role->findData(static_cast<int>(gate.role)));
}

void GateTable::readRow(int row)
{
    Gate &gate = m_gates[static_cast<std::size_t>(row)];
    gate.name = table().item(row, GateColumn::Name)->text().trimmed().toStdString();
    gate.role = static_cast<GateRole>(
        qobject_cast<QComboBox *>(table().cellWidget(row, GateColumn::Role))->currentData().toInt());
    for (int column = GateColumn::FromX; column < GateColumn::Count; ++column) {
        const QString text = table().item(row, column)->text();
        if (text != positionText(numberOf(gate, column))) // what was not touched keeps its last bit
            numberOf(gate, column) = positionOf(text);
    }
}

void GateTable::add()
{
    std::string name;
    const auto taken = [&] { return std::ranges::find(m_gates, name, &Gate::name) != m_gates.end(); };
    int number = 1;
    do
        name = tr("Split %1").arg(number++).toStdString();
    while (taken());
    Gate gate{name, GateRole::Split, {0.5, 0.5}, {0.5, 0.9}};
    const int current = currentRow();
    if (current >= 0) { // beside the chosen one, and passed after it
        const Gate &chosen = m_gates[static_cast<std::size_t>(current)];
        const Eigen::Vector2d along = (chosen.to - chosen.from).normalized();
        const Eigen::Vector2d aside = 0.2 * Eigen::Vector2d(along.y(), -along.x());
        gate.from = chosen.from + aside;
        gate.to = chosen.to + aside;
    }
    m_gates.insert(
        m_gates.begin() + (current < 0 ? static_cast<std::ptrdiff_t>(m_gates.size()) : current + 1), gate);
    showAdded(current < 0 ? static_cast<int>(m_gates.size()) - 1 : current + 1);
}

void GateTable::turn()
{
    const int row = currentRow();
    if (row < 0)
        return;
    Gate &gate = m_gates[static_cast<std::size_t>(row)];
    std::swap(gate.from, gate.to);
    showAll();
    Q_EMIT changed();
}

namespace {

struct ZoneColumn
{
    enum { Name, Rule, Corners, Count };
};
constexpr ZoneRule rules[] = {ZoneRule::StayInside, ZoneRule::StayOutside};
constexpr double newHalfM = 0.25, roomyHalfM = 1; ///< of a new zone to keep out of, and of one to stay in

} // namespace

QString zoneRuleName(ZoneRule rule)
{
    return rule == ZoneRule::StayInside ? ZoneTable::tr("stay inside") : ZoneTable::tr("keep out");
}

QString cornersText(const std::vector<Eigen::Vector2d> &corners)
{
    QStringList texts;
    for (const Eigen::Vector2d &corner : corners)
        texts << positionText(corner.x()) + u' ' + positionText(corner.y());
    return texts.join(QStringLiteral("; "));
}

std::vector<Eigen::Vector2d> cornersOf(const QString &text)
{
    static const QRegularExpression between(QStringLiteral("(,?\\s+)"));
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    std::vector<Eigen::Vector2d> corners;
    for (const QString &each : text.split(u';', Qt::SkipEmptyParts)) {
        const QStringList numbers = each.trimmed().split(between, Qt::SkipEmptyParts);
        if (numbers.isEmpty())
            continue;
        corners.push_back(numbers.size() == 2
                              ? Eigen::Vector2d(positionOf(numbers[0]), positionOf(numbers[1]))
                              : Eigen::Vector2d(none, none));
    }
    return corners;
}

ZoneTable::ZoneTable(const Eigen::Vector2d &middle, QWidget *parent)
    : PartTable({tr("Zone"), tr("Rule"), tr("Corners: x y; x y; … in mm")}, tr("Zones of the floor"),
                plainButton(tr("Remo&ve zone")), parent),
      m_middle(middle)
{
    table().setWordWrap(false);
    table().horizontalHeader()->setSectionResizeMode(ZoneColumn::Rule, QHeaderView::ResizeToContents);
    table().horizontalHeader()->setSectionResizeMode(ZoneColumn::Corners, QHeaderView::Stretch);
    auto *inside = plainButton(tr("Add zone to sta&y in")),
         *outside = plainButton(tr("Add zone to &keep out of"));
    auto *words = new QLabel(tr(
        "The robot's reference point must stay in a zone or keep out of it. Each zone counts separately; you "
        "can score how often, how long and how far a robot broke it. Drag corners and edges on the map."));
    words->setWordWrap(true);
    auto *layout = new QVBoxLayout(this);
    layout->addWidget(words);
    layout->addWidget(&table(), 1);
    layout->addLayout(rowOf({inside, outside, removeButton()}));
    connect(inside, &QPushButton::clicked, this, [this] { add(ZoneRule::StayInside); });
    connect(outside, &QPushButton::clicked, this, [this] { add(ZoneRule::StayOutside); });
    setZones({});
}

void ZoneTable::setZones(const std::vector<Zone> &zones)
{
    m_zones = zones;
    showAll();
}

void ZoneTable::showRow(int row)
{
    const Zone &zone = m_zones[static_cast<std::size_t>(row)];
    table().setItem(row, ZoneColumn::Name, new QTableWidgetItem(QString::fromStdString(zone.name)));
    table().item(row, ZoneColumn::Name)->setToolTip(QString::fromStdString(zone.name).toHtmlEscaped());
    table().setItem(row, ZoneColumn::Corners, new QTableWidgetItem(cornersText(zone.corners)));
    table().item(row, ZoneColumn::Corners)->setToolTip(cornersText(zone.corners));
    std::vector<std::pair<QString, int>> choices;
    for (const ZoneRule rule : rules)
        choices.emplace_back(zoneRuleName(rule), static_cast<int>(rule));
    QComboBox *rule = choiceIn(row, ZoneColumn::Rule, tr("Rule of the zone"), choices);
    rule->setCurrentIndex(rule->findData(static_cast<int>(zone.rule)));
}

void ZoneTable::readRow(int row)
{
    Zone &zone = m_zones[static_cast<std::size_t>(row)];
    zone.name = table().item(row, ZoneColumn::Name)->text().trimmed().toStdString();
    zone.rule = static_cast<ZoneRule>(
        qobject_cast<QComboBox *>(table().cellWidget(row, ZoneColumn::Rule))->currentData().toInt());
    const QString corners = table().item(row, ZoneColumn::Corners)->text();
    if (corners != cornersText(zone.corners)) // what was not touched keeps its last bit
        zone.corners = cornersOf(corners);
}

void ZoneTable::add(ZoneRule rule)
{
    std::string name;
    int number = 1;
    do
        name = tr("Zone %1").arg(number++).toStdString();
    while (std::ranges::find(m_zones, name, &Zone::name) != m_zones.end());
    const double half = rule == ZoneRule::StayInside ? roomyHalfM : newHalfM;
    const Eigen::Vector2d to(half, half);
    m_zones.push_back(rectangularZone(name, rule, m_middle - to, m_middle + to));
    showAdded(static_cast<int>(m_zones.size()) - 1);
}

} // namespace odo
