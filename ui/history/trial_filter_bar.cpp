// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/history/trial_filter_bar.h"

#include "ui/history/filter_choice.h"
#include "ui/views/theme_icon.h"

#include <QComboBox>
#include <QDateEdit>
#include <QHBoxLayout>
#include <QToolButton>

namespace odo {
namespace {

enum Dates { AnyDate, Today, LastWeek, LastMonth, LastYear, Between };

Instant startOf(const QDate &day)
{
    return Instant(std::chrono::milliseconds(day.startOfDay().toMSecsSinceEpoch()));
}

} // namespace

TrialFilterBar::TrialFilterBar(QWidget *parent)
    : QWidget(parent), m_from(new QDateEdit(this)), m_to(new QDateEdit(this)),
      m_starred(new QToolButton(this)), m_lower(new QHBoxLayout)
{
    // Two rows, so that a window at 200 % still holds them.
    auto *rows = new QVBoxLayout(this);
    rows->setContentsMargins(10, 6, 10, 6);
    rows->setSpacing(6);
    auto *upper = new QHBoxLayout, *lower = m_lower;
    rows->addLayout(upper);
    rows->addLayout(lower);
    m_class = addChoice(*upper, tr("Class"), tr("Any class"));
    m_team = addChoice(*upper, tr("Team"), tr("Any team"));
    m_task = addChoice(*upper, tr("Task"), tr("Any task"));
    m_robot = addChoice(*upper, tr("Robot"), tr("Any robot"));
    m_dates = addChoice(*lower, tr("Date"), tr("Any date"));
    m_dates->setMinimumContentsLength(12);
    m_dates->addItems(
        {tr("Today"), tr("Last 7 days"), tr("Last 30 days"), tr("Last 12 months"), tr("Between…")});
    m_place = addChoice(*lower, tr("Where"), tr("Trials"));
    m_place->addItems({tr("Archive"), tr("Bin")});
    m_from->setAccessibleName(tr("From"));
    m_to->setAccessibleName(tr("To"));
    for (QDateEdit *edit : {m_from, m_to}) {
        edit->setCalendarPopup(true);
        edit->setDate(QDate::currentDate());
        edit->hide();
        lower->insertWidget(lower->indexOf(m_place), edit);
        connect(edit, &QDateEdit::dateChanged, this, &TrialFilterBar::changed);
    }
    m_starred->setText(tr("Starred"));
    m_starred->setIcon(themeIcon(QStringLiteral("star")));
    m_starred->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    m_starred->setCheckable(true);
    m_starred->setFocusPolicy(Qt::TabFocus);
    m_starred->setAccessibleName(tr("Only starred trials"));
    m_starred->setToolTip(tr("Show starred trials only"));
    lower->addWidget(m_starred);
    lower->addStretch(1);
    connect(m_starred, &QToolButton::toggled, this, &TrialFilterBar::changed);
    connect(m_dates, &QComboBox::currentIndexChanged, this, &TrialFilterBar::showDates);
}

void TrialFilterBar::addAtEnd(QWidget *widget)
{
    m_lower->addWidget(widget);
}

QComboBox *TrialFilterBar::addChoice(QLayout &row, const QString &name, const QString &any)
{
    QComboBox *choice = makeChoice(name, 7);
    choice->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    choice->addItem(any);
    row.addWidget(choice);
    connect(choice, &QComboBox::currentIndexChanged, this, &TrialFilterBar::changed);
    return choice;
}

void TrialFilterBar::setOffer(const FilterOffer &offer)
{
    fillChoice(*m_class, offer.classes, offer.classesShown);
    fillChoice(*m_team, offer.teams, offer.teamsShown);
    fillChoice(*m_task, offer.tasks, offer.tasks);
    fillChoice(*m_robot, offer.robots, offer.robots);
}

void TrialFilterBar::showDates()
{
    const bool between = m_dates->currentIndex() == Between;
    m_from->setVisible(between);
    m_to->setVisible(between);
}

TrialFilter TrialFilterBar::filter() const
{
    TrialFilter filter;
    filter.className = chosenWord(*m_class);
    filter.team = chosenWord(*m_team);
    filter.task = chosenWord(*m_task);
    filter.robot = chosenWord(*m_robot);
    filter.starred = m_starred->isChecked();
    filter.place = static_cast<TrialFilter::Place>(m_place->currentIndex());
    const QDate today = QDate::currentDate();
    switch (m_dates->currentIndex()) {
    case Today:
        filter.from = startOf(today);
        break;
    case LastWeek:
        filter.from = startOf(today.addDays(-6));
        break;
    case LastMonth:
        filter.from = startOf(today.addDays(-29));
        break;
    case LastYear:
        filter.from = startOf(today.addYears(-1));
        break;
    case Between:
        filter.from = startOf(m_from->date());
        filter.to = startOf(m_to->date().addDays(1));
        break;
    default:
        break;
    }
    return filter;
}

} // namespace odo
