// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/memory_pools.h"

#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace odo {

void shareMemoryPools()
{
#ifdef __GLIBC__
    mallopt(M_ARENA_MAX, 2);
#endif
}

} // namespace odo
