// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/map/floor_image.h"

#include "core/base/shortage.h"
#include "core/video/image.h"
#include "core/video/video_reader.h"
#include "core/workflow/job.h"
#include "core/workflow/trial_sources.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace odo {

namespace {

constexpr int leastSide = 120, longestSide = 900;
/// Pixels of the plan from one computed node to the next; between them pixel positions are linear enough.
constexpr int nodeStep = 6;
constexpr std::size_t framesForMedian = 5;

/// Where a node of the plan lies in a view, and how well it is seen there.
struct Node
{
    float x = 0, y = 0, weight = 0; ///< weight 0: behind the camera; may be outside the image
};

struct Plan
{
    Eigen::AlignedBox2d extent;
    int width = 0, height = 0;
    double metresPerPixel = 0;

    Eigen::Vector2d world(double column, double row) const
    {
        return {extent.min().x() + (column + 0.5) * metresPerPixel,
                extent.max().y() - (row + 0.5) * metresPerPixel};
    }
    int nodeColumns() const { return width / nodeStep + 2; }
    int nodeRows() const { return height / nodeStep + 2; }
};

/// Image area that a square metre of the floor covers, faded out towards the image's edge.
float viewWeight(const FloorView &view, const Eigen::Vector2d &point, const Eigen::Vector2d &pixel)
{
    constexpr double aside = 0.01;
    const auto alongX = view.pixelFromWorld({point.x() + aside, point.y(), 0});
    const auto alongY = view.pixelFromWorld({point.x(), point.y() + aside, 0});
    if (!alongX || !alongY)
        return 0;
    const Eigen::Vector2d dx = *alongX - pixel, dy = *alongY - pixel;
    const double area = std::abs(dx.x() * dy.y() - dx.y() * dy.x()) / (aside * aside);
    const Intrinsics &image = view.camera().intrinsics();
    constexpr double fadePx = 40;
    const double edge =
        std::min({pixel.x(), pixel.y(), image.widthPx - 1 - pixel.x(), image.heightPx - 1 - pixel.y()});
    const double fade = std::clamp(edge / fadePx, 0.02, 1.0);
    return static_cast<float>(area * area * fade); // squared: mostly the better one, yet without a seam
}

std::vector<Node> nodesOf(const FloorView &view, const Plan &plan)
{
    std::vector<Node> nodes(static_cast<std::size_t>(plan.nodeColumns()) * plan.nodeRows());
    for (int row = 0; row < plan.nodeRows(); ++row) {
        for (int column = 0; column < plan.nodeColumns(); ++column) {
            const Eigen::Vector2d point = plan.world(column * nodeStep, row * nodeStep);
            const auto pixel = view.pixelFromWorld({point.x(), point.y(), 0});
            if (!pixel)
                continue;
            Node &node = nodes[static_cast<std::size_t>(row) * plan.nodeColumns() + column];
            node = {float(pixel->x()), float(pixel->y()), viewWeight(view, point, *pixel)};
        }
    }
    return nodes;
}

/// A few images spread over a recording, at full size; fewer where frames are damaged.
std::vector<ScreenImage> spreadFrames(const SceneView &view, const CancelToken &cancel)
{
    std::vector<ScreenImage> images;
    auto reader = VideoReader::open(view.file, cancel, knownRecording(view.recording));
    if (!reader)
        return images;
    const auto count = static_cast<std::int64_t>((*reader)->info().frameTimes.size());
    const std::int64_t wanted = std::min<std::int64_t>(framesForMedian, count);
    const std::int64_t apart = wanted < 2 ? 0 : (count - 1) / (wanted - 1);
    for (std::int64_t i = 0; i < wanted && !cancel.isCancelled(); ++i) {
        // A key frame near by serves as well, and the frames before it need not be decoded.
        const std::int64_t frameNumber = wanted == 1 ? 0 : i * (count - 1) / (wanted - 1);
        const std::int64_t key = (*reader)->keyFrameBefore(frameNumber);
        const auto frame = (*reader)->frameAt(frameNumber - key < (apart + 1) / 2 ? key : frameNumber);
        if (frame)
            images.push_back(toScreen(*frame, frame->format.width, frame->format.height));
    }
    return images;
}

/// Median over the images, channel by channel, of the nearest pixel.
std::array<int, 3> medianColour(const std::vector<ScreenImage> &images, int x, int y)
{
    std::array<int, 3> result{};
    std::array<int, framesForMedian> values{};
    const auto middle = static_cast<std::ptrdiff_t>(images.size() / 2);
    for (int channel = 0; channel < 3; ++channel) {
        for (std::size_t i = 0; i < images.size(); ++i) {
            const auto pixel = images[i].pixels[static_cast<std::size_t>(y) * images[i].width + x];
            values[i] = int(pixel >> (16 - 8 * channel)) & 0xff;
        }
        std::nth_element(values.begin(), values.begin() + middle,
                         values.begin() + std::ptrdiff_t(images.size()));
        result[static_cast<std::size_t>(channel)] = values[static_cast<std::size_t>(middle)];
    }
    return result;
}

Node interpolated(const std::vector<Node> &nodes, const Plan &plan, int column, int row)
{
    const float fx = float(column % nodeStep) / nodeStep, fy = float(row % nodeStep) / nodeStep;
    const Node *top =
        &nodes[static_cast<std::size_t>(row / nodeStep) * plan.nodeColumns() + column / nodeStep];
    const Node *bottom = top + plan.nodeColumns();
    if (top[0].weight <= 0 || top[1].weight <= 0 || bottom[0].weight <= 0 || bottom[1].weight <= 0)
        return {};
    const auto mix = [fx, fy](float a, float b, float c, float d) {
        return (a * (1 - fx) + b * fx) * (1 - fy) + (c * (1 - fx) + d * fx) * fy;
    };
    return {mix(top[0].x, top[1].x, bottom[0].x, bottom[1].x),
            mix(top[0].y, top[1].y, bottom[0].y, bottom[1].y),
            mix(top[0].weight, top[1].weight, bottom[0].weight, bottom[1].weight)};
}

/// Sums of weighted colours, for all views.
struct Accumulator
{
    explicit Accumulator(const Plan &plan) : sums(static_cast<std::size_t>(plan.width) * plan.height * 4) {}
    std::vector<float> sums; ///< red, green, blue, weight
};

void addView(const SceneView &view, const Plan &plan, const CancelToken &cancel, Accumulator &accumulator)
{
    const std::vector<ScreenImage> images = spreadFrames(view, cancel);
    if (images.empty())
        return;
    const std::vector<Node> nodes = nodesOf(*view.floorView, plan);
    const int width = images.front().width, height = images.front().height;
    for (int row = 0; row < plan.height && !cancel.isCancelled(); ++row) {
        float *sum = &accumulator.sums[static_cast<std::size_t>(row) * plan.width * 4];
        for (int column = 0; column < plan.width; ++column, sum += 4) {
            const Node node = interpolated(nodes, plan, column, row);
            const int x = int(std::lround(node.x)), y = int(std::lround(node.y));
            if (node.weight <= 0 || x < 0 || y < 0 || x >= width || y >= height)
                continue;
            const auto colour = medianColour(images, x, y);
            for (std::size_t channel = 0; channel < 3; ++channel)
                sum[channel] += node.weight * float(colour[channel]);
            sum[3] += node.weight;
        }
    }
}

QImage toImage(const Accumulator &accumulator, const Plan &plan)
{
    QImage image(plan.width, plan.height, QImage::Format_ARGB32_Premultiplied);
    const float *sum = accumulator.sums.data();
    for (int row = 0; row < plan.height; ++row) {
        auto *line = reinterpret_cast<QRgb *>(image.scanLine(row));
        for (int column = 0; column < plan.width; ++column, sum += 4) {
            const auto channel = [sum](int i) { return int(std::lround(sum[i] / sum[3])); };
            line[column] = sum[3] > 0 ? qRgba(channel(0), channel(1), channel(2), 255) : 0;
        }
    }
    return image;
}

} // namespace

