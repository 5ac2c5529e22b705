// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>

namespace odo {

/// While it lives, the system does not put the computer to sleep by itself: neither because nobody uses it,
/// nor when its lid is closed or it is told to. Released also when this program is killed. On Linux through
/// systemd-logind, by its program systemd-inhibit. Any thread, one at a time.
class SleepInhibitor
{
public:
    /// why: as the system lists it, in English: "recording". nullptr where the system knows no such thing.
    static std::unique_ptr<SleepInhibitor> take(const std::string &why);
    ~SleepInhibitor();
    SleepInhibitor(const SleepInhibitor &) = delete;
    SleepInhibitor &operator=(const SleepInhibitor &) = delete;

private:
    SleepInhibitor(int process, int pipe) : m_process(process), m_pipe(pipe) {}
    const int m_process, m_pipe; ///< ends when the pipe does
};

} // namespace odo
