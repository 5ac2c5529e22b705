// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/internal/lens_fit.h"

#include "core/base/quiet_ceres.h"
#include "core/calibration/internal/lens_cost.h"
#include "core/calibration/internal/plane_pose.h"
#include "core/calibration/internal/usual_lens.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <ceres/iteration_callback.h>
#include <ceres/manifold.h>
#include <ceres/normal_prior.h>
#include <ceres/problem.h>
#include <ceres/solver.h>
#include <cmath>
#include <deque>
#include <limits>

namespace odo {

namespace {

using Pose = std::array<double, 6>;

constexpr double leastLeft = 1e-3; // of what determines the lens, when an image is left out

class StopWhenCancelled : public ceres::IterationCallback
{
public:
    explicit StopWhenCancelled(const JobControl &control) : m_control(control) {}
    ceres::CallbackReturnType operator()(const ceres::IterationSummary &) override
    {
        return m_control.isCancelled() ? ceres::SOLVER_ABORT : ceres::SOLVER_CONTINUE;
    }

private:
    const JobControl &m_control;
};

Pose parametersOf(const RigidTransform &transform)
{
    const Eigen::AngleAxisd turn(transform.rotation);
    const Eigen::Vector3d rotation = turn.angle() * turn.axis();
    return {rotation.x(),
            rotation.y(),
            rotation.z(),
            transform.translation.x(),
            transform.translation.y(),
            transform.translation.z()};
}

RigidTransform transformOf(const Pose &pose)
{
    const Eigen::Vector3d rotation(pose[0], pose[1], pose[2]);
    RigidTransform transform;
    if (rotation.norm() > 0)
        transform.rotation = Eigen::AngleAxisd(rotation.norm(), rotation.normalized());
    transform.translation = {pose[3], pose[4], pose[5]};
    return transform;
}

// Of any size, for these are computed once a fit, and matrices of each lens's own size take the compiler a
// minute.
using Derivatives = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// The share of a view in the normal matrix and the gradient of what all views share, its pose eliminated
/// (Schur complement).
struct SharedPart
{
    Eigen::MatrixXd normal;
    Eigen::VectorXd gradient;
};

SharedPart withoutPose(const Derivatives &byShared, const Derivatives &byPose, const Eigen::VectorXd &errors)
{
    const Eigen::MatrixXd posePose = byPose.transpose() * byPose;
    const Eigen::MatrixXd sharedPose = byShared.transpose() * byPose * posePose.inverse();
    return {byShared.transpose() * byShared - sharedPose * byPose.transpose() * byShared,
            byShared.transpose() * errors - sharedPose * (byPose.transpose() * errors)};
}

/// Inverse of a normal matrix; what is not determined gets an enormous variance instead of a wrong small one.
Eigen::MatrixXd inverse(const Eigen::MatrixXd &normal)
{
    const Eigen::VectorXd scale = normal.diagonal().cwiseMax(1e-300).cwiseSqrt().cwiseInverse();
    const Eigen::MatrixXd scaled = scale.asDiagonal() * normal * scale.asDiagonal();
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(scaled);
    const Eigen::VectorXd inverted = eigen.eigenvalues().cwiseMax(1e-14).cwiseInverse();
    return scale.asDiagonal() *
           (eigen.eigenvectors() * inverted.asDiagonal() * eigen.eigenvectors().transpose()) *
           scale.asDiagonal();
}

/// Fills in how the fit changes without each image, and the covariance by the scatter of the images' pulls.
/// parts: one a view, at the optimum, where their gradients add up to nothing.
void judgeImages(const std::vector<SharedPart> &parts, const Eigen::MatrixXd &normal, LensFit &fit)
{
    // With S = LLᵀ and Sᵢ = L·Aᵢ·Lᵀ an image pulls by L⁻ᵀ(1 − Aᵢ)^(−p)·L⁻¹gᵢ: with p = 1 that is the change
    // of the fit without it, with p = ½ what adds up to the variance if all errors are alike and independent.
    const Eigen::LLT<Eigen::MatrixXd> root(normal);
    if (root.info() != Eigen::Success)
        return;
    const auto lower = root.matrixL();
    fit.clusterCovariance = Eigen::MatrixXd::Zero(normal.rows(), normal.rows());
    for (const SharedPart &part : parts) {
        const Eigen::MatrixXd half = lower.solve(part.normal);
        const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> share(lower.solve(half.transpose()));
        const Eigen::ArrayXd left = (1 - share.eigenvalues().array()).cwiseMax(leastLeft);
        const Eigen::ArrayXd pull = share.eigenvectors().transpose() * lower.solve(part.gradient);
        const auto change = [&](const Eigen::ArrayXd &by) -> Eigen::VectorXd {
            return root.matrixU().solve(share.eigenvectors() * by.matrix());
        };
        fit.withoutImage.push_back(change(pull / left));
        const Eigen::VectorXd scatter = change(pull / left.sqrt());
        fit.clusterCovariance += scatter * scatter.transpose();
    }
}

template <LensModel model>
class Fit
{
public:
    Fit(const std::vector<BoardView> &views, const LensStart &start, const LensFitOptions &options)
        : m_views(views), m_options(options), m_print(start.print), m_shape(start.print.values),
          m_intrinsics(start.intrinsics), m_lens{start.intrinsics.fxPx, start.intrinsics.fyPx,
                                                 start.intrinsics.cxPx, start.intrinsics.cyPx}
    {
        std::copy(start.intrinsics.distortion.begin(), start.intrinsics.distortion.end(), m_lens.begin() + 4);
        for (const RigidTransform &pose : start.cameraFromBoard)
            m_poses.push_back(parametersOf(pose));
        if (options.usualLensPx > 0 && model == LensModel::Standard)
            m_usual = usualLens(start.intrinsics, options.usualLensPx);
    }

