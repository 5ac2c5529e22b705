// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/platform/sleep_inhibitor.h"

#include <QObject>
#include <chrono>
#include <functional>
#include <memory>

class QTimer;

namespace odo {

/// Keeps the computer from going to sleep while something works: looks every two seconds, so what takes less
/// starts nothing. GUI thread.
class AwakeWatch : public QObject
{
    Q_OBJECT
public:
    static constexpr std::chrono::milliseconds step{2000};

    /// isWorking: whether a job runs or a run is recorded.
    explicit AwakeWatch(std::function<bool()> isWorking, QObject *parent = nullptr);
    ~AwakeWatch() override;

    bool isHeld() const { return m_held != nullptr; }

private:
    void look();
    const std::function<bool()> m_isWorking;
    std::unique_ptr<SleepInhibitor> m_held;
    bool m_wasTried = false; ///< for the work that goes on: where it cannot be had, it is not asked for again
    QTimer *m_timer;
};

} // namespace odo
