// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/school/internal/hub_queries.h"

#include <QStringList>

namespace odo::hubQueries {

namespace {

QVariant textValue(const std::string &text)
{
    return QString::fromStdString(text);
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

    void add(const QString &condition, const QVariantList &itsValues)
    {
        texts << condition;
        values << itsValues;
    }
    QString where() const
    {
        return texts.isEmpty() ? QString()
                               : QStringLiteral("WHERE ") + texts.join(QStringLiteral(" AND ")) + u' ';
    }
};

/// A value of a column as the server compares it.
QString placeholderOf(const QString &column)
{
    return column == QLatin1String("owner") ? QStringLiteral("CAST(? AS name)") : QStringLiteral("?");
}

/// A column that has one value only, but not by "=": an order by it first is then that of its own index and
/// of no other. With "=" the server takes the index of all times where it thinks that the value is frequent,
/// and goes through years of others if it was so long ago.
void addLeading(Conditions &conditions, const QString &column, const std::string &value)
{
    conditions.texts << column + QStringLiteral(" BETWEEN %1 AND %1").arg(placeholderOf(column));
    conditions.values << textValue(value) << textValue(value);
}

/// The index by which a list is read: that of a class, of a task or of a bench, or of all times; a team has
/// few runs, so any will do.
struct Leading
{
    QString column;
    const std::string *value = nullptr;
};

Leading leadingOf(const HubRunFilter &filter)
{
    if (!filter.team.empty())
        return {};
    if (!filter.className.empty())
        return {QStringLiteral("class"), &filter.className};
    if (!filter.task.empty())
        return {QStringLiteral("task"), &filter.task};
    if (!filter.bench.empty())
        return {QStringLiteral("owner"), &filter.bench};
    return {};
}

Conditions conditionsOf(const HubRunFilter &filter, const HubRun *after)
{
    Conditions conditions;
    const Leading leading = leadingOf(filter);
    for (const auto &[column, value] :
         {std::pair{"class", &filter.className}, std::pair{"shown_team", &filter.team},
          std::pair{"task", &filter.task}, std::pair{"owner", &filter.bench}}) {
        const QString name = QLatin1String(column);
        if (!value->empty() && name == leading.column)
            addLeading(conditions, name, *value);
        else if (!value->empty())
            conditions.add(name + QStringLiteral(" = ") + placeholderOf(name), {textValue(*value)});
    }
    if (!after)
        return conditions;
    const bool isLed = leading.value != nullptr;
    if (isLed)
        conditions.values << textValue(*leading.value);
    conditions.add(
        QStringLiteral("(%1held, trial, robot) < (%2to_timestamp(CAST(? AS double precision) / "
                       "1000), CAST(? AS uuid), ?)")
            .arg(isLed ? leading.column + QStringLiteral(", ") : QString(),
                 isLed ? placeholderOf(leading.column) + QStringLiteral(", ") : QString()),
        {qint64(after->held.time_since_epoch().count()), textValue(after->trial), textValue(after->robot)});
    return conditions;
}

} // namespace

HubQuery resultState()
{
    return {QStringLiteral("SELECT number FROM odograph.result_state")};
}

HubQuery standings(const StandingsChoice &choice)
{
    Conditions conditions{{QStringLiteral("r.task = ?")}, {textValue(choice.metric), textValue(choice.task)}};
    if (!choice.className.empty())
        conditions.add(QStringLiteral("class = ?"), {textValue(choice.className)});
    return {
        QStringLiteral(
            "SELECT r.trial, r.robot, shown_team, class, CAST(extract(epoch FROM held) * 1000 AS bigint), "
            "standing, unit, value, sigma, at_least FROM odograph.result r LEFT JOIN odograph.metric m "
            "ON m.task = r.task AND m.trial = r.trial AND m.robot = r.robot AND m.name = ? "
            "%1ORDER BY held, r.trial, r.robot")
            .arg(conditions.where()),
        conditions.values};
}

HubQuery newestTask(const std::string &className)
{
    Conditions conditions{{QStringLiteral("task <> ''")}, {}};
    if (!className.empty())
        addLeading(conditions, QStringLiteral("class"), className);
    return {QStringLiteral("SELECT task FROM odograph.result %1ORDER BY %2held DESC, trial DESC, robot DESC "
                           "LIMIT 1")
                .arg(conditions.where(), className.empty() ? QString() : QStringLiteral("class DESC, ")),
            conditions.values};
}

HubQuery metricNames(const StandingsChoice &choice)
{
    Conditions conditions;
    addLeading(conditions, QStringLiteral("task"), choice.task);
    if (!choice.className.empty())
        conditions.add(QStringLiteral("class = ?"), {textValue(choice.className)});
    return {QStringLiteral("SELECT DISTINCT m.name FROM (SELECT trial, robot FROM odograph.result "
                           "%1ORDER BY task DESC, held DESC LIMIT 200) r "
                           "JOIN odograph.metric m ON m.trial = r.trial AND m.robot = r.robot")
                .arg(conditions.where()),
            conditions.values};
}

HubQuery runs(const HubRunFilter &filter, TextSearch search, bool withNames, const HubRun *after, int most)
{
    const QString searched = withNames ? QStringLiteral("searched") : QStringLiteral("lower(shown_team)");
    const QString leading = leadingOf(filter).column;
    const QString order = QStringLiteral("ORDER BY %1held DESC, trial DESC, robot DESC LIMIT ")
                              .arg(leading.isEmpty() ? leading : leading + QStringLiteral(" DESC, "));
    const QString columns =
        QStringLiteral(
            "SELECT trial, robot, %1 AS name, shown_team, class, task, held, duration_s, standing, "
            "%2 AS searched, %3 AS owner FROM odograph.result ")
            .arg(withNames ? QStringLiteral("name") : QStringLiteral("''"), searched,
                 withNames ? QStringLiteral("owner") : QStringLiteral("''"));
    Conditions conditions = conditionsOf(filter, after);
    QString source;
    if (filter.search.empty()) {
        source = columns + conditions.where() + order + QStringLiteral("CAST(? AS integer)");
    } else if (search == TextSearch::InNewest) {
        source = QStringLiteral("SELECT * FROM (%1) newest WHERE searched LIKE ? %2CAST(? AS integer)")
                     .arg(columns + conditions.where() + order + QStringLiteral("20000"), order);
        conditions.values << pattern(filter.search);
    } else {
        conditions.add(searched + QStringLiteral(" LIKE ?"), {pattern(filter.search)});
        source = QStringLiteral("WITH found AS MATERIALIZED (%1) SELECT * FROM found %2CAST(? AS integer)")
                     .arg(columns + conditions.where(), order);
    }
    return {QStringLiteral(
                "SELECT r.trial, r.robot, r.name, shown_team, class, r.task, "
                "CAST(extract(epoch FROM held) * 1000 AS bigint), duration_s, standing, unit, value, sigma, "
                "at_least, r.owner FROM (%1) r LEFT JOIN odograph.metric m ON m.trial = r.trial AND "
                "m.robot = r.robot AND m.name = ? ORDER BY held DESC, r.trial DESC, r.robot DESC")
                .arg(source),
            conditions.values << most << textValue(filter.metric)};
}

HubQuery benches()
{
    return {QStringLiteral(
        "WITH RECURSIVE one AS ((SELECT owner FROM odograph.result ORDER BY owner LIMIT 1) UNION ALL "
        "SELECT (SELECT r.owner FROM odograph.result r WHERE r.owner > one.owner ORDER BY r.owner LIMIT 1) "
        "FROM one WHERE one.owner IS NOT NULL) SELECT owner FROM one WHERE owner IS NOT NULL")};
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
