// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/trajectory/internal/level_fit.h"

#include "core/trajectory/analyser.h"

#include <algorithm>
#include <array>
#include <ceres/ceres.h>
#include <cmath>
#include <numbers>
#include <numeric>

namespace odo {

namespace {

constexpr std::size_t mostLevelTimes = 40, leastLevelTimes = 12;
// as independentTimes of a box: more ways are seen, for more of the form is asked for
constexpr double timesThatDiffer = 8;
constexpr double likelyScale = 0.5; // σ of a level's size against the box's, of the logarithm
// σ of a level's middle along the heading against the box's, in lengths of the box
constexpr double likelyShift = 0.15;
// and across it: most robots are as wide to the left as to the right
constexpr double likelyLean = 0.005;
constexpr double likelyDrawnPx = 0.1;
constexpr double givenSigmaM = 0.001;
constexpr double leastMisfit = 0.2; // no outline is better than a tenth of a pixel
// of a heading against the motion; of how far behind the middle the wheels are that do not turn
constexpr double drivenSigmaRad = 0.035, likelyAxleM = 0.05;

using LevelPose = std::array<double, 3>; // x, y, heading

/// Of each level the middle (forward, left) and the logarithms of half its length and width; then the
/// logarithm of the top, the lower levels' heights as shares of those above them, and the roundness; and by
/// how many pixels all outlines are drawn too wide.
constexpr std::size_t perLevel = 4, levelCount = 3;
enum : std::size_t {
    TopLog = perLevel * levelCount,
    MiddleShare,
    LowerShare,
    Roundness,
    DrawnWider,
    FormSize
};
using LevelForm = std::array<double, FormSize>;

/// The levels of a form, whose position is the middle of all.
template <class T>
LevelsOf<T> levelsOf(const T *form)
{
    using std::exp, std::max;
    const T top = exp(form[TopLog]), middle = top * form[MiddleShare];
    const std::array<T, levelCount> heights{middle * form[LowerShare], middle, top};
    LevelsOf<T> levels;
    for (std::size_t i = 0; i < levelCount; ++i) {
        const T *level = form + perLevel * i;
        const T halfLength = exp(level[2]), halfWidth = exp(level[3]);
        levels[i] = {heights[i], level[0] + halfLength, halfLength - level[0], level[1] + halfWidth,
                     halfWidth - level[1]};
    }
    const auto farthest = [&levels](T LevelOf<T>::*side) {
        return max(levels[0].*side, max(levels[1].*side, levels[2].*side));
    };
    const T ahead = (farthest(&LevelOf<T>::front) - farthest(&LevelOf<T>::back)) / 2.0;
    const T aside = (farthest(&LevelOf<T>::left) - farthest(&LevelOf<T>::right)) / 2.0;
    for (LevelOf<T> &level : levels)
        level = {level.height, level.front - ahead, level.back + ahead, level.left - aside,
                 level.right + aside};
    return levels;
}

SolidShape shapeOfForm(const double *form)
{
    SolidShape shape;
    shape.form = SolidShape::Form::Levels;
    const auto levels = levelsOf(form);
    for (std::size_t i = 0; i < levelCount; ++i) {
        const LevelOf<double> &level = levels[i];
        shape.levels[i] = {level.height, level.front, level.back, level.left, level.right};
        shape.lengthM = std::max(shape.lengthM, 2 * std::max(level.front, level.back));
        shape.widthM = std::max(shape.widthM, 2 * std::max(level.left, level.right));
    }
    shape.baseM = levels.front().height;
    shape.topM = levels.back().height;
    shape.roundShare = std::clamp(form[Roundness], 0.0, 1.0);
    return shape;
}

double nothingMore(std::size_t, const Eigen::Vector3d &)
{
    return 0;
}

/// How far the outline of a solid reaches in each direction against how far it was seen to.
struct LevelResidual
{
    const CommonOutlines::Outline &outline;

    template <class T>
    bool operator()(const T *pose, const T *form, T *residual) const
    {
        std::array<T, supportDirections> reach;
        if (!reachOfLevels(*outline.view, levelsOf(form), form[Roundness], pose, reach, nothingMore))
            return false;
        reachDifferences(outline.supportPx, outline.moments.centrePx, form[DrawnWider], reach, residual);
        return true;
    }
};

/// Keeps what nothing determines near the box, and what was given.
struct LevelPrior
{
    LevelForm expected;
    SolidShape box;
    RobotShape given;
    static constexpr int size = FormSize + 3;

