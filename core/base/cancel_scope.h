// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/job_control.h"

namespace odo {

/// Thrown by endIfCancelled(); orShortage makes it an Error with the code Cancelled.
struct WorkCancelled
{
};

/// While it lives, what its thread computes ends where it asks: for long work on values, far below those who have a JobControl, that holds
/// nothing which has to be put right. Scopes may lie within one another, and in sideBySide() hold for all parts.
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
