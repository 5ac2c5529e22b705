// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/models/scene_uncertainty.h"

#include "core/workflow/track/track_warnings.h"
#include "ui/models/number_text.h"
#include "ui/models/shown_message.h"

#include <QCoreApplication>
#include <QStringList>
#include <algorithm>

namespace odo {

namespace {

class UncertainIntervalsWords
{
    Q_DECLARE_TR_FUNCTIONS(UncertainIntervals)
};

} // namespace

QString occlusionText(const Occlusion &occlusion)
{
    return UncertainIntervalsWords::tr("%1 (%2 to %3)")
        .arg(shownWords(occlusionWords(occlusion)), secondsText(occlusion.span.begin),
             secondsText(occlusion.span.end));
}

std::vector<UncertainInterval> uncertainIntervals(const TrialScene &scene)
{
    std::vector<UncertainInterval> all;
    for (std::size_t r = 0; r < scene.robots.size(); ++r) {
        const SceneRobot &robot = scene.robots[r];
        if (!robot.analysis)
            continue;
        const QString name = QString::fromStdString(robot.robot.name);
        for (const AmbiguousName &ambiguity : robot.analysis->ambiguousNames)
            all.push_back(
                {r,
                 {ambiguity.from, ambiguity.to},
                 UncertainInterval::Kind::Name,
                 UncertainIntervalsWords::tr("Which robot? Until %1").arg(secondsText(ambiguity.to)),
                 joinedWords(name, shownWords(ambiguousNamesText({&ambiguity, 1}, robot.robot.name)))});
        for (const Occlusion &occlusion : robot.occlusions)
            all.push_back({r, occlusion.span, UncertainInterval::Kind::Occlusion,
                           shownWords(occlusionWords(occlusion)),
                           joinedWords(name, occlusionText(occlusion))});
        for (const TimeSpan &gap : robot.analysis->profile.gaps)
            all.push_back({r, gap, UncertainInterval::Kind::Gap,
                           UncertainIntervalsWords::tr("Not measured until %1").arg(secondsText(gap.end)),
                           joinedWords(name, UncertainIntervalsWords::tr("not measured (%1 to %2)")
                                                 .arg(secondsText(gap.begin), secondsText(gap.end)))});
    }
    std::ranges::stable_sort(all, {}, [](const UncertainInterval &one) { return one.span.begin; });
    return all;
}

QString uncertaintyTextAt(const std::vector<UncertainInterval> &stretches, Nanoseconds time,
                          Nanoseconds reach)
{
    QStringList words;
    for (const UncertainInterval &one : stretches)
        if (time >= one.span.begin - reach && time <= one.span.end + reach)
            words << one.sentence.toHtmlEscaped();
    return words.isEmpty() ? QString() : QStringLiteral("<p>%1</p>").arg(words.join(QStringLiteral("<br>")));
}

namespace {

class SceneDisagreementWords
{
    Q_DECLARE_TR_FUNCTIONS(SceneDisagreement)
};

constexpr double surprising = 1.5; // times what is expected

double stepSigmaS(const TrialScene &scene)
{
    double largest = 0;
    for (const SceneView &view : scene.views)
        largest = std::max(largest, view.recording.startOffsetSigmaS);
    return largest;
}

} // namespace

std::vector<ViewDisagreement> disagreementsOf(const TrialScene &scene)
{
    std::vector<ViewDisagreement> all;
    for (const SceneRobot &robot : scene.robots) {
        std::vector<ViewTrack> tracks;
        for (std::size_t view = 0; view < scene.views.size() && view < robot.observations.size(); ++view) {
            const SceneView &shown = scene.views[view];
            tracks.push_back({shown.camera, shown.floorView, shown.startOffset, robot.observations[view],
                              shown.clockRate});
        }
        all.push_back(robot.analysis ? disagreementOf(robot.analysis->profile, tracks, stepSigmaS(scene))
                                     : ViewDisagreement());
    }
    return all;
}

QString disagreementWords(const ViewDisagreement &disagreement)
{
    if (disagreement.positions.empty())
        return SceneDisagreementWords::tr("Only one view at a time: nothing to compare");
    const QString measured = SceneDisagreementWords::tr("RMS %1, median %2")
                                 .arg(lengthText(disagreement.rmsM), lengthText(disagreement.medianM));
    const QString expected = SceneDisagreementWords::tr("expected from the uncertainty: %1")
                                 .arg(lengthText(disagreement.expectedRmsM));
    return measured + u'\n' +
           (disagreement.ratio() > surprising
                ? SceneDisagreementWords::tr("%1 – more than it explains").arg(expected)
                : expected);
}

Explanation explainDisagreement(const TrialScene &scene, std::size_t robot,
                                const ViewDisagreement &disagreement)
{
    Explanation explanation{SceneDisagreementWords::tr("Disagreement of the views"),
                            disagreementWords(disagreement).replace(u'\n', QStringLiteral("; ")),
                            {},
                            {},
                            analysisInputs(scene, robot),
                            {}};
    explanation.formula = SceneDisagreementWords::tr(
        "Each view alone gives a floor position of the robot. The chart shows the distance between these "
        "positions in each frame with two views or more (of more than two, the largest distance); RMS is "
        "√(mean of the squares). Unused samples are left out.\nExpected is √(tr A + tr B + (v·σs)²) from the "
        "covariances A and B of two views (pixels and calibration), the speed v and the synchronisation "
        "uncertainty σs of the views.\nMuch more than expected means that a setting is wrong: the views are "
        "not synchronised (the distance grows with the speed), a camera has moved or is badly registered (it "
        "depends on the position), or the robot's height is wrong (it points to and from the cameras).");
    explanation.inputs.prepend(
        SceneDisagreementWords::tr(
            "%1 frames with two views or more; largest %2; views synchronised to %3 ms")
            .arg(disagreement.positions.size())
            .arg(lengthText(disagreement.largestM), QLocale().toString(1e3 * stepSigmaS(scene), 'f', 1)));
    return explanation;
}

SpikeModel::SpikeModel(QObject *parent) : RowTableModel(ColumnCount, parent) {}

void SpikeModel::setScene(TrialScenePtr scene)
{
    beginResetModel();
    m_scene = std::move(scene);
    m_rows.clear();
    for (std::size_t robot = 0; m_scene && robot < m_scene->robots.size(); ++robot) {
        const auto &analysis = m_scene->robots[robot].analysis;
        if (!analysis)
            continue;
        for (const Spike &spike : analysis->profile.spikes) {
            // A person's mark that stands alone took the others away; beside others it set them.
            constexpr SampleFlags beside = flagBit(SampleFlag::ByHand) | flagBit(SampleFlag::Interpolated);
            const bool restored = hasFlag(spike.flags, SampleFlag::ByHand) && (spike.flags & ~beside) == 0;
            m_rows.push_back({static_cast<int>(robot), spike, restored});
        }
        addUsedByHand(static_cast<int>(robot), analysis->profile);
    }
    if (m_scene)
        addStretches();
    std::stable_sort(m_rows.begin(), m_rows.end(),
                     [](const Row &a, const Row &b) { return a.spike.time < b.spike.time; });
    endResetModel();
}

/// Samples that are no longer spikes because of a manual override.
void SpikeModel::addUsedByHand(int robot, const Profile &profile)
{
    for (std::size_t i = 0; i < profile.samples.size(); ++i) {
        const auto index = static_cast<std::int64_t>(i);
        const Sample &sample = profile.samples[i];
        if (!hasFlag(sample.flags, SampleFlag::ByHand) || isRejected(sample.flags))
            continue;
        if (std::ranges::find(profile.spikes, index, &Spike::sampleIndex) == profile.spikes.end())
            m_rows.push_back({robot, {index, sample.time, sample.flags, {}}, true});
    }
}

void SpikeModel::addStretches()
{
    for (UncertainInterval &stretch : uncertainIntervals(*m_scene)) {
        // Rounded to a frame: selecting the row moves the time line there.
        const auto frame = m_scene->views.empty() ? std::nullopt : m_scene->frameAt(0, stretch.span.begin);
        Row &row = m_rows.emplace_back();
        row.robot = static_cast<int>(stretch.robot);
        row.spike.sampleIndex = -1;
        row.spike.time = frame ? m_scene->timeOf(0, *frame) : stretch.span.begin;
        row.stretch = std::move(stretch);
    }
}

qsizetype SpikeModel::stretchesOf(UncertainInterval::Kind kind) const
{
    return std::ranges::count_if(m_rows,
                                 [kind](const Row &row) { return row.stretch && row.stretch->kind == kind; });
}

QString SpikeModel::summary() const
{
    const qsizetype uncertain = stretchesOf(UncertainInterval::Kind::Name),
                    hidden = stretchesOf(UncertainInterval::Kind::Occlusion),
                    gaps = stretchesOf(UncertainInterval::Kind::Gap);
    const auto restored =
        std::count_if(m_rows.begin(), m_rows.end(), [](const Row &row) { return row.restored; });
    const auto flagged = static_cast<qsizetype>(m_rows.size()) - restored - uncertain - hidden - gaps;
    QString text = flagged == 0 ? tr("none") : tr("%1 flagged").arg(flagged);
    if (restored > 0)
        text += QStringLiteral(" · ") + tr("%1 restored").arg(restored);
    if (uncertain > 0)
        text += QStringLiteral(" · ") + tr("%1 ambiguous").arg(uncertain);
    if (hidden > 0)
        text += QStringLiteral(" · ") + tr("%1 hidden").arg(hidden);
    if (gaps > 0)
        text += QStringLiteral(" · ") + tr("%1 not measured").arg(gaps);
    return text;
}

QVariant SpikeModel::display(const Row &row, int column) const
{
    switch (column) {
    case TimeColumn:
        return secondsText(row.spike.time);
    case ReasonColumn: {
        if (row.stretch)
            return row.stretch->reason;
        const QString reason = shownWords(
            reasonAmong(m_scene->robots[static_cast<std::size_t>(row.robot)].occlusions, row.spike));
        if (reason.isEmpty())
            return tr("used, by hand");
        return row.restored ? tr("%1 (restored by hand)").arg(reason) : reason;
    }
    case StateColumn:
        if (row.stretch && row.stretch->kind == UncertainInterval::Kind::Name)
            return QStringLiteral("?");
        if (row.stretch)
            return row.stretch->kind == UncertainInterval::Kind::Gap ? QStringLiteral("○")
                                                                     : QStringLiteral("◐");
        return row.restored ? QStringLiteral("↺") : QStringLiteral("⚑");
    default:
        return {};
    }
}

QVariant SpikeModel::cell(int index, int column, int role) const
{
    const Row &row = m_rows[static_cast<std::size_t>(index)];
    switch (role) {
    case Qt::DisplayRole:
        return display(row, column);
    case Qt::ToolTipRole:
    case Qt::AccessibleTextRole:
        if (row.stretch && column != TimeColumn)
            return row.stretch->sentence;
        if (column == StateColumn) {
            if (row.restored)
                return tr("Restored by hand");
            return isRejected(row.spike.flags) ? tr("Flagged, not used for the curve")
                                               : tr("Flagged, still used for the curve");
        }
        if (column == ReasonColumn && m_scene->robots.size() > 1)
            return QStringLiteral("%1: %2").arg(
                QString::fromStdString(m_scene->robots[static_cast<std::size_t>(row.robot)].robot.name),
                display(row, ReasonColumn).toString());
        return display(row, column);
    case Qt::TextAlignmentRole:
        return aligned(column == StateColumn ? Qt::AlignHCenter : Qt::AlignLeft);
    case TimeRole:
        return QVariant::fromValue<qint64>(row.spike.time.count());
    case SampleIndexRole:
        return QVariant::fromValue<qint64>(row.spike.sampleIndex);
    case RobotRole:
        return row.robot;
    case FlagsRole:
        return row.spike.flags;
    case RestoredRole:
        return row.restored;
    case SortRole:
        if (column == TimeColumn)
            return QVariant::fromValue<qint64>(row.spike.time.count());
        return display(row, column);
    default:
        return {};
    }
}

QVariant SpikeModel::heading(int column, int role) const
{
    if (role == Qt::TextAlignmentRole)
        return aligned(Qt::AlignLeft);
    if (role != Qt::DisplayRole)
        return {};
    switch (column) {
    case TimeColumn:
        return tr("Time");
    case ReasonColumn:
        return tr("Reason");
    default:
        return {};
    }
}

} // namespace odo
