// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/answers.h"
#include "app/command_call.h"
#include "app/commands/commands.h"
#include "core/base/platform/sleep_inhibitor.h"
#include "core/base/units.h"
#include "core/project/repositories.h"
#include "core/workflow/track/reanalysis.h"
#include "core/workflow/track/track_job.h"

#include <algorithm>

namespace odo {

namespace {

QJsonObject robotJson(const TrackedRobot &robot)
{
    const Profile &profile = robot.analysis.profile;
    QJsonObject json{
        {QStringLiteral("frames"), qint64(robot.frames)},
        {QStringLiteral("tracked"), qint64(robot.tracked)},
        {QStringLiteral("spikes"), qint64(profile.spikes.size())},
        {QStringLiteral("mean_view_disagreement_mm"), toMillimetres(profile.meanViewDisagreementM)},
        {QStringLiteral("look"), robot.isFoundByColour ? QStringLiteral("colour") : QStringLiteral("any")},
        {QStringLiteral("height_m"), profile.heightM}};
    insertMainMetrics(json, profile);
    json.insert(QStringLiteral("clearance_mm"),
                profile.clearanceM ? QJsonValue(toMillimetres(*profile.clearanceM)) : QJsonValue());
    json.insert(QStringLiteral("doubtful_s"), optionalJson(robot.ambiguousS));
    json.insert(QStringLiteral("doubts"), ambiguitiesJson(robot.analysis.ambiguousNames));
    json.insert(QStringLiteral("occlusions"), occlusionsJson(robot.occlusions));
    insertMeasuredTime(json, profile);
    insertTaskAnswers(json, profile);
    return json;
}

QString robotText(const TrackedRobot &robot)
{
    const Profile &profile = robot.analysis.profile;
    const QString found = QStringLiteral("%1 of %2 frames, %3, ")
                              .arg(robot.tracked)
                              .arg(robot.frames)
                              .arg(counted(profile.spikes.size(), QStringLiteral("spike")));
    return QString::fromStdString(robot.name) + QStringLiteral(": ") + found + mainMetricsText(profile) +
           taskRemark(profile);
}

/// "R=VIEW,SECONDS,X,Y", or "R=none".
Result<std::vector<RobotPointer>> pointersOf(const CommandCall &call)
{
    const auto pairs = ODO_TRY(call.pairs(option::at));
    constexpr qsizetype figures = 3;
    std::vector<RobotPointer> pointers;
    for (const auto &[robot, where] : pairs) {
        RobotPointer &pointer = pointers.emplace_back(RobotPointer{robot, {}});
        if (where == "none")
            continue;
        const QStringList parts = QString::fromStdString(where).split(u',');
        const qsizetype first = parts.size() - figures;
        const bool isComplete = first > 0;
        const auto figure = [&](qsizetype i) {
            return isComplete ? parseNumber(parts[first + i].toStdString()) : Result<double>();
        };
        const auto time = figure(0), x = figure(1), y = figure(2);
        if (!isComplete || !time || !x || !y)
            return call.wrongCall(
                ODO_TEXT("app.not_a_pointer",
                         "--at '%1=%2' is not of the form R=VIEW,SECONDS,X,Y or R=none")(robot, where));
        pointer.view = parts.first(first).join(u',').toStdString();
        pointer.timeS = *time;
        pointer.pixel = {*x, *y};
    }
    return pointers;
}

/// Numbers between commas; nullopt where one is none.
std::optional<std::vector<double>> numbersOf(const std::string &text)
{
    std::vector<double> numbers;
    for (const QString &part : QString::fromStdString(text).split(u',')) {
        const auto number = parseNumber(part.toStdString());
        if (!number)
            return std::nullopt;
        numbers.push_back(*number);
    }
    return numbers;
}

/// "R@A" in two; the last @ counts.
std::pair<std::string, std::string> robotAndView(const std::string &where)
{
    const std::size_t at = where.rfind('@');
    return at == std::string::npos ? std::pair(where, std::string())
                                   : std::pair(where.substr(0, at), where.substr(at + 1));
}

/// "R@A:SECONDS=X,Y": further marks of robots. The last @ and : count, for names may have some.
Result<std::vector<RobotPointer>> seedsOf(const CommandCall &call)
{
    const auto pairs = ODO_TRY(call.pairs(option::seed));
    std::vector<RobotPointer> seeds;
    for (const auto &[where, pixel] : pairs) {
        const std::size_t colon = where.rfind(':');
        const auto [robot, view] = robotAndView(where.substr(0, colon));
        const auto time = colon == std::string::npos ? std::nullopt : numbersOf(where.substr(colon + 1)),
                   point = numbersOf(pixel);
        if (robot.empty() || view.empty() || !time || time->size() != 1 || !point || point->size() != 2)
            return call.wrongCall(ODO_TEXT(
                "app.not_a_seed", "--seed '%1=%2' is not of the form R@A:SECONDS=X,Y")(where, pixel));
        seeds.push_back({robot, view, time->front(), {point->front(), point->back()}, true});
    }
    return seeds;
}

/// "VIEW=x,y,x,y,x,y": the corners of an area.
Result<void> addAreas(const CommandCall &call, const QString &option, GuidanceItem::Kind kind,
                      GuidanceEdit &edit)
{
    const auto pairs = ODO_TRY(call.pairs(option));
    for (const auto &[view, corners] : pairs) {
        GivenGuidance area{kind, view, {}};
        const auto numbers = numbersOf(corners);
        if (!numbers || numbers->size() % 2 != 0)
            return call.wrongCall(
                ODO_TEXT("app.not_an_area", "--%1 '%2=%3' is not of the form A=X,Y,X,Y,X,Y…")(
                    option.toStdString(), view, corners));
        for (std::size_t i = 0; i < numbers->size(); i += 2)
            area.pointsPx.emplace_back((*numbers)[i], (*numbers)[i + 1]);
        edit.added.push_back(std::move(area));
    }
    return {};
}

/// "R@A=SECONDS,X,Y,SIGMA" and "R[@A]=FROM,TO".
Result<void> addByHand(const CommandCall &call, GuidanceEdit &edit)
{
    const auto points = ODO_TRY(call.pairs(option::point));
    for (const auto &[where, what] : points) {
        const auto [robot, view] = robotAndView(where);
        const auto numbers = numbersOf(what);
        if (view.empty() || !numbers || numbers->size() != 4)
            return call.wrongCall(ODO_TEXT(
                "app.not_a_point", "--point '%1=%2' is not of the form R@A=SECONDS,X,Y,SIGMA")(where, what));
        edit.added.push_back({GuidanceItem::Kind::Point,
                              view,
                              {{(*numbers)[1], (*numbers)[2]}},
                              robot,
                              (*numbers)[0],
                              (*numbers)[0],
                              (*numbers)[3]});
    }
    const auto hidden = ODO_TRY(call.pairs(option::hidden));
    for (const auto &[where, what] : hidden) {
        const auto [robot, view] = robotAndView(where);
        const auto numbers = numbersOf(what);
        if (!numbers || numbers->size() != 2 || (*numbers)[0] > (*numbers)[1])
            return call.wrongCall(
                ODO_TEXT("app.not_hidden",
                         "--hidden '%1=%2' is not of the form R=FROM,TO or R@A=FROM,TO")(where, what));
        edit.added.push_back({GuidanceItem::Kind::Hidden, view, {}, robot, (*numbers)[0], (*numbers)[1], 0});
    }
    return {};
}

Result<GuidanceEdit> guidanceOf(const CommandCall &call)
{
    GuidanceEdit edit;
    edit.clearsAll = call.isSet(option::clearGuidance);
    ODO_TRY(addAreas(call, option::ignore, GuidanceItem::Kind::Ignore, edit));
    ODO_TRY(addAreas(call, option::search, GuidanceItem::Kind::Search, edit));
    ODO_TRY(addByHand(call, edit));
    return edit;
}

} // namespace

Result<void> runTrack(const QStringList &arguments, const CancelToken &cancel)
{
    CommandCall call(
        {QStringLiteral("track"),
         QStringLiteral("P.odo TRIAL [--robot R]... [--at R=VIEW,SECONDS,X,Y]... "
                        "[--seed R@A:SECONDS=X,Y]... [--ignore A=X,Y,X,Y,X,Y]... [--search A=X,Y,X,Y,X,Y]... "
                        "[--point R@A=SECONDS,X,Y,SIGMA]... [--hidden R=FROM,TO|R@A=FROM,TO]... "
                        "[--clear-guidance] [--smoother rts|savgol|tracker|none] [--again] [--json]"),
         2,
         2,
         {{option::robot, QStringLiteral("A robot to track."), QStringLiteral("R")},
          {option::at,
           QStringLiteral("Where a robot is in a frame, in pixels, if something else was tracked: the only "
                          "mark of it in that view; R=none clears all."),
           QStringLiteral("R=VIEW,SECONDS,X,Y")},
          {option::seed,
           QStringLiteral("A further mark: the robot is followed from there forwards and backwards."),
           QStringLiteral("R@A:SECONDS=X,Y")},
          {option::ignore,
           QStringLiteral("An area of a view to ignore: its corners in pixels. Stored with the trial."),
           QStringLiteral("A=X,Y,X,Y,X,Y")},
          {option::search,
           QStringLiteral("An area of a view to search; all else is ignored. Stored with the trial."),
           QStringLiteral("A=X,Y,X,Y,X,Y")},
          {option::point,
           QStringLiteral("Where a robot's middle is in a frame of a view, by hand, with its uncertainty in "
                          "pixels. Stored with the trial."),
           QStringLiteral("R@A=SECONDS,X,Y,SIGMA")},
          {option::hidden,
           QStringLiteral("A robot is not visible between two times, in all views or in one. Stored with the "
                          "trial."),
           QStringLiteral("R=FROM,TO|R@A=FROM,TO")},
          {option::clearGuidance,
           QStringLiteral("Remove the areas, points and times stored with the trial first.")},
          {option::smoother, QStringLiteral("How the curves are smoothed."), QStringLiteral("NAME")},
          {option::again,
           QStringLiteral("Reanalyse the stored observations, without decoding the videos.")}}},
        cancel);
    if (const auto parsed = call.parse(arguments); !parsed || !*parsed)
        return parsed.map([](bool) {});
    TrackSettings settings;
    settings.robots = call.texts(option::robot);
    settings.again = call.isSet(option::again);
    if (call.isSet(option::smoother)) {
        const auto known = parseSmoother(call.value(option::smoother));
        if (!known)
            return call.wrongCall(ODO_TEXT("app.smoother_is", "--smoother is rts, savgol, tracker or none"));
        settings.smoother = *known;
    }
    auto pointers = ODO_TRY(pointersOf(call));
    auto seeds = ODO_TRY(seedsOf(call));
    std::ranges::move(seeds, std::back_inserter(pointers));
    if (settings.again && !pointers.empty())
        return call.wrongCall(ODO_TEXT("app.at_needs_videos",
                                       "--at and --seed need the videos, and --again does not read them"));
    settings.pointers = std::move(pointers);
    auto guidance = ODO_TRY(guidanceOf(call));
    if (settings.again && (guidance.clearsAll || call.isSet(option::ignore) || call.isSet(option::search)))
        return call.wrongCall(ODO_TEXT("app.areas_need_videos",
                                       "--ignore, --search and --clear-guidance need the videos, and "
                                       "--again does not read them"));
    settings.guidance = std::move(guidance);
    const auto project = ODO_TRY(call.openProject(0, Project::Access::ReadWrite));
    TrackJob job(call.text(1), std::move(settings));
    const auto awake = SleepInhibitor::take("tracking");
    ODO_TRY(runToEnd(job, *project, call.control()));
    const TrackOutcome &outcome = job.outcome();
    QJsonObject robots;
    QStringList lines;
    for (const TrackedRobot &tracked : outcome.robots) {
        robots.insert(QString::fromStdString(tracked.name), robotJson(tracked));
        lines << robotText(tracked);
    }
    const auto trial = ODO_TRY(project->trials().find(outcome.trial));
    if (trial.range)
        lines << english(rangeSentence(trial));
    call.answer({{QStringLiteral("trial"), QString::fromStdString(outcome.trial)},
                 {QStringLiteral("range"), rangeJson(trial)},
                 {QStringLiteral("robots"), robots},
                 {QStringLiteral("warnings"), sentencesJson(outcome.warnings)},
                 {QStringLiteral("wall_s"), outcome.wallS},
                 {QStringLiteral("decode_s"), outcome.decodeS},
                 {QStringLiteral("frames_per_s"), outcome.framesPerSecond}},
                lines.join(u'\n'));
    for (const Message &warning : outcome.warnings)
        CommandCall::warn(warning);
    return {};
}

namespace {

/// "FROM,TO" and the reason that the samples have.
Result<SampleGroup> groupOf(const CommandCall &call)
{
    const auto ends = numbersOf(call.value(option::range));
    if (!ends || ends->size() != 2 || ends->front() > ends->back())
        return call.wrongCall(
            ODO_TEXT("app.flag_range_is", "--range takes FROM,TO in seconds, FROM not after TO"));
    SampleGroup group{ends->front(), ends->back(), 0};
    if (!call.isSet(option::reason))
        return group;
    for (SampleFlags bit = 1; bit <= flagBit(SampleFlag::ByHand); bit <<= 1)
        if (flagNames(bit) == call.value(option::reason))
            group.reasons = bit;
    if (group.reasons == 0)
        return call.isNoneOf(option::reason,
                             "jump, speed_limit, acceleration_limit, views_disagree, low_score, "
                             "duplicate_frame or by_hand");
    return group;
}

Result<OverrideRequest> requestOf(const CommandCall &call)
{
    if (int(call.isSet(option::spike)) + int(call.isSet(option::valid)) + int(call.isSet(option::clear)) != 1)
        return call.wrongCall(
            ODO_TEXT("app.flag_needs_word", "one of --spike, --valid and --clear is needed"));
    if (int(call.isSet(option::time)) + int(call.isSet(option::frame)) + int(call.isSet(option::range)) != 1)
        return call.wrongCall(
            ODO_TEXT("app.flag_needs_moment", "one of --time, --frame and --range is needed"));
    if (call.isSet(option::reason) && !call.isSet(option::range))
        return call.lacks(option::reason, option::range);
    OverrideRequest request;
    request.trial = call.text(1);
    request.robot = call.value(option::robot);
    request.word = call.isSet(option::spike)   ? OverrideRequest::Word::Spike
                   : call.isSet(option::valid) ? OverrideRequest::Word::Valid
                                               : OverrideRequest::Word::Clear;
    if (call.isSet(option::range)) {
        request.group = ODO_TRY(groupOf(call));
        return request;
    }
    const auto number = ODO_TRY(call.number(call.isSet(option::time) ? option::time : option::frame));
    if (call.isSet(option::time) && std::abs(number) > 1e9)
        return call.wrongCall(
            ODO_TEXT("app.time_takes", "--time takes seconds from -1,000,000,000 to 1,000,000,000"));
    if (call.isSet(option::time))
        request.timeS = number;
    else if (number != std::floor(number) || std::abs(number) > 1e9)
        return call.wrongCall(ODO_TEXT("app.frame_is", "--frame is a whole number"));
    else
        request.frame = static_cast<std::int64_t>(number);
    return request;
}

QString wordsOf(OverrideRequest::Word word)
{
    switch (word) {
    case OverrideRequest::Word::Spike:
        return QStringLiteral("marked as a spike by hand");
    case OverrideRequest::Word::Valid:
        return QStringLiteral("marked as valid by hand");
    case OverrideRequest::Word::Clear:
        break;
    }
    return QStringLiteral("manual override removed");
}

} // namespace

Result<void> runFlag(const QStringList &arguments, const CancelToken &cancel)
{
    CommandCall call(
        {QStringLiteral("flag"),
         QStringLiteral("P.odo TRIAL [--robot R] --time SECONDS|--frame N|--range FROM,TO [--reason FLAG] "
                        "(--spike|--valid|--clear) [--json]"),
         2,
         2,
         {{option::robot, QStringLiteral("The robot, if the trial has several."), QStringLiteral("R")},
          {option::time, QStringLiteral("The sample nearest to this time."), QStringLiteral("SECONDS")},
          {option::frame, QStringLiteral("The sample of this frame of the first view."), QStringLiteral("N")},
          {option::range, QStringLiteral("All samples between two times, in seconds, that this changes."),
           QStringLiteral("FROM,TO")},
          {option::reason, QStringLiteral("Of these only those with this flag, such as jump."),
           QStringLiteral("FLAG")},
          {option::spike, QStringLiteral("Mark it as a spike.")},
          {option::valid, QStringLiteral("Mark it as valid.")},
          {option::clear, QStringLiteral("Remove the manual override.")}}},
        cancel);
    if (const auto parsed = call.parse(arguments); !parsed || !*parsed)
        return parsed.map([](bool) {});
    const auto request = ODO_TRY(requestOf(call));
    const auto project = ODO_TRY(call.openProject(0, Project::Access::ReadWrite));
    OverrideJob job(request);
    ODO_TRY(runToEnd(job, *project, call.control()));
    const OverrideOutcome &outcome = job.outcome();
    const Profile &profile = outcome.analysis.profile;
    call.answer({{QStringLiteral("trial"), call.positional(1)},
                 {QStringLiteral("robot"), QString::fromStdString(outcome.robot)},
                 {QStringLiteral("count"), qint64(outcome.count)},
                 {QStringLiteral("frame"), qint64(outcome.frame)},
                 {QStringLiteral("t_s"), toSeconds(outcome.time)},
                 {QStringLiteral("flags"), QString::fromStdString(flagNames(outcome.flags))},
                 {QStringLiteral("used"), !isRejected(outcome.flags)},
                 {QStringLiteral("spikes"), qint64(profile.spikes.size())},
                 {QStringLiteral("analysis"), qint64(outcome.analysis.id)},
                 {QStringLiteral("metrics"), metricsJson(profile.metrics)}},
                QStringLiteral("%1, %2: %3. The trial was reanalysed; it has %4.")
                    .arg(QString::fromStdString(outcome.robot))
                    .arg(outcome.count > 1 ? counted(outcome.count, QStringLiteral("sample"))
                                           : QStringLiteral("frame %1 at %2 s")
                                                 .arg(outcome.frame)
                                                 .arg(toSeconds(outcome.time), 0, 'f', 3))
                    .arg(wordsOf(request.word))
                    .arg(counted(profile.spikes.size(), QStringLiteral("spike"))));
    return {};
}

namespace {

QJsonObject changeJson(const ProfileChange &change)
{
    QJsonArray metrics;
    for (const MetricChange &metric : change.metrics)
        metrics.append(QJsonObject{{QStringLiteral("name"), QString::fromStdString(metric.name)},
                                   {QStringLiteral("unit"), QString::fromStdString(metric.unit)},
                                   {QStringLiteral("before"), optionalJson(metric.before)},
                                   {QStringLiteral("after"), optionalJson(metric.after)},
                                   {QStringLiteral("sigma"), optionalJson(metric.sigma)}});
    return {{QStringLiteral("largest_shift_mm"), toMillimetres(change.largestShiftM)},
            {QStringLiteral("largest_at_s"), toSeconds(change.largestAt)},
            {QStringLiteral("rms_shift_mm"), toMillimetres(change.rmsShiftM)},
            {QStringLiteral("spikes_before"), qint64(change.spikesBefore)},
            {QStringLiteral("spikes_after"), qint64(change.spikesAfter)},
            {QStringLiteral("metrics"), metrics},
            {QStringLiteral("verdict"), english(change.words)}};
}

} // namespace

Result<void> runReprocess(const QStringList &arguments, const CancelToken &cancel)
{
    CommandCall call(
        {QStringLiteral("reprocess"),
         QStringLiteral("P.odo TRIAL [--keep] [--json]"),
         2,
         2,
         {{option::keep, QStringLiteral("Store the new analyses. Without it, only the changes are shown.")}}},
        cancel);
    if (const auto parsed = call.parse(arguments); !parsed || !*parsed)
        return parsed.map([](bool) {});
    const auto project = ODO_TRY(call.openProject(0, call.isSet(option::keep) ? Project::Access::ReadWrite
                                                                              : Project::Access::ReadOnly));
    ReprocessJob job(call.text(1));
    ODO_TRY(runToEnd(job, *project, call.control()));
    if (call.isSet(option::keep))
        ODO_TRY(job.keep(*project));
    QJsonObject robots;
    QStringList lines;
    for (const ReprocessedRobot &robot : job.robots()) {
        robots.insert(QString::fromStdString(robot.name), changeJson(robot.change));
        lines << QStringLiteral("%1: %2").arg(QString::fromStdString(robot.name),
                                              english(robot.change.words));
    }
    if (!call.isSet(option::keep))
        lines << QStringLiteral("Nothing was stored; --keep stores it.");
    call.answer({{QStringLiteral("trial"), call.positional(1)},
                 {QStringLiteral("robots"), robots},
                 {QStringLiteral("kept"), call.isSet(option::keep)}},
                lines.join(u'\n'));
    return {};
}

} // namespace odo
