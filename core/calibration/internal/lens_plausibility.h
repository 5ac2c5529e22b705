// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/internal/lens_fit.h"

namespace odo {

/// What is unlikely about the lens of a fit, in sentences that say what to do; empty of a likely one. Focal
/// lengths across and down that differ by more than 1 %, where the images do not prove the print's squares to
/// be equal, may come from a stretched print: then their difference is added to their σ. A principal point a
/// tenth of the image off its middle is of a cropped image. views: those of the fit.
Message implausible(const std::vector<BoardView> &views, LensFit &fit, const JobControl &control);

/// A sentence that names the image whose pull on the focal length or the centre is most of what all images'
/// pulls are; empty where there is none. views: those of the fit.
Message dominatingImage(const std::vector<BoardView> &views, const LensFit &fit);

} // namespace odo
