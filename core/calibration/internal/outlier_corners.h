// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/internal/lens_fit.h"

#include <vector>

namespace odo {

/// Indices of corners, a list for each view, ascending.
using CornerMarks = std::vector<std::vector<std::size_t>>;

/// sqrt(2 ln 2): the median distance of points whose coordinates have σ 1.
inline constexpr double medianOfRayleigh = 1.17741;

/// σ of one coordinate, from the median distance of the corners.
double medianSigmaPx(const LensFit &fit);
/// The same, what the fit took away by adapting given back.
double robustSigmaPx(const LensFit &fit);

/// Beyond 5 σ (and 0.1 px) from its prediction a corner is an outlier: of normal errors one in 270 000.
double outlierLimitPx(double sigmaPx);
/// The corners farther than that from their prediction.
CornerMarks cornersBeyond(const LensFit &fit, double limitPx);

/// The outlier corners of a fit, by outlierLimitPx(robustSigmaPx). If the fit has any, it is repeated with
/// Cauchy's loss, so they cannot bend it, and the corners are judged by that. Empty lists if there are none.
CornerMarks outlyingCorners(const std::vector<BoardView> &views, const LensFit &fit,
                            const JobControl &control);

/// Those corners of the marks that are misread: the isolated ones, and all of an image whose other corners
/// lie on a flat board as well as those of other images do; there also the whole of an outer row or column
/// with many marks. Three or more near one another (two squares) beside a rest that does not are a sign of a
/// bent board, for a person to check. A view that would keep fewer than six keeps all.
CornerMarks misreadCorners(const std::vector<BoardView> &views, const LensFit &fit, const CornerMarks &marks);

std::size_t countOf(const CornerMarks &marks);

/// The views without the corners marked.
std::vector<BoardView> withoutCorners(const std::vector<BoardView> &views, const CornerMarks &marks);

} // namespace odo
