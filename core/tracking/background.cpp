// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/background.h"

#include "core/tracking/internal/fetch_early.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>

namespace odo {

namespace {

constexpr std::size_t mostFrames = 24, fewestFrames = 9; // the median of fewer would show the robot too often
constexpr std::size_t mostChosen = 15;                   // of them, for the median
constexpr std::size_t mostBytes = 64'000'000;
constexpr int motionLattice = 4;   // every so many samples of luma are compared
constexpr int movedBy = 12;        // code values, beyond noise and coding
constexpr int leastMoved = 8;      // samples of the lattice: some 11 x 11 pixels
constexpr float sameLight = 1.05F; // ratio of the lights of frames that may be compared as they are
constexpr std::size_t block = 64;  // samples that are sorted side by side

std::size_t bytesOf(const Frame &frame)
{
    return std::size_t(frame.y.width) * std::size_t(frame.y.height) +
           2 * std::size_t(frame.u.width) * std::size_t(frame.u.height);
}

/// In memory of its own: the camera or decoder needs that of its frames back soon.
Frame copied(const Frame &frame)
{
    auto buffer = std::make_shared<FrameBuffer>(frame.format);
    const auto copyRows = [](const PlaneView &plane, const auto &rowOf) {
        for (int y = 0; y < plane.height; ++y)
            std::copy_n(plane.row(y), plane.width, rowOf(y));
    };
    copyRows(frame.y, [&](int y) { return buffer->yRow(y); });
    copyRows(frame.u, [&](int y) { return buffer->uRow(y); });
    copyRows(frame.v, [&](int y) { return buffer->vRow(y); });
    return FrameBuffer::toFrame(std::move(buffer), frame.index, frame.time);
}

/// The same block of all frames: one row of bytes a frame.
using Samples = std::array<std::array<std::uint8_t, block>, mostFrames>;

/// Puts the lesser of two rows' samples into the one and the greater into the other, column by column.
void orderRows(std::uint8_t *__restrict lesser, std::uint8_t *__restrict greater)
{
    for (std::size_t x = 0; x < block; ++x) {
        // By arithmetic: of a minimum and a maximum compilers make a branch for each sample.
        const auto tooMuch = std::uint8_t(std::max(lesser[x], greater[x]) - greater[x]);
        lesser[x] = std::uint8_t(lesser[x] - tooMuch);
        greater[x] = std::uint8_t(greater[x] + tooMuch);
    }
}

/// Sorts each column of the first `count` rows, all columns at once: Batcher's odd-even merge sort for any
/// count (Knuth, The Art of Computer Programming 3, 5.2.2, algorithm M).
void sortColumns(Samples &samples, std::size_t count)
{
    std::size_t top = 1;
    while (2 * top < count)
        top *= 2;
    for (std::size_t p = top; p > 0; p /= 2) {
        std::size_t q = top, r = 0, d = p;
        while (true) {
            for (std::size_t i = 0; i + d < count; ++i) {
                if ((i & p) == r)
                    orderRows(samples[i].data(), samples[i + d].data());
            }
            if (q == p)
                break;
            d = q - p;
            q /= 2;
            r = p;
        }
    }
}

/// For each distance of a quartile from the median the σ, in sigmaUnit: from the quarter of the samples next
/// to the median on that side where no robot was seen; the nearer of two sides is the lesser one by chance.
std::array<std::uint8_t, 256> sigmasOfQuarters()
{
    constexpr float sigmaPerQuarter = 1.75F;
    std::array<std::uint8_t, 256> sigmas{};
    for (std::size_t i = 0; i < sigmas.size(); ++i)
        sigmas[i] = std::uint8_t(std::min(
            255.0F,
            std::max(Background::leastSigma, sigmaPerQuarter * float(i)) / Background::sigmaUnit + 0.5F));
    return sigmas;
}

/// Medians, and σ from a quartile, of one plane. planes: that of each frame; gains: what brings each to the
/// light of the first.
Background::Plane medianOf(const std::vector<PlaneView> &planes, const std::vector<LightGain> &gains,
                           bool isLuma)
{
    Background::Plane result{planes.front().width, planes.front().height, {}, {}};
    const std::size_t count = planes.size();
    result.values.resize(std::size_t(result.width) * std::size_t(result.height));
    result.sigmas.resize(result.values.size());
    std::vector<std::array<std::uint8_t, 256>> tables;
    for (const LightGain &gain : gains)
        tables.push_back(isLuma ? gain.toReference() : gain.chromaToReference());
    const auto [dimmest, lightest] = std::ranges::minmax(gains, {}, &LightGain::factor);
    const bool lightChanges = isLuma && lightest.factor > sameLight * dimmest.factor;
    const auto sigmaOf = sigmasOfQuarters();
    Samples samples;
    for (int y = 0; y < result.height; ++y) {
        for (int x0 = 0; x0 < result.width; x0 += int(block)) {
            const auto here = std::size_t(std::min(int(block), result.width - x0));
            std::array<bool, block> isCutOff{}; // then it is not known what it is in other light
            for (std::size_t f = 0; f < count; ++f) {
                const std::uint8_t *row = planes[f].row(y) + x0;
                for (std::size_t x = 0; x < here; ++x)
                    samples[f][x] = tables[f][row[x]];
                for (std::size_t x = 0; lightChanges && x < here; ++x)
                    isCutOff[x] |= row[x] >= LightGain::mostLuma;
            }
            sortColumns(samples, count);
            std::uint8_t *values = result.values.data() + std::ptrdiff_t(y) * result.width + x0;
            std::uint8_t *sigmas = result.sigmas.data() + std::ptrdiff_t(y) * result.width + x0;
            const auto &median = samples[count / 2], &lower = samples[count / 4],
                       &upper = samples[count - 1 - count / 4];
            for (std::size_t x = 0; x < here; ++x) {
                values[x] = median[x];
                const int quarter = std::min(upper[x] - median[x], median[x] - lower[x]);
                sigmas[x] = isCutOff[x] ? std::uint8_t(255) : sigmaOf[std::size_t(quarter)];
            }
        }
    }
    return result;
}

/// Samples of a lattice over the frame that differ by more than noise and light.
int movedSamples(const Frame &frame, const Frame &before)
{
    const auto table = LightGain::between(frame.y, before.y, frame.format.fullRange).toReference();
    int moved = 0;
    for (int y = 0; y < frame.y.height; y += motionLattice) {
        const std::uint8_t *now = frame.y.row(y), *then = before.y.row(y);
        for (int x = 0; x < frame.y.width; x += motionLattice)
            moved += std::abs(table[now[x]] - then[x]) > movedBy;
    }
    return moved;
}

/// Frames evenly spread over what has moved: of a robot that starts slowly, few show where it was.
std::vector<Frame> spreadOverMotion(const std::vector<Frame> &frames)
{
    std::vector<int> moved{0}; // up to each frame
    for (std::size_t i = 1; i < frames.size(); ++i)
        moved.push_back(moved.back() + movedSamples(frames[i], frames[i - 1]));
    std::vector<Frame> chosen;
    const std::size_t wanted = std::min(frames.size(), mostChosen);
    for (std::size_t k = 0, i = 0; k < wanted; ++k) {
        const double at = wanted > 1 ? double(moved.back()) * double(k) / double(wanted - 1) : 0;
        while (i + 1 < frames.size() && moved[i] < at)
            ++i;
        if (chosen.empty() || chosen.back().index != frames[i].index)
            chosen.push_back(frames[i]);
    }
    return chosen;
}

} // namespace

void BackgroundLearner::keep(const Frame &frame)
{
    if (m_kept.size() >= m_most) { // every second one, so that they stay spread evenly
        std::size_t left = 0;
        for (std::size_t i = 0; i < m_kept.size(); i += 2)
            m_kept[left++] = m_kept[i];
        m_kept.resize(left);
        m_every *= 2;
    }
    m_kept.push_back(frame);
}

void BackgroundLearner::add(const Frame &frame)
{
    if (!m_last || !sameLayout(m_last->format, frame.format)) {
        *this = BackgroundLearner();
        m_moving = -1; // the first has moved against nothing
        m_most = std::clamp(mostBytes / std::max<std::size_t>(bytesOf(frame), 1), fewestFrames, mostFrames);
    } else if (movedSamples(frame, *m_last) < leastMoved) {
        return; // what comes slowly is seen against the last frame that moved
    }
    m_last = copied(frame);
    if (++m_moving % m_every == 0)
        keep(*m_last);
}

std::optional<Background> BackgroundLearner::learned() const
{
    std::vector<Frame> frames = m_kept.empty() ? m_kept : spreadOverMotion(m_kept);
    if (frames.empty() && m_last)
        frames.push_back(*m_last);
    if (frames.empty())
        return std::nullopt;
    std::vector<PlaneView> y, u, v;
    std::vector<LightGain> gains;
    for (const Frame &frame : frames) {
        y.push_back(frame.y);
        u.push_back(frame.u);
        v.push_back(frame.v);
        gains.push_back(LightGain::between(frame.y, frames.front().y, frame.format.fullRange));
    }
    return Background{frames.front().format, medianOf(y, gains, true), medianOf(u, gains, false),
                      medianOf(v, gains, false)};
}

namespace {

constexpr Nanoseconds interval = std::chrono::milliseconds(100); // of the frames used
// moving frames from one learning to the next
constexpr std::int64_t mostBetween = 50;

} // namespace

std::optional<Background> LiveBackground::add(const Frame &frame)
{
    if (m_lastLook != Nanoseconds::min() && frame.time - m_lastLook < interval)
        return std::nullopt;
    m_lastLook = frame.time;
    m_learner.add(frame);
    if (m_learner.movingFrames() < m_next)
        return std::nullopt;
    m_next += std::min(m_next / 2, mostBetween);
    return m_learner.learned();
}

namespace {

constexpr double wantedSamples = 4000, fewestSamples = 400;
constexpr int noticeable = 4; ///< code values: beyond the noise of most samples
constexpr int darkOffset = 8; ///< code values added, so that noise of a dark frame is no change of light
constexpr int limitedBlack = 16;

/// The common part of two frames.
PixelRect commonPart(const Frame &a, const Frame &b)
{
    const PixelRect image{0, 0, b.y.width, b.y.height};
    return a.validRegion.value_or(image).clipped(b.validRegion.value_or(image)).clipped(image);
}

struct Change
{
    double ratio = 1, share = 0;
};

Change changeBetween(const Frame &last, const Frame &frame)
{
    const PixelRect part = commonPart(last, frame);
    if (part.isEmpty())
        return {};
    const int step = std::max(
        1, static_cast<int>(std::sqrt(double(part.width()) * double(part.height()) / wantedSamples)));
    std::int64_t before = 0, now = 0, brighter = 0, count = 0;
    for (int y = part.y0; y < part.y1; y += step) {
        const std::uint8_t *from = last.y.row(y), *to = frame.y.row(y);
        for (int x = part.x0; x < part.x1; x += step) {
            const int difference = to[x] - from[x];
            before += from[x];
            now += to[x];
            brighter += (difference > noticeable) - (difference < -noticeable);
            ++count;
        }
    }
    if (double(count) < fewestSamples)
        return {};
    const std::int64_t zero = count * (darkOffset - (frame.format.fullRange ? 0 : limitedBlack));
    return {double(std::max(now + zero, count)) / double(std::max(before + zero, count)),
            double(brighter) / double(count)};
}

} // namespace

LightLevel LightMeter::measure(const Frame &frame)
{
    Change change;
    if (m_last && m_last->y.width == frame.y.width && m_last->y.height == frame.y.height)
        change = changeBetween(*m_last, frame);
    m_level *= change.ratio;
    m_last = frame;
    return {frame.time, m_level, change.share};
}

namespace {

constexpr double comparedSamples = 2000;
constexpr int codedBlack = 16, leastLuma = 24; // darker is noise
constexpr float leastFactor = 0.2F, mostFactor = 5;
constexpr int fewestRatios = 50;

/// Ratios of two lumas, sorted into narrow bins.
class RatioHistogram
{
public:
    void add(float ratio)
    {
        const int bin = std::min(int(m_bins.size()) - 1, int(ratio * binsPerOne));
        m_bins[std::size_t(bin)] += one + Bin(int(ratio * ratioUnit));
        ++m_count;
    }
    int count() const { return m_count; }
    /// Of a bin that lies across a quartile, a share at the bin's mean.
    float meanOfMiddleHalf() const
    {
        const int first = m_count / 4, last = m_count - first;
        double sum = 0;
        int before = 0;
        for (const Bin bin : m_bins) {
            const int inBin = int(bin / one),
                      taken = std::min(last, before + inBin) - std::max(first, before);
            if (taken > 0)
                sum += double(bin % one) / ratioUnit * taken / inBin;
            before += inBin;
            if (before >= last)
                break;
        }
        return float(sum / (last - first));
    }

private:
    /// how many, in units of `one`, and below that the sum of their ratios: both by one addition
    using Bin = std::uint64_t;
    static constexpr Bin one = Bin(1) << 40;
    static constexpr float ratioUnit = 65536, binsPerOne = 256, mostRatio = 10; ///< 235 by 24
    std::array<Bin, std::size_t(binsPerOne *mostRatio)> m_bins{};
    int m_count = 0;
};

} // namespace

LightGain LightGain::between(const PlaneView &plane, const PlaneView &reference, bool fullRange)
{
    LightGain gain{1, fullRange ? 0 : codedBlack};
    const int step =
        std::max(1, static_cast<int>(std::sqrt(double(plane.width) * plane.height / comparedSamples)));
    RatioHistogram ratios;
    for (int y = step / 2; y < plane.height; y += step) {
        const int next = std::min(y + step, plane.height - 1);
        fetchEarly(plane.row(next), plane.width);
        fetchEarly(reference.row(next), plane.width);
        const std::uint8_t *now = plane.row(y), *before = reference.row(y);
        for (int x = step / 2; x < plane.width; x += step) {
            if (std::min(now[x], before[x]) >= leastLuma + gain.black &&
                std::max(now[x], before[x]) <= mostLuma)
                ratios.add(float(now[x] - gain.black) / float(before[x] - gain.black));
        }
    }
    if (ratios.count() >= fewestRatios) // the median alone would step with the code values
        gain.factor = std::clamp(ratios.meanOfMiddleHalf(), leastFactor, mostFactor);
    return gain;
}

std::array<std::uint8_t, 256> LightGain::table(float by) const
{
    std::array<std::uint8_t, 256> values{};
    for (int i = 0; i < 256; ++i)
        values[std::size_t(i)] =
            static_cast<std::uint8_t>(std::clamp(float(black) + by * float(i - black) + 0.5F, 0.0F, 255.0F));
    return values;
}

} // namespace odo
