// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/message.h"

#include <string>

namespace odo {

/// What many errors and warnings are about, the same words everywhere: "camera 'Left'".
Message cameraSubject(std::string name);
Message robotSubject(std::string name);
Message teamSubject(std::string name);
Message classSubject(std::string name);
Message taskSubject(std::string name);
Message trialSubject(std::string name);
Message layoutSubject(std::string name);
Message fileSubject(const std::filesystem::path &path);       ///< the path alone
Message quotedFileSubject(const std::filesystem::path &path); ///< "file 'A.csv'"
Message quotedName(MessageArgument name);                     ///< "'Left'", in a list
Message robotInTrialSubject(std::string robot, std::string trial);
Message viewInTrialSubject(std::string camera, std::string trial);

} // namespace odo
