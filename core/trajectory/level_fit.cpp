// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/trajectory/level_fit.h"

#include "core/trajectory/view_clock.h"

#include <ceres/ceres.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace odo {

namespace {

constexpr std::size_t mostLevelTimes = 40, leastLevelTimes = 12;
constexpr double timesThatDiffer = 8; // as independentTimes of a box: more ways are seen, for more of the form is asked for
constexpr double centroidSigmaPx = 0.5;
constexpr double beyondCamera = 1e3;
constexpr double likelyScale = 0.5;       // σ of a level's size against the box's, of the logarithm
constexpr double likelyShift = 0.15;      // σ of a level's middle along the heading against the box's, in lengths of the box
constexpr double likelyLean = 0.02;       // and across it: most robots are as wide to the left as to the right
constexpr double likelyDrawnPx = 0.3;
constexpr double toldSigmaM = 0.001;

using LevelPose = std::array<double, 3>; // x, y, heading

/// Of each level the middle (forward, left) and the logarithms of half its length and width; then the logarithm of the top, the lower levels' heights as
/// shares of those above them, and the roundness; and by how many pixels all outlines are drawn too wide, and too far down, as shadows at the foot do.
constexpr int perLevel = 4, levelCount = 3;
enum : int { TopLog = perLevel * levelCount, MiddleShare, LowerShare, Roundness, DrawnWider, DrawnLower, FormSize };
using LevelForm = std::array<double, FormSize>;

SolidShape shapeOfForm(const double *form)
{
    SolidShape shape;
    shape.form = SolidShape::Form::Levels;
    const double top = std::exp(form[TopLog]);
    const double middle = top * std::clamp(form[MiddleShare], 0.0, 1.0);
    const std::array<double, levelCount> heights{middle * std::clamp(form[LowerShare], 0.0, 1.0), middle, top};
    double front = -HUGE_VAL, back = -HUGE_VAL, left = -HUGE_VAL, right = -HUGE_VAL;
    for (int i = 0; i < levelCount; ++i) {
        const double *level = form + perLevel * i;
        const double halfLength = std::exp(level[2]), halfWidth = std::exp(level[3]);
        shape.levels[std::size_t(i)] = {heights[std::size_t(i)], level[0] + halfLength, halfLength - level[0], level[1] + halfWidth, halfWidth - level[1]};
        front = std::max(front, level[0] + halfLength);
        back = std::max(back, halfLength - level[0]);
        left = std::max(left, level[1] + halfWidth);
        right = std::max(right, halfWidth - level[1]);
    }
    // The place is the middle of all of it.
    for (SolidLevel &level : shape.levels) {
        level.frontM -= (front - back) / 2;
        level.backM += (front - back) / 2;
        level.leftM -= (left - right) / 2;
        level.rightM += (left - right) / 2;
    }
    shape.lengthM = front + back;
    shape.widthM = left + right;
    shape.baseM = heights.front();
    shape.topM = top;
    shape.roundShare = std::clamp(form[Roundness], 0.0, 1.0);
    return shape;
}

/// As of a box (shape_estimation): centroid, area and second moments.
struct LevelResidual
{
    const CommonOutlines::Outline &outline;

    bool operator()(const double *pose, const double *form, double *residual) const
    {
        const auto model = silhouetteMoments(*outline.view, shapeOfForm(form), {pose[0], pose[1]}, pose[2]);
        if (!model || model->areaPx2 < 1) {
            std::fill_n(residual, 6, beyondCamera);
            return true;
        }
        RegionMoments seen = outline.moments;
        const OutlineSigma sigma = sigmaOfOutline(seen);
        const double wider = 1 + form[DrawnWider] / std::sqrt(seen.areaPx2 / std::numbers::pi);
        seen.areaPx2 /= wider * wider;
        seen.covariancePx2 /= wider * wider;
        seen.centrePx.y() -= form[DrawnLower];
        Eigen::Map<OutlineDifferences> differences(residual);
        differences = outlineDifferences(seen, *model, sigma, centroidSigmaPx);
        return true;
    }
};

/// Keeps what nothing determines near the box, and what was told.
struct LevelPrior
{
    LevelForm expected;
    SolidShape box;
    RobotShape told;
    static constexpr int size = FormSize + 3;