    template <class T>
    bool operator()(const T *form, T *residual) const
    {
        using std::max;
        for (std::size_t i = 0; i < FormSize; ++i)
            residual[i] = (form[i] - expected[i]) / likelyScale;
        for (std::size_t level = 0; level < levelCount; ++level) {
            residual[perLevel * level] = form[perLevel * level] / (likelyShift * box.lengthM);
            residual[perLevel * level + 1] = form[perLevel * level + 1] / (likelyLean * box.lengthM);
        }
        residual[DrawnWider] = form[DrawnWider] / likelyDrawnPx;
        const auto levels = levelsOf(form);
        const auto off = [&levels](const std::optional<double> &known, T LevelOf<T>::*side) {
            return known ? T((2.0 * max(levels[0].*side, max(levels[1].*side, levels[2].*side)) - *known) /
                             givenSigmaM)
                         : T(0);
        };
        residual[FormSize] = off(given.lengthM, &LevelOf<T>::front);
        residual[FormSize + 1] = off(given.widthM, &LevelOf<T>::left);
        residual[FormSize + 2] =
            given.heightM ? T((levels.back().height - *given.heightM) / givenSigmaM) : T(0);
        return true;
    }
};

/// Most robots move along their heading, but for the point between their wheels: what lies before it swings
/// out in a bend.
struct DrivenPrior
{
    BodyMotion motion;

    template <class T>
    bool operator()(const T *pose, const T *axleM, T *residual) const
    {
        using std::sin;
        const T away = pose[2] - motion.directionRad + *axleM * motion.curvature; // modulo a half turn
        *residual = limitedDifference(T(sin(2.0 * away) / (2 * drivenSigmaRad)));
        return true;
    }
};

struct AxlePrior
{
    template <class T>
    bool operator()(const T *axleM, T *residual) const
    {
        *residual = *axleM / likelyAxleM;
        return true;
    }
};

LevelForm formOf(const SolidShape &box, const LevelStart &start)
{
    LevelForm form{};
    for (std::size_t level = 0; level < levelCount; ++level) {
        const double share = 1 + start.taper * (1 - double(level));
        form[perLevel * level + 2] = std::log(share * std::max(box.lengthM, 0.01) / 2);
        form[perLevel * level + 3] = std::log(share * std::max(box.widthM, 0.01) / 2);
    }
    form[perLevel * (levelCount - 1)] = start.topShift * box.lengthM;
    form[TopLog] = std::log(std::max(box.topM, 0.01));
    form[MiddleShare] = 0.6;
    form[LowerShare] = 0.15;
    form[Roundness] = 0.1;
    return form;
}

/// The direction at a time, of the observation of any view next to it; nothing where none is known.
std::optional<double> directionAt(const std::vector<ViewTrack> &views,
                                  const std::vector<std::vector<BodyAxis>> &axes, Nanoseconds time)
{
    constexpr double farthestS = 0.1;
    std::optional<double> direction;
    double nearestS = farthestS;
    for (std::size_t v = 0; v < views.size(); ++v) {
        const auto &observations = views[v].observations;
        const auto after = std::lower_bound(
            observations.begin(), observations.end(), time,
            [&](const Observation &observation, Nanoseconds t) { return timeOf(views[v], observation) < t; });
        for (const auto each : {after, after == observations.begin() ? after : after - 1}) {
            if (each == observations.end() || axes[v].empty())
                continue;
            const BodyAxis &axis = axes[v][std::size_t(each - observations.begin())];
            const double awayS = std::abs(toSeconds(timeOf(views[v], *each) - time));
            if (axis.sigmaRad <= unknownAxisSigmaRad && awayS < nearestS) {
                nearestS = awayS;
                direction = axis.angleRad;
            }
        }
    }
    return direction;
}

/// The outlines at some times of a run, with the poses and the form that explain them.
class LevelProblem
{
public:
    LevelProblem(const std::vector<CommonOutlines> &times, const std::vector<ViewTrack> &views,
                 const std::vector<std::vector<BodyAxis>> &axes,
                 const std::vector<std::vector<Sighting>> &sightings, const SolidShape &box);
    bool isEnough() const { return m_times.size() >= leastLevelTimes; }
    bool solve(const SolidShape &box, const RobotShape &given, const LevelStart &start);
    std::optional<LevelFit> result();

private:
    double share() const { return std::min(1.0, timesThatDiffer / double(m_times.size())); }
    void addResiduals(const LevelPrior &prior);
    std::vector<double> residualsLeft();
    double misfit();
    void findMisfit(LevelFit &fit);
    static ceres::Problem::Options problemOptions()
    {
        ceres::Problem::Options options;
        options.loss_function_ownership = ceres::DO_NOT_TAKE_OWNERSHIP;
        return options;
    }
    bool findUncertainty(LevelFit &fit);

