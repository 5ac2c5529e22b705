// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>

namespace odo::test {

/// What a test program may be given no more of. Linked into a test it stands before the system's own
/// functions for all of the program's threads.
enum class Scarce {
    Memory,      ///< operator new, as Odograph's own code and the standard library call it
    VideoMemory, ///< what libav allocates
    Threads      ///< pthread_create
};

/// While it lives, the n-th request from now on fails, counted from 1 (0: none); all after it succeed again.
/// One at a time.
class FailingRequest
{
public:
    FailingRequest(Scarce what, std::uint64_t n);
    ~FailingRequest();
    FailingRequest(const FailingRequest &) = delete;
    FailingRequest &operator=(const FailingRequest &) = delete;

    std::uint64_t requests() const; ///< so far
    bool hasFailed() const;         ///< whether the n-th has come
};

} // namespace odo::test
