// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/trajectory/internal/cause_model.h"

#include "core/base/units.h"

#include <array>
#include <numbers>

namespace odo {

namespace {

constexpr double degreeRad = std::numbers::pi / 180;
constexpr std::array rotationScalesRad{0.04 * degreeRad, 0.2 * degreeRad, 1.0 * degreeRad};
constexpr std::array offsetScalesS{0.008, 0.05};
constexpr std::array heightScalesM{0.008, 0.04};
constexpr double clockRateScale = 0.001, freeHeightScaleM = 0.03, clearanceScaleM = 0.005;

} // namespace

std::vector<CauseModel> lastingCauses(bool isHeightGiven)
{
    using Kind = ContradictionCause::Kind;
    std::vector<CauseModel> all;
    const std::vector<double> one{1.0}, rotation(rotationParameters, 1.0),
        rotations(2 * rotationParameters, 1.0),
        rotationScales(rotationScalesRad.begin(), rotationScalesRad.end()),
        offsetScales(offsetScalesS.begin(), offsetScalesS.end()),
        heightScales(heightScalesM.begin(), heightScalesM.end());
    const auto add = [&](CauseModel cause) {
        // a height that was estimated from these positions has taken up what it could, and so has the
        // clearance under a robot whose height is given
        if (!cause.raises) {
            cause.raises = true;
            cause.sigmas.push_back((isHeightGiven ? clearanceScaleM : freeHeightScaleM) /
                                   cause.scales[cause.scales.size() / 2]);
        }
        all.push_back(std::move(cause));
    };
    add({.kind = Kind::CameraMoved, .rotatesA = true, .scales = rotationScales, .sigmas = rotation});
    add({.kind = Kind::CameraMoved, .rotatesB = true, .scales = rotationScales, .sigmas = rotation});
    add({.kind = Kind::CamerasMoved,
         .rotatesA = true,
         .rotatesB = true,
         .scales = rotationScales,
         .sigmas = rotations});
    add({.kind = Kind::Offset, .shiftsTime = true, .scales = offsetScales, .sigmas = one});
    add({.kind = Kind::ClockRate,
         .shiftsTime = true,
         .changesRate = true,
         .scales = offsetScales,
         .sigmas = {1.0, clockRateScale / offsetScalesS.back()}});
    if (isHeightGiven)
        add({.kind = Kind::Height, .raises = true, .scales = heightScales, .sigmas = one});
    return all;
}

PairCorrection correctionBy(const CauseModel &model, const Eigen::VectorXd &parameters, double aboutS)
{
    PairCorrection correction;
    Eigen::Index next = 0;
    for (const auto &[turns, its] :
         {std::pair(model.rotatesA, &correction.turnA), std::pair(model.rotatesB, &correction.turnB)}) {
        if (!turns)
            continue;
        *its = parameters.segment<3>(next);
        next += rotationParameters;
    }
    if (model.sinceS)
        correction.since = fromSeconds(*model.sinceS);
    correction.aboutS = aboutS;
    if (model.shiftsTime)
        correction.laterS = parameters[next++];
    if (model.changesRate)
        correction.laterPerS = parameters[next++];
    if (model.kind == ContradictionCause::Kind::Height)
        correction.raiseM = parameters[next];
    return correction;
}

} // namespace odo