    std::vector<CommonOutlines> m_times;
    std::vector<LevelPose> m_poses; ///< at the times
    std::vector<std::optional<BodyMotion>> m_motions;
    double m_axleM = 0;
    LevelForm m_form{};
    ceres::LossFunctionWrapper m_weight{nullptr, ceres::DO_NOT_TAKE_OWNERSHIP}; ///< of the outlines
    ceres::LossFunctionWrapper m_drivenWeight{nullptr, ceres::DO_NOT_TAKE_OWNERSHIP};
    ceres::Problem m_problem{problemOptions()};
    std::vector<ceres::ResidualBlockId> m_blocks; ///< of the outlines
};

LevelProblem::LevelProblem(const std::vector<CommonOutlines> &times, const std::vector<ViewTrack> &views,
                           const std::vector<std::vector<BodyAxis>> &axes,
                           const std::vector<std::vector<Sighting>> &sightings, const SolidShape &box)
{
    for (CommonOutlines common : times) {
        std::erase_if(common.outlines, [](const CommonOutlines::Outline &outline) {
            return outline.supportPx.size() != supportDirections;
        });
        const auto direction = directionAt(views, axes, common.time);
        const auto position = common.outlines.empty()
                                  ? std::nullopt
                                  : common.outlines.front().view->floorFromPixel(
                                        common.outlines.front().moments.centrePx, middleHeightM(box));
        if (!direction || !position)
            continue;
        m_poses.push_back({position->x(), position->y(), *direction});
        m_motions.push_back(motionAt(sightings, common.time));
        m_times.push_back(std::move(common));
    }
}

void LevelProblem::addResiduals(const LevelPrior &prior)
{
    for (std::size_t t = 0; t < m_times.size(); ++t) {
        for (const CommonOutlines::Outline &outline : m_times[t].outlines) {
            auto *cost = new ceres::AutoDiffCostFunction<LevelResidual, supportDirections, 3, FormSize>(
                new LevelResidual{outline});
            m_blocks.push_back(m_problem.AddResidualBlock(cost, &m_weight, m_poses[t].data(), m_form.data()));
        }
        if (m_motions[t]) {
            auto *cost =
                new ceres::AutoDiffCostFunction<DrivenPrior, 1, 3, 1>(new DrivenPrior{*m_motions[t]});
            m_problem.AddResidualBlock(cost, &m_drivenWeight, m_poses[t].data(), &m_axleM);
        }
    }
    m_problem.AddResidualBlock(new ceres::AutoDiffCostFunction<AxlePrior, 1, 1>(new AxlePrior), nullptr,
                               &m_axleM);
    auto *cost =
        new ceres::AutoDiffCostFunction<LevelPrior, LevelPrior::size, FormSize>(new LevelPrior(prior));
    m_problem.AddResidualBlock(cost, nullptr, m_form.data());
    for (const int bounded : {int(MiddleShare), int(LowerShare), int(Roundness)}) {
        m_problem.SetParameterLowerBound(m_form.data(), bounded, 0);
        m_problem.SetParameterUpperBound(m_form.data(), bounded, 1);
    }
}

bool LevelProblem::solve(const SolidShape &box, const RobotShape &given, const LevelStart &start)
{
    constexpr LevelStart usual{0.1, 0};
    m_form = formOf(box, start);
    addResiduals({formOf(box, usual), box, given});
    ceres::Solver::Options options;
    options.linear_solver_type = ceres::DENSE_SCHUR;
    options.max_num_iterations = 100;
    options.use_nonmonotonic_steps = true;
    options.function_tolerance = 1e-5;
    options.logging_type = ceres::SILENT;
    ceres::Solver::Summary summary;
    m_drivenWeight.Reset(new ceres::ScaledLoss(nullptr, share(), ceres::TAKE_OWNERSHIP),
                         ceres::TAKE_OWNERSHIP);
    for (const bool again : {false, true}) {
        // The residual after the first time shows how exact the outlines are.
        const double sigma = again ? std::clamp(misfit(), leastMisfit, 1.0) : 1;
        m_weight.Reset(new ceres::ScaledLoss(nullptr, share() / (sigma * sigma), ceres::TAKE_OWNERSHIP),
                       ceres::TAKE_OWNERSHIP);
        ceres::Solve(options, &m_problem, &summary);
        if (!summary.IsSolutionUsable())
            return false;
    }
    return true;
}

std::vector<double> LevelProblem::residualsLeft()
{
    std::vector<double> residuals;
    ceres::Problem::EvaluateOptions evaluated;
    evaluated.residual_blocks = m_blocks;
    evaluated.apply_loss_function = false;
    m_problem.Evaluate(evaluated, nullptr, &residuals, nullptr, nullptr);
    return residuals;
}

double LevelProblem::misfit()
{
    const std::vector<double> residuals = residualsLeft();
    const double freedom = double(residuals.size()) - 3.0 * double(m_times.size()) - double(FormSize);
    return std::sqrt(std::inner_product(residuals.begin(), residuals.end(), residuals.begin(), 0.0) /
                     std::max(1.0, freedom));
}

void LevelProblem::findMisfit(LevelFit &fit)
{
    fit.misfit = misfit();
    const std::vector<double> residuals = residualsLeft();
    double squares = 0;
    for (std::size_t i = 0; i < residuals.size(); i += supportDirections) {
        Eigen::Vector2d shift = Eigen::Vector2d::Zero();
        for (std::size_t k = 0; k < supportDirections; ++k)
            shift += 2 * supportSigmaPx * residuals[i + k] * supportDirection(k) / double(supportDirections);
        squares += shift.squaredNorm();
    }
    fit.lastingPx = std::sqrt(squares / (2.0 * double(m_blocks.size())));
}

bool LevelProblem::findUncertainty(LevelFit &fit)
{
    ceres::Covariance covariance({});
    std::array<double, FormSize * FormSize> block{};
    const std::vector<std::pair<const double *, const double *>> wanted{{m_form.data(), m_form.data()}};
    if (!covariance.Compute(wanted, &m_problem) ||
        !covariance.GetCovarianceBlock(m_form.data(), m_form.data(), block.data()))
        return false;
    const double sigmaTopLog = std::sqrt(std::max(0.0, block[TopLog * FormSize + TopLog]));
    fit.sigmaTopM = fit.shape.topM * sigmaTopLog * std::max(1.0, fit.misfit);
    return true;
}

std::optional<LevelFit> LevelProblem::result()
{
    LevelFit fit;
    fit.shape = shapeOfForm(m_form.data());
    fit.widerPx = m_form[DrawnWider];
    for (std::size_t t = 0; t < m_times.size(); ++t)
        fit.poses.push_back({m_times[t].time, {m_poses[t][0], m_poses[t][1]}, m_poses[t][2]});
    findMisfit(fit);
    return findUncertainty(fit) ? std::optional(std::move(fit)) : std::nullopt;
}

} // namespace

std::vector<CommonOutlines> levelTimes(const std::vector<ViewTrack> &views)
{
    return commonOutlines(views, mostLevelTimes);
}

std::optional<LevelFit> fitLevels(const std::vector<CommonOutlines> &times,
                                  const std::vector<ViewTrack> &views,
                                  const std::vector<std::vector<BodyAxis>> &axes,
                                  const std::vector<std::vector<Sighting>> &sightings, const SolidShape &box,
                                  const RobotShape &given, const LevelStart &start)
{
    LevelProblem problem(times, views, axes, sightings, box);
    return problem.isEnough() && problem.solve(box, given, start) ? problem.result() : std::nullopt;
}

} // namespace odo
