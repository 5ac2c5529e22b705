// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/internal/marker_candidates.h"

#include "core/base/job_control.h"
#include "core/calibration/internal/luma_matrix.h"

#include <algorithm>
#include <cmath>
#include <opencv2/aruco.hpp>
#include <opencv2/imgproc.hpp>
#include <optional>

namespace odo {

namespace {

constexpr double mostCandidatePixels = 1.5e6;
constexpr int cellPx = 6;
constexpr double mostWrongOfBorder = 0.35; // as detectMarkers has it

/// One byte a cell, 1 where it is bright; nullopt where the border is not dark.
std::optional<cv::Mat> readCells(const cv::Mat &grey, const std::array<cv::Point2f, 4> &outline, int across)
{
    const int all = across + 2, side = all * cellPx;
    const auto last = static_cast<float>(side - 1);
    const std::array<cv::Point2f, 4> square{cv::Point2f(0, 0), {last, 0}, {last, last}, {0, last}};
    cv::Mat upright;
    cv::warpPerspective(grey, upright, cv::getPerspectiveTransform(outline.data(), square.data()),
                        {side, side}, cv::INTER_LINEAR, cv::BORDER_REPLICATE);
    cv::threshold(upright, upright, 0, 1, cv::THRESH_BINARY | cv::THRESH_OTSU);
    cv::Mat cells(all, all, CV_8UC1);
    int wrong = 0;
    for (int y = 0; y < all; ++y) {
        for (int x = 0; x < all; ++x) {
            // without the rim of a cell, which its neighbours blur
            const cv::Mat inside = upright({x * cellPx + 1, y * cellPx + 1, cellPx - 2, cellPx - 2});
            const bool isBright = 2 * cv::countNonZero(inside) > (cellPx - 2) * (cellPx - 2);
            cells.at<std::uint8_t>(y, x) = isBright ? 1 : 0;
            const bool isBorder = x == 0 || y == 0 || x == all - 1 || y == all - 1;
            wrong += isBorder && isBright ? 1 : 0;
        }
    }
    if (wrong > mostWrongOfBorder * across * across)
        return std::nullopt;
    return cells({1, 1, across, across}).clone();
}

} // namespace

MarkerCandidates::MarkerCandidates(const cv::Mat &grey) : m_grey(grey)
{
    endIfCancelled();
    const double scale =
        std::min(1.0, std::sqrt(mostCandidatePixels / (static_cast<double>(grey.cols) * grey.rows)));
    std::vector<std::vector<cv::Point2f>> read, others;
    std::vector<int> ids;
    cv::aruco::detectMarkers(reduced(grey, scale), cv::aruco::getPredefinedDictionary(cv::aruco::DICT_4X4_50),
                             read, ids, cv::aruco::DetectorParameters::create(), others);
    for (const auto *list : {&read, &others}) {
        for (const auto &corners : *list) {
            std::array<cv::Point2f, 4> outline;
            std::ranges::transform(corners, outline.begin(),
                                   [scale](cv::Point2f corner) { return unscaled(corner, scale); });
            m_outlines.push_back(outline);
        }
    }
}

const std::vector<cv::Mat> &MarkerCandidates::cellsOf(int across)
{
    const auto [entry, isNew] = m_cells.try_emplace(across);
    if (isNew) {
        for (const auto &outline : m_outlines) {
            if (auto cells = readCells(m_grey, outline, across))
                entry->second.push_back(std::move(*cells));
        }
    }
    return entry->second;
}

int MarkerCandidates::countIn(const cv::aruco::Dictionary &dictionary)
{
    return static_cast<int>(std::ranges::count_if(cellsOf(dictionary.markerSize), [&](const cv::Mat &cells) {
        int id = 0, rotation = 0;
        return dictionary.identify(cells, id, rotation, 1);
    }));
}

} // namespace odo
