// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/internal/registration_causes.h"

#include "core/base/units.h"
#include "core/calibration/internal/marker_pairs.h"
#include "core/calibration/internal/wording.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numeric>
#include <set>
#include <vector>

namespace odo {

namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double outsideShare = 0.02; // of the longer side: nobody clicks so far beyond an image's edge
constexpr double leastCauseHeightM = 0.05, mostCauseHeightM = 100; // of a camera
constexpr double clearlyBetterCause = 3, leastCauseDifferencePx = 0.7;
constexpr double nadirCosine = 0.9; // a camera that looks straight down to 25° has no upper side
constexpr double otherSize = 1.03;  // a size nearer to the camera's is the same one
constexpr double otherZoom = 1.05, farBetter = 0.1;
constexpr double symmetricShare = 0.02; // of a layout's extent: looks the same mirrored
constexpr double samePixels = 3;        // of another camera's markers, RMS: as people click
constexpr std::size_t mostNamed = 3;

// Widths at which cameras record and programs show images.
constexpr int widths[] = {320,  480,  640,  720,  800,  960,  1024, 1152, 1280, 1440,
                          1600, 1920, 2048, 2304, 2560, 2592, 3072, 3264, 3840, 4096};

/// How much a mistake leaves to choose. The fewer ways a mistake has, the less it fits by chance.
enum class Freedom {
    None,       ///< one way: v from below, a mirrored image
    Order,      ///< one of the orders of the labels
    Choice,     ///< one of some twenty sizes, one of the other cameras
    FreeNumber, ///< a focal length, a marker that is left out
};

struct Cause
{
    Freedom freedom;
    double rmsPx;
    bool isUpright;
    Message words;
};

using Pairs = std::vector<PointPair>;
using Words = std::function<Message(const PlanePose &, const MessageArgument &fit)>;
using Order = std::vector<std::size_t>;

bool isInside(const Vector2d &pixel, const CameraModel &camera)
{
    const Intrinsics &lens = camera.intrinsics();
    const double margin = outsideShare * std::max(lens.widthPx, lens.heightPx);
    return pixel.x() >= -margin && pixel.y() >= -margin && pixel.x() <= lens.widthPx - 1 + margin &&
           pixel.y() <= lens.heightPx - 1 + margin;
}

/// The top of the image is the upper side of what is seen; or the camera looks down and has none.
bool isUpright(const RigidTransform &worldFromCamera)
{
    return (worldFromCamera.rotation * Vector3d::UnitY()).z() < 0 ||
           (worldFromCamera.rotation * Vector3d::UnitZ()).z() < -nadirCosine;
}

double carefulSum(std::span<const PointPair> pairs, const PlanePose &pose)
{
    const double tapeM = carefulTapeM(extentOf(positionsOf(pairs)));
    const FloorView view(pose.camera, pose.worldFromCamera, Eigen::Matrix<double, 6, 6>::Zero());
    double sum = 0;
    for (const PointPair &pair : pairs) {
        Eigen::Matrix<double, 2, 3> byWorld;
        const auto pixel = view.pixelFromWorld({pair.source.x(), pair.source.y(), 0}, byWorld);
        if (!pixel)
            return std::numeric_limits<double>::infinity();
        const double tapePx = tapeM * std::sqrt(std::abs(byWorld.leftCols<2>().determinant()));
        sum += (*pixel - pair.target).squaredNorm() / (carefulMarkPx * carefulMarkPx + tapePx * tapePx);
    }
    return sum;
}

std::vector<Order> exchangesOf(std::size_t count)
{
    Order order(count);
    std::iota(order.begin(), order.end(), 0);
    std::vector<Order> orders;
    for (std::size_t i = 0; i < count; ++i) {
        for (std::size_t j = i + 1; j < count; ++j) {
            orders.push_back(order);
            std::swap(orders.back()[i], orders.back()[j]);
        }
    }
    return orders;
}

/// Orders that mirror the layout onto itself, to 2 % of its extent.
std::vector<Order> mirrorOrdersOf(std::span<const PointPair> pairs)
{
    const std::vector<Vector2d> points = positionsOf(pairs);
    Vector2d middle = Vector2d::Zero();
    for (const Vector2d &point : points)
        middle += point / static_cast<double>(points.size());
    const double reachM = symmetricShare * extentOf(points);
    const auto farthest = *std::ranges::max_element(points, {}, [&](const Vector2d &p) {
        return (p - middle).norm();
    }) - middle;
    std::vector<Order> orders;
    for (const Vector2d &onto : points) {
        // About the line through the middle that maps the farthest point onto this one.
        const double twice =
            std::atan2(farthest.y(), farthest.x()) + std::atan2(onto.y() - middle.y(), onto.x() - middle.x());
        Eigen::Matrix2d mirror;
        mirror << std::cos(twice), std::sin(twice), std::sin(twice), -std::cos(twice);
        Order order;
        for (const Vector2d &point : points) {
            const Vector2d mirrored = middle + mirror * (point - middle);
            const auto nearest = std::ranges::min_element(
                points, {}, [&](const Vector2d &p) { return (p - mirrored).norm(); });
            if ((*nearest - mirrored).norm() < reachM)
                order.push_back(static_cast<std::size_t>(nearest - points.begin()));
        }
        if (std::set<std::size_t>(order.begin(), order.end()).size() == points.size())
            orders.push_back(std::move(order));
    }
    return orders;
}

/// All orders of four labels; of more their reversed order, and those that mirror the layout onto itself.
std::vector<Order> ordersOf(std::span<const PointPair> pairs)
{
    Order order(pairs.size());
    std::iota(order.begin(), order.end(), 0);
    std::vector<Order> orders;
    if (pairs.size() == 4) {
        while (std::ranges::next_permutation(order).found)
            orders.push_back(order);
        return orders;
    }
    orders = mirrorOrdersOf(pairs);
    for (std::size_t i = 1; i < pairs.size(); ++i) {
        std::ranges::rotate(order, order.begin() + 1);
        orders.push_back(order);
    }
    std::ranges::sort(order, std::greater());
    orders.push_back(order);
    return orders;
}

class CauseSearch
{
public:
    CauseSearch(const TriedMarkers &tried, std::optional<double> fitPx) : m_tried(tried), m_fitPx(fitPx) {}

