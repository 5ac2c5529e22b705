// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/workflow/calibrate/fitted_intrinsics.h"

#include "core/base/units.h"
#include "core/calibration/floor_registration.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace odo {

namespace {

constexpr double leastEnlargement = 0.9, mostEnlargement = 2;
constexpr double firstStep = 0.04, lastStep = 0.001;
constexpr double threeSigma = 9, fiveSigma = 25; // of χ²
constexpr double exactWithin = 0.04;             // excluded at three σ
constexpr double knownSigma = 0.017;             // of an enlargement that is taken as found
constexpr double unknownSigma = 0.1;             // stabilisation takes some ten per cent of the image
constexpr std::size_t enoughMarkers = 6;         // of fewer the errors of their layout do not show
constexpr double fewMarkersSigmaPx = 1;
constexpr double none = std::numeric_limits<double>::infinity();

/// How a lens fits the markers with and without enlargement.
class Scan
{
public:
    /// The misfit is taken to have one minimum. Far from it each evaluation takes long, so the search begins
    /// where nothing is enlarged and goes downhill.
    Scan(const Intrinsics &calibrated, const SensorFormat &format, const MarkerMisfit &misfit)
        : m_lens(inFormat(calibrated, format)), m_format(format), m_misfit(misfit), m_atOne(squaresAt(1)),
          m_least(m_atOne)
    {
        for (double next = leastEnlargement; !fits() && next < mostEnlargement; next *= 1 + firstStep)
            take(next);
        for (double step = firstStep; step > lastStep;) {
            if (!goBy(1 + step) && !goBy(1 / (1 + step)))
                step /= 2;
        }
    }

    const Intrinsics &lens() const { return m_lens; }
    const SensorFormat &format() const { return m_format; }
    double best() const { return m_best; }
    double leastSquares() const { return m_least; } ///< px²
    bool fits() const { return std::isfinite(m_least); }
    /// Δχ² of an enlargement against the best.
    double excess(double enlargement, double variance) const
    {
        return ((enlargement == 1 ? m_atOne : squaresAt(enlargement)) - m_least) / variance;
    }
    /// Of the best enlargement, by how the misfit rises beside it.
    double sigma(double variance) const
    {
        constexpr double aside = 0.01;
        const double rise =
            (excess(m_best * (1 + aside), variance) + excess(m_best * (1 - aside), variance)) / 2;
        return rise > 0 ? m_best * aside / std::sqrt(rise) : none;
    }

private:
    double squaresAt(double enlargement) const
    {
        return m_misfit(enlarged(m_lens, enlargement)).value_or(none);
    }
    bool goBy(double factor)
    {
        const double next = m_best * factor;
        return next >= leastEnlargement && next <= mostEnlargement && take(next);
    }
    bool take(double next)
    {
        const double squares = squaresAt(next);
        if (!(squares < m_least))
            return false;
        m_least = squares;
        m_best = next;
        return true;
    }

    Intrinsics m_lens;
    SensorFormat m_format;
    const MarkerMisfit &m_misfit;
    double m_atOne, m_least; ///< px²
    double m_best = 1;
};

/// Of a pixel of a marker, as far as this many can tell: the mean of a posterior whose mode markSigmaPx is.
double varianceOf(const Scan &scan, std::size_t markers)
{
    constexpr double priorFreedom = 6;
    const double freedom =
        std::max(2.0 * double(markers) - 7, 0.0); // six of the pose, one of the enlargement
    const double sigma = markSigmaPx(scan.fits() ? scan.leastSquares() : 0, freedom),
                 variance = sigma * sigma * (freedom + priorFreedom) / (freedom + priorFreedom - 2);
    return markers < enoughMarkers ? std::max(variance, fewMarkersSigmaPx * fewMarkersSigmaPx) : variance;
}

Message converted(const std::string &before, const std::string &now)
{
    return ODO_TEXT("workflow.lens_scaled", "The lens calibration at %1 was converted to %2.")(before, now);
}

class Judgement
{
public:
    Judgement(const Intrinsics &calibrated, int widthPx, int heightPx)
        : m_before(sizeText(calibrated.widthPx, calibrated.heightPx)), m_now(sizeText(widthPx, heightPx))
    {
    }

