// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/acceptance/scenes/scene_metrics.h"

#include "tests/acceptance/scenes/scene_visibility.h"

#include <QHash>
#include <QList>
#include <array>
#include <cmath>

namespace odo::test {

namespace {

constexpr double sigmas95 = 1.96;
constexpr double spikeMm = 20;
// Several times the stated σ of a sound place: whoever flags a place further off is right.
constexpr double honestMm = 4;
constexpr double anotherMm = 200;
constexpr double impactMarginS = 0.2; // half of what a smoother looks at
constexpr int exchangeFrames = 3;

using Row = QList<QByteArray>;

/// One line of the table, by the columns' names.
class Line
{
public:
    Line(const QHash<QByteArray, qsizetype> &columns, const Row &row) : m_columns(columns), m_row(row) {}

    QByteArray text(const char *column) const { return m_row.value(m_columns.value(column)); }
    bool has(const char *column) const { return !text(column).isEmpty(); }
    double number(const char *column) const { return text(column).toDouble(); }
    Eigen::Vector2d pair(const char *x, const char *y) const { return {number(x), number(y)}; }

    bool isFlagged() const
    {
        static const std::array<QByteArray, 5> reasons{"jump", "speed_limit", "acceleration_limit",
                                                       "views_disagree", "low_score"};
        const QList<QByteArray> flags = text("flags").split('|');
        return std::any_of(reasons.begin(), reasons.end(),
                           [&](const QByteArray &reason) { return flags.contains(reason); });
    }

private:
    const QHash<QByteArray, qsizetype> &m_columns;
    const Row &m_row;
};

class Comparison
{
public:
    Comparison(const AccuracyScene &scene, std::size_t robot) : m_scene(scene), m_robot(robot) {}

    void add(const Line &line)
    {
        const double stampS = line.number("t_s");
        const double timeS = sceneTimeOfStamp(m_scene.scene, 0, fromSeconds(stampS));
        const MotionState truth = m_scene.scene.robots[m_robot].motion->at(timeS);
        ++m_sums.frames;
        if (line.has("x_mm"))
            addCurve(line, truth, timeS);
        addSpike(line, truth, timeS);
        addHidden(line, timeS);
    }

    const AccuracySums &sums() const { return m_sums; }

private:
    void addCurve(const Line &line, const MotionState &truth, double timeS)
    {
        const Eigen::Vector2d error = line.pair("x_mm", "y_mm") - truth.position * 1000;
        ++m_sums.withPosition;
        m_sums.errorSumMm += error;
        m_sums.squaredMm += error.squaredNorm();
        m_sums.insideX += std::abs(error.x()) <= sigmas95 * line.number("sigma_x_mm");
        m_sums.insideY += std::abs(error.y()) <= sigmas95 * line.number("sigma_y_mm");
        m_sums.sigmaSumMm += (line.number("sigma_x_mm") + line.number("sigma_y_mm")) / 2;
        const double speedError = line.number("speed_mm_s") - truth.velocity.norm() * 1000;
        m_sums.insideSpeed += std::abs(speedError) <= sigmas95 * line.number("sigma_speed_mm_s");
        const bool atImpact =
            std::any_of(m_scene.impactsS.begin(), m_scene.impactsS.end(),
                        [&](double impactS) { return std::abs(impactS - timeS) < impactMarginS; });
        if (!atImpact) {
            ++m_sums.curveFrames;
            m_sums.squaredMmS += (line.pair("vx_mm_s", "vy_mm_s") - truth.velocity * 1000).squaredNorm();
            m_sums.squaredMmS2 +=
                (line.pair("ax_mm_s2", "ay_mm_s2") - truth.acceleration * 1000).squaredNorm();
        }
        addExchange(line.pair("x_mm", "y_mm"), error.norm(), timeS);
    }

    void addExchange(const Eigen::Vector2d &positionMm, double ownErrorMm, double timeS)
    {
        bool nearerToAnother = false;
        for (std::size_t other = 0; other < m_scene.scene.robots.size(); ++other) {
            const Eigen::Vector2d there = m_scene.scene.robots[other].motion->at(timeS).position * 1000;
            nearerToAnother =
                nearerToAnother || (other != m_robot && (positionMm - there).norm() < ownErrorMm);
        }
        m_framesOfAnother = nearerToAnother ? m_framesOfAnother + 1 : 0;
        m_sums.exchanges += m_framesOfAnother == exchangeFrames + 1;
    }

