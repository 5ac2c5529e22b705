// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/intrinsic_calibration.h"

#include "core/base/percentile.h"
#include "core/base/units.h"
#include "core/calibration/board_placement.h"
#include "core/calibration/internal/calibration_checks.h"
#include "core/calibration/internal/lens_choice.h"
#include "core/calibration/internal/plane_pose.h"
#include "core/calibration/internal/wording.h"

#include <algorithm>
#include <cctype>
#include <cmath>

namespace odo {

namespace {

constexpr std::size_t leastViews = 3;
constexpr double mostDisagreeing = 0.25; // of the corners: with more it is not known which of them are right

/// Why a view cannot be used and what to do; empty where it can.
std::string faultOf(const BoardView &view)
{
    const std::size_t corners = std::min(view.pixels.size(), view.pointsOnBoard.size());
    if (corners < leastCornersOfView || view.pixels.size() != view.pointsOnBoard.size())
        return "it has " + std::to_string(corners) + " corners of the board, six are needed: show more of it";
    if (!std::ranges::all_of(view.pixels, [](const auto &p) { return p.allFinite(); }) ||
        !std::ranges::all_of(view.pointsOnBoard, [](const auto &p) { return p.allFinite(); }))
        return "a corner of it is not a number: let the board be found in it again";
    return "";
}

/// The views that can be used; the others are told with a reason.
std::vector<BoardView> usableViews(const std::vector<BoardView> &views,
                                   std::vector<RejectedPicture> &rejected)
{
    std::vector<BoardView> usable;
    for (const BoardView &view : views) {
        const std::string fault = faultOf(view);
        if (fault.empty())
            usable.push_back(view);
        else
            rejected.push_back({view.source, fault});
    }
    return usable;
}

tl::unexpected<Error> tooFew(std::size_t usable)
{
    return refuseCalibration("three pictures of the board are needed, " + std::to_string(usable) +
                                 " can be used",
                             "take ten or more, the board tilted differently in each");
}

/// Starts of the models for the same views; views are dropped that have no pose under any model, and models
/// under which more views have none than under another.
std::vector<LensStart> startsFor(std::vector<BoardView> &views, int widthPx, int heightPx,
                                 std::optional<LensModel> model, std::vector<RejectedPicture> &rejected)
{
    std::vector<LensModel> models{LensModel::Standard, LensModel::Fisheye, LensModel::Rational};
    if (model)
        models = {*model};
    else if (views.size() < leastViewsForHalves)
        models = {LensModel::Standard};
    std::vector<std::vector<std::size_t>> withoutPose(models.size());
    std::vector<std::optional<LensStart>> starts;
    std::size_t fewest = views.size();
    for (std::size_t i = 0; i < models.size(); ++i) {
        // A rational lens begins as a standard one.
        if (models[i] == LensModel::Rational && !model) {
            starts.push_back(starts.front());
            withoutPose[i] = withoutPose.front();
            if (starts.back())
                starts.back()->intrinsics.model = LensModel::Rational;
        } else {
            starts.push_back(startLens(views, widthPx, heightPx, models[i], withoutPose[i]));
        }
        if (starts.back())
            fewest = std::min(fewest, withoutPose[i].size());
    }
    std::vector<LensStart> kept;
    std::vector<std::size_t> dropped;
    for (std::size_t i = 0; i < models.size(); ++i) {
        if (!starts[i] || withoutPose[i].size() > fewest || (!kept.empty() && withoutPose[i] != dropped))
            continue;
        dropped = withoutPose[i];
        kept.push_back(std::move(*starts[i]));
    }
    for (auto index = dropped.rbegin(); index != dropped.rend(); ++index) {
        rejected.push_back(
            {views[*index].source,
             "its corners do not lie as on a flat board: glue the board onto something stiff"});
        views.erase(views.begin() + static_cast<std::ptrdiff_t>(*index));
    }
    return kept;
}

/// Fills in the residuals of a picture under a lens and a pose, and its RMS over the corners that count.
void judge(CalibrationPicture &picture, const CameraModel &camera, const RigidTransform &cameraFromBoard)
{
    picture.residualsPx.clear();
    double squares = 0, count = 0;
    for (std::size_t i = 0; i < picture.view.pixels.size(); ++i) {
        const Eigen::Vector2d &point = picture.view.pointsOnBoard[i];
        const auto pixel = camera.project(cameraFromBoard * Eigen::Vector3d(point.x(), point.y(), 0));
        picture.residualsPx.push_back(pixel ? Eigen::Vector2d(picture.view.pixels[i] - *pixel)
                                            : Eigen::Vector2d::Constant(std::nan("")));
        if (!pixel || std::ranges::binary_search(picture.leftOut, i))
            continue;
        squares += picture.residualsPx.back().squaredNorm();
        ++count;
    }
    picture.rmsPx = count > 0 ? std::sqrt(squares / count) : 0;
}

std::optional<RigidTransform> poseOf(const BoardView &view, const CameraModel &camera)
{
    std::vector<PointPair> pairs;
    for (std::size_t i = 0; i < view.pixels.size(); ++i)
        pairs.push_back({view.pointsOnBoard[i], view.pixels[i], {}});
    const auto pose = fitPlanePose(pairs, camera, FocalLength::Known);
    return pose ? std::optional(pose->worldFromCamera.inverse()) : std::nullopt;
}

/// From a lens fitted to all corners to the outcome: outliers, halves, checks, figures, words. views: those
/// of the pictures in `calibration` that are used, in their order.
Result<void> finish(IntrinsicCalibration &calibration, const std::vector<BoardView> &views, LensFit fit,
                    const CornerMarks &outliers, const JobControl &control)
{
    if (auto one = checkOneCamera(views, fit, control); !one)
        return one;
    std::size_t corners = 0;
    for (const BoardView &view : views)
        corners += view.pixels.size();
    calibration.disagreeingPart = static_cast<double>(countOf(outliers)) / static_cast<double>(corners);
    if (calibration.disagreeingPart >= mostDisagreeing)
        return refuseCalibration(
            percentWords(calibration.disagreeingPart) + " of the corners do not agree with the others",
            "check that all pictures are sharp, of one flat board and of one camera at one zoom and focus");
    const CornerMarks leftOut = calibration.disagreeingPart <= mostOutliers
                                    ? singleCorners(views, fit, outliers)
                                    : CornerMarks(views.size());
    const std::vector<BoardView> counted = withoutCorners(views, leftOut);
    if (countOf(leftOut) > 0) {
        auto again = fitLens(counted, {fit.intrinsics, fit.cameraFromBoard}, {}, control);
        if (again)
            fit = std::move(*again);
    }
    control.report(0.6, "checking halves against one another");
    const auto halves = holdOut(counted, fit, control);
    if (control.isCancelled())
        return cancelled(calibrationWhat);
    const auto sigma = checkDetermined(counted, fit, halves, control);
    if (!sigma)
        return tl::unexpected(sigma.error());

    if (auto spread = checkPlaces(views, fit.intrinsics.widthPx, fit.intrinsics.heightPx); !spread)
        return spread;

    calibration.intrinsics = fit.intrinsics;
    calibration.rmsPx = fit.rmsPx();
    calibration.onFloor = expectedOnFloor(fit.intrinsics);
    if (halves) {
        calibration.crossValidationPx = halves->rmsPx;
        calibration.halvesApart = apartOnFloor(halves->lenses[0], halves->lenses[1]);
    }
    const auto camera = CameraModel::create(fit.intrinsics);
    std::size_t next = 0;
    for (CalibrationPicture &picture : calibration.pictures) {
        picture.outliers.clear();
        picture.leftOut.clear();
        if (picture.used) {
            picture.outliers = outliers[next];
            picture.leftOut = leftOut[next];
            judge(picture, *camera, fit.cameraFromBoard[next++]);
        } else if (const auto pose = poseOf(picture.view, *camera)) {
            judge(picture, *camera, *pose);
        }
    }
    calibration.verdict = calibrationVerdict(calibration, *sigma);
    control.report(1, "done");
    return {};
}

} // namespace

std::size_t IntrinsicCalibration::picturesUsed() const
{
    return static_cast<std::size_t>(std::ranges::count_if(pictures, &CalibrationPicture::used));
}

std::size_t IntrinsicCalibration::cornersLeftOut() const
{
    std::size_t count = 0;
    for (const CalibrationPicture &picture : pictures)
        count += picture.leftOut.size();
    return count;
}

Result<IntrinsicCalibration> calibrateIntrinsics(const std::vector<BoardView> &views, int widthPx,
                                                 int heightPx, std::optional<LensModel> model,
                                                 const JobControl &control)
{
    if (widthPx <= 0 || heightPx <= 0)
        return fail(ErrorCode::InvalidInput, calibrationWhat, "the picture has no size",
                    "use pictures of the camera");
    IntrinsicCalibration calibration;
    std::vector<BoardView> used = usableViews(views, calibration.rejected);
    if (used.size() < leastViews)
        return tooFew(used.size());
    const auto starts = startsFor(used, widthPx, heightPx, model, calibration.rejected);
    if (used.size() < leastViews || starts.empty())
        return tooFew(used.size());
    control.report(0.1, "fitting the lens to " + std::to_string(used.size()) + " pictures");
    auto choice = chooseLens(used, starts, control);
    if (control.isCancelled())
        return cancelled(calibrationWhat);
    if (!choice)
        return refuseCalibration("no lens fits these pictures",
                                 "check that all are of one camera, at one zoom and focus");
    for (const BoardView &view : used)
        calibration.pictures.push_back({view, true, 0, {}, {}, {}});
    calibration.lensTrials = std::move(choice->trials);
    calibration.lensReason = model || used.size() >= leastViewsForHalves
                                 ? std::move(choice->reason)
                                 : "too few pictures to compare it with others";
    if (auto finished = finish(calibration, used, std::move(choice->fit), choice->outliers, control);
        !finished)
        return tl::unexpected(finished.error());
    return calibration;
}

Result<IntrinsicCalibration> recalibrate(const IntrinsicCalibration &reference,
                                         const std::vector<std::size_t> &pictures, const JobControl &control)
{
    IntrinsicCalibration calibration = reference;
    calibration.crossValidationPx = 0;
    calibration.halvesApart.reset();
    const auto camera = CameraModel::create(reference.intrinsics);
    if (!camera)
        return tl::unexpected(camera.error());
    std::vector<BoardView> used;
    LensStart start{reference.intrinsics, {}};
    for (std::size_t i = 0; i < calibration.pictures.size(); ++i) {
        CalibrationPicture &picture = calibration.pictures[i];
        const auto pose =
            std::ranges::find(pictures, i) == pictures.end() ? std::nullopt : poseOf(picture.view, *camera);
        picture.used = pose.has_value();
        if (!pose)
            continue;
        used.push_back(picture.view);
        start.cameraFromBoard.push_back(*pose);
    }
    if (used.size() < leastViews)
        return tooFew(used.size());
    auto fit = fitLens(used, start, {}, control);
    if (control.isCancelled())
        return cancelled(calibrationWhat);
    if (!fit)
        return refuseCalibration("no lens fits these pictures", "choose others");
    const CornerMarks outliers = outlyingCorners(used, *fit, control);
    if (auto finished = finish(calibration, used, std::move(*fit), outliers, control); !finished)
        return tl::unexpected(finished.error());
    return calibration;
}

std::vector<std::size_t> picturesWithin(const IntrinsicCalibration &calibration, double mostRmsPx)
{
    std::vector<std::size_t> within;
    for (std::size_t i = 0; i < calibration.pictures.size(); ++i) {
        if (calibration.pictures[i].rmsPx <= mostRmsPx)
            within.push_back(i);
    }
    return within;
}

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
    return coverageOf(views, {}, calibration.intrinsics.widthPx, calibration.intrinsics.heightPx)
        .coveredPart();
}

