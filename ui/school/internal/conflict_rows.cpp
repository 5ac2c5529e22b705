// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/school/internal/conflict_rows.h"

#include "ui/models/number_text.h"
#include "ui/models/shown_names.h"

#include <QCoreApplication>
#include <QJsonArray>
#include <QJsonObject>
#include <QLocale>
#include <algorithm>
#include <map>

namespace odo {

namespace {

constexpr std::size_t mostRows = 300;
constexpr qsizetype longestValue = 300;

class ConflictWords
{
    Q_DECLARE_TR_FUNCTIONS(Conflict)
};

/// The keys of documents that people know; others as they are.
QString keyWords(const QString &key)
{
    const std::map<QString, QString> known{{QStringLiteral("name"), ConflictWords::tr("Name")},
                                           {QStringLiteral("notes"), ConflictWords::tr("Notes")},
                                           {QStringLiteral("team"), ConflictWords::tr("Team")},
                                           {QStringLiteral("class"), ConflictWords::tr("Class")},
                                           {QStringLiteral("task"), ConflictWords::tr("Task")},
                                           {QStringLiteral("tasks"), ConflictWords::tr("Tasks")},
                                           {QStringLiteral("tags"), ConflictWords::tr("Tags")},
                                           {QStringLiteral("starred"), ConflictWords::tr("Starred")},
                                           {QStringLiteral("archived"), ConflictWords::tr("Archived")},
                                           {QStringLiteral("archived_ms"), ConflictWords::tr("Archived")},
                                           {QStringLiteral("binned_ms"), ConflictWords::tr("In the bin")},
                                           {QStringLiteral("date_ms"), ConflictWords::tr("Date")},
                                           {QStringLiteral("members"), ConflictWords::tr("Members")},
                                           {QStringLiteral("pseudonym"), ConflictWords::tr("Pseudonym")},
                                           {QStringLiteral("robot"), ConflictWords::tr("Robot")},
                                           {QStringLiteral("robots"), ConflictWords::tr("Robots")},
                                           {QStringLiteral("variables"), ConflictWords::tr("Variables")},
                                           {QStringLiteral("value"), ConflictWords::tr("Value")},
                                           {QStringLiteral("analyses"), ConflictWords::tr("Analyses")},
                                           {QStringLiteral("metrics"), ConflictWords::tr("Metrics")},
                                           {QStringLiteral("gates"), ConflictWords::tr("Gates")},
                                           {QStringLiteral("zones"), ConflictWords::tr("Zones")},
                                           {QStringLiteral("scoring"), ConflictWords::tr("Scoring")}};
    const auto found = known.find(key);
    return found == known.end() ? QString(key).replace(u'_', u' ') : found->second;
}

/// Which person may be meant by a value.
enum class Meant { Nobody, Team, Pupils };

QString valueWords(const QJsonValue &value, const QString &key, Meant meant)
{
    if (value.isNull() || value.isUndefined())
        return {};
    if (meant == Meant::Pupils && arePseudonymsShown())
        return ConflictWords::tr("(hidden)");
    if (meant == Meant::Team)
        return shownTeam(value.toString().toStdString());
    if (value.isBool())
        return value.toBool() ? ConflictWords::tr("yes") : ConflictWords::tr("no");
    if (key.endsWith(QLatin1String("_ms")) && value.isDouble())
        return shortDate(Instant(std::chrono::milliseconds(qint64(value.toDouble()))));
    QString text = value.isDouble() ? QLocale().toString(value.toDouble(), 'g', 10) : value.toString();
    text.replace(u'\n', u' ');
    return text.size() > longestValue ? text.left(longestValue - 1) + u'…' : text;
}

/// Walks through both versions side by side.
class VersionComparison
{
public:
    void compare(const QJsonValue &here, const QJsonValue &there, const QString &path, const QString &key,
                 Meant meant)
    {
        if (here == there || rows.size() == mostRows)
            return;
        if (here.isObject() || there.isObject())
            return compareObjects(here.toObject(), there.toObject(), path, meant);
        if (here.isArray() || there.isArray())
            return compareLists(here.toArray(), there.toArray(), path, key, meant);
        rows.push_back({path, valueWords(here, key, meant), valueWords(there, key, meant)});
    }

    std::vector<ConflictRow> rows;

private:
    static QString below(const QString &path, const QString &part)
    {
        return path.isEmpty() ? part : path + QStringLiteral(" › ") + part;
    }

    void compareObjects(const QJsonObject &here, const QJsonObject &there, const QString &path, Meant meant)
    {
        QStringList keys = here.keys() + there.keys();
        keys.removeDuplicates();
        for (const QString &key : keys) {
            Meant inside = meant;
            if (key == QLatin1String("members"))
                inside = Meant::Pupils;
            else if (key != QLatin1String("name") && inside == Meant::Team)
                inside = Meant::Nobody;
            if (key == QLatin1String("team"))
                inside = Meant::Team;
            compare(here.value(key), there.value(key), below(path, keyWords(key)), key, inside);
        }
    }

    void compareLists(const QJsonArray &here, const QJsonArray &there, const QString &path,
                      const QString &key, Meant meant)
    {
        const qsizetype count = std::max(here.size(), there.size());
        for (qsizetype i = 0; i < count; ++i)
            compare(i < here.size() ? here.at(i) : QJsonValue(),
                    i < there.size() ? there.at(i) : QJsonValue(), path + QStringLiteral(" %1").arg(i + 1),
                    key, meant);
    }
};

} // namespace

std::vector<ConflictRow> conflictRows(const SchoolConflict &conflict)
{
    VersionComparison comparison;
    comparison.compare(conflict.ours, conflict.theirs, {}, {},
                       conflict.kind == SchoolKind::Team ? Meant::Team : Meant::Nobody);
    if (comparison.rows.empty())
        comparison.rows.push_back({ConflictWords::tr("Measured values"), ConflictWords::tr("this version"),
                                   ConflictWords::tr("another version")});
    return std::move(comparison.rows);
}

} // namespace odo
