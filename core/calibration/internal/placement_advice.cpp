// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/placement_advice.h"

#include "core/calibration/internal/planned_registration.h"
#include "core/calibration/internal/wording.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace odo {

namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double triedM = 0.1;    // of the positions that are tried
constexpr double leastGain = 0.1; // of σ where it is largest
constexpr double mostOfIt = 0.9;  // of the gain that a nearer position may bring instead
constexpr double lowestM = 0.3;   // of a camera
constexpr int judgedAcross = 12;  // positions of the floor at which σ is judged

/// A position that was tried.
struct Tried
{
    Eigen::Vector3i steps; ///< left, back, up
    double worstM = 0;
    double distance() const { return steps.cast<double>().norm(); }
};

class Adviser
{
public:
    Adviser(const MarkerLayout &layout, const PlacementQuestion &question)
        : m_layout(layout), m_question(question), m_grid(gridOver(layout, 0, judgedAcross))
    {
        for (const Marker &marker : layout.markers)
            m_floor.extend(marker.pointInWorld);
    }

    /// Where the cameras are.
    void setViews(std::vector<FloorView> views) { m_views = std::move(views); }
    AccuracySummary summary(const FloorScore &score) const
    {
        return summariseAccuracy(m_grid, score.sigmaM, m_layout);
    }
    FloorScore score() const
    {
        const double ofTime = m_views.size() < 2 ? 0 : m_question.speedMps * m_question.timeSigmaS / 2;
        return floorScore(m_views, m_grid, m_question.sigmaPx, m_question.robotHeightM, ofTime);
    }
    /// The best move of one of them; nullopt where none gains enough.
    std::optional<PlacementMove> bestMove(const AdvisedCamera &camera, std::size_t index,
                                          const FloorScore &now);

private:
    std::optional<FloorView> viewFrom(const AdvisedCamera &camera, const Eigen::Vector3i &steps) const;
    std::vector<Tried> tryAll(const AdvisedCamera &camera, std::size_t index, const FloorScore &now);

    const MarkerLayout &m_layout;
    const PlacementQuestion &m_question;
    FloorGrid m_grid;
    Eigen::AlignedBox2d m_floor;
    std::vector<FloorView> m_views;
};

/// The camera elsewhere; nullopt where it could not be registered, or would be among the robots.
std::optional<FloorView> Adviser::viewFrom(const AdvisedCamera &camera, const Eigen::Vector3i &steps) const
{
    const Vector3d position = camera.view.cameraInWorld();
    const Vector2d foot = position.head<2>(), middle = m_floor.center();
    Vector2d back = (foot - middle).normalized();
    if ((foot - middle).norm() < triedM) // it looks straight down: back is down in its image
        back = camera.view.worldFromCamera().rotation.toRotationMatrix().col(1).head<2>().normalized();
    const Vector2d right(-back.y(), back.x());
    const Vector2d there = foot + triedM * (-steps.x() * right + steps.y() * back);
    const double height = position.z() + triedM * steps.z();
    if (height < lowestM || (m_floor.contains(there) && !m_floor.contains(foot)))
        return std::nullopt;
    const Vector2d away = there - middle;
    const Vector2d across = away.norm() > 0 ? Vector2d(-away.y(), away.x()).normalized() : right;
    const FloorView exact(camera.view.camera(), lookingAt({there.x(), there.y(), height}, middle, across),
                          Eigen::Matrix<double, 6, 6>::Zero());
    auto view = registeredByMarkers(exact, m_layout, camera.markerSigmaPx);
    return view ? std::optional(std::move(*view)) : std::nullopt;
}

std::vector<Tried> Adviser::tryAll(const AdvisedCamera &camera, std::size_t index, const FloorScore &now)
{
    std::vector<Tried> tried;
    const FloorView here = m_views[index];
    const auto tryOne = [&](const Eigen::Vector3i &steps) {
        const auto known = std::ranges::find(tried, steps, &Tried::steps);
        auto view = known == tried.end() ? viewFrom(camera, steps) : std::nullopt;
        if (!view)
            return;
        m_views[index] = std::move(*view);
        const FloorScore score = this->score();
        if (score.unseen <= now.unseen)
            tried.push_back({steps, score.worstM});
    };
    const int reach = int(std::floor(m_question.reachM / triedM + 1e-9)), coarse = std::max(1, reach / 4);
    for (int up = -reach / 2; up <= reach / 2; up += coarse)
        for (int back = -reach; back <= reach; back += coarse)
            for (int left = -reach; left <= reach; left += coarse)
                if (left * left + back * back <= reach * reach)
                    tryOne({left, back, up});
    if (!tried.empty()) { // the nearer ones in the same direction
        const Eigen::Vector3i best = std::ranges::min_element(tried, {}, &Tried::worstM)->steps;
        for (const double share : {0.2, 0.4, 0.6, 0.8})
            tryOne((share * best.cast<double>()).array().round().cast<int>());
        for (int axis = 0; axis < 3; ++axis) {
            Eigen::Vector3i without = best;
            without[axis] = 0;
            for (const double share : {0.5, 0.75, 1.0})
                tryOne((share * without.cast<double>()).array().round().cast<int>());
        }
    }
    m_views[index] = here;
    return tried;
}

