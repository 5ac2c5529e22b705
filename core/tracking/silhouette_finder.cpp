// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/silhouette_finder.h"

#include "core/tracking/compared_window.h"
#include "core/tracking/light_gain.h"
#include "core/tracking/silhouette_parts.h"

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cmath>

namespace odo {

namespace {

constexpr int lattice = 4;                 // of the search through the whole picture, luma pixels
constexpr int windowMargin = 20;           // round what was found on the lattice
constexpr int mostSilhouettes = 16;
constexpr double mostShare = 0.4;          // of the picture that robots take up
constexpr double leastFragmentPx = 12;     // of a part that is taken with a body
constexpr int edgeReach = 4, hueReach = 6; // pixels round one on a region's edge, in which both sides are looked at
constexpr float half = 0.5F;

/// Windows round what differs, which do not overlap.
std::vector<PixelRect> windowsAround(const cv::Mat1b &hits, const PixelRect &picture)
{
    // One or two are noise; those that are two apart belong together.
    cv::Mat1b together;
    cv::boxFilter(hits, together, -1, {3, 3}, {-1, -1}, false, cv::BORDER_CONSTANT);
    cv::Mat1b joined = (together >= 3);
    cv::dilate(joined, joined, cv::Mat1b::ones(3, 3));
    cv::Mat labels, stats, centres;
    const int count = cv::connectedComponentsWithStats(joined, labels, stats, centres, 8, CV_32S);
    std::vector<PixelRect> windows;
    for (int label = 1; label < count; ++label) {
        const int x = stats.at<int>(label, cv::CC_STAT_LEFT), y = stats.at<int>(label, cv::CC_STAT_TOP);
        const int w = stats.at<int>(label, cv::CC_STAT_WIDTH), h = stats.at<int>(label, cv::CC_STAT_HEIGHT);
        PixelRect rect = PixelRect{x * lattice - windowMargin, y * lattice - windowMargin, (x + w) * lattice + windowMargin,
                                   (y + h) * lattice + windowMargin}.clipped(picture);
        for (std::size_t i = 0; i < windows.size();) {
            if (windows[i].clipped(rect).isEmpty()) {
                ++i;
                continue;
            }
            rect = rect.united(windows[i]);
            windows.erase(windows.begin() + std::ptrdiff_t(i));
            i = 0;
        }
        windows.push_back(rect);
    }
    return windows;
}

} // namespace

struct SilhouetteFinder::Impl
{
    Background background;
    std::vector<SeenSilhouette> found;
    LightGain gain;
    ComparedWindow window;

    cv::Mat1b differencesOnLattice(const Frame &frame) const;
    bool fits(const Frame &frame) const;
    int firstPiece = 0; ///< of the window's shadow pieces

