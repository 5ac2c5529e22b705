// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <glog/logging.h>

namespace odo {

/// Keeps Ceres from warning on standard error of what its callers expect: steps that it then takes otherwise,
/// parameters that nothing determines. Call it before a fit; any thread.
inline void quietCeres()
{
    static const bool once = [] {
        FLAGS_minloglevel = google::GLOG_ERROR;
        return true;
    }();
    static_cast<void>(once);
}

} // namespace odo