/// "40 cm to the left and 20 cm up".
MessageArgument wayOf(const PlacementMove &move)
{
    std::vector<Message> parts;
    const auto add = [&](double metres, const MessageText &positive, const MessageText &negative) {
        if (metres != 0)
            parts.push_back((metres > 0 ? positive : negative)(quantity(100 * std::abs(metres), 0, "cm")));
    };
    add(move.leftM, ODO_TEXT("calibration.move_left", "%1 to the left"),
        ODO_TEXT("calibration.move_right", "%1 to the right"));
    add(move.backM, ODO_TEXT("calibration.move_back", "%1 away from the floor"),
        ODO_TEXT("calibration.move_closer", "%1 closer to the floor's middle"));
    add(move.upM, ODO_TEXT("calibration.move_up", "%1 up"), ODO_TEXT("calibration.move_down", "%1 down"));
    return listed(std::move(parts));
}

std::optional<PlacementMove> Adviser::bestMove(const AdvisedCamera &camera, std::size_t index,
                                               const FloorScore &now)
{
    const std::vector<Tried> tried = tryAll(camera, index, now);
    if (tried.empty())
        return std::nullopt;
    const double gain = now.worstM - std::ranges::min_element(tried, {}, &Tried::worstM)->worstM;
    if (gain < leastGain * now.worstM)
        return std::nullopt;
    const double enough = std::max(mostOfIt * gain, leastGain * now.worstM);
    const Tried *chosen = nullptr;
    for (const Tried &one : tried)
        if (now.worstM - one.worstM >= enough && (!chosen || one.distance() < chosen->distance()))
            chosen = &one;
    const FloorView here = m_views[index];
    PlacementMove move{index,
                       triedM * chosen->steps.x(),
                       triedM * chosen->steps.y(),
                       triedM * chosen->steps.z(),
                       viewFrom(camera, chosen->steps).value(),
                       {},
                       {},
                       {}};
    m_views[index] = move.view;
    const AccuracySummary then = summary(score());
    m_views[index] = here;
    move.worstM = then.worstM;
    move.middleM = then.middleM;
    move.words = ODO_TEXT(
        "calibration.move_helps",
        "Moving %1 by %2, aimed at the middle of the floor, lowers the error from ±%3 to ±%4 where it is "
        "largest.")(Named::camera(camera.name), wayOf(move), millimetres(now.worstM),
                    millimetres(then.worstM));
    return move;
}

} // namespace

Result<PlacementAdvice> placementAdvice(std::span<const AdvisedCamera> cameras, const MarkerLayout &layout,
                                        const PlacementQuestion &question, const JobControl &control)
{
    const Message what = ODO_TEXT("calibration.camera_positions", "the camera positions");
    PlacementAdvice advice;
    std::vector<std::size_t> judged;
    std::vector<FloorView> views;
    for (std::size_t i = 0; i < cameras.size(); ++i) {
        const FloorView &view = cameras[i].view;
        const FloorView exact(view.camera(), view.worldFromCamera(), Eigen::Matrix<double, 6, 6>::Zero());
        auto again = registeredByMarkers(exact, layout, cameras[i].markerSigmaPx);
        if (again)
            judged.push_back(i);
        else
            advice.remarks.push_back(wholeMessage(
                ODO_TEXT("calibration.camera_not_moved", "camera '%1'")(Named::camera(cameras[i].name)),
                again.error().why));
        views.push_back(again ? std::move(*again) : view);
    }
    if (judged.empty())
        return fail(
            ErrorCode::InvalidInput, what,
            ODO_TEXT("calibration.none_sees_four_markers", "no camera sees four markers of the layout"),
            ODO_TEXT("calibration.register_by_four", "register the cameras by four markers or more"));
    Adviser adviser(layout, question);
    adviser.setViews(std::move(views));
    const FloorScore now = adviser.score();
    advice.now = adviser.summary(now);
    for (std::size_t i = 0; i < judged.size(); ++i) {
        if (control.isCancelled())
            return cancelled(what);
        control.report(double(i) / double(judged.size()),
                       ODO_TEXT("calibration.trying_positions", "trying other positions of the cameras"));
        if (auto move = adviser.bestMove(cameras[judged[i]], judged[i], now))
            advice.moves.push_back(std::move(*move));
    }
    std::ranges::sort(advice.moves, {}, &PlacementMove::worstM);
    return advice;
}

} // namespace odo
