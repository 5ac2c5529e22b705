// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/models/doubtful_stretches.h"

#include "core/workflow/track_warnings.h"
#include "ui/models/core_words.h"
#include "ui/models/figure_text.h"

#include <QCoreApplication>
#include <QStringList>
#include <algorithm>

namespace odo {

namespace {

class DoubtfulStretchesWords
{
    Q_DECLARE_TR_FUNCTIONS(DoubtfulStretches)
};

} // namespace

QString occlusionText(const Occlusion &occlusion)
{
    return DoubtfulStretchesWords::tr("%1 (%2 to %3)").arg(shownWords(occlusionWords(occlusion)), secondsText(occlusion.span.begin), secondsText(occlusion.span.end));
}

std::vector<DoubtfulStretch> doubtfulStretches(const TrialScene &scene)
{
    std::vector<DoubtfulStretch> all;
    for (std::size_t r = 0; r < scene.robots.size(); ++r) {
        const SceneRobot &robot = scene.robots[r];
        if (!robot.analysis)
            continue;
        const QString name = QString::fromStdString(robot.robot.name);
        for (const DoubtfulName &doubt : robot.analysis->doubtfulNames)
            all.push_back({r, {doubt.from, doubt.to}, DoubtfulStretch::Kind::Name, DoubtfulStretchesWords::tr("Which robot? Until %1").arg(secondsText(doubt.to)),
                           joinedWords(name, shownWords(doubtfulNamesSentence({&doubt, 1}, robot.robot.name)))});
        for (const Occlusion &occlusion : robot.occlusions)
            all.push_back({r, occlusion.span, DoubtfulStretch::Kind::Occlusion, shownWords(occlusionWords(occlusion)),
                           joinedWords(name, occlusionText(occlusion))});
    }
    std::ranges::stable_sort(all, {}, [](const DoubtfulStretch &one) { return one.span.begin; });
    return all;
}

QString doubtfulWordsAt(const std::vector<DoubtfulStretch> &stretches, Nanoseconds time, Nanoseconds reach)
{
    QStringList words;
    for (const DoubtfulStretch &one : stretches)
        if (time >= one.span.begin - reach && time <= one.span.end + reach)
            words << one.sentence.toHtmlEscaped();
    return words.isEmpty() ? QString() : QStringLiteral("<p>%1</p>").arg(words.join(QStringLiteral("<br>")));
}

} // namespace odo
