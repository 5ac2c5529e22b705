// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/internal/robot_follower.h"

#include "core/tracking/internal/fetch_early.h"
#include "core/tracking/internal/robot_expectation.h"
#include "core/tracking/internal/searched_mask.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace odo {

namespace {

constexpr int framesPerTable = 64;
constexpr int missesUntilLost = 1, missesWhileHidden = 30;
constexpr double relearnAfterS = 1.5; ///< lost for so long, the given colour is believed again
constexpr int missesPerRelearning = 8;
constexpr double leastRankInWindow = 0.02, leastRankInImage = 0.15, leastFirstScore = 0.25;
constexpr double sizeSigma = 0.2;      ///< of the logarithm of the area, from one frame to the next
constexpr double mostSizeNoise = 0.12; ///< of the area of a small robot, from frame to frame
constexpr std::size_t mostCandidates = 6;
constexpr double leastColourSigma = 3.0, relativeColourSigma = 0.06; ///< of a region's mean, in code values
constexpr double mostSizeCost = 12.0, mostColourCost = 16.0;
constexpr double uncertaintyPerFrameTogether = 0.04; ///< of the position, in radii
constexpr double scoreTogether = 0.1;                ///< below what is used where another view is surer
constexpr double sigmaTogether = 0.3;                ///< of the position, in radii
/// Of a touched robot's area: what may always be hidden unnoticed, and what may be hidden without making its
/// position uncertain.
constexpr double leastPartHidden = 0.02, mostPartHidden = 0.08;

} // namespace

void RobotFollower::reset(const FrameFormat &format, std::shared_ptr<const BitMask> searched)
{
    m_searched = std::move(searched);
    m_finder.searchOnly(m_searched);
    m_phase = Phase::Unseen;
    m_model = ColourModel(chromaOf(m_given, format));
    m_candidates.clear();
    m_missed = 0;
    m_touched = false;
    m_framesTogether = 0;
    m_strangers.clear();
}

/// Luma pixels in which the robot is searched at this time.
Eigen::AlignedBox2d RobotFollower::expectedBox(double timeS) const
{
    const double sinceS = std::max(0.0, timeS - m_predictor.lastTimeS());
    const double uncertainty =
        6.0 + 0.5 * m_radiusPx + 0.5 * sinceS * m_predictor.velocity().norm() + 0.5 * m_missed * m_radiusPx;
    const Eigen::Vector2d centre = m_predictor.at(timeS);
    const Eigen::Vector2d half = 1.3 * m_halfSizePx + Eigen::Vector2d::Constant(uncertainty);
    return {centre - half, centre + half};
}

ChromaRect RobotFollower::windowOf(const TrackedFrame &frame) const
{
    const Eigen::AlignedBox2d box = expectedBox(frame.timeS());
    const Eigen::Vector2d low = frame.grid().fromLuma(box.min()), high = frame.grid().fromLuma(box.max());
    const ChromaRect window{static_cast<int>(std::floor(low.x())), static_cast<int>(std::floor(low.y())),
                            static_cast<int>(std::ceil(high.x())) + 1,
                            static_cast<int>(std::ceil(high.y())) + 1};
    return window.clippedTo(frame.grid().bounds());
}

std::optional<PixelRect> RobotFollower::neededRegion(const FrameFormat &format, double timeS) const
{
    if (!isFollowing() || m_wantsTable || m_framesSinceTable + 1 >= framesPerTable)
        return std::nullopt;
    const Eigen::AlignedBox2d box = expectedBox(timeS);
    // Two samples more for rounding and for where chroma lies among the pixels.
    const int beyondX = (RegionMeasure::reach + 2) << format.chromaShiftX,
              beyondY = (RegionMeasure::reach + 2) << format.chromaShiftY;
    return PixelRect{static_cast<int>(std::floor(box.min().x())) - beyondX,
                     static_cast<int>(std::floor(box.min().y())) - beyondY,
                     static_cast<int>(std::ceil(box.max().x())) + beyondX,
                     static_cast<int>(std::ceil(box.max().y())) + beyondY};
}

