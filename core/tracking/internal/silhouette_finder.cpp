// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/internal/silhouette_finder.h"

#include "core/geometry/silhouette.h"
#include "core/tracking/internal/bit_mask.h"
#include "core/tracking/internal/compared_window.h"
#include "core/tracking/internal/difference_windows.h"
#include "core/tracking/internal/floor_shade.h"
#include "core/tracking/internal/region_edge.h"
#include "core/tracking/internal/searched_mask.h"
#include "core/tracking/internal/silhouette_parts.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

namespace odo {

namespace {

constexpr int mostSilhouettes = 16;
constexpr double mostShare = 0.4;      // of the frame that robots cover
constexpr double leastFragmentPx = 12; // of a part that is taken with a body
constexpr double leastFilled = 0.15;   // of its hull: a cable on the floor fills less
constexpr int speckRadius = 1, gapRadius = 2;

bool fits(const Frame &frame, const Background &background)
{
    const auto alike = [](const PlaneView &plane, const Background::Plane &behind) {
        return plane.width == behind.width && plane.height == behind.height;
    };
    const auto cover = [](int samples, int shift, int pixels) { return samples << shift >= pixels; };
    constexpr int leastSide = 8 * DifferenceLattice::step;
    const FrameFormat &format = background.format;
    return alike(frame.y, background.y) && alike(frame.u, background.u) && alike(frame.v, background.v) &&
           frame.y.width >= leastSide && frame.y.height >= leastSide &&
           frame.format.chromaShiftX == format.chromaShiftX &&
           frame.format.chromaShiftY == format.chromaShiftY &&
           cover(frame.u.width, format.chromaShiftX, frame.y.width) &&
           cover(frame.u.height, format.chromaShiftY, frame.y.height);
}

/// The pixels of a region beside which something else lies.
BitMask edgeOf(const BitMask &region)
{
    return region - region.eroded(1, false);
}

/// Whether the background has the edge of a region, and the frame has none: what was there while the
/// background was learned has gone.
bool isGhost(const ComparedWindow &w, const BitMask &edge, const PixelRect &part)
{
    constexpr int across = 2; // pixels to either side of the edge
    constexpr float clearly = 1.5F;
    const auto step = [](const PixelColour &left, const PixelColour &right, const PixelColour &above,
                         const PixelColour &below) {
        const auto length = [](float x, float y) { return std::sqrt(x * x + y * y); };
        return length(right.luma - left.luma, below.luma - above.luma) +
               length(right.u - left.u, below.u - above.u) + length(right.v - left.v, below.v - above.v);
    };
    float now = 0, behind = 0;
    edge.forEach([&](int px, int py) {
        const int x = part.x0 + px, y = part.y0 + py, left = std::max(0, x - across),
                  right = std::min(w.width() - 1, x + across);
        const int above = std::max(0, y - across), below = std::min(w.height() - 1, y + across);
        now += step(w.seen(left, y), w.seen(right, y), w.seen(x, above), w.seen(x, below));
        behind += step(w.behind(left, y), w.behind(right, y), w.behind(x, above), w.behind(x, below));
    });
    return behind > clearly * now;
}

/// The convex hull of the pixels' centres.
std::vector<Eigen::Vector2d> hullOf(const BitMask &set)
{
    std::vector<Eigen::Vector2d> ends; // of the rows, as far as they may be corners
    for (int y = 0; y < set.height(); ++y)
        if (const int first = set.nextSet(0, y); first < set.width())
            addToChain(ends, 0, -1, {first, y});
    const std::size_t lefts = ends.size();
    for (int y = 0; y < set.height(); ++y)
        if (const int last = set.lastSet(set.width(), y); last >= 0)
            addToChain(ends, lefts, 1, {last, y});
    return convexHull(std::move(ends));
}

/// Whether a point is farther than a distance from a convex polygon.
bool isBeyond(const std::vector<Eigen::Vector2d> &hull, const Eigen::Vector2d &position, double distance)
{
    bool isInside = true;
    for (std::size_t i = 0; i < hull.size(); ++i) {
        const Eigen::Vector2d &from = hull[i], along = hull[(i + 1) % hull.size()] - from,
                              away = position - from;
        isInside &= along.x() * away.y() - along.y() * away.x() >= 0;
        const double at = std::clamp(along.dot(away) / std::max(along.squaredNorm(), 1e-9), 0.0, 1.0);
        if ((away - at * along).squaredNorm() <= distance * distance)
            return false;
    }
    return !isInside;
}

/// Adds a part of a set to another one, which lies so far from it.
void addPart(const ConnectedPart &part, BitMask &into, int left = 0, int top = 0)
{
    for (const PixelRun &run : part)
        into.setRun(run.y - top, run.x0 - left, run.x1 - left);
}

/// A set of pixels without its small parts: the ends of something thin.
BitMask withoutSpecks(const BitMask &set)
{
    constexpr double small = 0.05; // of the largest part
    const ConnectedParts parts = connectedParts(set);
    const auto pixelsOf = [](const ConnectedPart &part) {
        return std::accumulate(part.begin(), part.end(), 0,
                               [](int sum, const PixelRun &run) { return sum + run.x1 - run.x0; });
    };
    int most = 0;
    for (const ConnectedPart &part : parts)
        most = std::max(most, pixelsOf(part));
    BitMask left(set.width(), set.height());
    for (const ConnectedPart &part : parts)
        if (pixelsOf(part) >= small * most)
            addPart(part, left);
    return left;
}

/// Takes away what is thin and reaches far out of a region, and gives it: cables and aerials are no part of a
/// body's form, and often move in it. A mast with something on it is: it turns with the body.
BitMask cutAppendages(BitMask &region, const BitMask &edge)
{
    BitMask cut(region.width(), region.height());
    // of the side of a square of its area; of its hull's area
    constexpr double thin = 0.12, farOut = 0.25, leastHollow = 1.1;
    // The area within the line through the pixels on the edge, as the hull's (Pick's theorem).
    const double area = region.count() - edge.count() / 2.0 - 1, side = std::sqrt(std::max(0.0, area));
    const int width = int(thin * side) | 1;
    if (width < 3 || polygonMoments(hullOf(region)).areaPx2 < leastHollow * area)
        return cut;
    const BitMask opened = region.opened(width / 2);
    if (opened.isEmpty())
        return cut;
    const BitMask body = withoutSpecks(opened);
    const std::vector<Eigen::Vector2d> hull = hullOf(body);
    for (const ConnectedPart &part : connectedParts(region - body)) {
        const auto isFar = [&](int x, int y) { return isBeyond(hull, {x, y}, farOut * side); };
        if (std::ranges::none_of(
                part, [&](const PixelRun &run) { return isFar(run.x0, run.y) || isFar(run.x1 - 1, run.y); }))
            continue;
        addPart(part, cut);
    }
    region -= cut;
    return cut;
}

/// Of a few pixels of a region and beside it. shade: of the window, as part is. Black is no shadow.
ShadowAmbiguity shadowAmbiguityOf(const ComparedWindow &w, const BitMask &shade, const BitMask &region,
                                  const PixelRect &part)
{
    constexpr int step = 4;                                                              // pixels
    constexpr float deepest = 0.15F, lightest = 0.95F, surelyTinted = 1.5F, sameHue = 3; // code values
    constexpr float ofLightShadows = 0.55F; // what the first lighter ones that are tried leave of the luma
    constexpr float nearly = 0.8F;          // of the limit, or the limit of it
    const float darkest = w.shadow().darkest;
    int pixels = 0, deep = 0, tinted = 0, light = 0, near = 0;
    for (int y = 0; y < region.height(); y += step) {
        for (int x = 0; x < region.width(); x += step) {
            const bool isRobot = region.at(x, y);
            if (!isRobot && !shade.at(part.x0 + x, part.y0 + y))
                continue;
            const PixelColour seen = w.seen(part.x0 + x, part.y0 + y),
                              behind = w.behind(part.x0 + x, part.y0 + y);
            const float left = seen.luma / std::max(1.0F, behind.luma);
            if (!isRobot) {
                light += left < ofLightShadows;
                near += nearly * left < darkest;
                continue;
            }
            const float off =
                std::max(std::abs(seen.u - left * behind.u), std::abs(seen.v - left * behind.v));
            const bool isDeep = left < darkest;
            ++pixels;
            deep += left > deepest && isDeep && off < sameHue;
            near += left > nearly * darkest && isDeep && off < sameHue;
            tinted += !isDeep && left < lightest && off > surelyTinted &&
                      off < sameHue + Background::strongTint * (behind.luma - seen.luma);
        }
    }
    const auto share = [all = float(std::max(1, pixels))](int of) { return float(of) / all; };
    return {share(deep), share(tinted), share(light), share(near)};
}

} // namespace

struct SilhouetteFinder::Impl
{
    Impl(Background learned, const SearchedArea &area)
        : background(std::move(learned)), lattice(background), window(background)
    {
        if (area.isWholeFrame())
            return;
        const Background::Plane &luma = background.y;
        constexpr int step = DifferenceLattice::step;
        searchedCells =
            searchedSamples(area, {luma.width / step, luma.height / step,
                                   Eigen::Vector2d::Constant(step / 2.0), Eigen::Vector2d::Constant(step)});
        searched = searchedSamples(area, {luma.width, luma.height});
        window.searchOnly(*searched);
    }

