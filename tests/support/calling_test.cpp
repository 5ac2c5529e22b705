// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/calling_test.h"

#include <QDir>
#include <QFile>
#include <QTest>

namespace odo::test {

QByteArray gappedTrack(double gapS)
{
    QByteArray text("t_s,x_mm,y_mm\n");
    for (int i = 0; i < 250; ++i) {
        const double t = i / 25.0;
        if (t > 4 && t < 4 + gapS)
            continue;
        text += QByteArray::number(t, 'f', 3) + ',' + QByteArray::number(500 * t, 'f', 2) + ',' +
                QByteArray::number(i % 3 - 1) + '\n';
    }
    return text;
}

void CallingTest::write(const char *name, const QByteArray &content) const
{
    QFile file(path(name));
    QVERIFY(file.open(QIODevice::WriteOnly) && file.write(content) == content.size());
}

QStringList CallingTest::filled(const QString &line) const
{
    QStringList arguments = line.split(u' ', Qt::SkipEmptyParts);
    for (QString &argument : arguments)
        argument.replace(QStringLiteral("%P"), m_project)
            .replace(QStringLiteral("%/"), m_folder.path() + u'/');
    return arguments;
}

ProgramRun CallingTest::good(const char *line) const
{
    const ProgramRun done = run(line);
    if (done.exitStatus != 0)
        qWarning("%s: %s", line, done.err.constData());
    return done;
}

void CallingTest::beginBadCalls()
{
    QTest::addColumn<QString>("line");
    QTest::addColumn<int>("status");
    QTest::addColumn<QByteArray>("words");
}

void CallingTest::addBadCall(const char *line, int status, const char *words)
{
    QTest::newRow(line) << QString::fromUtf8(line) << status << QByteArray(words);
}

void CallingTest::badCallFailsInOneLine() const
{
    QFETCH(QString, line);
    QFETCH(int, status);
    QFETCH(QByteArray, words);
    const QByteArray before = fileHash(m_project);
    const QStringList filesBefore = QDir(m_folder.path()).entryList();
    const ProgramRun failed = run(line);
    QVERIFY2(failed.exitStatus == status,
             qPrintable(QString::number(failed.exitStatus) + QString::fromUtf8(failed.err)));
    QVERIFY2(failed.err.startsWith("odograph: ") && failed.err.count('\n') == 1, failed.err);
    QVERIFY2(failed.err.contains("; "), failed.err); // it says what to do
    QVERIFY2(failed.err.contains(words), failed.err);
    QVERIFY2(line.contains(QStringLiteral(" --json")) ? !failed.json().isEmpty() : failed.out.isEmpty(),
             failed.out);
    QCOMPARE(fileHash(m_project), before);
    QCOMPARE(QDir(m_folder.path()).entryList(), filesBefore);
}

} // namespace odo::test