double RobotFollower::rankInWindow(const TrackedFrame &frame, const Blob &blob) const
{
    const double ratio = m_area.ratioToLikely(blob.area() * frame.lumaPerSample());
    if (ratio > 4 || ratio < (m_atBorder ? 0.02 : 0.25))
        return 0;
    const Eigen::Vector2d centre = frame.grid().toLuma(blob.centre());
    const double sinceS = std::max(0.0, frame.timeS() - m_predictor.lastTimeS());
    const double reach =
        0.7 * m_radiusPx + 3.0 + 0.5 * sinceS * m_predictor.velocity().norm() + 0.5 * m_missed * m_radiusPx;
    return bellOf((centre - m_predictor.at(frame.timeS())).norm() / reach) * bellOf(std::log(ratio) / 0.7) *
           blob.meanWeight();
}

double RobotFollower::rankHidden(const TrackedFrame &frame, const Blob &blob) const
{
    return compactness(blob.covariance(), blob.area()) *
           sizeLikelihood(blob.area() * frame.lumaPerSample() / frame.imageAreaPx()) *
           likeness(blob.meanChroma(), m_model.given());
}

double RobotFollower::rankLost(const TrackedFrame &frame, const Blob &blob) const
{
    const double ratio = m_area.ratioToLikely(blob.area() * frame.lumaPerSample());
    const Eigen::Vector2d centre = frame.grid().toLuma(blob.centre());
    const double lostS = std::max(0.0, frame.timeS() - m_predictor.lastTimeS());
    const double reach = std::sqrt(m_area.wholePx() / std::numbers::pi) * (3.0 + 25.0 * lostS);
    return bellOf((centre - m_predictor.at(frame.timeS())).norm() / reach) * bellOf(std::log(ratio) / 0.6) *
           blob.meanWeight() * compactness(blob.covariance(), blob.area());
}

void RobotFollower::collect(const TrackedFrame &frame, Candidate::By by, double least,
                            double (RobotFollower::*rank)(const TrackedFrame &, const Blob &) const)
{
    for (const Blob &blob : m_finder.blobs()) {
        if (blob.count < 3 || (!isFollowing() && m_strangers.contain(frame, blob, m_radiusPx)))
            continue;
        const double score = (this->*rank)(frame, blob);
        if (score >= least)
            m_candidates.push_back({blob, frame.grid().toLuma(blob.centre()), score, by});
    }
}

void RobotFollower::sortCandidates()
{
    std::sort(m_candidates.begin(), m_candidates.end(),
              [](const Candidate &a, const Candidate &b) { return a.score > b.score; });
    if (m_candidates.size() > mostCandidates)
        m_candidates.resize(mostCandidates);
}

void RobotFollower::propose(const TrackedFrame &frame)
{
    m_candidates.clear();
    const ChromaRect window = windowOf(frame);
    if (window.isEmpty())
        return;
    m_finder.find(frame.grid(), m_model.table(), window, 1);
    collect(frame, Candidate::By::LearnedColour, leastRankInWindow, &RobotFollower::rankInWindow);
    sortCandidates();
}

void RobotFollower::lookAt(const TrackedFrame &frame, const ChromaRect &window, const ChromaTable &table)
{
    m_finder.find(frame.grid(), table, window, 1);
}

double RobotFollower::costOf(const TrackedFrame &frame, const Blob &region) const
{
    const double sinceS = std::max(0.0, frame.timeS() - m_predictor.lastTimeS());
    const double uncertain = std::min(1.0, uncertaintyPerFrameTogether * (m_framesTogether + 2 * m_missed));
    const double reach = (0.35 + uncertain) * m_radiusPx + 3.0 + 0.5 * sinceS * m_predictor.velocity().norm();
    const double away = (frame.grid().toLuma(region.centre()) - predictedPx(frame)).norm() / reach;
    const double size =
        std::log(region.area() * frame.lumaPerSample() / m_area.px()) / (m_atBorder ? 1.0 : sizeSigma);
    const Chroma expected = m_model.expected();
    const double colour =
        (region.meanChroma() - expected).norm() / (leastColourSigma + relativeColourSigma * expected.norm());
    return 0.5 *
           (away * away + std::min(size * size, mostSizeCost) + std::min(colour * colour, mostColourCost));
}