    Background background;
    DifferenceLattice lattice;
    ComparedWindow window;
    FloorShade shade;
    RegionEdge edge;
    /// where robots are searched, in pixels and in cells of the lattice; none: everywhere
    std::optional<BitMask> searched, searchedCells;
    std::vector<SeenSilhouette> found;
    int firstPiece = 0; ///< of the window's shadow pieces

    bool look(const Frame &frame, const DifferenceWindow &part);
    void takeGroup(const Frame &frame, const std::vector<DifferenceWindow> &windows);
    void takeRegions(const BitMask &taken, const BitMask &clear);
    bool measure(BitMask region, const BitMask &edgePixels, const PixelRect &part, const BitMask &clear,
                 SeenSilhouette &silhouette);
};

/// Whether anything differs in a part of the frame.
bool SilhouetteFinder::Impl::look(const Frame &frame, const DifferenceWindow &part)
{
    window.compare(frame, lattice.gain(), part);
    if (window.rect().isEmpty())
        return false;
    shade.find(window);
    return true;
}

/// Takes the regions of windows that are near one another: what cannot be a shadow, or where there is nothing
/// of that, all that differs: perhaps it is a robot of the floor's own hue.
void SilhouetteFinder::Impl::takeGroup(const Frame &frame, const std::vector<DifferenceWindow> &windows)
{
    const std::size_t foundBefore = found.size();
    const int pieceBefore = firstPiece;
    int pixels = 0;
    for (const DifferenceWindow &part : windows) {
        if (!look(frame, part))
            continue;
        const BitMask clear = window.differs() - shade.shade();
        // a speck would move the hull, but a part may be a few pixels wide
        const BitMask taken = clear.opened(speckRadius) | (clear & window.plain());
        pixels += taken.count();
        takeRegions(taken, clear);
    }
    if (pixels >= leastAreaPx)
        return;
    found.resize(foundBefore);
    firstPiece = pieceBefore;
    for (const DifferenceWindow &part : windows) {
        const bool isThere = windows.size() == 1 ? !window.rect().isEmpty() : look(frame, part);
        if (isThere)
            takeRegions(window.differs().opened(speckRadius), window.differs() - shade.shade());
    }
}

void SilhouetteFinder::Impl::takeRegions(const BitMask &taken, const BitMask &clear)
{
    const BitMask closed = taken.closed(gapRadius);
    const ConnectedParts parts = connectedParts(closed);
    ConnectedParts pieces;
    if (parts.size() > 1)
        pieces = connectedParts(closed | window.differs());
    BitMask enclosed(closed.width(), closed.height());
    for (const ConnectedPart &pixels : parts) {
        const PixelRun &first = pixels.front();
        if (enclosed.at(first.x0, first.y)) // it lies in a hole of another
            continue;
        constexpr int margin = RegionEdge::marginPx;
        const PixelRect box = boundsOf(pixels);
        const PixelRect part =
            PixelRect{box.x0 - margin, box.y0 - margin, box.x1 + margin, box.y1 + margin}.clipped(
                {0, 0, window.width(), window.height()});
        BitMask region(part.width(), part.height());
        addPart(pixels, region, part.x0, part.y0);
        if (enclosesAny(pixels))
            region = withoutHoles(region);
        if (parts.size() > 1)
            enclosed.add(region, part.x0, part.y0);
        SeenSilhouette silhouette;
        silhouette.box = {window.rect().x0 + box.x0, window.rect().y0 + box.y0, window.rect().x0 + box.x1,
                          window.rect().y0 + box.y1};
        const BitMask edgePixels = edgeOf(region);
        if (isGhost(window, edgePixels, part) ||
            !measure(std::move(region), edgePixels, part, clear, silhouette))
            continue;
        const auto piece = std::find_if(pieces.begin(), pieces.end(), [&](const ConnectedPart &one) {
            return contains(one, first.x0, first.y);
        });
        silhouette.shadowPiece = firstPiece + int(piece - pieces.begin());
        found.push_back(std::move(silhouette));
    }
    firstPiece += int(std::max<std::size_t>(1, pieces.size()));
}

/// Measures a region of a part of the window. False where it is too small to be even a fragment.
bool SilhouetteFinder::Impl::measure(BitMask region, const BitMask &edgePixels, const PixelRect &part,
                                     const BitMask &clear, SeenSilhouette &silhouette)
{
    const BitMask cut = cutAppendages(region, edgePixels);
    silhouette.isTrimmed = !cut.isEmpty();
    edge.measure(window, shade, part, region, cut);
    if (edge.points().size() < 3)
        return false;
    measureHull(silhouette, edge.points());
    if (silhouette.moments.areaPx2 < leastFragmentPx ||
        region.count() < leastFilled * silhouette.moments.areaPx2)
        return false;
    silhouette.meanChroma = edge.meanChroma();
    silhouette.shadowAmbiguity = shadowAmbiguityOf(window, shade.shade(), region, part);
    silhouette.clearShare = double((clear.cropped(part) & region).count()) / double(region.count());
    const int right = background.y.width - 2, bottom = background.y.height - 2;
    silhouette.touchesBorder =
        silhouette.box.x0 < 2 || silhouette.box.y0 < 2 || silhouette.box.x1 > right ||
        silhouette.box.y1 > bottom ||
        (searched && isCutBy(*searched, region, window.rect().x0 + part.x0, window.rect().y0 + part.y0));
    return true;
}

SilhouetteFinder::SilhouetteFinder(Background background, const SearchedArea &area)
    : m_impl(std::make_unique<Impl>(std::move(background), area))
{
}

SilhouetteFinder::~SilhouetteFinder() = default;
SilhouetteFinder::SilhouetteFinder(SilhouetteFinder &&) noexcept = default;
SilhouetteFinder &SilhouetteFinder::operator=(SilhouetteFinder &&) noexcept = default;

const std::vector<SeenSilhouette> &SilhouetteFinder::find(const Frame &frame)
{
    Impl &d = *m_impl;
    d.found.clear();
    d.firstPiece = 0;
    if (!fits(frame, d.background))
        return d.found;
    d.lattice.compare(frame, d.background);
    BitMask within;
    if (d.searchedCells)
        within = d.lattice.differences() & *d.searchedCells;
    const BitMask &differences = d.searchedCells ? within : d.lattice.differences();
    // the light of a part of the room, or the camera, has changed
    if (differences.count() > mostShare * differences.width() * differences.height())
        return d.found;
    for (const std::vector<DifferenceWindow> &group :
         windowsAround(differences, {0, 0, frame.y.width, frame.y.height}))
        d.takeGroup(frame, group);
    const auto areaOf = [](const SeenSilhouette &one) { return one.moments.areaPx2; };
    std::ranges::sort(d.found, std::greater<>(), areaOf);
    if (d.background.shadow.connects)
        joinByShadow(d.found);
    joinFragments(d.found);
    noteApart(d.found);
    noteBeside(d.found);
    std::erase_if(d.found, [&](const SeenSilhouette &one) { return areaOf(one) < leastAreaPx; });
    std::ranges::sort(d.found, std::greater<>(), areaOf);
    if (d.found.size() > mostSilhouettes)
        d.found.resize(mostSilhouettes);
    return d.found;
}

} // namespace odo
