// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/testbed/tasks/zone_table.h"

#include "ui/testbed/tasks/floor_numbers.h"
#include "ui/views/plain_button.h"

#include <QComboBox>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QRegularExpression>
#include <QTableWidget>
#include <QVBoxLayout>
#include <algorithm>
#include <limits>

namespace odo {
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
    : PartTable({tr("Zone"), tr("Rule"), tr("Corners: x y; x y; … in mm")}, tr("Zones of the floor"),
                plainButton(tr("Remo&ve zone")), parent),
      m_middle(middle)
{
    table().setWordWrap(false);
    table().horizontalHeader()->setSectionResizeMode(ZoneColumn::Rule, QHeaderView::ResizeToContents);
    table().horizontalHeader()->setSectionResizeMode(ZoneColumn::Corners, QHeaderView::Stretch);
    auto *inside = plainButton(tr("Add zone to sta&y in")), *outside = plainButton(tr("Add zone to &keep out of"));
    auto *words = new QLabel(tr("The robot's centre must stay in a zone, or keep out of it. Each is judged by itself; how often, how long "
                                "and how far it was broken can be scored. Drag corners and edges on the map."));
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