Eigen::AlignedBox2d floorExtent(const Eigen::AlignedBox2d &bounds)
{
    const Eigen::Vector2d beyond = Eigen::Vector2d::Constant(0.2 * bounds.sizes().maxCoeff());
    return {bounds.min() - beyond, bounds.max() + beyond};
}

int floorSidePx(const Eigen::AlignedBox2d &extent, double pixelsPerMetre)
{
    return static_cast<int>(std::clamp(std::ceil(extent.sizes().maxCoeff() * pixelsPerMetre),
                                       double(leastSide), double(longestSide)));
}

FloorImage makeFloorImage(const TrialScene &scene, const Eigen::AlignedBox2d &extent, int longestSidePx,
                          const CancelToken &cancel)
{
    Plan plan;
    plan.extent = extent;
    plan.metresPerPixel = extent.sizes().maxCoeff() / longestSidePx;
    plan.width = std::max(1, int(std::lround(extent.sizes().x() / plan.metresPerPixel)));
    plan.height = std::max(1, int(std::lround(extent.sizes().y() / plan.metresPerPixel)));
    Accumulator accumulator(plan);
    for (const SceneView &view : scene.views) {
        if (view.floorView)
            addView(view, plan, cancel, accumulator);
    }
    const bool anything =
        std::any_of(accumulator.sums.begin(), accumulator.sums.end(), [](float sum) { return sum > 0; });
    if (cancel.isCancelled() || !anything)
        return {{}, extent};
    return {toImage(accumulator, plan), extent};
}

