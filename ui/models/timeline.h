// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/units.h"

#include <QList>
#include <QObject>
#include <QTimer>
#include <functional>
#include <optional>
#include <vector>

class QAction;

namespace odo {

class HeldKey;

/// The one shared time of a window: which frame of the first view is shown, whether it plays, and the range
/// of it that a person has selected. Everything that shows or moves time holds a reference to it. GUI thread
/// only.
class Timeline : public QObject
{
    Q_OBJECT
public:
    /// A steady clock; tests inject their own.
    using Clock = std::function<Nanoseconds()>;

    /// What a person can do with it; each is a QAction, so that menus, buttons and keys share them.
    enum class Command {
        PlayPause,        ///< Space
        PreviousFrame,    ///< Left
        NextFrame,        ///< Right
        BackOneSecond,    ///< Shift+Left
        ForwardOneSecond, ///< Shift+Right
        ShuttleBack,      ///< J: backwards, twice as fast each time; while K is held, one frame
        ShuttleStop,      ///< K
        ShuttleForward,   ///< L: forwards likewise
        First,            ///< Home
        Last,             ///< End
        Loop,             ///< Ctrl+L, checkable: the selected range, or all
        SelectionBegin,   ///< Shift+I: the selection begins here
        SelectionEnd,     ///< Shift+O: it ends here
        ClearSelection,   ///< Esc, while there is one
    };

    static constexpr double slowestRate = 0.1, fastestRate = 8.0;

    explicit Timeline(QObject *parent = nullptr);
    explicit Timeline(Clock clock, QObject *parent = nullptr);
    ~Timeline() override;

    /// Strictly increasing times; stops playing and goes to the first frame. An empty list: nothing to show.
    void setFrameTimes(std::vector<Nanoseconds> times);
    const std::vector<Nanoseconds> &frameTimes() const { return m_times; }
    qint64 frameCount() const { return static_cast<qint64>(m_times.size()); }
    /// Times of the first and last frame; 0 when empty.
    Nanoseconds startTime() const;
    Nanoseconds endTime() const;

    /// Time of the current frame; 0 when empty.
    Nanoseconds currentTime() const;
    qint64 currentFrame() const { return m_frame; } ///< 0 when empty
    /// Goes to the frame nearest to a time.
    void setCurrentTime(Nanoseconds time);
    void setCurrentFrame(qint64 frame);
    /// Pauses and moves by frames.
    void step(qint64 frames);
    /// Pauses and moves by a duration, at least by one frame.
    void skip(Nanoseconds duration);

    bool isPlaying() const { return m_playing; }
    void play(); ///< at the end: from the other end
    void pause();
    void toggle();
    /// Times of real time; negative: backwards. The magnitude is kept within slowestRate and fastestRate.
    double rate() const { return m_rate; }
    void setRate(double rate);
    void setLooping(bool looping);

    /// The range that is selected; nullopt: none.
    const std::optional<TimeSpan> &selection() const { return m_selection; }
    /// Kept within the time line, at frames, its ends in order; one of a single frame or none at all clears.
    void setSelection(std::optional<TimeSpan> selection);

    QAction *action(Command command) const;
    /// All of them, in the order of Command.
    const QList<QAction *> &actions() const { return m_actions; }

    /// Moves on by what the clock says; called by the own timer while playing, by tests with their clock.
    void tick();

Q_SIGNALS:
    void currentChanged();
    void rangeChanged();
    void playingChanged(bool playing);
    void rateChanged(double rate);
    void selectionChanged();

private:
    void makeActions();
    void updateActions();
    void showFrame(qint64 frame);
    qint64 frameNotAfter(Nanoseconds time) const;
    Nanoseconds frameEnd(qint64 frame) const;
    TimeSpan playedSpan() const;
    Nanoseconds frameTimeNear(Nanoseconds time) const;
    void beginSelection();
    void endSelection();
    void shuttle(double direction);
    void stepOrShuttle(int direction);

    Clock m_clock;
    QTimer m_timer;
    QList<QAction *> m_actions;
    HeldKey *m_stopKey = nullptr;
    std::vector<Nanoseconds> m_times;
    qint64 m_frame = 0;
    double m_rate = 1.0;
    bool m_playing = false;
    bool m_looping = false;
    std::optional<TimeSpan> m_selection;
    Nanoseconds m_position{0}; ///< while playing: time between frames that is shown
    Nanoseconds m_lastTick{0};
};

} // namespace odo