    void takeRegions();
    void measure(const cv::Mat1b &region, const cv::Mat1b &cutAway, const cv::Rect &box, SeenSilhouette &silhouette) const;
};

bool SilhouetteFinder::Impl::fits(const Frame &frame) const
{
    const auto alike = [](const PlaneView &plane, const Background::Plane &behind) { return plane.width == behind.width && plane.height == behind.height; };
    constexpr int leastSide = 8 * lattice;
    return alike(frame.y, background.y) && alike(frame.u, background.u) && alike(frame.v, background.v) && frame.y.width >= leastSide &&
           frame.y.height >= leastSide;
}

/// Where something differs on a lattice over the whole picture.
cv::Mat1b SilhouetteFinder::Impl::differencesOnLattice(const Frame &frame) const
{
    const auto behind = gain.fromReference();
    const int columns = frame.y.width / lattice, rows = frame.y.height / lattice;
    cv::Mat1b hits(rows, columns);
    const int sx = frame.format.chromaShiftX, sy = frame.format.chromaShiftY;
    for (int j = 0; j < rows; ++j) {
        const int y = j * lattice + lattice / 2, cy = std::min(y >> sy, frame.u.height - 1);
        const std::uint8_t *luma = frame.y.row(y), *u = frame.u.row(cy), *v = frame.v.row(cy);
        const std::uint8_t *lumaBehind = background.y.row(y), *uBehind = background.u.row(cy), *vBehind = background.v.row(cy);
        const std::uint8_t *sigma = background.y.sigmaRow(y), *uSigma = background.u.sigmaRow(cy), *vSigma = background.v.sigmaRow(cy);
        for (int i = 0; i < columns; ++i) {
            const int x = i * lattice + lattice / 2, cx = std::min(x >> sx, frame.u.width - 1);
            const auto share = [](int difference, int sigmas) {
                return squared(float(difference)) / squared(float(sigmas) * Background::sigmaUnit);
            };
            const int darker = luma[x] - behind[lumaBehind[x]], dy = luma[x] >= LightGain::mostLuma ? std::max(0, darker) : darker, du = u[cx] - uBehind[cx], dv = v[cx] - vBehind[cx];
            const bool isStep = float(std::abs(dy)) > leastLumaStep || float(std::max(std::abs(du), std::abs(dv))) > leastChromaStep;
            hits(j, i) = isStep && share(dy, sigma[x]) + share(du, uSigma[cx]) + share(dv, vSigma[cx]) > differsInSigmas2 ? 1 : 0;
        }
    }
    return hits;
}

/// What lies on both sides of a pixel on a region's edge: the mean colour inside, and by what the floor outside is in shadow.
struct EdgeSides
{
    float inside = 0; ///< pixels
    float luma = 0, u = 0, v = 0;
    float shade = 1;
};

EdgeSides sidesOf(const ComparedWindow &w, const cv::Mat1b &core, const cv::Mat1b &near, int x, int y, int reach)
{
    EdgeSides sides;
    float outside = 0, shade = 0;
    for (int j = std::max(0, y - reach); j <= std::min(core.rows - 1, y + reach); ++j) {
        for (int i = std::max(0, x - reach); i <= std::min(core.cols - 1, x + reach); ++i) {
            if (core(j, i)) {
                sides.inside += 1;
                sides.luma += w.luma(j, i);
                sides.u += w.u(j, i);
                sides.v += w.v(j, i);
            } else if (!near(j, i)) {
                outside += 1;
                shade += w.differs(j, i) && w.shade(j, i) ? w.luma(j, i) / std::max(1.0F, w.lumaBehind(j, i)) : 1.0F;
            }
        }
    }
    if (sides.inside > 0) {
        sides.luma /= sides.inside;
        sides.u /= sides.inside;
        sides.v /= sides.inside;
    }
    if (outside > 0)
        sides.shade = shade / outside;
    return sides;
}

/// The part of a pixel that a region covers: what is seen is a blend of what lies inside and of the floor behind.
float coveredPart(const ComparedWindow &w, const EdgeSides &sides, int x, int y, float otherwise)
{
    if (sides.inside == 0)
        return otherwise;
    const float behind = sides.shade * w.lumaBehind(y, x), uBehind = sides.shade * w.uBehind(y, x), vBehind = sides.shade * w.vBehind(y, x);
    const float dy = sides.luma - behind, du = sides.u - uBehind, dv = sides.v - vBehind;
    const float ly = 1 / w.lumaNoise2(y, x), lc = 1 / w.chromaNoise2(y, x);
    const float contrast = dy * dy * ly + (du * du + dv * dv) * lc;
    if (contrast < differsInSigmas2)
        return otherwise;
    const float along = (w.luma(y, x) - behind) * dy * ly + ((w.u(y, x) - uBehind) * du + (w.v(y, x) - vBehind) * dv) * lc;
    return std::clamp(along / contrast, 0.0F, 1.0F);
}

/// Where the covered part crosses one half along the rows and the columns, from both ends of each: the corners of the region's hull are
/// among these points. Pixels of the window.
std::vector<Eigen::Vector2d> edgePoints(const cv::Mat1f &covered)
{
    std::vector<Eigen::Vector2d> points;
    const auto walk = [&](int lines, int length, const auto &valueAt, const auto &pointAt) {
        for (int line = 0; line < lines; ++line) {
            for (const bool fromEnd : {false, true}) {
                float before = 0;
                for (int k = 0; k < length; ++k) {
                    const int at = fromEnd ? length - 1 - k : k;
                    const float here = valueAt(line, at);
                    if (here >= half) {
                        const double back = k > 0 ? double((here - half) / (here - before)) : 0;
                        points.push_back(pointAt(line, fromEnd ? at + back : at - back));
                        break;
                    }
                    before = here;
                }
            }
        }
    };
    walk(covered.rows, covered.cols, [&](int y, int x) { return covered(y, x); }, [](int y, double x) { return Eigen::Vector2d(x, y); });
    walk(covered.cols, covered.rows, [&](int x, int y) { return covered(y, x); }, [](int x, double y) { return Eigen::Vector2d(x, y); });
    return points;
}

/// Moments of a region's hull, from the part of each pixel near its edge that is covered; cutAway: what is there and no part of it.
void SilhouetteFinder::Impl::measure(const cv::Mat1b &region, const cv::Mat1b &cutAway, const cv::Rect &box, SeenSilhouette &silhouette) const
{
    const ComparedWindow &w = window;
    cv::Mat1b core, near;
    const cv::Mat1b disc = cv::getStructuringElement(cv::MORPH_ELLIPSE, {5, 5});
    cv::erode(region, core, disc, {-1, -1}, 1, cv::BORDER_CONSTANT, 0);
    cv::dilate(region, near, disc);
    near &= cutAway == 0;
    cv::Mat1b inner, soft; // where the edge is known by hue only, it is somewhere in a wider band
    cv::erode(region, inner, cv::getStructuringElement(cv::MORPH_ELLIPSE, {9, 9}), {-1, -1}, 1, cv::BORDER_CONSTANT, 0);
    soft = near & w.byHue & (inner == 0);
    core &= soft == 0;
    const cv::Rect part = cv::Rect(box.x - 3, box.y - 3, box.width + 6, box.height + 6) & cv::Rect(0, 0, region.cols, region.rows);
    cv::Mat1f covered = cv::Mat1f::zeros(part.size());
    double inside = 0, su = 0, sv = 0;
    for (int y = part.y; y < part.y + part.height; ++y) {
        for (int x = part.x; x < part.x + part.width; ++x) {
            if (!near(y, x))
                continue;
            float &here = covered(y - part.y, x - part.x);
            if (!core(y, x)) {
                here = coveredPart(w, sidesOf(w, core, near, x, y, soft(y, x) ? hueReach : edgeReach), x, y, region(y, x));
                continue;
            }
            here = 1;
            su += double(w.u(y, x));
            sv += double(w.v(y, x));
            inside += 1;
        }
    }
    std::vector<Eigen::Vector2d> points = edgePoints(covered);
    if (points.size() < 8)
        return;
    for (Eigen::Vector2d &point : points)
        point += Eigen::Vector2d(w.rect.x0 + part.x, w.rect.y0 + part.y);
    measureHull(silhouette, std::move(points));
    if (inside > 0)
        silhouette.meanChroma = Chroma(su / inside, sv / inside);
}

/// Whether the background has the edge that an outline follows, and the picture has none: what was there while the background was learned has gone.
bool isGhost(const ComparedWindow &w, const std::vector<cv::Point> &outline)
{
    constexpr int across = 2;        // pixels to either side of the edge
    constexpr float clearly = 1.5F;
    float now = 0, behind = 0;
    for (const cv::Point &point : outline) {
        const int left = std::max(0, point.x - across), right = std::min(w.luma.cols - 1, point.x + across);
        const int above = std::max(0, point.y - across), below = std::min(w.luma.rows - 1, point.y + across);
        const auto step = [&](const cv::Mat1f &plane) {
            return std::hypot(plane(point.y, right) - plane(point.y, left), plane(below, point.x) - plane(above, point.x));
        };
        now += step(w.luma) + step(w.u) + step(w.v);
        behind += step(w.lumaBehind) + step(w.uBehind) + step(w.vBehind);
    }
    return behind > clearly * now;
}

/// Takes away what is thin and reaches far out of a region, and gives it: cables, aerials and masts are no part of a body's form, and often move in it.
cv::Mat1b cutAppendages(cv::Mat1b &region, const std::vector<cv::Point> &outline)
{
    cv::Mat1b cut = cv::Mat1b::zeros(region.size());
    constexpr double thin = 0.12, farOut = 0.25, leastHollow = 1.1; // of the side of a square of its area; of its hull's area
    std::vector<cv::Point> hull;
    cv::convexHull(outline, hull);
    const double area = cv::contourArea(outline), side = std::sqrt(area);
    const int width = int(thin * side) | 1;
    if (width < 3 || cv::contourArea(hull) < leastHollow * area)
        return cut;
    cv::Mat1b body;
    cv::morphologyEx(region, body, cv::MORPH_OPEN, cv::getStructuringElement(cv::MORPH_ELLIPSE, {width, width}));
    std::vector<cv::Point> points;
    cv::findNonZero(body, points);
    if (points.empty())
        return cut;
    cv::convexHull(points, hull);
    std::vector<std::vector<cv::Point>> rests;
    cv::findContours(region & (body == 0), rests, cv::RETR_EXTERNAL, cv::CHAIN_APPROX_NONE);
    for (std::size_t k = 0; k < rests.size(); ++k) {
        const bool isFar = std::ranges::any_of(rests[k], [&](const cv::Point &point) { return cv::pointPolygonTest(hull, cv::Point2f(point), true) < -farOut * side; });
        if (isFar)
            cv::drawContours(cut, rests, int(k), cv::Scalar(1), cv::FILLED);
    }
    region &= cut == 0;
    return cut;
}

void SilhouetteFinder::Impl::takeRegions()
{
    ComparedWindow &w = window;
    const cv::Mat1b clear = w.differs & (w.shade == 0), small = cv::getStructuringElement(cv::MORPH_ELLIPSE, {3, 3});
    cv::Mat1b taken;
    cv::morphologyEx(clear, taken, cv::MORPH_OPEN, small); // a speck would move the hull
    taken |= clear & w.plain;                              // but a part may be a few pixels wide
    if (cv::countNonZero(taken) < leastAreaPx) // nothing that cannot be a shadow: perhaps a robot of the floor's own hue
        cv::morphologyEx(w.differs, taken, cv::MORPH_OPEN, small);
    cv::morphologyEx(taken, taken, cv::MORPH_CLOSE, cv::getStructuringElement(cv::MORPH_ELLIPSE, {5, 5}));
    cv::Mat1i pieces;
    cv::connectedComponents(taken | w.differs, pieces, 8, CV_32S);
    std::vector<std::vector<cv::Point>> outlines;
    cv::findContours(taken, outlines, cv::RETR_EXTERNAL, cv::CHAIN_APPROX_NONE);
    for (std::size_t k = 0; k < outlines.size(); ++k) {
        if (isGhost(w, outlines[k]))
            continue;
        const cv::Rect box = cv::boundingRect(outlines[k]);
        cv::Mat1b region = cv::Mat1b::zeros(taken.size());
        cv::drawContours(region, outlines, int(k), cv::Scalar(1), cv::FILLED);
        const cv::Mat1b cutAway = cutAppendages(region, outlines[k]);
        SeenSilhouette silhouette;
        silhouette.isTrimmed = cv::countNonZero(cutAway) > 0;
        silhouette.box = {w.rect.x0 + box.x, w.rect.y0 + box.y, w.rect.x0 + box.x + box.width, w.rect.y0 + box.y + box.height};
        measure(region, cutAway, box, silhouette);
        if (silhouette.moments.areaPx2 < leastFragmentPx)
            continue;
        silhouette.shadowPiece = firstPiece + pieces(outlines[k].front());
        silhouette.clearShare = double(cv::countNonZero(clear & region)) / double(cv::countNonZero(region));
        const int right = background.y.width - 2, bottom = background.y.height - 2;
        silhouette.touchesBorder = silhouette.box.x0 < 2 || silhouette.box.y0 < 2 || silhouette.box.x1 > right || silhouette.box.y1 > bottom;
        found.push_back(std::move(silhouette));
    }
    double most = 0;
    cv::minMaxLoc(pieces, nullptr, &most);
    firstPiece += int(most);
}

SilhouetteFinder::SilhouetteFinder(Background background) : m_impl(std::make_unique<Impl>())
{
    m_impl->background = std::move(background);
}

SilhouetteFinder::~SilhouetteFinder() = default;
SilhouetteFinder::SilhouetteFinder(SilhouetteFinder &&) noexcept = default;
SilhouetteFinder &SilhouetteFinder::operator=(SilhouetteFinder &&) noexcept = default;

const std::vector<SeenSilhouette> &SilhouetteFinder::find(const Frame &frame)
{
    Impl &d = *m_impl;
    d.found.clear();
    d.firstPiece = 0;
    const Background::Plane &behind = d.background.y;
    const PixelRect picture{0, 0, behind.width, behind.height};
    if (!d.fits(frame))
        return d.found;
    d.gain = LightGain::between(frame.y, {behind.values.data(), behind.width, behind.height, behind.width}, frame.format.fullRange);
    const cv::Mat1b hits = d.differencesOnLattice(frame);
    if (cv::countNonZero(hits) > mostShare * double(hits.total())) // the light of a part of the room, or the camera, has changed
        return d.found;
    for (const PixelRect &rect : windowsAround(hits, picture)) {
        d.window.compare(frame, d.background, d.gain, rect);
        d.takeRegions();
    }
    const auto areaOf = [](const SeenSilhouette &one) { return one.moments.areaPx2; };
    std::ranges::sort(d.found, std::greater<>(), areaOf);
    joinFragments(d.found);
    std::erase_if(d.found, [&](const SeenSilhouette &one) { return areaOf(one) < leastAreaPx; });
    std::ranges::sort(d.found, std::greater<>(), areaOf);
    if (d.found.size() > mostSilhouettes)
        d.found.resize(mostSilhouettes);
    return d.found;
}

} // namespace odo