    bool operator()(const double *form, double *residual) const
    {
        for (int i = 0; i < FormSize; ++i)
            residual[i] = (form[i] - expected[std::size_t(i)]) / likelyScale;
        for (int level = 0; level < levelCount; ++level) {
            residual[perLevel * level] = form[perLevel * level] / (likelyShift * box.lengthM);
            residual[perLevel * level + 1] = form[perLevel * level + 1] / (likelyLean * box.lengthM);
        }
        for (const int drawn : {int(DrawnWider), int(DrawnLower)})
            residual[drawn] = form[drawn] / likelyDrawnPx;
        const SolidShape shape = shapeOfForm(form);
        residual[FormSize] = told.lengthM ? (shape.lengthM - *told.lengthM) / toldSigmaM : 0;
        residual[FormSize + 1] = told.widthM ? (shape.widthM - *told.widthM) / toldSigmaM : 0;
        residual[FormSize + 2] = told.heightM ? (shape.topM - *told.heightM) / toldSigmaM : 0;
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
std::optional<double> directionAt(const std::vector<ViewTrack> &views, const std::vector<std::vector<BodyAxis>> &axes, Nanoseconds time)
{
    constexpr double farthestS = 0.1;
    std::optional<double> direction;
    double nearestS = farthestS;
    for (std::size_t v = 0; v < views.size(); ++v) {
        const auto &observations = views[v].observations;
        const auto after = std::lower_bound(observations.begin(), observations.end(), time, [&](const Observation &observation, Nanoseconds t) {
            return timeOf(views[v], observation) < t;
        });
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
    LevelProblem(const std::vector<CommonOutlines> &times, const std::vector<ViewTrack> &views, const std::vector<std::vector<BodyAxis>> &axes,
                 const SolidShape &box);
    bool isEnough() const { return m_times.size() >= leastLevelTimes; }
    bool solve(const SolidShape &box, const RobotShape &told, const LevelStart &start);
    std::optional<LevelFit> result();

private:
    double share() const { return std::min(1.0, timesThatDiffer / double(m_times.size())); }
    void addResiduals(const LevelPrior &prior);
    void findMisfit(LevelFit &fit);
    bool findDoubt(LevelFit &fit);
    void findCommonDoubt(LevelFit &fit);

    std::vector<CommonOutlines> m_times;
    std::vector<LevelPose> m_poses; ///< at the times
    LevelForm m_form{};
    ceres::Problem m_problem;
    std::vector<ceres::ResidualBlockId> m_blocks; ///< of the outlines
};

LevelProblem::LevelProblem(const std::vector<CommonOutlines> &times, const std::vector<ViewTrack> &views,
                           const std::vector<std::vector<BodyAxis>> &axes, const SolidShape &box)
{
    for (const CommonOutlines &common : times) {
        const auto direction = directionAt(views, axes, common.time);
        const CommonOutlines::Outline &first = common.outlines.front();
        const auto place = first.view->floorFromPixel(first.moments.centrePx, middleHeightM(box));
        if (!direction || !place)
            continue;
        m_poses.push_back({place->x(), place->y(), *direction});
        m_times.push_back(common);
    }
}

void LevelProblem::addResiduals(const LevelPrior &prior)
{
    for (std::size_t t = 0; t < m_times.size(); ++t) {
        for (const CommonOutlines::Outline &outline : m_times[t].outlines) {
            auto *cost = new ceres::NumericDiffCostFunction<LevelResidual, ceres::CENTRAL, 6, 3, FormSize>(new LevelResidual{outline});
            auto *loss = new ceres::ScaledLoss(new ceres::CauchyLoss(5), share(), ceres::TAKE_OWNERSHIP);
            m_blocks.push_back(m_problem.AddResidualBlock(cost, loss, m_poses[t].data(), m_form.data()));
        }
    }
    auto *cost = new ceres::NumericDiffCostFunction<LevelPrior, ceres::CENTRAL, LevelPrior::size, FormSize>(new LevelPrior(prior));
    m_problem.AddResidualBlock(cost, nullptr, m_form.data());
    for (const int bounded : {int(MiddleShare), int(LowerShare), int(Roundness)}) {
        m_problem.SetParameterLowerBound(m_form.data(), bounded, 0);
        m_problem.SetParameterUpperBound(m_form.data(), bounded, 1);
    }
}

bool LevelProblem::solve(const SolidShape &box, const RobotShape &told, const LevelStart &start)
{
    constexpr LevelStart usual{0.1, 0};
    m_form = formOf(box, start);
    addResiduals({formOf(box, usual), box, told});
    ceres::Solver::Options options;
    options.linear_solver_type = ceres::DENSE_SCHUR;
    options.max_num_iterations = 100;
    options.use_nonmonotonic_steps = true;
    options.function_tolerance = 1e-5;
    options.logging_type = ceres::SILENT;
    ceres::Solver::Summary summary;
    ceres::Solve(options, &m_problem, &summary);
    return summary.IsSolutionUsable();
}

void LevelProblem::findMisfit(LevelFit &fit)
{
    constexpr double mostOff = 50; // squared, of one outline: it shows something else
    double cost = 0;
    std::vector<double> residuals;
    ceres::Problem::EvaluateOptions evaluated;
    evaluated.residual_blocks = m_blocks;
    m_problem.Evaluate(evaluated, &cost, nullptr, nullptr, nullptr);
    const double freedom = 6.0 * double(m_blocks.size()) - 3.0 * double(m_times.size()) - double(FormSize);
    fit.misfit = std::sqrt(2 * cost / share() / std::max(1.0, freedom));
    evaluated.apply_loss_function = false;
    m_problem.Evaluate(evaluated, &cost, &residuals, nullptr, nullptr);
    double squares = 0;
    for (std::size_t i = 0; i < residuals.size(); i += 6)
        squares += std::min(residuals[i] * residuals[i] + residuals[i + 1] * residuals[i + 1], mostOff);
    fit.lastingPx = centroidSigmaPx * std::sqrt(squares / (2.0 * double(m_blocks.size())));
}

bool LevelProblem::findDoubt(LevelFit &fit)
{
    ceres::Covariance covariance({});
    std::array<double, FormSize * FormSize> block{};
    const std::vector<std::pair<const double *, const double *>> wanted{{m_form.data(), m_form.data()}};
    if (!covariance.Compute(wanted, &m_problem) || !covariance.GetCovarianceBlock(m_form.data(), m_form.data(), block.data()))
        return false;
    const double sigmaTopLog = std::sqrt(std::max(0.0, block[TopLog * FormSize + TopLog]));
    fit.sigmaTopM = fit.shape.topM * sigmaTopLog * std::max(1.0, fit.misfit);
    findCommonDoubt(fit);
    return true;
}

/// What all places share of their doubt, along and across the heading: the mean covariance of the places at different times, each along its own heading.
void LevelProblem::findCommonDoubt(LevelFit &fit)
{
    constexpr std::size_t asked = 6;
    std::vector<const double *> some;
    for (std::size_t i = 0; i < asked; ++i)
        some.push_back(m_poses[i * (m_poses.size() - 1) / (asked - 1)].data());
    std::vector<std::pair<const double *, const double *>> pairs;
    for (std::size_t i = 0; i < some.size(); ++i)
        for (std::size_t j = i + 1; j < some.size(); ++j)
            pairs.emplace_back(some[i], some[j]);
    ceres::Covariance covariance({});
    if (!covariance.Compute(pairs, &m_problem))
        return;
    double forward = 0, left = 0;
    for (const auto &[a, b] : pairs) {
        Eigen::Matrix<double, 3, 3, Eigen::RowMajor> block;
        if (!covariance.GetCovarianceBlock(a, b, block.data()))
            return;
        const Eigen::Vector2d alongA(std::cos(a[2]), std::sin(a[2])), alongB(std::cos(b[2]), std::sin(b[2]));
        const Eigen::Matrix2d places = block.topLeftCorner<2, 2>();
        forward += alongA.dot(places * alongB);
        left += Eigen::Vector2d(-alongA.y(), alongA.x()).dot(places * Eigen::Vector2d(-alongB.y(), alongB.x()));
    }
    const double scale = std::max(1.0, fit.misfit);
    fit.sigmaForwardM = scale * std::sqrt(std::max(0.0, forward / double(pairs.size())));
    fit.sigmaLeftM = scale * std::sqrt(std::max(0.0, left / double(pairs.size())));
}

std::optional<LevelFit> LevelProblem::result()
{
    LevelFit fit;
    fit.shape = shapeOfForm(m_form.data());
    for (std::size_t t = 0; t < m_times.size(); ++t)
        fit.poses.push_back({m_times[t].time, {m_poses[t][0], m_poses[t][1]}, m_poses[t][2]});
    findMisfit(fit);
    return findDoubt(fit) ? std::optional(std::move(fit)) : std::nullopt;
}

} // namespace

std::vector<CommonOutlines> levelTimes(const std::vector<ViewTrack> &views)
{
    return commonOutlines(views, mostLevelTimes);
}

std::optional<LevelFit> fitLevels(const std::vector<CommonOutlines> &times, const std::vector<ViewTrack> &views, const std::vector<std::vector<BodyAxis>> &axes, const SolidShape &box,
                                  const RobotShape &told, const LevelStart &start)
{
    LevelProblem problem(times, views, axes, box);
    return problem.isEnough() && problem.solve(box, told, start) ? problem.result() : std::nullopt;
}

} // namespace odo