void RobotFollower::search(const TrackedFrame &frame, const ChromaDensity &background)
{
    m_candidates.clear();
    const ChromaRect image = frame.grid().bounds();
    if (m_phase == Phase::Lost) {
        m_finder.find(frame.grid(), m_model.table(), image, frame.searchStep());
        m_strangers.note(frame, m_finder.blobs(),
                         {predictedPx(frame), m_radiusPx, m_area.px(),
                          frame.timeS() - m_predictor.lastTimeS(), m_missed == missesUntilLost});
        collect(frame, Candidate::By::LearnedColour, leastRankInImage, &RobotFollower::rankLost);
        const bool forLong = frame.timeS() - m_predictor.lastTimeS() > relearnAfterS;
        if (!m_candidates.empty() || !forLong || m_missed % missesPerRelearning != 0) {
            sortCandidates();
            return;
        }
    }
    // A robot that fills much of the frame is also much of the background, so once more without regard to it.
    m_finder.find(frame.grid(), m_model.givenColourTable(&background), image, frame.searchStep());
    collect(frame, Candidate::By::GivenColour, leastRankInImage, &RobotFollower::rankHidden);
    m_finder.find(frame.grid(), m_model.givenColourTable(nullptr), image, frame.searchStep());
    collect(frame, Candidate::By::GivenColourAlone, leastRankInImage, &RobotFollower::rankHidden);
    sortCandidates();
}

/// Found on the coarse lattice by the colour that is known: the same region on every sample.
bool RobotFollower::searchAgain(const TrackedFrame &frame, const Candidate &candidate, Blob &blob)
{
    const ChromaRect window = candidate.blob.box.grownBy(8).clippedTo(frame.grid().bounds());
    m_finder.find(frame.grid(), m_model.table(), window, 1);
    const auto &blobs = m_finder.blobs();
    const auto largest = std::max_element(blobs.begin(), blobs.end(),
                                          [](const Blob &a, const Blob &b) { return a.count < b.count; });
    if (largest == blobs.end() || largest->count < 4)
        return false;
    blob = *largest;
    return true;
}

/// Found by the given colour: learns the colour, first from what that shows, then from what was learned,
/// which gathers sides and shades that were missed.
bool RobotFollower::learnFrom(const TrackedFrame &frame, const Candidate &candidate,
                              const ChromaDensity &background, Blob &blob)
{
    const ChromaRect box = candidate.blob.box;
    const int margin = 8 + std::max(box.width(), box.height()) / 2;
    const ChromaRect window = box.grownBy(margin).clippedTo(frame.grid().bounds());
    ColourModel model = m_model;
    ChromaTable table =
        model.givenColourTable(candidate.by == Candidate::By::GivenColour ? &background : nullptr);
    RegionShape shape;
    for (int pass = 0; pass < 3; ++pass) {
        m_finder.find(frame.grid(), table, window, 1);
        const Blob *best = nullptr;
        for (const Blob &found : m_finder.blobs()) {
            const ChromaRect common = found.box.clippedTo(box.grownBy(2));
            if (!common.isEmpty() && (!best || found.count > best->count))
                best = &found;
        }
        if (!best || best->count < 4)
            return false;
        blob = *best;
        m_finder.paint(blob, RegionMeasure::margin, m_mask);
        shape = m_measure.measure(frame.grid(), blob, m_mask, model.expected());
        if (pass == 2)
            break;
        model.learn(frame.grid(), m_mask, shape.colour);
        model.buildTable(background);
        table = model.table();
    }
    if (rankHidden(frame, blob) < leastFirstScore)
        return false;
    m_model = model;
    return true;
}

void RobotFollower::accept(const TrackedFrame &frame, const Candidate &candidate, Observation &observation)
{
    observe(frame, candidate.blob, observation);
    if (m_touched)
        uncertainWhenTouched(observation);
    else
        keepSilhouette(frame, observation);
}

void RobotFollower::keepSilhouette(const TrackedFrame &frame, const Observation &observation)
{
    std::swap(m_mask, m_silhouette);
    m_silhouetteCentre = frame.grid().fromLuma(observation.ellipse.centrePx);
}

/// Another robot may hide a part of this one, which shifts the centre; or has lent it a part of its own.
void RobotFollower::uncertainWhenTouched(Observation &observation) const
{
    const double off = std::abs(1 - observation.areaPx / m_area.px());
    const double shift = std::clamp(off, leastPartHidden, 1.0) * m_radiusPx;
    observation.centreCovariancePx2 += Eigen::Matrix2d::Identity() * shift * shift;
    if (off > mostPartHidden)
        observation.score = std::min(observation.score, scoreTogether);
}