    bool solve(const JobControl &control)
    {
        ceres::Problem::Options ownership;
        ownership.cost_function_ownership = ceres::DO_NOT_TAKE_OWNERSHIP;
        std::deque<ViewCost<model>> costs;
        ceres::Problem problem(ownership);
        auto *ordering = new ceres::ParameterBlockOrdering;
        for (std::size_t view = 0; view < m_views.size(); ++view) {
            problem.AddResidualBlock(&costs.emplace_back(m_views[view], m_print, m_options.cauchyPx), nullptr,
                                     m_lens.data(), m_poses[view].data(), m_shape.data());
            ordering->AddElementToGroup(m_poses[view].data(), 0);
        }
        ordering->AddElementToGroup(m_lens.data(), 1);
        ordering->AddElementToGroup(m_shape.data(), 1);
        std::optional<ceres::NormalPrior> usual;
        if (m_usual)
            problem.AddResidualBlock(&usual.emplace(m_usual->weights, m_usual->values), nullptr,
                                     m_lens.data());
        hold(problem);
        StopWhenCancelled stop(control);
        ceres::Solver::Options options;
        // Without anything in common there is nothing to eliminate the poses from.
        options.linear_solver_type =
            m_options.holdLens && !m_options.freePrint ? ceres::DENSE_QR : ceres::DENSE_SCHUR;
        options.linear_solver_ordering.reset(ordering);
        options.max_num_iterations = 200;
        // A probe needs no last digits; a rational lens goes on for ever along what the images do not
        // determine.
        options.function_tolerance = m_options.holdFocal ? 1e-6 : model == LensModel::Rational ? 1e-7 : 1e-12;
        options.parameter_tolerance = 1e-12;
        options.gradient_tolerance = 1e-14;
        // Coefficients of the rational lens that the images do not determine leave a matrix that cannot be
        // factored: some damping stays, and steps that need more of it are no news for the terminal.
        options.max_trust_region_radius = 1e9;
        quietCeres();
        options.logging_type = ceres::SILENT;
        options.callbacks.push_back(&stop);
        ceres::Solver::Summary summary;
        ceres::Solve(options, &problem, &summary);
        return summary.IsSolutionUsable() && !control.isCancelled();
    }

