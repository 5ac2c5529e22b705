// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QString>
#include <QStringList>
#include <QtGlobal>

namespace odo::test {

/// Holds a JSON value against a JSON schema, of which it knows what docs/ use: type, enum, required,
/// properties, additionalProperties: false, items and $ref into $defs. Anything else in the schema is an
/// error, so that nothing is passed over.
class JsonSchema
{
public:
    /// file: below the tree's folder.
    explicit JsonSchema(const QString &file)
    {
        QFile in(qEnvironmentVariable("ODOGRAPH_SOURCE_DIR") + u'/' + file);
        if (in.open(QIODevice::ReadOnly))
            m_root = QJsonDocument::fromJson(in.readAll()).object();
    }
    bool isRead() const { return !m_root.isEmpty(); }
    /// What does not fit, with where: "robots/0/name: is no string".
    QStringList problemsOf(const QJsonValue &value) const
    {
        QStringList problems;
        check(value, m_root, QString(), problems);
        return problems;
    }

private:
    static bool isOfType(const QJsonValue &value, const QString &type)
    {
        const double number = value.toDouble(0.5);
        return (type == QLatin1String("object") && value.isObject()) ||
               (type == QLatin1String("array") && value.isArray()) ||
               (type == QLatin1String("string") && value.isString()) ||
               (type == QLatin1String("boolean") && value.isBool()) ||
               (type == QLatin1String("null") && value.isNull()) ||
               (type == QLatin1String("number") && value.isDouble()) ||
               (type == QLatin1String("integer") && value.isDouble() && number == double(qint64(number)));
    }

    void check(const QJsonValue &value, const QJsonObject &schema, const QString &where,
               QStringList &problems) const
    {
        for (auto rule = schema.begin(); rule != schema.end(); ++rule) {
            const QString name = rule.key();
            if (name == QLatin1String("$ref")) {
                check(
                    value,
                    m_root[QStringLiteral("$defs")].toObject()[rule->toString().section(u'/', -1)].toObject(),
                    where, problems);
            } else if (name == QLatin1String("type")) {
                bool fits = rule->isString() && isOfType(value, rule->toString());
                for (const QJsonValue &one : rule->toArray())
                    fits |= isOfType(value, one.toString());
                if (!fits)
                    problems << where + QStringLiteral(": is of another type");
            } else if (name == QLatin1String("enum")) {
                if (!rule->toArray().contains(value))
                    problems << where + QStringLiteral(": is none of those");
            } else if (name == QLatin1String("required")) {
                for (const QJsonValue &one : rule->toArray())
                    if (value.isObject() && !value.toObject().contains(one.toString()))
                        problems << where + u'/' + one.toString() + QStringLiteral(": is missing");
            } else if (name == QLatin1String("properties")) {
                checkProperties(value.toObject(), schema, where, problems);
            } else if (name == QLatin1String("items")) {
                const QJsonArray items = value.toArray();
                for (qsizetype i = 0; i < items.size(); ++i)
                    check(items[i], rule->toObject(), where + u'/' + QString::number(i), problems);
            } else if (!QStringList{QStringLiteral("description"), QStringLiteral("title"),
                                    QStringLiteral("$schema"), QStringLiteral("$id"), QStringLiteral("$defs"),
                                    QStringLiteral("additionalProperties")}
                            .contains(name)) {
                problems << where + QStringLiteral(": the schema has a rule that is not known, ") + name;
            }
        }
    }

    void checkProperties(const QJsonObject &object, const QJsonObject &schema, const QString &where,
                         QStringList &problems) const
    {
        const QJsonObject known = schema[QStringLiteral("properties")].toObject();
        for (auto property = object.begin(); property != object.end(); ++property) {
            const QString place = where + u'/' + property.key();
            if (known.contains(property.key()))
                check(*property, known[property.key()].toObject(), place, problems);
            else if (schema[QStringLiteral("additionalProperties")] == QJsonValue(false))
                problems << place + QStringLiteral(": is not told");
        }
    }

    QJsonObject m_root;
};

} // namespace odo::test
