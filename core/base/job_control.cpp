// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/job_control.h"

namespace odo {

namespace {

thread_local const CancelToken *inForce = nullptr;

} // namespace

CancelScope::CancelScope(const CancelToken *cancel) : m_before(inForce)
{
    inForce = cancel;
}

CancelScope::~CancelScope()
{
    inForce = m_before;
}

const CancelToken *CancelScope::current()
{
    return inForce;
}

void endIfCancelled()
{
    if (inForce && inForce->isCancelled())
        throw WorkCancelled();
}

} // namespace odo