    /// Each test in turn: the one list of all that is tested.
    std::vector<Cause> find()
    {
        if (!m_tried.context.isSeenInImage) {
            tryFromBelow();
            tryColumnsSwapped();
            tryQuarterTurns();
        }
        tryMirroredImage();
        tryMirroredLayout();
        tryOrders();
        tryOtherCameras();
        if (!m_fitPx) {
            tryOtherSizes();
            tryWithoutOne();
            tryOtherZoom();
        }
        return std::move(m_causes);
    }

private:
    const Intrinsics &lens() const { return m_tried.camera.intrinsics(); }
    std::size_t count() const { return m_tried.pairs.size(); }
    /// With the focal length free, four markers fit in nearly any order and size: that would prove nothing.
    bool provesLittle() const { return m_tried.focal == FocalLength::Free && count() == 4; }

    template <class Move>
    Pairs moved(Move move) const
    {
        Pairs pairs(m_tried.pairs.begin(), m_tried.pairs.end());
        for (PointPair &pair : pairs)
            pair.target = move(pair.target);
        return pairs;
    }

    void consider(Freedom freedom, const Pairs &pairs, const Words &words)
    {
        consider(freedom, pairs, m_tried.camera, m_tried.focal, words);
    }

    void consider(Freedom freedom, const Pairs &pairs, const CameraModel &camera, FocalLength focal,
                  const Words &words)
    {
        if (std::ranges::any_of(pairs, [&](const PointPair &pair) { return !isInside(pair.target, camera); }))
            return;
        const auto pose = fitPlanePose(pairs, camera, focal);
        const double heightM = pose ? pose->worldFromCamera.translation.z() : 0;
        if (heightM < leastCauseHeightM || heightM > mostCauseHeightM)
            return;
        const bool fits = m_fitPx ? pose->rmsPx <= *m_fitPx
                                  : carefulSum(pairs, *pose) <= mostCarefulSum(pairs.size(), focal);
        if (fits)
            m_causes.push_back({freedom, pose->rmsPx, isUpright(pose->worldFromCamera),
                                words(*pose, quantity(pose->rmsPx, 1, "px"))});
    }