    LensFit result() const
    {
        LensFit fit;
        fit.print = m_print;
        fit.print.values = m_shape;
        fit.intrinsics = m_intrinsics;
        fit.intrinsics.fxPx = m_lens[0];
        fit.intrinsics.fyPx = m_lens[1];
        fit.intrinsics.cxPx = m_lens[2];
        fit.intrinsics.cyPx = m_lens[3];
        fit.intrinsics.distortion.assign(m_lens.begin() + 4, m_lens.end());
        std::vector<SharedPart> parts;
        Eigen::MatrixXd normal = Eigen::MatrixXd::Zero(sharedSize(), sharedSize());
        std::size_t count = 0;
        for (std::size_t view = 0; view < m_views.size(); ++view) {
            fit.cameraFromBoard.push_back(transformOf(m_poses[view]));
            parts.push_back(judge(view, fit));
            normal += parts.back().normal;
            fit.squares += fit.imageSquares.back();
            count += m_views[view].pixels.size();
        }
        if (m_usual) {
            normal.topLeftCorner<size, size>() += m_usual->weights.transpose() * m_usual->weights;
            const Eigen::Map<const Eigen::VectorXd> values(m_lens.data(), size);
            fit.unusualSquares = (m_usual->weights * (values - m_usual->values)).squaredNorm();
        }
        const double freedom = 2.0 * static_cast<double>(count) - static_cast<double>(sharedSize()) -
                               6.0 * static_cast<double>(m_views.size());
        fit.sigmaPx = std::sqrt(fit.squares / std::max(1.0, freedom));
        const Eigen::MatrixXd covariance = fit.sigmaPx * fit.sigmaPx * inverse(normal);
        fit.intrinsics.covariance = covariance.topLeftCorner<size, size>();
        fit.printCovariance = covariance.bottomRightCorner(sharedSize() - size, sharedSize() - size);
        if (!m_options.holdFocal && !m_options.holdLens && !m_options.holdSixthOrder &&
            m_options.cauchyPx == 0)
            judgeImages(parts, normal, fit);
        return fit;
    }

private:
    static constexpr int size = intrinsicsSize(model);

    Eigen::Index sharedSize() const { return size + (m_options.freePrint ? BoardShape::size : 0); }

    /// Holds what shall stay.
    void hold(ceres::Problem &problem)
    {
        if (m_options.holdLens)
            problem.SetParameterBlockConstant(m_lens.data());
        else if (m_options.holdFocal)
            problem.SetManifold(m_lens.data(), new ceres::SubsetManifold(size, {0, 1}));
        else if (m_options.holdSixthOrder && model == LensModel::Standard)
            problem.SetManifold(m_lens.data(), new ceres::SubsetManifold(size, {4 + sixthOrder}));
        if (!m_options.freePrint)
            problem.SetParameterBlockConstant(m_shape.data());
    }

    /// Fills in a view's residuals and squares; returns its share in what the views have in common.
    SharedPart judge(std::size_t view, LensFit &fit) const
    {
        const std::size_t corners = m_views[view].pixels.size();
        const auto rows = static_cast<Eigen::Index>(2 * corners);
        Derivatives byIntrinsics(rows, size), byPose(rows, 6), byShape(rows, int(BoardShape::size));
        Eigen::VectorXd errors(rows);
        const double *parameters[] = {m_lens.data(), m_poses[view].data(), m_shape.data()};
        double *derivatives[] = {byIntrinsics.data(), byPose.data(), byShape.data()};
        ViewCost<model>(m_views[view], m_print, 0).Evaluate(parameters, errors.data(), derivatives);
        fit.residualsPx.emplace_back();
        for (std::size_t i = 0; i < corners; ++i)
            fit.residualsPx.back().emplace_back(-errors.segment<2>(static_cast<Eigen::Index>(2 * i)));
        fit.imageSquares.push_back(errors.squaredNorm());
        Derivatives byShared(rows, sharedSize());
        byShared.leftCols(size) = byIntrinsics;
        byShared.rightCols(sharedSize() - size) = byShape.leftCols(sharedSize() - size);
        return withoutPose(byShared, byPose, errors);
    }

