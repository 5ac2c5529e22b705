// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/job_control.h"

namespace odo {

/// From now on SIGINT (Ctrl-C), SIGTERM and SIGHUP ask this program to stop in good order: each cancels the
/// token and is told by the descriptor. A second SIGINT ends it at once. SIGHUP stays ignored where it was
/// (nohup). Once, at the start.
void watchStopSignals();

/// Cancelled by the first of them. Any thread.
const CancelToken &stopToken();
/// Which came first, SIGINT before the others; 0: none. Any thread.
int stopSignal();
/// Can be read from once one came; nobody reads from it. -1: there was none to be had.
int stopDescriptor();

/// The exit status of a program that was asked to stop, as a shell tells it: 130 of Ctrl-C, or where no
/// signal came; 143 of SIGTERM, 129 of SIGHUP.
int exitStatusOfStop();

} // namespace odo
