// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"

#include <cstddef>
#include <cstdint>

namespace odo {

/// What several errors and problems of a project say, the same words everywhere.

Message fileIsDamaged();
Message restoreFile(); ///< advice
Message isNoProject();
Message chooseOurFile(); ///< advice
Message isOfNewerFormat(std::int64_t version, int newestKnown);
Message openWithThatOdograph();  ///< advice
Message openWithNewerOdograph(); ///< advice
Message cannotBeWrittenTo();
Message copyToWritableFolder(); ///< advice
Message anotherProgramWrites();
Message closeOtherProgram(); ///< advice
Message diskCannotBeRead();
Message copyToAnotherDisk();       ///< advice
Message writingFailed(int reason); ///< an errno
Message checkDiskAndRetry();       ///< advice

Message isDamagedRestoreFile();       ///< advice, of what only a damaged file holds
Message restoreProject();             ///< advice
Message hasTooManySamples();          ///< more than maxBlobRows
Message useAtMost(std::size_t count); ///< advice
Message putFileBack();                ///< advice
Message keepIt();                     ///< advice
Message projectCheck();               ///< "check of the project"
Message runProjectCheck();            ///< advice

} // namespace odo
