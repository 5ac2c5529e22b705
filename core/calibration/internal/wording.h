// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/message.h"

namespace odo {

/// "12.3 mm".
MessageArgument millimetres(double metres);

/// Clauses, joined or not, as one sentence with its full stop.
Message sentence(Message clauses);

/// The first sentence of a verdict, of clauses without a full stop: "Good: 4 markers fit ...".
Message goodVerdict(Message clauses);
Message usableVerdict(Message clauses);
Message uncertainVerdict(Message clauses);
/// How a registration is judged by the larger of its misfit and its σ, both in metres, against the extent of
/// its points.
bool isGoodRegistration(double worseM, double extentM);
Message registrationVerdict(double worseM, double extentM, Message clauses);

// What several checks say.
Message edgesAreWide(double widthPx);                 ///< of a board that is not sharp
Message sameBoardPosition(const std::string &source); ///< of an image, as in the one of this source
Message pointsUndetermined();                         ///< they do not determine the camera position
Message hardlyChecked(Message four); ///< a sentence of the clause that four check one another little
Message calibrateToRely();           ///< a sentence, without a lens calibration

// What several of them advise.
Message useCameraImage();
Message correctPixels();
Message markWhereSeen();
Message spreadMarkers();

} // namespace odo
