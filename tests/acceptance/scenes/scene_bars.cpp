// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/acceptance/scenes/scene_bars.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>

namespace odo::test {

namespace {

using Pick = std::function<bool(const MeasuredScene &)>;
using Metric = double (AccuracySums::*)() const;

class Judge
{
public:
    explicit Judge(const std::vector<MeasuredScene> &scenes) : m_scenes(scenes) {}

    /// The worst scene's and all together's root mean square, of scenes with two views or more.
    void rms(const QString &metric, Metric value, double atMost, const Pick &counts)
    {
        AccuracySums together;
        BarResult worst{metric + QStringLiteral(", worst"), -1, 0, atMost, {}};
        for (const MeasuredScene &scene : m_scenes) {
            if (scene.scene.oneView || !counts(scene) || !scene.problem.isEmpty())
                continue;
            const AccuracySums sums = scene.sums();
            together += sums;
            if ((sums.*value)() > worst.value) {
                worst.value = (sums.*value)();
                worst.where = QStringLiteral("%1/%2")
                                  .arg(QString::fromStdString(scene.scene.name))
                                  .arg(scene.scene.seed);
            }
        }
        if (worst.value < 0)
            return;
        m_results.push_back({metric + QStringLiteral(", together"), (together.*value)(), 0, atMost, {}});
        m_results.push_back(worst);
    }

    void add(const QString &metric, double value, double atLeast, double atMost)
    {
        m_results.push_back({metric, value, atLeast, atMost, {}});
    }