    void addSpike(const Line &line, const MotionState &truth, double timeS)
    {
        const double rawErrorMm =
            line.has("raw_x_mm") ? (line.pair("raw_x_mm", "raw_y_mm") - truth.position * 1000).norm() : 0;
        const bool isSpike = rawErrorMm > spikeMm;
        const bool disturbed = isDisturbed(m_scene.scene, m_robot, timeS), flagged = line.isFlagged();
        m_sums.elsewhere += rawErrorMm > anotherMm;
        m_sums.trueSpikes += isSpike;
        m_sums.foundSpikes += isSpike && flagged;
        m_sums.flagged += flagged;
        m_sums.justlyFlagged += flagged && (rawErrorMm > honestMm || disturbed);
        m_sums.disturbed += disturbed;
    }

    void addHidden(const Line &line, double timeS)
    {
        int hidden = 0, seen = 0;
        for (std::size_t camera = 0; camera < m_scene.scene.cameras.size(); ++camera) {
            const double share = hiddenShare(m_scene.scene, static_cast<int>(camera), m_robot, timeS);
            hidden += share >= 1;
            seen += share <= 0;
        }
        if (hidden > 0 && seen > 0) {
            ++m_sums.hiddenInOneView;
            m_sums.hiddenWithPosition += line.has("x_mm");
        }
    }

    const AccuracyScene &m_scene;
    const std::size_t m_robot;
    AccuracySums m_sums;
    int m_framesOfAnother = 0;
};

double rootMean(double squares, long count)
{
    return count > 0 ? std::sqrt(squares / double(count)) : 0;
}

} // namespace

AccuracySums &AccuracySums::operator+=(const AccuracySums &other)
{
    frames += other.frames;
    withPosition += other.withPosition;
    errorSumMm += other.errorSumMm;
    squaredMm += other.squaredMm;
    curveFrames += other.curveFrames;
    squaredMmS += other.squaredMmS;
    squaredMmS2 += other.squaredMmS2;
    insideX += other.insideX;
    insideY += other.insideY;
    insideSpeed += other.insideSpeed;
    sigmaSumMm += other.sigmaSumMm;
    trueSpikes += other.trueSpikes;
    foundSpikes += other.foundSpikes;
    flagged += other.flagged;
    justlyFlagged += other.justlyFlagged;
    disturbed += other.disturbed;
    hiddenInOneView += other.hiddenInOneView;
    hiddenWithPosition += other.hiddenWithPosition;
    elsewhere += other.elsewhere;
    exchanges += other.exchanges;
    return *this;
}

double AccuracySums::positionRmsMm() const
{
    return rootMean(squaredMm, withPosition);
}

double AccuracySums::velocityRmsMmS() const
{
    return rootMean(squaredMmS, curveFrames);
}

double AccuracySums::accelerationRmsMmS2() const
{
    return rootMean(squaredMmS2, curveFrames);
}

std::optional<double> AccuracySums::recall() const
{
    return trueSpikes > 0 ? std::optional(double(foundSpikes) / double(trueSpikes)) : std::nullopt;
}

std::optional<double> AccuracySums::precision() const
{
    return flagged > 0 ? std::optional(double(justlyFlagged) / double(flagged)) : std::nullopt;
}

std::optional<AccuracySums> compareWithTruth(const QByteArray &csv, const AccuracyScene &scene,
                                             std::size_t robot)
{
    const QList<QByteArray> lines = csv.trimmed().split('\n');
    QHash<QByteArray, qsizetype> columns;
    const Row header = lines.first().trimmed().split(',');
    for (qsizetype i = 0; i < header.size(); ++i)
        columns.insert(header[i], i);
    for (const char *needed :
         {"t_s", "x_mm", "y_mm", "vx_mm_s", "vy_mm_s", "speed_mm_s", "ax_mm_s2", "ay_mm_s2", "sigma_x_mm",
          "sigma_y_mm", "sigma_speed_mm_s", "raw_x_mm", "raw_y_mm", "flags"}) {
        if (!columns.contains(needed))
            return std::nullopt;
    }
    Comparison comparison(scene, robot);
    for (const QByteArray &text : lines.mid(1)) {
        const Row row = text.trimmed().split(',');
        comparison.add(Line(columns, row));
    }
    return comparison.sums();
}

} // namespace odo::test
