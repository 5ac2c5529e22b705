// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/models/core_words.h"

#include <QCoreApplication>
#include <array>

/// The sentences of core, one file a subject. What is changed in core is changed here, and its translations
/// with it (tests/ui/models/tst_core_words makes core say them).
namespace odo::core_words {

std::span<const CorePattern> calibration(); ///< Verdicts on a lens.
/// Verdicts on a camera's place on the floor, its accuracy, what has moved, a length measured again.
std::span<const CorePattern> registration();
/// Attentions and warnings of calibrations, trials, recordings and imports.
std::span<const CorePattern> attentions();
/// Cameras, step, disk and the live map while they run; what a job does.
std::span<const CorePattern> health();
std::span<const CorePattern> setup();  ///< Titles, findings and advice of the set-up doctor.
std::span<const CorePattern> spikes(); ///< Reasons of spikes, and what hid a robot.
/// Changes of the project whose words core makes, and where calibrations come from.
std::span<const CorePattern> changes();
/// Errors of projects: opening, saving, names, what belongs to what.
std::span<const CorePattern> errorsProject();
/// Errors of videos, imports, roster and tracks of other programs.
std::span<const CorePattern> errorsVideo();
std::span<const CorePattern> errorsCapture(); ///< Errors of cameras, recording and the disk.
/// Errors of calibrating, registering and checking cameras.
std::span<const CorePattern> errorsCalibration();
/// Errors of boards, marker layouts, axes and planned cameras, and of their geometry.
std::span<const CorePattern> errorsTestbed();
std::span<const CorePattern> errorsFiles(); ///< Errors of files that others wrote: tasks, lenses, tracks.
/// Errors of tracking, measuring, comparing, tasks and scoring; and what most errors are about.
std::span<const CorePattern> errorsTracking();
std::span<const CorePattern> errorsRest(); ///< Errors that are met seldom.

/// One a subject.
inline auto all()
{
    return std::array{calibration(), registration(),   attentions(),        health(),
                      setup(),       spikes(),         changes(),           errorsProject(),
                      errorsVideo(), errorsCapture(),  errorsCalibration(), errorsTestbed(),
                      errorsFiles(), errorsTracking(), errorsRest()};
}

} // namespace odo::core_words
