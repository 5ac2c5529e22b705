// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/school/internal/hub_queries.h"

#include <QStringList>

namespace odo::hubQueries {

namespace {

QVariant textValue(const std::string &text)
{
    return QString::fromStdString(text);
}

/// Adds the class where it is one.
HubQuery ofClass(const QString &text, QVariantList values, const std::string &className)
{
    if (!className.empty())
        values << textValue(className);
    return {text.arg(className.empty() ? QString() : QStringLiteral("AND class = ? ")), values};
}

/// As it is, anywhere in a text.
QString pattern(const std::string &search)
{
    QString text = QString::fromStdString(search).toLower();
    for (const QChar special : {u'\\', u'%', u'_'})
        text.replace(special, QStringLiteral("\\") + special);
    return u'%' + text + u'%';
}

/// What a list of runs is limited to.
struct Conditions
{
    QStringList texts;
    QVariantList values;

    void add(const char *condition, const QVariantList &itsValues)
    {
        texts << QLatin1String(condition);
        values << itsValues;
    }
    QString where() const
    {
        return texts.isEmpty() ? QString()
                               : QStringLiteral("WHERE ") + texts.join(QStringLiteral(" AND ")) + u' ';
    }
};

Conditions conditionsOf(const HubRunFilter &filter, const HubRun *after)
{
    Conditions conditions;
    for (const auto &[condition, value] :
         {std::pair{"class = ?", &filter.className}, std::pair{"shown_team = ?", &filter.team},
          std::pair{"task = ?", &filter.task}})
        if (!value->empty())
            conditions.add(condition, {textValue(*value)});
    if (after)
        conditions.add(
            "(held, trial, robot) < (to_timestamp(CAST(? AS double precision) / 1000), CAST(? AS uuid), ?)",
            {qint64(after->held.time_since_epoch().count()), textValue(after->trial),
             textValue(after->robot)});
    return conditions;
}

} // namespace

HubQuery resultState()
{
    return {QStringLiteral("SELECT number FROM odograph.result_state")};
}

HubQuery standings(const StandingsChoice &choice)
{
    return ofClass(
        QStringLiteral(
            "SELECT r.trial, r.robot, shown_team, class, CAST(extract(epoch FROM held) * 1000 AS bigint), "
            "standing, unit, value, sigma, at_least FROM odograph.result r LEFT JOIN odograph.metric m "
            "ON m.task = r.task AND m.trial = r.trial AND m.robot = r.robot AND m.name = ? "
            "WHERE r.task = ? %1ORDER BY held, r.trial, r.robot"),
        {textValue(choice.metric), textValue(choice.task)}, choice.className);
}

HubQuery newestTask(const std::string &className)
{
    return ofClass(QStringLiteral("SELECT task FROM odograph.result WHERE task <> '' %1"
                                  "ORDER BY held DESC, trial DESC, robot DESC LIMIT 1"),
                   {}, className);
}

HubQuery metricNames(const StandingsChoice &choice)
{
    return ofClass(QStringLiteral("SELECT DISTINCT m.name FROM (SELECT trial, robot FROM odograph.result "
                                  "WHERE task = ? %1ORDER BY held DESC LIMIT 200) r "
                                  "JOIN odograph.metric m ON m.trial = r.trial AND m.robot = r.robot"),
                   {textValue(choice.task)}, choice.className);
}

HubQuery runs(const HubRunFilter &filter, TextSearch search, bool withNames, const HubRun *after, int most)
{
    const QString searched = withNames ? QStringLiteral("lower(name || ' ' || team || ' ' || shown_team)")
                                       : QStringLiteral("lower(shown_team)");
    const QString order = QStringLiteral("ORDER BY held DESC, trial DESC, robot DESC LIMIT ");
    const QString columns = QStringLiteral("SELECT trial, robot, %1 AS name, shown_team, class, task, held, "
                                           "duration_s, standing, %2 AS searched FROM odograph.result ")
                                .arg(withNames ? QStringLiteral("name") : QStringLiteral("''"), searched);
    Conditions conditions = conditionsOf(filter, after);
    QString source;
    if (filter.search.empty()) {
        source = columns + conditions.where() + order + QStringLiteral("CAST(? AS integer)");
    } else if (search == TextSearch::InNewest) {
        source = QStringLiteral("SELECT * FROM (%1) newest WHERE searched LIKE ? %2CAST(? AS integer)")
                     .arg(columns + conditions.where() + order + QStringLiteral("20000"), order);
        conditions.values << pattern(filter.search);
    } else {
        conditions.add(withNames ? "lower(name || ' ' || team || ' ' || shown_team) LIKE ?"
                                 : "lower(shown_team) LIKE ?",
                       {pattern(filter.search)});
        source = QStringLiteral("WITH found AS MATERIALIZED (%1) SELECT * FROM found %2CAST(? AS integer)")
                     .arg(columns + conditions.where(), order);
    }
    return {QStringLiteral(
                "SELECT r.trial, r.robot, r.name, shown_team, class, r.task, "
                "CAST(extract(epoch FROM held) * 1000 AS bigint), duration_s, standing, unit, value, sigma, "
                "at_least FROM (%1) r LEFT JOIN odograph.metric m ON m.trial = r.trial AND m.robot = r.robot "
                "AND m.name = ? ORDER BY held DESC, r.trial DESC, r.robot DESC")
                .arg(source),
            conditions.values << most << textValue(filter.metric)};
}

HubQuery publish(const QVariantList &document)
{
    return {QStringLiteral("SELECT outcome, kept_uuid, kept_revision, kept_owner, other FROM "
                           "odograph.publish(CAST(? AS uuid), ?, ?, CAST(? AS uuid), CAST(? AS bigint), ?, "
                           "CAST(? AS bytea), CAST(? AS bytea), CAST(? AS jsonb), CAST(? AS boolean))"),
            document};
}

HubQuery setStandings(const std::string &bench, const QString &standings)
{
    return {QStringLiteral("SELECT odograph.set_standings(CAST(? AS uuid), CAST(? AS jsonb))"),
            {textValue(bench), standings}};
}

HubQuery since(std::int64_t revision, const std::string &bench, int most)
{
    return {
        QStringLiteral("SELECT uuid, kind, name, owner, revision, removed, sha256, body FROM "
                       "odograph.document WHERE revision > CAST(? AS bigint) AND bench <> CAST(? AS uuid) "
                       "ORDER BY revision LIMIT CAST(? AS integer)"),
        {qint64(revision), textValue(bench), most}};
}

HubQuery recordings(const std::string &trial)
{
    return {QStringLiteral("SELECT body FROM odograph.recording WHERE trial = CAST(? AS uuid)"),
            {textValue(trial)}};
}

HubQuery document(const std::string &uuid)
{
    return {QStringLiteral("SELECT kind, name, owner, sha256, body FROM odograph.document "
                           "WHERE uuid = CAST(? AS uuid)"),
            {textValue(uuid)}};
}

HubQuery revision(const std::string &uuid)
{
    return {QStringLiteral("SELECT revision FROM odograph.document WHERE uuid = CAST(? AS uuid)"),
            {textValue(uuid)}};
}

} // namespace odo::hubQueries