    FittedIntrinsics of(const Scan &scan, double variance) const
    {
        const bool isWhole = scan.format().kind == SensorFormat::Kind::Whole;
        const auto isExcluded = [&](double enlargement) {
            return !(scan.excess(enlargement, variance) <= (isWhole ? fiveSigma : threeSigma));
        };
        const bool isOther = scan.fits() && isExcluded(1), isNearOne = scan.fits() && !isOther;
        if ((isNearOne || !scan.fits()) && isWhole)
            return {scan.lens(), exact(scan.format())};
        if (isNearOne && (isWhole || (isExcluded(1 + exactWithin) && isExcluded(1 - exactWithin))))
            return {scan.lens(), exact(scan.format())};
        const double sigma = isOther ? scan.sigma(variance) : none;
        if (sigma <= knownSigma * scan.best())
            return {
                withEnlargementSigma(enlarged(scan.lens(), scan.best()), sigma / scan.best()),
                ODO_TEXT("workflow.lens_enlarged",
                         "The lens calibration at %1 was fitted to %2 by the markers, which show that the "
                         "image is enlarged by a factor of %3 (± %4).")(
                    m_before, m_now, quantity(scan.best(), 3), quantity(sigma, 3))};
        return {
            withEnlargementSigma(scan.lens(), unknownSigma),
            ODO_TEXT("workflow.lens_part_unknown",
                     "The lens calibration at %1 was cropped to %2, but the markers do not show whether the "
                     "image is enlarged as well, so its focal length is known only to %3: calibrate the "
                     "lens at %2, or use more markers.")(m_before, m_now,
                                                         quantity(100 * unknownSigma, 0, "%"))};
    }

    /// Of two scans that fit alike.
    FittedIntrinsics eitherWay(const FittedIntrinsics &one, const FittedIntrinsics &other) const
    {
        return {
            meanOf(one.intrinsics, other.intrinsics),
            joined({one.how, ODO_TEXT("workflow.lens_turned_either_way",
                                      "Which way the camera was turned since is not known, so the centre of "
                                      "its images is less certain.")},
                   Join::Space)};
    }

private:
    Message exact(const SensorFormat &format) const
    {
        switch (format.kind) {
        case SensorFormat::Kind::WholeWidth:
            return ODO_TEXT("workflow.lens_cropped_rows",
                            "The lens calibration at %1 was cropped above and below to %2, as the markers "
                            "confirm.")(m_before, m_now);
        case SensorFormat::Kind::WholeHeight:
            return ODO_TEXT("workflow.lens_cropped_columns",
                            "The lens calibration at %1 was cropped on both sides to %2, as the markers "
                            "confirm.")(m_before, m_now);
        case SensorFormat::Kind::Whole:
            break;
        }
        return converted(m_before, m_now);
    }

    std::string m_before, m_now;
};

} // namespace

Message intrinsicsConverted(const Intrinsics &calibrated, int widthPx, int heightPx)
{
    return converted(sizeText(calibrated.widthPx, calibrated.heightPx), sizeText(widthPx, heightPx));
}

FittedIntrinsics fittedIntrinsics(const Intrinsics &calibrated, int widthPx, int heightPx,
                                  std::size_t markers, const MarkerMisfit &misfit)
{
    std::vector<Scan> scans;
    for (const SensorFormat &format :
         sensorFormats(calibrated.widthPx, calibrated.heightPx, widthPx, heightPx))
        scans.emplace_back(calibrated, format, misfit);
    const auto best = std::ranges::min_element(scans, {}, &Scan::leastSquares);
    const Judgement judgement(calibrated, widthPx, heightPx);
    const double variance = varianceOf(*best, markers);
    FittedIntrinsics fitted = judgement.of(*best, variance);
    for (const Scan &other : scans) {
        if (&other != &*best && !(other.leastSquares() - best->leastSquares() > threeSigma * variance))
            fitted = judgement.eitherWay(fitted, judgement.of(other, variance));
    }
    return fitted;
}

} // namespace odo
