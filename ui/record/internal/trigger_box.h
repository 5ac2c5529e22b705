// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/workflow/record/run_control.h"

#include <QComboBox>
#include <QString>
#include <optional>

namespace odo {

/// A choice of what starts, or ends, a run. Its data is one of the numbers below, the seconds of a countdown,
/// or, of a zone, "enter:NAME" or "leave:NAME".
class TriggerBox : public QComboBox
{
    Q_OBJECT
public:
    enum class Of { Start, Stop };
    static constexpr int byPress = 0, byGate = -1, byMotion = -2, byTime = -3;

    explicit TriggerBox(Of of, QWidget *parent = nullptr);

    /// What there is with this task; what is chosen stays, as far as it is still there. Emits nothing.
    void setTask(const std::optional<Task> &task);
    /// byPress where there is no such choice.
    void choose(const QVariant &data);
    /// nullopt: the button. Its time is 0.
    std::optional<RunTrigger> trigger() const;
    bool isBy(int number) const;
    int countdownS() const; ///< 0: none

private:
    void fillStart(const std::optional<Task> &task);
    void fillStop(const std::optional<Task> &task);
    void addZones(const std::optional<Task> &task);

    const Of m_of;
};

/// What an armed run waits for, and that the seconds before are recorded too. gate: the name of the start.
QString awaitedWords(const RunTrigger &start, const QString &gate, int beforeS);
/// How a run ends by itself.
QString endWords(const RunTrigger &stop);

} // namespace odo
