// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/project.h"
#include "core/workflow/trial_sources.h"

#include <string>
#include <vector>

namespace odo {

/// Which recordings are opened to read what their files say: to open one takes some 10 ms, and those whose
/// frames no version has turned can be told without.
enum class Opened { All, NeverTurned };

/// A whole sentence on a view whose recording an earlier version measured as stored, although its file
/// demands to be shown turned, mirrored or stretched: it stays so, and a new import would read otherwise.
/// Empty for any other. Opens the file. Any thread.
Message storedFrameWarning(const std::string &trialName, const RecordingRecord &recording,
                           const std::filesystem::path &file, Opened which = Opened::All);

/// Those of a trial's views, and sentences on views whose frames are turned while the registration of their
/// camera may belong to frames as stored. Any thread.
std::vector<Message> turnedWarnings(const std::string &trialName, const std::vector<RegisteredView> &views,
                                    Opened which = Opened::All);

/// Of one view whose recording may be new: that an earlier version registered its camera, perhaps by frames
/// as stored, while its frames are turned. Nothing where the size of the frames or what the registration's
/// image shows tells that they were upright. Reads a frame of the recording. Any thread.
Message oldRegistrationWarning(const std::string &trialName, const RegisteredView &view);

/// All recordings of a project that storedFrameWarning warns of, for its check. Project's thread.
Result<std::vector<ProjectProblem>> turnedRecordings(Project &project, Opened which);

} // namespace odo