    void tryFromBelow()
    {
        const int height = m_tried.camera.intrinsics().heightPx;
        consider(Freedom::None, moved([&](const Vector2d &p) { return Vector2d(p.x(), height - p.y()); }),
                 [&](const PlanePose &, const MessageArgument &fit) {
                     return ODO_TEXT("calibration.v_from_below",
                                     "v = %1 - v fits to %2: is v counted from below?")(height, fit);
                 });
    }

    void tryColumnsSwapped()
    {
        consider(Freedom::None, moved([](const Vector2d &p) { return Vector2d(p.y(), p.x()); }),
                 [](const PlanePose &, const MessageArgument &fit) {
                     return ODO_TEXT("calibration.u_v_swapped",
                                     "with u and v swapped they fit to %1: are these columns swapped?")(fit);
                 });
    }

    void tryQuarterTurns()
    {
        const auto words = [](const PlanePose &, const MessageArgument &fit) {
            return ODO_TEXT("calibration.quarter_turn",
                            "turned by a quarter they fit to %1: was the image shown turned?")(fit);
        };
        consider(Freedom::None,
                 moved([&](const Vector2d &p) { return Vector2d(p.y(), lens().heightPx - 1 - p.x()); }),
                 words);
        consider(Freedom::None,
                 moved([&](const Vector2d &p) { return Vector2d(lens().widthPx - 1 - p.y(), p.x()); }),
                 words);
    }

    void tryOtherSizes()
    {
        const bool isOutside = pixelOutside(m_tried.pairs, m_tried.camera) != nullptr;
        if (m_tried.context.isSeenInImage || (provesLittle() && !isOutside))
            return;
        std::vector<Cause> others;
        std::swap(others, m_causes);
        for (const int width : widths)
            tryWidth(width);
        if (!m_causes.empty())
            others.push_back(*std::ranges::min_element(m_causes, {}, &Cause::rmsPx));
        m_causes = std::move(others);
    }

    void tryWidth(int width)
    {
        const double scale = double(width) / lens().widthPx;
        const int height = static_cast<int>(std::lround(scale * lens().heightPx));
        const double differs = std::max(scale, 1 / scale);
        const auto isBeyond = [&](const PointPair &pair) {
            return pair.target.x() > width - 0.5 || pair.target.y() > height - 0.5;
        };
        if (differs < otherSize || std::ranges::any_of(m_tried.pairs, isBeyond))
            return;
        consider(pixelOutside(m_tried.pairs, m_tried.camera) ? Freedom::None : Freedom::Choice,
                 moved([&](const Vector2d &p) -> Vector2d {
                     return (p + Vector2d(0.5, 0.5)) / scale - Vector2d(0.5, 0.5);
                 }),
                 [&](const PlanePose &, const MessageArgument &fit) {
                     return ODO_TEXT("calibration.other_picking_size",
                                     "at %1 they fit to %2: were they picked at that size?")(
                         sizeText(width, height), fit);
                 });
    }

    void tryMirroredImage()
    {
        consider(Freedom::None,
                 moved([&](const Vector2d &p) { return Vector2d(lens().widthPx - 1 - p.x(), p.y()); }),
                 [](const PlanePose &, const MessageArgument &fit) {
                     return ODO_TEXT("calibration.image_mirrored",
                                     "mirrored left to right they fit to %1: is the image mirrored?")(fit);
                 });
    }

    void tryMirroredLayout()
    {
        Pairs pairs(m_tried.pairs.begin(), m_tried.pairs.end());
        for (PointPair &pair : pairs)
            pair.source.y() *= -1;
        consider(Freedom::None, pairs, [](const PlanePose &, const MessageArgument &fit) {
            return ODO_TEXT("calibration.layout_mirrored",
                            "with a reversed Y of the layout they fit to %1: check the signs of the layout, "
                            "seen from above Y must point to the left of X")(fit);
        });
    }

    void tryOrders()
    {
        for (const Order &order : exchangesOf(count()))
            tryOrder(Freedom::None, order);
        if (!provesLittle()) {
            for (const Order &order : ordersOf(m_tried.pairs)) {
                if (movedBy(order).size() > 2)
                    tryOrder(Freedom::Order, order);
            }
        }
    }

