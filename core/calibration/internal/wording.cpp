// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/internal/wording.h"

#include "core/base/units.h"

#include <algorithm>

namespace odo {

MessageArgument millimetres(double metres)
{
    return quantity(toMillimetres(metres), 1, "mm");
}

Message sentence(Message clauses)
{
    return ODO_TEXT("calibration.sentence", "%1.")(std::move(clauses));
}

Message goodVerdict(Message clauses)
{
    return ODO_TEXT("calibration.good", "Good: %1.")(std::move(clauses));
}

Message usableVerdict(Message clauses)
{
    return ODO_TEXT("calibration.usable", "Usable: %1.")(std::move(clauses));
}

Message uncertainVerdict(Message clauses)
{
    return ODO_TEXT("calibration.uncertain", "Uncertain: %1.")(std::move(clauses));
}

bool isGoodRegistration(double worseM, double extentM)
{
    return worseM <= std::max(0.005, 0.0025 * extentM);
}

Message registrationVerdict(double worseM, double extentM, Message clauses)
{
    if (isGoodRegistration(worseM, extentM))
        return goodVerdict(std::move(clauses));
    if (worseM <= std::max(0.015, 0.0075 * extentM))
        return usableVerdict(std::move(clauses));
    return ODO_TEXT("calibration.poor_measure_again",
                    "Poor, measure the markers again: %1.")(std::move(clauses));
}

Message edgesAreWide(double widthPx)
{
    return ODO_TEXT("calibration.edges_wide", "its edges are %1 pixels wide")(quantity(widthPx, 0));
}

Message sameBoardPosition(const std::string &source)
{
    return ODO_TEXT("calibration.board_stands_as_in", "the board is in the same position as in %1")(source);
}

Message pointsUndetermined()
{
    return ODO_TEXT("calibration.points_undetermined", "the points do not determine the camera position");
}

Message hardlyChecked(Message four)
{
    return joined({std::move(four), ODO_TEXT("calibration.fifth_would", "add a fifth.")}, Join::Semicolon);
}

Message calibrateToRely()
{
    return ODO_TEXT("calibration.calibrate_to_rely", "Calibrate it for reliable positions.");
}

Message useCameraImage()
{
    return ODO_TEXT("calibration.use_camera_picture", "use an image from the camera");
}

Message correctPixels()
{
    return ODO_TEXT("calibration.correct_pixels", "correct the pixels");
}

Message markWhereSeen()
{
    return ODO_TEXT("calibration.mark_where_seen", "mark each of them at its own position in the image");
}

Message spreadMarkers()
{
    return ODO_TEXT("calibration.spread_markers", "spread the markers over the floor");
}

} // namespace odo
