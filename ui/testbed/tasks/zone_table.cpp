// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/testbed/tasks/zone_table.h"

#include "ui/testbed/tasks/floor_numbers.h"
#include "ui/views/plain_button.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QRegularExpression>
#include <QTableWidget>
#include <algorithm>
#include <limits>

namespace odo {
namespace {

enum Column { NameColumn, RuleColumn, CornersColumn, ColumnCount };
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
        texts << placeText(corner.x()) + u' ' + placeText(corner.y());
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
        corners.push_back(numbers.size() == 2 ? Eigen::Vector2d(placeOf(numbers[0]), placeOf(numbers[1]))
                                              : Eigen::Vector2d(none, none));
    }
    return corners;
}

ZoneTable::ZoneTable(const Eigen::Vector2d &middle, QWidget *parent)
    : QWidget(parent), m_middle(middle), m_table(new QTableWidget(0, ColumnCount)), m_remove(plainButton(tr("Remo&ve zone")))
{
    m_table->setHorizontalHeaderLabels({tr("Zone"), tr("Rule"), tr("Corners: x y; x y; … in mm")});
    m_table->setAccessibleName(tr("Zones of the floor"));
    m_table->verticalHeader()->hide();
    m_table->setTabKeyNavigation(false);
    m_table->setSelectionMode(QAbstractItemView::SingleSelection);
    m_table->setWordWrap(false);
    m_table->horizontalHeader()->setHighlightSections(false);
    m_table->horizontalHeader()->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
    m_table->horizontalHeader()->setSectionResizeMode(RuleColumn, QHeaderView::ResizeToContents);
    m_table->horizontalHeader()->setSectionResizeMode(CornersColumn, QHeaderView::Stretch);
    auto *inside = plainButton(tr("Add zone to sta&y in")), *outside = plainButton(tr("Add zone to &keep out of"));
    auto *buttons = new QHBoxLayout;
    for (QPushButton *button : {inside, outside, m_remove})
        buttons->addWidget(button);
    buttons->addStretch(1);
    auto *words = new QLabel(tr("The robot's centre must stay in a zone, or keep out of it. Each is judged by itself; how often, how long "
                                "and how far it was broken can be scored. Drag corners and edges on the map."));
    words->setWordWrap(true);
    auto *layout = new QVBoxLayout(this);
    layout->addWidget(words);
    layout->addWidget(m_table, 1);
    layout->addLayout(buttons);
    connect(inside, &QPushButton::clicked, this, [this] { add(ZoneRule::StayInside); });
    connect(outside, &QPushButton::clicked, this, [this] { add(ZoneRule::StayOutside); });
    connect(m_remove, &QPushButton::clicked, this, &ZoneTable::remove);
    connect(m_table, &QTableWidget::cellChanged, this, &ZoneTable::readRow);
    connect(m_table, &QTableWidget::currentCellChanged, this, [this](int row) {
        if (!m_isShowing)
            Q_EMIT currentChanged(row);
    });
    setZones({});
}

void ZoneTable::setZones(const std::vector<Zone> &zones)
{
    m_zones = zones;
    showAll();
}

void ZoneTable::setCurrent(int zone)
{
    m_isShowing = true;
    m_table->setCurrentCell(zone, std::max(0, m_table->currentColumn()));
    m_isShowing = false;
}

void ZoneTable::showAll()
{
    m_isShowing = true;
    const int row = m_table->currentRow();
    m_table->setRowCount(static_cast<int>(m_zones.size()));
    for (int i = 0; i < m_table->rowCount(); ++i)
        show(i);
    m_table->setCurrentCell(std::min(row, m_table->rowCount() - 1), std::max(0, m_table->currentColumn()));
    m_remove->setEnabled(!m_zones.empty());
    m_isShowing = false;
}

void ZoneTable::show(int row)
{
    const Zone &zone = m_zones[static_cast<std::size_t>(row)];
    m_table->setItem(row, NameColumn, new QTableWidgetItem(QString::fromStdString(zone.name)));
    m_table->item(row, NameColumn)->setToolTip(QString::fromStdString(zone.name).toHtmlEscaped());
    m_table->setItem(row, CornersColumn, new QTableWidgetItem(cornersText(zone.corners)));
    m_table->item(row, CornersColumn)->setToolTip(cornersText(zone.corners));
    auto *rule = qobject_cast<QComboBox *>(m_table->cellWidget(row, RuleColumn));
    if (!rule) {
        rule = new QComboBox;
        for (const ZoneRule each : rules)
            rule->addItem(zoneRuleName(each), static_cast<int>(each));
        rule->setAccessibleName(tr("Rule of the zone"));
        m_table->setCellWidget(row, RuleColumn, rule);
        connect(rule, &QComboBox::activated, this, [this, row] { readRow(row); });
    }
    rule->setCurrentIndex(rule->findData(static_cast<int>(zone.rule)));
}

void ZoneTable::readRow(int row)
{
    if (m_isShowing)
        return;
    Zone &zone = m_zones[static_cast<std::size_t>(row)];
    zone.name = m_table->item(row, NameColumn)->text().trimmed().toStdString();
    zone.rule = static_cast<ZoneRule>(qobject_cast<QComboBox *>(m_table->cellWidget(row, RuleColumn))->currentData().toInt());
    const QString corners = m_table->item(row, CornersColumn)->text();
    if (corners != cornersText(zone.corners)) // what was not touched keeps its last bit
        zone.corners = cornersOf(corners);
    Q_EMIT changed();
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
    showAll();
    setCurrent(static_cast<int>(m_zones.size()) - 1);
    Q_EMIT changed();
    Q_EMIT currentChanged(m_table->currentRow());
}

void ZoneTable::remove()
{
    const int row = m_table->currentRow();
    if (row < 0)
        return;
    m_zones.erase(m_zones.begin() + row);
    showAll();
    Q_EMIT changed();
    Q_EMIT currentChanged(m_table->currentRow());
}

} // namespace odo
