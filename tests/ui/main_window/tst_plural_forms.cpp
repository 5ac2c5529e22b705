// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/history/history_page.h"
#include "ui/main_window/plural_forms.h"

#include <QDirIterator>
#include <QRegularExpression>
#include <QTest>

using namespace odo;

class TestPluralForms : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void initTestCase() { installPluralForms(*qApp); }
    void oneIsNotMany()
    {
        QCOMPARE(HistoryPage::tr("%n trial(s)", "", 0), QStringLiteral("0 trials"));
        QCOMPARE(HistoryPage::tr("%n trial(s)", "", 1), QStringLiteral("1 trial"));
        QCOMPARE(HistoryPage::tr("%n trial(s)", "", 2), QStringLiteral("2 trials"));
    }
    /// No word that is counted shows its brackets.
    void everyCountedWordHasItsForms()
    {
        const QString root = qEnvironmentVariable("ODOGRAPH_SOURCE_DIR");
        QFile forms(root + QStringLiteral("/translations/odograph_en.ts"));
        QVERIFY(forms.open(QIODevice::ReadOnly));
        const QString known = QString::fromUtf8(forms.readAll()).replace(QLatin1String("&quot;"), QLatin1String("\""));
        static const QRegularExpression counted(QStringLiteral("\\btr\\(\\s*((?:\"[^\"]*\"\\s*)+)"));
        static const QRegularExpression between(QStringLiteral("\"\\s*\"")); // of a word in several lines
        int count = 0;
        QDirIterator files(root + QStringLiteral("/ui"), {QStringLiteral("*.cpp")}, QDir::Files, QDirIterator::Subdirectories);
        while (files.hasNext()) {
            QFile file(files.next());
            QVERIFY(file.open(QIODevice::ReadOnly));
            auto match = counted.globalMatch(QString::fromUtf8(file.readAll()));
            while (match.hasNext()) {
                const QString source = match.next().captured(1).trimmed().replace(between, QString()).chopped(1).mid(1);
                if (!source.contains(QLatin1String("%n")))
                    continue;
                ++count;
                QVERIFY2(known.contains(u'>' + source + u'<'), qPrintable(file.fileName() + QStringLiteral(": ") + source));
            }
        }
        QVERIFY(count > 5);
    }
};

QTEST_MAIN(TestPluralForms)
#include "tst_plural_forms.moc"