    std::vector<BarResult> take() { return std::move(m_results); }

private:
    const std::vector<MeasuredScene> &m_scenes;
    std::vector<BarResult> m_results;
};

void judgeSolids(Judge &judge)
{
    const Pick given = [](const MeasuredScene &m) { return m.scene.hasGivenSize(); };
    const Pick notGiven = [](const MeasuredScene &m) { return !m.scene.hasGivenSize(); };
    const Pick plain = [](const MeasuredScene &m) { return m.scene.kind == SceneKind::Plain; };
    const Pick hard = [](const MeasuredScene &m) { return m.scene.kind == SceneKind::Hard; };
    judge.rms(QStringLiteral("position RMS, size told, mm"), &AccuracySums::positionRmsMm, 4, given);
    judge.rms(QStringLiteral("position RMS, size not told, mm"), &AccuracySums::positionRmsMm, 8, notGiven);
    judge.rms(QStringLiteral("velocity RMS, plain, mm/s"), &AccuracySums::velocityRmsMmS, 12, plain);
    judge.rms(QStringLiteral("velocity RMS, hard, mm/s"), &AccuracySums::velocityRmsMmS, 20, hard);
    judge.rms(QStringLiteral("acceleration RMS, plain, mm/s2"), &AccuracySums::accelerationRmsMmS2, 250,
              plain);
    judge.rms(QStringLiteral("acceleration RMS, hard, mm/s2"), &AccuracySums::accelerationRmsMmS2, 450, hard);
}

/// What is told of all scenes together, whatever their kind.
void judgeTogether(Judge &judge, const AccuracySums &all, const std::vector<MeasuredScene> &scenes)
{
    const auto failed =
        std::ranges::count_if(scenes, [](const MeasuredScene &scene) { return !scene.problem.isEmpty(); });
    judge.add(QStringLiteral("calls that failed"), double(failed), 0, 0);
    judge.add(QStringLiteral("truth in the 95 % interval, x, %"), 100 * all.share(all.insideX), 92, 98);
    judge.add(QStringLiteral("truth in the 95 % interval, y, %"), 100 * all.share(all.insideY), 92, 98);
    judge.add(QStringLiteral("exchanges of names"), double(all.exchanges), 0, 0);
}

std::vector<BarResult> judgeSolidScenes(const std::vector<MeasuredScene> &scenes)
{
    Judge judge(scenes);
    judgeSolids(judge);
    AccuracySums all;
    double worstOffsetS = -1;
    for (const MeasuredScene &scene : scenes) {
        all += scene.sums();
        if (scene.offsetErrorS)
            worstOffsetS = std::max(worstOffsetS, std::abs(*scene.offsetErrorS));
    }
    judgeTogether(judge, all, scenes);
    // Or a good figure could be had by leaving the hard frames out.
    judge.add(QStringLiteral("frames without a position, %"),
              all.frames > 0 ? 100.0 * double(all.frames - all.withPosition) / double(all.frames) : 100, 0,
              2);
    judge.add(QStringLiteral("truth in the 95 % interval, speed, %"), 100 * all.share(all.insideSpeed), 92,
              98);
    if (all.recall())
        judge.add(QStringLiteral("spikes: recall"), *all.recall(), 0.98, 1);
    if (all.precision())
        judge.add(QStringLiteral("spikes: precision"), *all.precision(), 0.95, 1);
    if (worstOffsetS >= 0)
        judge.add(QStringLiteral("clip offset error, worst, ms"), 1000 * worstOffsetS, 0, 2);
    if (all.hiddenInOneView > 0)
        judge.add(QStringLiteral("hidden in a view, with a position, %"),
                  100.0 * double(all.hiddenWithPosition) / double(all.hiddenInOneView), 100, 100);
    return judge.take();
}

std::vector<BarResult> judgeLooks(const std::vector<MeasuredScene> &scenes)
{
    Judge judge(scenes);
    judge.rms(QStringLiteral("position RMS, size told, mm"), &AccuracySums::positionRmsMm, 3,
              [](const MeasuredScene &m) { return m.scene.hasGivenSize(); });
    judge.rms(QStringLiteral("position RMS, size not told, mm"), &AccuracySums::positionRmsMm, 5,
              [](const MeasuredScene &m) { return !m.scene.hasGivenSize(); });
    const Pick every = [](const MeasuredScene &) { return true; };
    judge.rms(QStringLiteral("velocity RMS, mm/s"), &AccuracySums::velocityRmsMmS, 15, every);
    judge.rms(QStringLiteral("acceleration RMS, mm/s2"), &AccuracySums::accelerationRmsMmS2, 300, every);
    AccuracySums all;
    double leastFound = 1, leastInside = 1;
    for (const MeasuredScene &scene : scenes) {
        const AccuracySums sums = scene.sums();
        all += sums;
        leastFound =
            std::min(leastFound, sums.frames > 0 ? double(sums.withPosition) / double(sums.frames) : 0);
        leastInside = std::min(leastInside, (sums.share(sums.insideX) + sums.share(sums.insideY)) / 2);
    }
    judgeTogether(judge, all, scenes);
    judge.add(QStringLiteral("frames in which something else was taken for a robot"), double(all.elsewhere),
              0, 0);
    judge.add(QStringLiteral("truth in the 95 % interval, worst scene, %"), 100 * leastInside, 80, 100);
    judge.add(QStringLiteral("frames with a position, worst scene, %"), 100 * leastFound, 99.5, 100);
    judge.add(QStringLiteral("false spikes in 1000 frames"),
              all.frames > 0 ? 1000.0 * double(all.flagged - all.justlyFlagged) / double(all.frames) : 0, 0,
              1);
    return judge.take();
}

} // namespace

std::vector<BarResult> judge(const std::vector<MeasuredScene> &scenes)
{
    std::vector<MeasuredScene> solids, looks;
    for (const MeasuredScene &scene : scenes)
        (scene.scene.kind == SceneKind::Look ? looks : solids).push_back(scene);
    std::vector<BarResult> results;
    if (!solids.empty())
        results = judgeSolidScenes(solids);
    if (!looks.empty())
        std::ranges::move(judgeLooks(looks), std::back_inserter(results));
    return results;
}

} // namespace odo::test
