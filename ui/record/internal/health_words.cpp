// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/record/internal/health_words.h"

#include "ui/models/figure_text.h"
#include "ui/models/shown_message.h"

#include <QCoreApplication>
#include <QLocale>
#include <bit>
#include <cmath>

namespace odo {
namespace {

class RecordHealthWords
{
    Q_DECLARE_TR_FUNCTIONS(RecordHealth)
};

constexpr double goodStepS = 0.005, badStepS = 0.017; // half an interval of 30 frames/s
constexpr double slowMapS = 0.2, littleRoomS = 300;

Badge viewBadge(const ViewHealth &view)
{
    if (view.state == ViewHealth::State::Waiting || view.state == ViewHealth::State::Ended || view.trouble)
        return {RecordHealthWords::tr("trouble"), BadgeState::Bad};
    if (view.slow)
        return {RecordHealthWords::tr("slow"), BadgeState::Warning};
    if (view.lostByUs > 0 || view.lostOnWire > 0)
        return {RecordHealthWords::tr("losses"), BadgeState::Warning};
    return view.state == ViewHealth::State::Delivering
               ? Badge{RecordHealthWords::tr("good"), BadgeState::Good}
               : Badge{};
}

Fact viewFact(const ViewHealth &view, const WantedCamera &camera)
{
    QString words = shownWords(healthWords(view));
    if (view.state == ViewHealth::State::Delivering && view.latencyS > 0)
        words += RecordHealthWords::tr(", %1 ms").arg(std::lround(1e3 * view.latencyS));
    if (!camera.floorView)
        words += RecordHealthWords::tr("; not registered");
    return {RecordHealthWords::tr("Camera %1").arg(QString::fromStdString(camera.name)), words,
            viewBadge(view)};
}

ViewHealth since(ViewHealth view, const CaptureHealth &before, std::size_t v)
{
    if (v >= before.views.size())
        return view;
    const ViewHealth &then = before.views[v];
    view.lostOnWire -= std::min(view.lostOnWire, then.lostOnWire);
    view.lostByUs -= std::min(view.lostByUs, then.lostByUs);
    view.source.damaged -= std::min(view.source.damaged, then.source.damaged);
    return view;
}

Fact robotFact(const SeenRobot &robot)
{
    const QString name = QString::fromStdString(robot.name);
    if (!robot.now || !robot.now->point.valid)
        return {
            name, RecordHealthWords::tr("not seen"), {RecordHealthWords::tr("unseen"), BadgeState::Warning}};
    const ProfilePoint &point = robot.now->point;
    const QString place = RecordHealthWords::tr("x %1, y %2, %3")
                              .arg(distanceText(point.position.x()), distanceText(point.position.y()),
                                   speedText(point.speedMps, point.sigmaSpeedMps));
    if (std::popcount(robot.now->sample.views) == 1)
        return {name,
                place + RecordHealthWords::tr("; one camera sees it"),
                {RecordHealthWords::tr("seen"), BadgeState::Neutral}};
    return {name, place, {RecordHealthWords::tr("seen"), BadgeState::Good}};
}

Fact stepFact(const PairHealth &pairs)
{
    const Badge badge = pairs.p95S <= goodStepS  ? Badge{RecordHealthWords::tr("good"), BadgeState::Good}
                        : pairs.p95S <= badStepS ? Badge{RecordHealthWords::tr("fair"), BadgeState::Neutral}
                                                 : Badge{RecordHealthWords::tr("apart"), BadgeState::Warning};
    return {RecordHealthWords::tr("Step"), shownWords(inStepWords(pairs.p95S)), badge};
}

QString sentence(QString words)
{
    if (!words.isEmpty() && !words.endsWith(u'.'))
        words += u'.';
    return words;
}

QString errorSentence(const Error &error)
{
    return sentence(errorLine(error));
}

} // namespace

QList<Fact> healthFacts(const CaptureHealth &health, const std::vector<WantedCamera> &cameras,
                        const LiveFigures &live, const std::vector<SeenRobot> &robots,
                        const CaptureHealth &before)
{
    QList<Fact> facts;
    for (std::size_t v = 0; v < std::min(cameras.size(), health.views.size()); ++v)
        facts.append(viewFact(since(health.views[v], before, v), cameras[v]));
    if (health.pairs.pairs > 0 && cameras.size() > 1)
        facts.append(stepFact(health.pairs));
    if (const Message words = liveWords(live); !words.isEmpty())
        facts.append({RecordHealthWords::tr("Live"), shownWords(words),
                      live.latencyP99S > slowMapS ? Badge{RecordHealthWords::tr("slow"), BadgeState::Warning}
                                                  : Badge{RecordHealthWords::tr("good"), BadgeState::Good}});
    if (health.disk.recording) {
        QStringList words{RecordHealthWords::tr("%1 MB written")
                              .arg(QLocale().toString(double(health.disk.bytes) / 1e6, 'f', 0))};
        if (const Message room = roomWords(health.disk); !room.isEmpty())
            words << shownWords(room);
        const bool bad = health.disk.trouble || health.disk.waiting >= 1;
        facts.append({RecordHealthWords::tr("Disk"), words.join(QStringLiteral(", ")),
                      bad ? Badge{RecordHealthWords::tr("trouble"), BadgeState::Bad}
                          : Badge{RecordHealthWords::tr("good"), BadgeState::Good}});
    }
    for (const SeenRobot &robot : robots)
        facts.append(robotFact(robot));
    return facts;
}

QString unregisteredWords(const std::vector<WantedCamera> &cameras)
{
    for (const WantedCamera &camera : cameras) {
        const QString name = QString::fromStdString(camera.name);
        if (!camera.floorView && camera.registeredPx.isEmpty())
            return RecordHealthWords::tr(
                       "Camera %1 is not registered to the floor: it is recorded, but cannot tell "
                       "where a robot is.")
                .arg(name);
        if (!camera.floorView)
            return RecordHealthWords::tr(
                       "Camera %1 was registered for pictures of %2×%3, which it does not send now: it "
                       "is recorded, but cannot tell where a robot is.")
                .arg(name)
                .arg(camera.registeredPx.width())
                .arg(camera.registeredPx.height());
    }
    return {};
}

QString troubleWords(const CaptureHealth &health, const std::vector<WantedCamera> &cameras)
{
    if (health.disk.trouble)
        return RecordHealthWords::tr("Recording: %1").arg(errorSentence(health.disk.trouble->error));
    const auto firstOf = [&](std::optional<Trouble> ViewHealth::*kind) {
        for (std::size_t v = 0; v < std::min(cameras.size(), health.views.size()); ++v) {
            if (const auto &trouble = health.views[v].*kind)
                return RecordHealthWords::tr("Camera %1: %2")
                    .arg(QString::fromStdString(cameras[v].name), errorSentence(trouble->error));
        }
        return QString();
    };
    if (QString words = firstOf(&ViewHealth::trouble); !words.isEmpty())
        return words;
    if (health.sleep)
        return errorSentence(health.sleep->error);
    if (QString words = firstOf(&ViewHealth::slow); !words.isEmpty())
        return words;
    if (health.disk.recording && health.disk.waiting >= 0.5)
        return RecordHealthWords::tr(
            "The disk is hardly fast enough: record to a faster one, or with fewer cameras.");
    if (health.disk.secondsLeft && *health.disk.secondsLeft < littleRoomS)
        return sentence(
            RecordHealthWords::tr("The disk is nearly full: %1").arg(shownWords(roomWords(health.disk))));
    if (health.pairs.pairs > 0 && health.pairs.p95S > badStepS)
        return RecordHealthWords::tr("The cameras are not in step: set both to the same rate.");
    return {};
}

} // namespace odo
