// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/calibration_verdict.h"

#include "core/base/units.h"
#include "core/base/upper_median.h"
#include "core/calibration/board_coverage.h"
#include "core/calibration/calibration_checks.h"
#include "core/calibration/lens_choice.h"
#include "core/calibration/wording.h"

#include <algorithm>
#include <cctype>

namespace odo {

namespace {

constexpr std::size_t fewViews = 10;
constexpr double goodM = 0.005, usableM = 0.015; // at worst on the floor, σ
constexpr double goodFocal = 0.005, usableFocal = 0.015, goodPx = 1, usablePx = 2;
constexpr double leastCoverage = 0.5; // of the picture
constexpr double standingOut = 3;     // times the median of the pictures' RMS

std::string millimetreWords(double metres)
{
    const double mm = toMillimetres(metres);
    return formatNumber(mm, mm < 10 ? 1 : 0) + " mm";
}

std::vector<const CalibrationPicture *> usedPictures(const IntrinsicCalibration &calibration)
{
    std::vector<const CalibrationPicture *> used;
    for (const CalibrationPicture &picture : calibration.pictures) {
        if (picture.used)
            used.push_back(&picture);
    }
    return used;
}

double coveredPart(const IntrinsicCalibration &calibration)
{
    std::vector<BoardView> views;
    for (const CalibrationPicture *picture : usedPictures(calibration))
        views.push_back(picture->view);
    return coverageOf(views, {}, calibration.intrinsics.widthPx, calibration.intrinsics.heightPx).coveredPart();
}

std::string grade(const IntrinsicCalibration &calibration, double focalSigma, double covered)
{
    const double worstM = calibration.onFloor ? calibration.onFloor->worstM : 1;
    const bool trusted = calibration.disagreeingPart <= mostOutliers;
    if (worstM < goodM && focalSigma < goodFocal && calibration.rmsPx < goodPx && trusted &&
        calibration.picturesUsed() >= fewViews && covered >= leastCoverage)
        return "Good: ";
    return worstM < usableM && focalSigma < usableFocal && calibration.rmsPx < usablePx ? "Usable: " : "Poor: ";
}

std::string floorWords(const IntrinsicCalibration &calibration)
{
    if (!calibration.onFloor)
        return "no figure in millimetres, since this lens holds only for a part of the picture; ";
    const FloorExpectation &floor = *calibration.onFloor;
    return "±" + millimetreWords(floor.middleM) + " in the middle and ±" + millimetreWords(floor.worstM) + " at worst (" +
           floor.worstWhere + ") on " + typicalTestbedWords() + ", as far as the lens is concerned; ";
}

std::string fitWords(const IntrinsicCalibration &calibration, double focalSigma)
{
    std::string words = std::to_string(calibration.picturesUsed()) + " pictures fit to " +
                        formatNumber(calibration.rmsPx, 2) + " px, focal length " +
                        formatNumber(calibration.intrinsics.fxPx, 1) + " px ± " + percentWords(focalSigma);
    if (calibration.crossValidationPx > 0)
        words += "; each half of them foretells the other to " + formatNumber(calibration.crossValidationPx, 2) + " px";
    if (calibration.halvesApart)
        words += ", " + millimetreWords(calibration.halvesApart->worstM) + " apart at worst on that floor";
    return words + ".";
}

/// "in left02.jpg (6) and left09.jpg (3)", the pictures with most of the corners first. counted: of one picture.
template <class Counted>
std::string whereWords(const IntrinsicCalibration &calibration, Counted counted)
{
    constexpr std::size_t mostNamed = 3;
    std::vector<const CalibrationPicture *> with = usedPictures(calibration);
    std::erase_if(with, [&](const CalibrationPicture *picture) { return counted(*picture) == 0; });
    std::ranges::stable_sort(with, std::ranges::greater{},
                             [&](const CalibrationPicture *picture) { return counted(*picture); });
    std::vector<std::string> names;
    for (const CalibrationPicture *picture : with) {
        if (names.size() < mostNamed)
            names.push_back(picture->view.source + " (" + std::to_string(counted(*picture)) + ")");
    }
    return (with.size() > mostNamed ? "most in " : "in ") + listed(names);
}

std::string outlierWords(const IntrinsicCalibration &calibration)
{
    if (calibration.disagreeingPart <= 0)
        return "";
    const auto all = [](const CalibrationPicture &picture) { return picture.outliers.size(); };
    const auto left = [](const CalibrationPicture &picture) { return picture.leftOut.size(); };
    const auto kept = [](const CalibrationPicture &picture) { return picture.outliers.size() - picture.leftOut.size(); };
    std::string words = " ";
    if (calibration.disagreeingPart > mostOutliers) {
        words += formatNumber(100 * calibration.disagreeingPart, 0) + " % of the corners disagree, " +
                 whereWords(calibration, all);
        return words + ": they were kept; look at these pictures and leave out those that are blurred, bent or of another board.";
    }
    const std::size_t leftOut = calibration.cornersLeftOut();
    std::size_t keptCount = 0;
    for (const CalibrationPicture &picture : calibration.pictures)
        keptCount += kept(picture);
    if (leftOut > 0)
        words += std::to_string(leftOut) + (leftOut == 1 ? " corner that stands out was" : " corners that stand out were") +
                 " left out, " + whereWords(calibration, left) + ". ";
    if (keptCount > 0)
        words += std::to_string(keptCount) + " corners that stand out side by side were kept, " +
                 whereWords(calibration, kept) + ": leave out these pictures if the board is bent, cut or covered there. ";
    words.pop_back();
    return words;
}

/// The picture whose misfit stands out from the others, if one does.
std::string oddPicture(const IntrinsicCalibration &calibration)
{
    std::vector<double> rms;
    const CalibrationPicture *worst = nullptr;
    for (const CalibrationPicture *picture : usedPictures(calibration)) {
        rms.push_back(picture->rmsPx);
        if (worst == nullptr || picture->rmsPx > worst->rmsPx)
            worst = picture;
    }
    if (worst == nullptr || worst->rmsPx <= standingOut * upperMedian(rms))
        return "";
    return " Look at " + worst->view.source + ": its " + formatNumber(worst->rmsPx, 2) + " px stand out.";
}

std::string lensWords(const IntrinsicCalibration &calibration)
{
    std::string name = lensModelName(calibration.intrinsics.model);
    name[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(name[0])));
    return " " + name + " lens: " + calibration.lensReason + ".";
}

} // namespace

std::string calibrationVerdict(const IntrinsicCalibration &calibration, double focalSigma)
{
    const double covered = coveredPart(calibration);
    std::string verdict = grade(calibration, focalSigma, covered) + floorWords(calibration) +
                          fitWords(calibration, focalSigma) + lensWords(calibration) + outlierWords(calibration);
    if (calibration.picturesUsed() < fewViews)
        verdict += " More pictures (" + std::to_string(fewViews) + " or more) would make it surer.";
    if (covered < leastCoverage)
        verdict += " Only " + formatNumber(100 * covered, 0) +
                   " % of the picture was covered: show the board near its edges too.";
    return verdict + oddPicture(calibration);
}

} // namespace odo