    /// Marker i is given the pixel of marker order[i].
    void tryOrder(Freedom freedom, const Order &order)
    {
        Pairs pairs(m_tried.pairs.begin(), m_tried.pairs.end());
        for (std::size_t i = 0; i < order.size(); ++i)
            pairs[i].target = m_tried.pairs[order[i]].target;
        consider(freedom, pairs, [&](const PlanePose &, const MessageArgument &fit) {
            return joined(
                {orderWords(order, fit), ODO_TEXT("calibration.check_labels", "check these labels")},
                Join::Colon);
        });
    }

    static std::vector<std::size_t> movedBy(const Order &order)
    {
        std::vector<std::size_t> moved;
        for (std::size_t i = 0; i < order.size(); ++i) {
            if (order[i] != i)
                moved.push_back(i);
        }
        return moved;
    }

    Message orderWords(const Order &order, const MessageArgument &fit) const
    {
        const auto label = [&](std::size_t i) { return m_tried.pairs[i].label; };
        const auto moved = movedBy(order);
        if (moved.size() == 2)
            return ODO_TEXT("calibration.labels_exchanged", "with %1 and %2 swapped they fit to %3")(
                Named::marker(label(moved[0])), Named::marker(label(moved[1])), fit);
        std::vector<std::string> given, meant;
        for (const std::size_t i : moved) {
            given.push_back(label(order[i]));
            meant.push_back(label(i));
        }
        const auto inOrder = [](const std::vector<std::string> &labels) {
            return listed(labels, MessageArgument::Kind::Marker, MessageArgument::Joint::Comma);
        };
        return ODO_TEXT("calibration.labels_called",
                        "with %1 renamed %2 they fit to %3")(inOrder(given), inOrder(meant), fit);
    }

    void tryOtherCameras()
    {
        for (const OtherCamera &other : m_tried.context.others) {
            if (const auto apartPx = markersApartPx(other, m_tried.pairs);
                apartPx && *apartPx <= m_fitPx.value_or(samePixels))
                m_causes.push_back(
                    {Freedom::None, *apartPx, true,
                     ODO_TEXT("calibration.seen_by_other_camera",
                              "camera '%1' sees the markers there, to %2: are the views "
                              "swapped?")(Named::camera(other.name), quantity(*apartPx, 1, "px"))});
            consider(Freedom::Choice, {m_tried.pairs.begin(), m_tried.pairs.end()}, other.camera,
                     FocalLength::Known, [&](const PlanePose &, const MessageArgument &fit) {
                         return ODO_TEXT("calibration.lens_of_other_camera",
                                         "with the lens calibration of camera '%1' they fit to %2: are the "
                                         "views swapped?")(Named::camera(other.name), fit);
                     });
        }
    }

    void tryOtherZoom()
    {
        if (m_tried.focal != FocalLength::Known)
            return;
        const Pairs pairs(m_tried.pairs.begin(), m_tried.pairs.end());
        const auto pose = fitPlanePose(pairs, m_tried.camera, FocalLength::Free),
                   known = fitPlanePose(pairs, m_tried.camera, FocalLength::Known);
        const double ratio = pose ? pose->camera.intrinsics().fxPx / lens().fxPx : 1;
        // Four markers leave a single residual, which fits by chance. Another zoom has another distortion.
        const bool isFarBetter = pose && known && pose->rmsPx < farBetter * known->rmsPx;
        if (std::max(ratio, 1 / ratio) < otherZoom || (count() == 4 && !isFarBetter))
            return;
        if (isFarBetter)
            m_fitPx = farBetter * known->rmsPx;
        consider(Freedom::FreeNumber, pairs, m_tried.camera, FocalLength::Free,
                 [&](const PlanePose &fitted, const MessageArgument &fit) {
                     return ODO_TEXT(
                         "calibration.other_zoom",
                         "with a focal length of %1 instead of %2 they fit to %3: has the zoom or "
                         "the lens changed?")(quantity(fitted.camera.intrinsics().fxPx, 0, "px"),
                                              quantity(lens().fxPx, 0, "px"), fit);
                 });
    }

    void tryWithoutOne()
    {
        for (std::size_t i = 0; count() > 5 && i < count(); ++i) {
            Pairs pairs(m_tried.pairs.begin(), m_tried.pairs.end());
            pairs.erase(pairs.begin() + static_cast<std::ptrdiff_t>(i));
            consider(Freedom::FreeNumber, pairs, [&](const PlanePose &, const MessageArgument &fit) {
                return ODO_TEXT("calibration.fits_without",
                                "without %1 the others fit to %2: check its position and its pixel")(
                    Named::marker(m_tried.pairs[i].label), fit);
            });
        }
    }