std::string grade(const IntrinsicCalibration &calibration, double focalSigma, double covered)
{
    const double worstM = calibration.onFloor ? calibration.onFloor->worstM : 1;
    const bool trusted = calibration.disagreeingPart <= mostOutliers;
    if (worstM < goodM && focalSigma < goodFocal && calibration.rmsPx < goodPx && trusted &&
        calibration.picturesUsed() >= fewViews && covered >= leastCoverage)
        return "Good: ";
    return worstM < usableM && focalSigma < usableFocal && calibration.rmsPx < usablePx ? "Usable: "
                                                                                        : "Poor: ";
}

std::string floorWords(const IntrinsicCalibration &calibration)
{
    if (!calibration.onFloor)
        return "no figure in millimetres, since this lens holds only for a part of the picture; ";
    const FloorExpectation &floor = *calibration.onFloor;
    return "±" + millimetreWords(floor.middleM) + " in the middle and ±" + millimetreWords(floor.worstM) +
           " at worst (" + floor.worstWhere + ") on " + typicalTestbedWords() +
           ", as far as the lens is concerned; ";
}

std::string fitWords(const IntrinsicCalibration &calibration, double focalSigma)
{
    std::string words = std::to_string(calibration.picturesUsed()) + " pictures fit to " +
                        formatNumber(calibration.rmsPx, 2) + " px, focal length " +
                        formatNumber(calibration.intrinsics.fxPx, 1) + " px ± " + percentWords(focalSigma);
    if (calibration.crossValidationPx > 0)
        words += "; each half of them foretells the other to " +
                 formatNumber(calibration.crossValidationPx, 2) + " px";
    if (calibration.halvesApart)
        words += ", " + millimetreWords(calibration.halvesApart->worstM) + " apart at worst on that floor";
    return words + ".";
}

