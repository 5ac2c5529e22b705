// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/record/internal/trigger_box.h"

#include <QLocale>
#include <QSignalBlocker>
#include <algorithm>

namespace odo {

namespace {

const QString enters = QStringLiteral("enter:"), leaves = QStringLiteral("leave:");

bool hasGate(const std::optional<Task> &task, GateRole role)
{
    return task && std::ranges::any_of(task->gates, [role](const Gate &gate) {
               return gate.role == GateRole::StartFinish || gate.role == role;
           });
}

} // namespace

TriggerBox::TriggerBox(Of of, QWidget *parent) : QComboBox(parent), m_of(of)
{
    setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    setMinimumContentsLength(12);
    setTask(std::nullopt);
}

void TriggerBox::setTask(const std::optional<Task> &task)
{
    const QSignalBlocker quiet(this);
    const QVariant chosen = count() > 0 ? currentData() : QVariant(byPress);
    clear();
    if (m_of == Of::Start)
        fillStart(task);
    else
        fillStop(task);
    setCurrentIndex(std::max(0, findData(chosen)));
}

void TriggerBox::fillStart(const std::optional<Task> &task)
{
    addItem(tr("at once"), byPress);
    for (const int seconds : {3, 5, 10})
        addItem(tr("after a countdown of %1 s").arg(seconds), seconds);
    if (hasGate(task, GateRole::Start))
        addItem(tr("when the robot passes the start"), byGate);
    addItem(tr("when something moves"), byMotion);
    addZones(task);
}

void TriggerBox::fillStop(const std::optional<Task> &task)
{
    addItem(tr("with the button"), byPress);
    if (hasGate(task, GateRole::Start) && hasGate(task, GateRole::Finish))
        addItem(tr("at the finish"), byGate);
    addItem(tr("when nothing moves any more"), byMotion);
    addZones(task);
    addItem(tr("after a time"), byTime);
}

void TriggerBox::addZones(const std::optional<Task> &task)
{
    if (!task)
        return;
    for (const Zone &zone : task->zones) {
        const QString name = QString::fromStdString(zone.name);
        addItem(tr("when a robot enters “%1”").arg(name), QString(enters + name));
        addItem(tr("when a robot leaves “%1”").arg(name), QString(leaves + name));
    }
}

void TriggerBox::choose(const QVariant &data)
{
    setCurrentIndex(std::max(0, findData(data)));
}

bool TriggerBox::isBy(int number) const
{
    return currentData() == QVariant(number);
}

int TriggerBox::countdownS() const
{
    return currentData().typeId() == QMetaType::Int ? std::max(0, currentData().toInt()) : 0;
}

std::optional<RunTrigger> TriggerBox::trigger() const
{
    const QString zone = currentData().toString();
    if (zone.startsWith(enters))
        return RunTrigger{RunTrigger::Kind::Entry, zone.mid(enters.size()).toStdString()};
    if (zone.startsWith(leaves))
        return RunTrigger{RunTrigger::Kind::Exit, zone.mid(leaves.size()).toStdString()};
    if (isBy(byGate))
        return RunTrigger{RunTrigger::Kind::Gate};
    if (isBy(byMotion))
        return RunTrigger{RunTrigger::Kind::Motion};
    if (isBy(byTime))
        return RunTrigger{RunTrigger::Kind::Time};
    return std::nullopt;
}

QString awaitedWords(const RunTrigger &start, const QString &gate, int beforeS)
{
    const QString zone = QString::fromStdString(start.zone);
    const int seconds = std::max(1, beforeS);
    switch (start.kind) {
    case RunTrigger::Kind::Gate:
        return TriggerBox::tr("Waiting for the robot at “%1”. The recording will include the %2 s before it")
            .arg(gate)
            .arg(seconds);
    case RunTrigger::Kind::Entry:
        return TriggerBox::tr("Waiting until a robot enters “%1”. The recording will include the %2 s before")
            .arg(zone)
            .arg(seconds);
    case RunTrigger::Kind::Exit:
        return TriggerBox::tr("Waiting until a robot leaves “%1”. The recording will include the %2 s before")
            .arg(zone)
            .arg(seconds);
    case RunTrigger::Kind::Motion:
    case RunTrigger::Kind::Time:
        break;
    }
    return TriggerBox::tr(
               "Waiting until something moves on the floor. The recording will include the %1 s before")
        .arg(seconds);
}

QString endWords(const RunTrigger &stop)
{
    const QString zone = QString::fromStdString(stop.zone);
    const QString seconds = QLocale().toString(toSeconds(stop.time), 'f',
                                               stop.time % std::chrono::seconds(1) == Nanoseconds{0} ? 0 : 1);
    switch (stop.kind) {
    case RunTrigger::Kind::Gate:
        return TriggerBox::tr("Ends at the finish, or with F9");
    case RunTrigger::Kind::Entry:
        return TriggerBox::tr("Ends when a robot enters “%1”, or with F9").arg(zone);
    case RunTrigger::Kind::Exit:
        return TriggerBox::tr("Ends when a robot leaves “%1”, or with F9").arg(zone);
    case RunTrigger::Kind::Motion:
        return TriggerBox::tr("Ends when nothing has moved for %1 s, or with F9").arg(seconds);
    case RunTrigger::Kind::Time:
        break;
    }
    return TriggerBox::tr("Ends %1 s after the start, or with F9").arg(seconds);
}

} // namespace odo
