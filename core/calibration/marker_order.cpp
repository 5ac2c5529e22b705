// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/marker_order.h"

#include "core/base/units.h"

#include <algorithm>
#include <numeric>
#include <optional>
#include <vector>

namespace odo {

namespace {

using Order = std::vector<std::size_t>;

/// RMS in pixels when marker i is given the pixel of marker order[i].
std::optional<double> misfit(std::span<const PointPair> pairs, const Order &order, const CameraModel &camera,
                             FocalLength focal)
{
    std::vector<PointPair> ordered(pairs.begin(), pairs.end());
    for (std::size_t i = 0; i < order.size(); ++i)
        ordered[i].target = pairs[order[i]].target;
    const auto pose = fitPlanePose(ordered, camera, focal);
    if (!pose || pose->worldFromCamera.translation.z() <= 0)
        return std::nullopt;
    return pose->rmsPx;
}

std::vector<Order> exchanges(std::size_t count)
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

std::string describe(std::span<const PointPair> pairs, const Order &order, double rmsPx)
{
    std::vector<std::size_t> moved;
    for (std::size_t i = 0; i < order.size(); ++i) {
        if (order[i] != i)
            moved.push_back(i);
    }
    const std::string fit = formatNumber(rmsPx, 1);
    if (moved.size() == 2)
        return "with " + pairs[moved[0]].label + " and " + pairs[moved[1]].label + " exchanged they fit to " +
               fit + " px";
    std::string told, meant;
    for (std::size_t i : moved) {
        told += (told.empty() ? "" : ", ") + pairs[order[i]].label;
        meant += (meant.empty() ? "" : ", ") + pairs[i].label;
    }
    return "with " + told + " called " + meant + " they fit to " + fit + " px";
}

} // namespace

std::string betterOrder(std::span<const PointPair> pairs, const CameraModel &camera, FocalLength focal,
                        double fitPx)
{
    std::string words;
    const auto consider = [&](const Order &order) {
        if (const auto rmsPx = misfit(pairs, order, camera, focal); rmsPx && *rmsPx <= fitPx)
            words += (words.empty() ? "" : "; ") + describe(pairs, order, *rmsPx);
    };
    for (const Order &order : exchanges(pairs.size()))
        consider(order);
    if (words.empty() && pairs.size() == 4) {
        Order order{0, 1, 2, 3};
        while (words.empty() && std::ranges::next_permutation(order).found)
            consider(order);
    }
    return words;
}

} // namespace odo