FloorImageMaker::FloorImageMaker(QObject *parent) : QObject(parent) {}
FloorImageMaker::~FloorImageMaker()
{
    m_cancel.cancel();
    if (m_thread.joinable())
        m_thread.join();
}

void FloorImageMaker::make(TrialScenePtr scene, const Eigen::AlignedBox2d &bounds, double pixelsPerMetre)
{
    m_scene = std::move(scene);
    m_extent = floorExtent(bounds);
    m_sidePx = floorSidePx(m_extent, pixelsPerMetre);
    restart();
}

void FloorImageMaker::setScale(double pixelsPerMetre)
{
    constexpr double coarserAllowed = 1.4;
    const int side = floorSidePx(m_extent, pixelsPerMetre);
    if (!m_scene || side <= coarserAllowed * m_sidePx)
        return;
    m_sidePx = side;
    restart();
}

void FloorImageMaker::restart()
{
    m_cancel.cancel();
    m_running = m_isWanted = m_scene != nullptr;
    // else when it has ended: a decoder takes a while to, and the window must not wait
    if (!m_thread.joinable())
        begin();
}

void FloorImageMaker::begin()
{
    if (!std::exchange(m_isWanted, false))
        return;
    m_cancel = CancelToken();
    const auto finishLater = [this, cancel = m_cancel](const FloorImage &image) {
        callLater(this, [this, image, cancel] { finish(image, cancel.isCancelled()); });
    };
    auto thread = startThread(
        {}, [scene = m_scene, extent = m_extent, side = m_sidePx, cancel = m_cancel, finishLater] {
            const auto made = orShortage(Message(), [&]() -> Result<FloorImage> {
                return makeFloorImage(*scene, extent, side, cancel);
            });
            finishLater(made.value_or(FloorImage())); // the map is of use without it
        });
    if (thread)
        m_thread = std::move(*thread);
    else
        finishLater({});
}

void FloorImageMaker::finish(const FloorImage &image, bool givenUp)
{
    if (m_thread.joinable())
        m_thread.join(); // it had nothing left to do
    if (givenUp) {
        begin();
        return;
    }
    m_running = false;
    Q_EMIT ready(image);
}

} // namespace odo
