// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/scoreboard/internal/board_language.h"

#include "core/analysis/metric_table.h"

#include <QDir>
#include <algorithm>
#include <utility>

namespace odo {

namespace {

const QString wordsFolder = QStringLiteral(":/odograph/translations");
const QString englishCode = QStringLiteral("en");

QLocale localeOfLanguage(const QString &code)
{
    return code == englishCode ? QLocale(QLocale::English, QLocale::World) : QLocale(code);
}

/// How much a browser wants what "de-AT;q=0.8" names; the tag is left in `tag`.
double weightOf(QByteArrayView range, QByteArray &tag)
{
    const qsizetype semicolon = range.indexOf(';');
    tag = (semicolon < 0 ? range : range.first(semicolon)).trimmed().toByteArray().toLower();
    const QByteArrayView weight = semicolon < 0 ? QByteArrayView() : range.sliced(semicolon + 1).trimmed();
    return weight.startsWith("q=") ? weight.sliced(2).toByteArray().toDouble() : 1;
}

} // namespace

BoardLanguage::BoardLanguage(QString code)
    : m_code(std::move(code)), m_locale(localeOfLanguage(m_code)), m_words(std::make_unique<QTranslator>())
{
    [[maybe_unused]] const bool isThere = m_words->load(QStringLiteral("odograph_") + m_code, wordsFolder);
    Q_ASSERT(isThere); // compiled in
}

QByteArray BoardLanguage::tag() const
{
    return m_code.toLatin1().replace('_', '-');
}

QString BoardLanguage::translated(const char *context, const char *english, int count) const
{
    QString words = m_words->translate(context, english, nullptr, count);
    if (words.isEmpty())
        words = QString::fromUtf8(english);
    return count < 0 ? words : words.replace(QStringLiteral("%n"), m_locale.toString(count));
}

QString BoardLanguage::text(const char *english, int count) const
{
    return translated("Scoreboard", english, count);
}

QString BoardLanguage::metric(const std::string &name) const
{
    const MetricKind *kind = metricKind(name);
    return kind ? QString::fromStdString(render(kind->name)) : metricName(name);
}

NumberText BoardLanguage::number(Metric metric, double value, std::optional<double> sigma) const
{
    metric.value = value;
    metric.sigma = sigma;
    if (metric.unit != "points")
        return metricNumber(metric, m_locale);
    constexpr double leastSigma = 0.05; // that is seen in tenths of a point, the finest that is shown
    const auto tenths = [this](double points) { return m_locale.toString(points, 'f', 1); };
    return {tenths(value), sigma && *sigma >= leastSigma ? tenths(*sigma) : QString(),
            translated("odo::NumberText", "points", -1)};
}

std::string BoardLanguage::words(const MessageText &text) const
{
    return translated(text.code, text.english, -1).toStdString();
}

std::string BoardLanguage::number(double value, int decimals) const
{
    QLocale locale = m_locale;
    locale.setNumberOptions(QLocale::OmitGroupSeparator);
    return locale.toString(value, 'f', decimals).toStdString();
}

BoardLanguages::BoardLanguages()
{
    m_all.push_back(std::make_unique<BoardLanguage>(englishCode));
    const QStringList files = QDir(wordsFolder).entryList({QStringLiteral("odograph_*.qm")}, QDir::Files);
    for (const QString &file : files) {
        const QString code = file.section(u'.', 0, 0).section(u'_', 1);
        if (!code.startsWith(englishCode)) // of which there are two files
            m_all.push_back(std::make_unique<BoardLanguage>(code));
    }
}

const BoardLanguage &BoardLanguages::preferred(const QByteArray &accepted) const
{
    const BoardLanguage *best = m_all.front().get();
    double most = 0;
    for (const QByteArray &range : accepted.split(',')) {
        QByteArray wanted;
        const double weight = weightOf(range, wanted);
        const QByteArray language =
            wanted.left(wanted.indexOf('-') < 0 ? wanted.size() : wanted.indexOf('-'));
        const auto known = std::ranges::find_if(
            m_all, [&language](const auto &each) { return each->tag().left(2).toLower() == language; });
        if (weight > most && known != m_all.end()) {
            most = weight;
            best = known->get();
        }
    }
    return *best;
}

const BoardLanguage *BoardLanguages::find(const QByteArray &tag) const
{
    const auto known = std::ranges::find_if(m_all, [&tag](const auto &each) { return each->tag() == tag; });
    return known == m_all.end() ? nullptr : known->get();
}

} // namespace odo