void RobotFollower::acceptTogether(const TrackedFrame &frame, const Eigen::Vector2d &centrePx,
                                   Observation &observation)
{
    const Eigen::Vector2d moved = centrePx - frame.grid().toLuma(m_silhouetteCentre);
    observation.found = true;
    observation.ellipse = m_ellipse;
    observation.ellipse.centrePx = centrePx;
    const double sigma = sigmaTogether * m_radiusPx;
    observation.centreCovariancePx2 = Eigen::Matrix2d::Identity() * sigma * sigma;
    observation.areaPx = m_area.px();
    observation.score = scoreTogether;
    m_predictor.nudge(centrePx, frame.timeS());
    const Eigen::Vector2d samples = moved.cwiseQuotient(frame.grid().scale);
    const int dx = static_cast<int>(std::lround(samples.x())),
              dy = static_cast<int>(std::lround(samples.y()));
    const ChromaRect &area = m_silhouette.area;
    m_occupied = {area.left + dx, area.top + dy, area.right + dx, area.bottom + dy};
    m_missed = 0;
    ++m_framesTogether;
}

bool RobotFollower::acceptFound(const TrackedFrame &frame, const Candidate &candidate,
                                const ChromaDensity &background, Observation &observation)
{
    Blob blob;
    const bool known = candidate.by == Candidate::By::LearnedColour;
    if (!(known ? searchAgain(frame, candidate, blob) : learnFrom(frame, candidate, background, blob)))
        return false;
    const double areaPx = blob.area() * frame.lumaPerSample();
    if (known)
        m_area.startAgain(areaPx);
    else
        m_area.start(areaPx);
    m_predictor.start(frame.grid().toLuma(blob.centre()), frame.timeS());
    m_outline.reset();
    observe(frame, blob, observation);
    keepSilhouette(frame, observation);
    return true;
}

bool RobotFollower::startAt(const TrackedFrame &frame, const Eigen::Vector2d &pixel,
                            const ChromaDensity &background, Observation &observation)
{
    const Eigen::Vector2d sample = frame.grid().fromLuma(pixel);
    const int x = int(std::lround(sample.x())), y = int(std::lround(sample.y())),
              beside = frame.searchStep() + 2;
    const auto startBy = [&](Candidate::By by, const ChromaTable &table) {
        m_finder.find(frame.grid(), table, frame.grid().bounds(), frame.searchStep());
        const Blob *there = nullptr;
        for (const Blob &blob : m_finder.blobs())
            if (blob.box.grownBy(beside).contains(x, y) && (!there || blob.count > there->count))
                there = &blob;
        if (!there)
            return false;
        const Candidate candidate{*there, frame.grid().toLuma(there->centre()), 1, by};
        return acceptFound(frame, candidate, background, observation);
    };
    return (m_model.isLearned() && startBy(Candidate::By::LearnedColour, m_model.table())) ||
           startBy(Candidate::By::GivenColour, m_model.givenColourTable(&background)) ||
           startBy(Candidate::By::GivenColourAlone, m_model.givenColourTable(nullptr));
}

/// The edges will soon be searched on the luma plane.
void RobotFollower::fetchLuma(const TrackedFrame &frame, const Blob &blob)
{
    const FrameFormat &format = frame.frame().format;
    const ChromaRect part = blob.box.grownBy(RegionMeasure::margin);
    fetchEarly(frame.frame().y,
               PixelRect{part.left << format.chromaShiftX, part.top << format.chromaShiftY,
                         part.right << format.chromaShiftX, part.bottom << format.chromaShiftY}
                   .clipped({0, 0, format.width, format.height}));
}

/// Whether the region, which was painted last, reaches the edge of the frame or of what is searched.
bool RobotFollower::isCut(const TrackedFrame &frame, const Blob &blob) const
{
    const ChromaRect inner = frame.grid().bounds().grownBy(-1);
    if (blob.box.left < inner.left || blob.box.top < inner.top || blob.box.right > inner.right ||
        blob.box.bottom > inner.bottom)
        return true;
    if (!m_searched)
        return false;
    BitMask region(m_mask.area.width(), m_mask.area.height());
    for (int y = 0; y < region.height(); ++y)
        region.setRow(y, m_mask.row(m_mask.area.top + y), 0, region.width());
    return isCutBy(*m_searched, region, m_mask.area.left, m_mask.area.top);
}

