// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/steady_now.h"

#include <atomic>
#include <thread>

namespace odo::test {

/// How long the emulated machine has stood still since this began, because the host had no time for it: what
/// a thread that looks each ten milliseconds looked too late. A program in it is no faster than that.
class MachineStalls
{
public:
    MachineStalls()
        : m_thread([this](const std::stop_token &stop) {
              while (!stop.stop_requested()) {
                  const Nanoseconds due = steadyNow() + each;
                  std::this_thread::sleep_for(each);
                  m_stalled += std::max(Nanoseconds(0), steadyNow() - due).count();
              }
          })
    {
    }
    Nanoseconds total() const { return Nanoseconds(m_stalled.load()); }

private:
    static constexpr Nanoseconds each = std::chrono::milliseconds(10);
    std::atomic<Nanoseconds::rep> m_stalled = 0;
    std::jthread m_thread; ///< last, so that it begins when all is there
};

} // namespace odo::test
