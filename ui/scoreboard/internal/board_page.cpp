// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/scoreboard/internal/board_page.h"

#include "core/analysis/run_differences.h"
#include "core/base/plain_text.h"
#include "resources/resources.h"
#include "ui/models/shown_names.h"
#include "ui/report/run_map.h"

#include <QJsonArray>
#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

namespace odo {

namespace {

/// The words of the page's frame by their names in scoreboard.html; the page has them in its own language.
constexpr std::pair<const char *, const char *> frameWords[] = {
    {"title", QT_TRANSLATE_NOOP("Scoreboard", "Standings")},
    {"team", QT_TRANSLATE_NOOP("Scoreboard", "Team")},
    {"median", QT_TRANSLATE_NOOP("Scoreboard", "Median")},
    {"gap", QT_TRANSLATE_NOOP("Scoreboard", "Gap")},
    {"best", QT_TRANSLATE_NOOP("Scoreboard", "Best")},
    {"last", QT_TRANSLATE_NOOP("Scoreboard", "Last")},
    {"runs", QT_TRANSLATE_NOOP("Scoreboard", "Runs")},
    {"rank", QT_TRANSLATE_NOOP("Scoreboard", "Rank")},
    {"bestRun", QT_TRANSLATE_NOOP("Scoreboard", "Best run")},
    {"connecting", QT_TRANSLATE_NOOP("Scoreboard", "Connecting…")},
    {"lost", QT_TRANSLATE_NOOP("Scoreboard", "Connection lost. Reconnecting…")},
    {"noScript", QT_TRANSLATE_NOOP("Scoreboard", "This page needs JavaScript.")},
    {"rule", QT_TRANSLATE_NOOP(
                 "Scoreboard",
                 "Teams rank by the median of their runs. Teams that do not differ significantly (95 %) "
                 "share a rank. ±: one standard deviation. ≈: not significantly behind the first.")},
};

/// Any name on one line, no longer than a page can show.
QString shownName(const QString &name)
{
    constexpr qsizetype longest = 80;
    const QString line = QString::fromStdString(plainLine(name.toStdString()));
    return line.size() <= longest ? line : line.left(longest - 1) + QChar(u'…');
}

QString shownName(const std::string &name)
{
    return shownName(QString::fromStdString(name));
}

QString markedNumber(const TeamRun &run, const BoardLanguage &language)
{
    const QString number = language.number(run.metric, run.metric.value, run.metric.sigma).value;
    return run.isDoubtful ? QStringLiteral("! ") + number : number;
}

/// What a value of the standings is, but for its number.
Metric plainMetric(const TeamStanding &team)
{
    Metric metric = team.runs.front().metric;
    metric.isAtLeast = false;
    return metric;
}

QJsonObject teamState(const TeamStanding &team, const TeamStanding &first, const Standings &standings,
                      const BoardLanguage &language)
{
    const auto known = [](double sigma) { return sigma > 0 ? std::optional(sigma) : std::nullopt; };
    const double sigma = team.statistics.sigma;
    const NumberText median = language.number(plainMetric(team), team.statistics.median, known(sigma));
    QJsonObject state{{QStringLiteral("rank"),
                       standings.isRanked() ? language.locale().toString(team.statistics.rank) : QString()},
                      {QStringLiteral("team"), shownName(shownTeam(team.team, team.pseudonym))},
                      {QStringLiteral("value"), median.value},
                      {QStringLiteral("sigma"), median.sigma},
                      {QStringLiteral("best"), markedNumber(team.bestRun(), language)},
                      {QStringLiteral("last"), markedNumber(team.runs.back(), language)},
                      {QStringLiteral("runs"), language.locale().toString(int(team.runs.size()))}};
    if (!standings.isRanked() || &team == &first)
        return state;
    const Difference gap{team.statistics.median - first.statistics.median,
                         std::hypot(sigma, first.statistics.sigma)};
    const QString size = language.number(plainMetric(team), std::abs(gap.value), known(gap.sigma)).value;
    state[QStringLiteral("behind")] = (gap.value < 0 ? QChar(0x2212) : QChar(u'+')) + size;
    state[QStringLiteral("isNear")] = !gap.isSignificant();
    return state;
}

QJsonArray teamStates(const Standings &standings, const BoardLanguage &language)
{
    std::set<std::string> classes;
    for (const TeamStanding &team : standings.teams)
        classes.insert(team.className);
    QJsonArray states;
    for (const TeamStanding &team : standings.teams) {
        QJsonObject state = teamState(team, standings.teams.front(), standings, language);
        if (classes.size() > 1)
            state[QStringLiteral("of")] = shownName(team.className);
        states.append(state);
    }
    return states;
}

QJsonArray notesOf(const BoardContent &content, const BoardLanguage &language)
{
    QJsonArray notes;
    const StandingsReading &reading = content.reading;
    if (content.problem)
        notes.append(QString::fromStdString(language.render(wholeMessage(*content.problem))));
    if (!reading.standings.isRanked() && !reading.standings.teams.empty())
        notes.append(language.text(
            QT_TRANSLATE_NOOP("Scoreboard", "No ranks: no trial has a task, and runs of different tasks "
                                            "cannot be compared.")));
    if (reading.leftOut > 0)
        notes.append(language.text(QT_TRANSLATE_N_NOOP("Scoreboard", "%n trial(s) not counted: analysed with "
                                                                     "a different course."),
                                   reading.leftOut));
    if (reading.bad > 0)
        notes.append(language.text(QT_TRANSLATE_N_NOOP("Scoreboard", "%n trial(s) not counted: bad results."),
                                   reading.bad));
    int doubtful = 0;
    for (const TeamStanding &team : reading.standings.teams)
        doubtful += team.doubtfulRuns();
    if (doubtful > 0)
        notes.append(language.text(
            QT_TRANSLATE_N_NOOP("Scoreboard", "! %n trial(s) with doubtful results counted."), doubtful));
    return notes;
}

} // namespace

QByteArray boardPage(const BoardLanguage &language)
{
    QString page = QString::fromUtf8(resourceBytes(QStringLiteral("scoreboard/scoreboard.html")));
    page.replace(QStringLiteral("{{language}}"), QString::fromLatin1(language.tag()));
    for (const auto &[name, words] : frameWords)
        page.replace(QStringLiteral("{{%1}}").arg(QLatin1String(name)), language.text(words).toHtmlEscaped());
    return page.toUtf8();
}

QJsonObject boardState(const BoardContent &content, const BoardLanguage &language, Instant now)
{
    const Standings &standings = content.reading.standings;
    const StandingsChoice &choice = standings.choice;
    QJsonArray facts;
    if (!choice.className.empty())
        facts.append(shownName(choice.className));
    if (!choice.metric.empty())
        facts.append(language.metric(choice.metric));
    QJsonObject state{{QStringLiteral("task"), shownName(choice.task)},
                      {QStringLiteral("facts"), facts},
                      {QStringLiteral("teams"), teamStates(standings, language)},
                      {QStringLiteral("notes"), notesOf(content, language)}};
    if (standings.teams.empty())
        state[QStringLiteral("empty")] =
            language.text(QT_TRANSLATE_NOOP("Scoreboard", "No team has a result yet."));
    else
        state[QStringLiteral("unit")] = language.number(plainMetric(standings.teams.front()), 0, {}).unit;
    if (content.running) {
        using Seconds = std::chrono::duration<double>;
        const RunningRecording &running = *content.running;
        state[QStringLiteral("running")] = QJsonObject{
            {QStringLiteral("team"), shownName(shownTeam(running.team, running.pseudonym))},
            {QStringLiteral("words"), language.text(QT_TRANSLATE_NOOP("Scoreboard", "Running now"))},
            {QStringLiteral("seconds"), std::max(0.0, Seconds(now - running.since).count())}};
    }
    if (content.scene) {
        const NumberText best = language.number(*content.best, content.best->value, content.best->sigma);
        state[QStringLiteral("map")] = qint64(content.mapVersion);
        state[QStringLiteral("mapWords")] = QStringLiteral("%1 · %2").arg(
            shownName(shownTeam(content.bestTeam, content.bestPseudonym)), best.text());
    }
    return state;
}

QByteArray boardMap(const BoardContent &content, const BoardLanguage &language)
{
    if (!content.scene)
        return {};
    return runMap(*content.scene, content.robot,
                  {language.text(QT_TRANSLATE_NOOP("Scoreboard", "The best run from above")),
                   language.text(QT_TRANSLATE_NOOP("Scoreboard", "a square: %1")), language.locale()})
        .toUtf8();
}

} // namespace odo
