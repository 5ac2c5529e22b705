// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/models/number_text.h"

#include <QObject>
#include <QString>
#include <utility>
#include <vector>

class QWidget;

namespace odo {

/// What a presentation shows of a robot.
struct PresentedRobot
{
    QString name, unit;                               ///< of the speed, or why there is none
    std::vector<std::pair<QString, QString>> results; ///< each with its value
};

/// What a presentation shows of a run.
struct PresentedRun
{
    QString team, more; ///< the second one: trial and task
    Badge badge;
    std::vector<PresentedRobot> robots;
};

/// A run for a presentation: a stored trial, or the one that is being recorded. GUI thread.
class PresentSource : public QObject
{
    Q_OBJECT
public:
    enum class Move { Play, Back, Forward };

    using QObject::QObject;
    /// The caller owns it; it may outlive the source.
    virtual QWidget *makeMap() = 0;
    virtual PresentedRun run() const = 0;
    /// Of a robot of the run, in its unit; "–" where it is not known.
    virtual QString speed(std::size_t robot) const = 0;
    /// By a key of the presentation.
    virtual void move(Move /*how*/) {}
    virtual bool isSettled() const { return true; }

Q_SIGNALS:
    void changed(); ///< another run, or other results
    void moved();   ///< other speeds
};

/// A speed in the user's unit, as a presentation shows it, in few digits.
QString presentedSpeed(double metresPerSecond);

} // namespace odo
