// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/known_length.h"

#include "core/base/units.h"
#include "core/calibration/wording.h"

#include <cmath>

namespace odo {

namespace {

using Eigen::Vector2d;

constexpr const char *lengthMeasurement = "the length cannot be measured";
constexpr double agreesWithin = 2.5; // σ
constexpr double shortestPx = 2;

struct Measured
{
    double lengthM = 0, varianceM2 = 0;
};

Eigen::Matrix2d noiseOf(double sigmaPx) { return sigmaPx * sigmaPx * Eigen::Matrix2d::Identity(); }

Result<Measured> measure(const SeenLength &seen, double heightM)
{
    if ((seen.fromPixel - seen.toPixel).norm() < shortestPx)
        return fail(ErrorCode::InvalidInput, lengthMeasurement,
                    "both ends lie on one pixel of camera '" + seen.camera + "'",
                    "mark the two ends where they are seen");
    const auto from = seen.view->locate(seen.fromPixel, noiseOf(seen.fromSigmaPx), heightM);
    const auto to = seen.view->locate(seen.toPixel, noiseOf(seen.toSigmaPx), heightM);
    if (!from || !to)
        return fail(ErrorCode::InvalidInput, lengthMeasurement,
                    std::string("the ") + (from ? "second" : "first") +
                        " end lies at or beyond the horizon of camera '" + seen.camera + "'",
                    "lay the stick on the floor, nearer to the camera");
    const Vector2d along = to->pointInWorld - from->pointInWorld;
    const double length = along.norm();
    const Vector2d unit = along / length;
    const Eigen::Matrix2d shared =
        seen.view->sharedCovariance(from->pointInWorld, to->pointInWorld, heightM).value_or(Eigen::Matrix2d::Zero());
    const Eigen::Matrix2d covariance = from->pixelCovariance + to->pixelCovariance + from->calibrationCovariance +
                                       to->calibrationCovariance - shared - shared.transpose();
    return Measured{length, unit.dot(covariance * unit)};
}

std::string judgement(const LengthCheck &check, double toldM)
{
    const double difference = *check.differenceM;
    const std::string off =
        " It is " + millimetres(std::abs(difference)) + (difference < 0 ? " shorter" : " longer") + " than the " + millimetres(toldM) + " told: ";
    const double allowed = agreesWithin * check.sigmaM;
    if (std::abs(difference) <= allowed)
        return off + "inside the expected error of " + millimetres(allowed) + ".";
    return off + "outside the expected error of " + millimetres(allowed) +
           ". Check the length itself, whether it lies on the floor, and the places of the markers.";
}

} // namespace

Result<LengthCheck> checkLength(std::span<const SeenLength> seen, std::optional<double> toldM, double heightM)
{
    if (seen.empty())
        return fail(ErrorCode::InvalidInput, lengthMeasurement, "no camera was given that sees it",
                    "mark its ends in one picture at least");
    if (toldM && !(*toldM > 0 && std::isfinite(*toldM)))
        return fail(ErrorCode::InvalidInput, lengthMeasurement, "the told length is not above 0",
                    "give the length as it was measured with a tape");
    double information = 0, weighted = 0;
    std::vector<Measured> each;
    for (const SeenLength &one : seen) {
        const auto measured = measure(one, heightM);
        if (!measured)
            return tl::unexpected(measured.error());
        each.push_back(*measured);
        information += 1 / measured->varianceM2;
        weighted += measured->lengthM / measured->varianceM2;
    }
    LengthCheck check;
    check.lengthM = weighted / information;
    check.sigmaM = std::sqrt(1 / information);
    check.words = "The length is " + millimetres(check.lengthM) + " ± " + millimetres(check.sigmaM) + ".";
    for (std::size_t i = 0; i < each.size(); ++i) {
        const double off = each[i].lengthM - check.lengthM;
        if (each.size() > 1 && std::abs(off) > agreesWithin * std::sqrt(each[i].varianceM2)) {
            check.agrees = false;
            check.words += " Camera '" + seen[i].camera + "' alone says " + millimetres(each[i].lengthM) +
                           ": look whether the same ends are marked in each picture, and register it again if they are.";
        }
    }
    if (toldM) {
        check.differenceM = check.lengthM - *toldM;
        check.agrees = check.agrees && std::abs(*check.differenceM) <= agreesWithin * check.sigmaM;
        check.words += judgement(check, *toldM);
    }
    return check;
}

} // namespace odo
