// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/message.h"

#include <atomic>
#include <functional>
#include <memory>
#include <string>

namespace odo {

/// A flag that asks a job to stop. Copies share the flag; any thread may set or read it.
class CancelToken
{
public:
    void cancel() const { m_flag->store(true, std::memory_order_relaxed); }
    bool isCancelled() const { return m_flag->load(std::memory_order_relaxed); }

private:
    std::shared_ptr<std::atomic<bool>> m_flag = std::make_shared<std::atomic<bool>>(false);
};

/// What long work needs of its caller: somewhere to report, and a way to be stopped.
/// The progress function is called on the thread that works; it must be quick and must not throw.
struct JobControl
{
    CancelToken cancel;
    /// fraction in [0,1]; may be empty
    std::function<void(double fraction, const Message &text)> progress;

    void report(double fraction, const Message &text) const
    {
        if (progress)
            progress(fraction, text);
    }
    bool isCancelled() const { return cancel.isCancelled(); }
};

/// What a part of long work is given: its own progress is from one fraction of the whole to another.
inline JobControl partOf(const JobControl &whole, double from, double to)
{
    JobControl part = whole;
    if (whole.progress)
        part.progress = [report = whole.progress, from, to](double fraction, const Message &text) {
            report(from + (to - from) * fraction, text);
        };
    return part;
}

/// Thrown by endIfCancelled(); orShortage makes it an Error with the code Cancelled.
struct WorkCancelled
{
};

/// While it lives, what its thread computes ends where it asks: for long work on values, far below those who
/// have a JobControl, that holds nothing that has to be cleaned up. Scopes may lie within one another, and in
/// sideBySide() hold for all parts.
class CancelScope
{
public:
    /// cancel must outlive it; null: nothing ends.
    explicit CancelScope(const CancelToken *cancel);
    ~CancelScope();
    CancelScope(const CancelScope &) = delete;
    CancelScope &operator=(const CancelScope &) = delete;

    static const CancelToken *current();

private:
    const CancelToken *const m_before;
};

/// Throws WorkCancelled where the scope around it is cancelled. As quick as a look at a variable.
void endIfCancelled();

} // namespace odo