void RobotFollower::observe(const TrackedFrame &frame, const Blob &blob, Observation &observation)
{
    fetchLuma(frame, blob);
    m_finder.paint(blob, RegionMeasure::margin, m_mask);
    m_atBorder = isCut(frame, blob);
    observation.found = true;
    observation.touchesBorder = m_atBorder;
    RegionShape shape = m_measure.examine(frame.grid(), blob, m_mask, m_model.expected());
    const Eigen::Vector2d motionPx = m_predictor.velocity() * (frame.timeS() - m_predictor.lastTimeS());
    const auto trust =
        m_atBorder ? std::nullopt : m_outline.refine(frame, m_mask, {motionPx, m_area.wholePx()}, shape);
    if (!trust)
        shape = m_measure.measure(frame.grid(), blob, m_mask, m_model.expected());
    const Eigen::Vector2d &scale = frame.grid().scale;
    observation.ellipse = ellipseOf(shape, frame.grid());
    observation.centreCovariancePx2 = scale.asDiagonal() * shape.centreCovariance * scale.asDiagonal();
    observation.areaPx = shape.area * frame.lumaPerSample();
    if (!trust && !m_atBorder)
        uncertainSize(observation);
    observation.meanChroma = shape.colour;
    observation.score = trust.value_or(1) * scoreOf(frame, blob, shape);
    update(frame, blob, shape, observation);
}

/// Moments alone cannot distinguish a cover or a merge from the robot: an area that is not the expected one
/// has moved the centre by as much of the radius, at most.
void RobotFollower::uncertainSize(Observation &observation) const
{
    const double off = std::abs(1 - observation.areaPx / m_area.px());
    if (off < mostSizeNoise)
        return;
    const double shift = std::min(off, 1.0) * m_radiusPx;
    observation.centreCovariancePx2 += Eigen::Matrix2d::Identity() * shift * shift;
}

double RobotFollower::scoreOf(const TrackedFrame &frame, const Blob &blob, const RegionShape &shape) const
{
    const double colour = std::min(1.0, blob.meanWeight() / 0.9) * likeness(shape.colour, m_model.expected());
    const double form = compactness(shape.covariance, shape.area);
    const double size =
        m_atBorder ? 1.0 : bellOf(m_area.offInLn(shape.area * frame.lumaPerSample()) / sizeSigma);
    const double away = (frame.grid().toLuma(shape.centre) - m_predictor.at(frame.timeS())).norm();
    return std::clamp(colour * form * size * bellOf(away / (m_radiusPx + 4.0)), 0.0, 1.0);
}

void RobotFollower::update(const TrackedFrame &frame, const Blob &blob, const RegionShape &shape,
                           const Observation &observation)
{
    const bool wasFollowing = isFollowing();
    m_phase = Phase::Following;
    m_missed = 0;
    m_framesTogether = 0;
    m_ellipse = observation.ellipse;
    m_predictor.update(observation.ellipse.centrePx, frame.timeS());
    const bool trusted = observation.score > 0.4;
    if (wasFollowing && !m_touched)
        m_area.follow(observation.areaPx, m_atBorder);
    m_radiusPx = std::sqrt(m_area.px() / std::numbers::pi);
    m_halfSizePx =
        2.0 * frame.grid().scale.cwiseProduct(shape.covariance.diagonal().cwiseMax(0.1).cwiseSqrt());
    m_occupied = blob.box.grownBy(3);
    ++m_framesSinceTable;
    m_wantsTable = m_framesSinceTable >= framesPerTable;
    if (trusted && !m_atBorder && m_model.follow(shape.colour))
        m_wantsTable = true;
}

void RobotFollower::miss(bool hidden)
{
    ++m_missed;
    if (m_phase == Phase::Following && m_missed >= (hidden ? missesWhileHidden : missesUntilLost)) {
        m_phase = Phase::Lost;
        m_area.lose();
    }
}

void RobotFollower::buildTable(const ChromaDensity &background)
{
    m_model.buildTable(background);
    m_framesSinceTable = 0;
    m_wantsTable = false;
}

} // namespace odo