    const std::vector<BoardView> &m_views;
    const LensFitOptions m_options;
    const BoardShape m_print;
    std::array<double, BoardShape::size> m_shape;
    Intrinsics m_intrinsics;
    std::array<double, size> m_lens{};
    std::vector<Pose> m_poses;
    std::optional<UsualLens> m_usual;
};

template <LensModel model>
std::optional<LensFit> fitWith(const std::vector<BoardView> &views, const LensStart &start,
                               const LensFitOptions &options, const JobControl &control)
{
    Fit<model> fit(views, start, options);
    if (!fit.solve(control))
        return std::nullopt;
    LensFit result = fit.result();
    if (!std::isfinite(result.squares) || !CameraModel::create(result.intrinsics))
        return std::nullopt;
    return result;
}

} // namespace

std::vector<PointPair> pairsOf(const BoardView &view)
{
    std::vector<PointPair> pairs;
    for (std::size_t i = 0; i < view.pixels.size(); ++i)
        pairs.push_back({view.pointsOnBoard[i], view.pixels[i], {}});
    return pairs;
}

double squareSideM(const BoardView &view)
{
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < view.pointsOnBoard.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j)
            least = std::min(least, (view.pointsOnBoard[i] - view.pointsOnBoard[j]).norm());
    }
    return least;
}

double LensFit::rmsPx() const
{
    std::size_t count = 0;
    for (const auto &residuals : residualsPx)
        count += residuals.size();
    return count == 0 ? 0 : std::sqrt(squares / static_cast<double>(count));
}

std::optional<LensFit> fitIntrinsics(const std::vector<BoardView> &views, const LensStart &start,
                                     const LensFitOptions &options, const JobControl &control)
{
    switch (start.intrinsics.model) {
    case LensModel::Standard:
        return fitWith<LensModel::Standard>(views, start, options, control);
    case LensModel::Fisheye:
        return fitWith<LensModel::Fisheye>(views, start, options, control);
    case LensModel::Rational:
        break;
    }
    // The rational model has so many ways to bend that it is started from the standard one's answer, unless
    // one is known.
    if (start.intrinsics.distortion.size() == 8)
        return fitWith<LensModel::Rational>(views, start, options, control);
    LensStart simple = start;
    simple.intrinsics.model = LensModel::Standard;
    simple.intrinsics.distortion.clear();
    const auto first = fitWith<LensModel::Standard>(views, simple, options, control);
    if (!first)
        return std::nullopt;
    LensStart better{first->intrinsics, first->cameraFromBoard, first->print};
    better.intrinsics.model = LensModel::Rational;
    better.intrinsics.covariance.resize(0, 0);
    better.intrinsics.distortion.resize(8, 0.0);
    return fitWith<LensModel::Rational>(views, better, options, control);
}

std::optional<LensFit> fitPose(const BoardView &view, const LensFit &known,
                               const RigidTransform &cameraFromBoard)
{
    const auto from = [&](const RigidTransform &pose) {
        return fitIntrinsics({view}, {known.intrinsics, {pose}, known.print}, {.holdLens = true},
                             JobControl());
    };
    if (auto near = from(cameraFromBoard))
        return near;
    const auto camera = CameraModel::create(known.intrinsics);
    if (!camera)
        return std::nullopt;
    const auto pose = fitPlanePose(pairsOf(view), *camera, FocalLength::Known);
    return pose ? from(pose->worldFromCamera.inverse()) : std::nullopt;
}

namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr std::size_t viewsForFocal = 8;

CameraModel cameraOf(int widthPx, int heightPx, LensModel model, double focalPx)
{
    Intrinsics intrinsics = CameraModel::assumed(widthPx, heightPx).intrinsics();
    intrinsics.fxPx = intrinsics.fyPx = focalPx;
    intrinsics.model = model;
    return CameraModel::create(intrinsics).value_or(CameraModel::assumed(widthPx, heightPx));
}

