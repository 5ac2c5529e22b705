// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/internal/document_fields.h"

#include <cmath>

namespace odo {

namespace {

QString keyOf(const char *key)
{
    return QString::fromLatin1(key);
}

} // namespace

void DocumentFields::refuse(const char *key) const
{
    if (m_fault->empty())
        *m_fault = key;
}

std::string DocumentFields::text(const char *key, int most) const
{
    const QCborValue value = m_map.value(keyOf(key));
    const QString text = value.toString();
    if (!value.isString() || text.size() > 2 * most || text.contains(QChar(u'\0'))) {
        refuse(key);
        return {};
    }
    return text.toStdString();
}

double DocumentFields::real(const char *key) const
{
    const auto value = optionalReal(key);
    if (!value)
        refuse(key);
    return value.value_or(0);
}

std::optional<double> DocumentFields::optionalReal(const char *key) const
{
    const QCborValue value = m_map.value(keyOf(key));
    if (value.isNull())
        return std::nullopt;
    const double number = value.toDouble();
    if (!(value.isDouble() || value.isInteger()) || !std::isfinite(number) ||
        std::abs(number) > largestNumber) {
        refuse(key);
        return std::nullopt;
    }
    return number;
}

std::int64_t DocumentFields::integer(const char *key) const
{
    const QCborValue value = m_map.value(keyOf(key));
    if (!value.isInteger())
        refuse(key);
    return value.toInteger();
}

std::optional<std::int64_t> DocumentFields::optionalInteger(const char *key) const
{
    if (m_map.value(keyOf(key)).isNull())
        return std::nullopt;
    return integer(key);
}

bool DocumentFields::flag(const char *key) const
{
    const QCborValue value = m_map.value(keyOf(key));
    if (!value.isBool())
        refuse(key);
    return value.toBool();
}

QByteArray DocumentFields::bytes(const char *key) const
{
    const QCborValue value = m_map.value(keyOf(key));
    if (!value.isByteArray())
        refuse(key);
    return value.toByteArray();
}

QCborArray DocumentFields::list(const char *key, std::size_t most) const
{
    const QCborValue value = m_map.value(keyOf(key));
    const QCborArray list = value.toArray();
    if (!value.isArray() || list.size() > qsizetype(most)) {
        refuse(key);
        return {};
    }
    return list;
}

std::vector<std::string> DocumentFields::texts(const char *key, std::size_t most) const
{
    std::vector<std::string> texts;
    for (const QCborValue value : list(key, most)) {
        if (!value.isString() || value.toString().size() > 2 * maxNameLength)
            refuse(key);
        texts.push_back(value.toString().toStdString());
    }
    return texts;
}

std::vector<QByteArray> DocumentFields::blobs(const char *key, std::size_t most) const
{
    std::vector<QByteArray> blobs;
    for (const QCborValue value : list(key, most)) {
        if (!value.isByteArray())
            refuse(key);
        blobs.push_back(value.toByteArray());
    }
    return blobs;
}

std::vector<double> DocumentFields::reals(const char *key, std::size_t most) const
{
    std::vector<double> numbers;
    for (const QCborValue value : list(key, most)) {
        if (!(value.isDouble() || value.isInteger()) || !std::isfinite(value.toDouble()))
            refuse(key);
        numbers.push_back(value.toDouble());
    }
    return numbers;
}

DocumentFields DocumentFields::part(const char *key) const
{
    const QCborValue value = m_map.value(keyOf(key));
    if (!value.isMap())
        refuse(key);
    return DocumentFields(value.toMap(), m_fault);
}

bool DocumentFields::has(const char *key) const
{
    return m_map.contains(keyOf(key));
}

std::vector<DocumentFields> DocumentFields::parts(const char *key, std::size_t most) const
{
    std::vector<DocumentFields> parts;
    for (const QCborValue value : list(key, most)) {
        if (!value.isMap())
            refuse(key);
        parts.emplace_back(value.toMap(), m_fault);
    }
    return parts;
}

QString documentText(const std::string &text)
{
    return QString::fromStdString(text);
}

QCborArray documentTexts(const std::vector<std::string> &texts)
{
    QCborArray list;
    for (const std::string &text : texts)
        list.append(documentText(text));
    return list;
}

QCborValue documentOptional(const std::optional<double> &value)
{
    return value ? QCborValue(*value) : QCborValue(nullptr);
}

QCborArray documentPoints(const std::vector<Eigen::Vector2d> &points)
{
    QCborArray list;
    for (const Eigen::Vector2d &point : points) {
        list.append(point.x());
        list.append(point.y());
    }
    return list;
}

std::vector<Eigen::Vector2d> pointsIn(const DocumentFields &fields, const char *key, std::size_t most)
{
    const std::vector<double> numbers = fields.reals(key, 2 * most);
    if (numbers.size() % 2 != 0)
        fields.refuse(key);
    std::vector<Eigen::Vector2d> points;
    for (std::size_t i = 0; i + 1 < numbers.size(); i += 2)
        points.emplace_back(numbers[i], numbers[i + 1]);
    return points;
}

} // namespace odo
