// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

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
    std::function<void(double fraction, const std::string &text)> progress; ///< fraction in [0,1]; may be empty

    void report(double fraction, const std::string &text) const
    {
        if (progress)
            progress(fraction, text);
    }
    bool isCancelled() const { return cancel.isCancelled(); }
};

} // namespace odo