/// Zhang 2000, equations 3 and 4, over all views, with the principal point in the middle and one focal
/// length.
std::optional<double> closedFormFocal(const std::vector<BoardView> &views, int widthPx, int heightPx)
{
    const Vector2d middle(0.5 * (widthPx - 1), 0.5 * (heightPx - 1));
    const double side = std::max(widthPx, heightPx);
    double products = 0, squares = 0;
    for (const BoardView &view : views) {
        std::vector<PointPair> pairs = pairsOf(view);
        for (PointPair &pair : pairs)
            pair.target = (pair.target - middle) / side;
        const auto homography = Homography::estimate(pairs);
        if (!homography)
            continue;
        const double length = homography->matrix().leftCols<2>().norm();
        const Vector3d a = homography->matrix().col(0) / length, b = homography->matrix().col(1) / length;
        const Vector2d factors(a.head<2>().dot(b.head<2>()),
                               a.head<2>().squaredNorm() - b.head<2>().squaredNorm());
        const Vector2d constants(a.z() * b.z(), a.z() * a.z() - b.z() * b.z());
        products -= factors.dot(constants);
        squares += factors.squaredNorm();
    }
    const double inverseSquare = products / squares;
    if (!(inverseSquare > 0) || !std::isfinite(inverseSquare))
        return std::nullopt;
    return side / std::sqrt(inverseSquare);
}

/// A start with one focal length, and how badly its plane poses fit.
struct Trial
{
    LensStart start;
    std::vector<std::size_t> withoutPose;
    double badness = std::numeric_limits<double>::infinity();
};

/// Poses of every step-th view.
Trial tried(const std::vector<BoardView> &views, const CameraModel &camera, std::size_t step)
{
    Trial trial{{camera.intrinsics(), {}}, {}, {}};
    double squares = 0;
    for (std::size_t i = 0; i < views.size(); i += step) {
        const auto pose = fitPlanePose(pairsOf(views[i]), camera, FocalLength::Known);
        if (!pose) {
            trial.withoutPose.push_back(i);
            continue;
        }
        trial.start.cameraFromBoard.push_back(pose->worldFromCamera.inverse());
        squares += pose->rmsPx * pose->rmsPx;
    }
    // Fewer lost images first, then the better fit.
    const double side = std::max(camera.intrinsics().widthPx, camera.intrinsics().heightPx);
    if (!trial.start.cameraFromBoard.empty())
        trial.badness = squares / static_cast<double>(trial.start.cameraFromBoard.size()) +
                        side * side * static_cast<double>(trial.withoutPose.size());
    return trial;
}

} // namespace

std::optional<LensStart> startLens(const std::vector<BoardView> &views, int widthPx, int heightPx,
                                   LensModel model, std::vector<std::size_t> &withoutPose)
{
    const double side = std::max(widthPx, heightPx);
    std::vector<double> focals{0.35 * side, 0.6 * side, 1.0 * side, 1.7 * side, 3.0 * side};
    if (const auto closed = closedFormFocal(views, widthPx, heightPx))
        focals.push_back(std::clamp(*closed, 0.2 * side, 20 * side));
    const auto bestOf = [&](std::size_t step) {
        Trial best;
        for (const double focal : focals) {
            Trial trial = tried(views, cameraOf(widthPx, heightPx, model, focal), step);
            if (trial.badness < best.badness)
                best = std::move(trial);
        }
        return best;
    };
    // Some views suffice for the focal length; use all only if others then lack a pose.
    const std::size_t step = std::max<std::size_t>(1, views.size() / viewsForFocal);
    Trial start = bestOf(step);
    if (step > 1 && std::isfinite(start.badness))
        start = tried(views, cameraOf(widthPx, heightPx, model, start.start.intrinsics.fxPx), 1);
    if (step > 1 && !start.withoutPose.empty())
        start = bestOf(1);
    withoutPose = std::move(start.withoutPose);
    if (!std::isfinite(start.badness))
        return std::nullopt;
    return std::move(start.start);
}

} // namespace odo
