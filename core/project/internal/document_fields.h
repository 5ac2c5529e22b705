// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/project/internal/words.h"
#include "core/project/names.h"

#include <Eigen/Core>
#include <QByteArray>
#include <QCborArray>
#include <QCborMap>
#include <optional>
#include <string>
#include <vector>

namespace odo {

/// Reads the fields of a document that came from elsewhere. A field of the wrong type, or beyond its limit,
/// gives an empty value and is remembered, the first one by its name: whoever reads a whole document asks
/// once, at its end, whether it was sound. Parts share that with the document that they belong to.
class DocumentFields
{
public:
    explicit DocumentFields(QCborMap map, std::string *fault) : m_map(std::move(map)), m_fault(fault) {}

    std::string text(const char *key, int most = maxNameLength) const;
    double real(const char *key) const;
    std::optional<double> optionalReal(const char *key) const; ///< empty where it is null
    std::int64_t integer(const char *key) const;
    std::optional<std::int64_t> optionalInteger(const char *key) const;
    bool flag(const char *key) const;
    QByteArray bytes(const char *key) const;
    std::vector<std::string> texts(const char *key, std::size_t most) const;
    std::vector<QByteArray> blobs(const char *key, std::size_t most) const;
    std::vector<double> reals(const char *key, std::size_t most) const;
    DocumentFields part(const char *key) const;
    bool has(const char *key) const;
    std::vector<DocumentFields> parts(const char *key, std::size_t most) const;
    /// From outside: a field whose value no type describes is wrong.
    void refuse(const char *key) const;
    /// Whether nothing that was read of the document was wrong so far.
    bool isSound() const { return m_fault->empty(); }
    const QCborMap &map() const { return m_map; }

private:
    QCborArray list(const char *key, std::size_t most) const;

    QCborMap m_map;
    std::string *m_fault;
};

/// The value of a stored word; refuses one that is not known.
template <class Value, class Words>
Value wordIn(const DocumentFields &fields, const char *key, const Words &words)
{
    const auto value = fromStoredWord(words, fields.text(key), Message());
    if (!value)
        fields.refuse(key);
    return value.value_or(Value());
}

QString documentText(const std::string &text);
QCborArray documentTexts(const std::vector<std::string> &texts);
QCborValue documentOptional(const std::optional<double> &value);
QCborArray documentPoints(const std::vector<Eigen::Vector2d> &points);
/// Pairs of coordinates; refuses an odd number of them.
std::vector<Eigen::Vector2d> pointsIn(const DocumentFields &fields, const char *key, std::size_t most);

} // namespace odo