/// "in left02.jpg (6) and left09.jpg (3)", the pictures with most of the corners first. counted: of one
/// picture.
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
    const auto kept = [](const CalibrationPicture &picture) {
        return picture.outliers.size() - picture.leftOut.size();
    };
    std::string words = " ";
    if (calibration.disagreeingPart > mostOutliers) {
        words += formatNumber(100 * calibration.disagreeingPart, 0) + " % of the corners disagree, " +
                 whereWords(calibration, all);
        return words + ": they were kept; look at these pictures and leave out those that are blurred, bent "
                       "or of another board.";
    }
    const std::size_t leftOut = calibration.cornersLeftOut();
    std::size_t keptCount = 0;
    for (const CalibrationPicture &picture : calibration.pictures)
        keptCount += kept(picture);
    if (leftOut > 0)
        words += std::to_string(leftOut) +
                 (leftOut == 1 ? " corner that stands out was" : " corners that stand out were") +
                 " left out, " + whereWords(calibration, left) + ". ";
    if (keptCount > 0)
        words += std::to_string(keptCount) + " corners that stand out side by side were kept, " +
                 whereWords(calibration, kept) +
                 ": leave out these pictures if the board is bent, cut or covered there. ";
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
                          fitWords(calibration, focalSigma) + lensWords(calibration) +
                          outlierWords(calibration);
    if (calibration.picturesUsed() < fewViews)
        verdict += " More pictures (" + std::to_string(fewViews) + " or more) would make it surer.";
    if (covered < leastCoverage)
        verdict += " Only " + formatNumber(100 * covered, 0) +
                   " % of the picture was covered: show the board near its edges too.";
    return verdict + oddPicture(calibration);
}

} // namespace odo