    const TriedMarkers &m_tried;
    std::optional<double> m_fitPx;
    std::vector<Cause> m_causes;
};

/// Leaves those of the best kind: as said in the header.
void keepLikeliest(std::vector<Cause> &causes)
{
    const auto isFree = [](const Cause &cause) { return cause.freedom == Freedom::FreeNumber; };
    if (!std::ranges::all_of(causes, isFree))
        std::erase_if(causes, isFree);
    if (std::ranges::any_of(causes, &Cause::isUpright))
        std::erase_if(causes, [](const Cause &cause) { return !cause.isUpright; });
    const double bestPx = std::ranges::min_element(causes, {}, &Cause::rmsPx)->rmsPx;
    std::erase_if(causes, [&](const Cause &cause) {
        return cause.rmsPx > std::max(clearlyBetterCause * bestPx, bestPx + leastCauseDifferencePx);
    });
    const Freedom least = std::ranges::min_element(causes, {}, &Cause::freedom)->freedom;
    std::erase_if(causes, [&](const Cause &cause) {
        return cause.freedom > std::max(least, least == Freedom::None ? Freedom::Order : least);
    });
    std::ranges::stable_sort(causes, {}, [](const Cause &cause) {
        return std::pair(cause.freedom, std::lround(cause.rmsPx / leastCauseDifferencePx));
    });
    if (causes.size() > mostNamed)
        causes.resize(mostNamed);
}

} // namespace

const PointPair *pixelOutside(std::span<const PointPair> pairs, const CameraModel &camera)
{
    const auto outside =
        std::ranges::find_if(pairs, [&](const PointPair &pair) { return !isInside(pair.target, camera); });
    return outside == pairs.end() ? nullptr : &*outside;
}

double carefulTapeM(double layoutM)
{
    return 0.002 + 0.0005 * layoutM;
}

double mostCarefulSum(std::size_t markers, FocalLength focal)
{
    const double freedom =
        std::max(1.0, 2 * static_cast<double>(markers) - (focal == FocalLength::Free ? 7 : 6));
    return freedom + 3 * std::sqrt(2 * freedom);
}

std::optional<double> markersApartPx(const OtherCamera &other, std::span<const PointPair> pairs)
{
    if (!other.view || pairs.empty())
        return std::nullopt;
    double squares = 0;
    for (const PointPair &pair : pairs) {
        const auto pixel = other.view->pixelFromWorld({pair.source.x(), pair.source.y(), 0});
        if (!pixel)
            return std::nullopt;
        squares += (*pixel - pair.target).squaredNorm();
    }
    const double apartPx = std::sqrt(squares / static_cast<double>(pairs.size()));
    return apartPx <= samePixels ? std::optional(apartPx) : std::nullopt;
}

Message likelyCauses(const TriedMarkers &tried, std::optional<double> fitPx)
{
    std::vector<Cause> causes = CauseSearch(tried, fitPx).find();
    if (causes.empty())
        return {};
    keepLikeliest(causes);
    std::vector<Message> words;
    for (Cause &cause : causes)
        words.push_back(std::move(cause.words));
    return joined(std::move(words), Join::Semicolon);
}

bool mayBeMirrored(const TriedMarkers &tried, const PlanePose &pose)
{
    if (tried.context.isSeenInImage || isUpright(pose.worldFromCamera))
        return false;
    const int height = tried.camera.intrinsics().heightPx;
    for (const Order &order : mirrorOrdersOf(tried.pairs)) {
        Pairs pairs(tried.pairs.begin(), tried.pairs.end());
        for (std::size_t i = 0; i < order.size(); ++i) {
            pairs[i].target = tried.pairs[order[i]].target;
            pairs[i].target.y() = height - pairs[i].target.y();
        }
        const auto other = fitPlanePose(pairs, tried.camera, tried.focal);
        if (other && other->worldFromCamera.translation.z() > 0 && isUpright(other->worldFromCamera) &&
            other->rmsPx < std::max(clearlyBetterCause * pose.rmsPx, pose.rmsPx + leastCauseDifferencePx))
            return true;
    }
    return false;
}

} // namespace odo
