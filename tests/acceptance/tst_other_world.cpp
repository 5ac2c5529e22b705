// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/program.h"
#include "tests/support/real_material.h"
#include "tests/support/registered_test.h"

#include <QFile>
#include <QTemporaryDir>
#include <QTest>
#include <cmath>

using namespace odo::test;

namespace {

/// A table of numbers with one header line; what is no number is NaN.
QList<QList<double>> numbersIn(const QString &name)
{
    QList<QList<double>> rows;
    QFile file(name);
    if (!file.open(QIODevice::ReadOnly))
        return rows;
    for (const QByteArray &line : file.readAll().trimmed().split('\n').mid(1)) {
        QList<double> row;
        for (const QByteArray &cell : line.trimmed().split(',')) {
            bool isNumber = false;
            const double value = cell.toDouble(&isNumber);
            row << (isNumber ? value : NAN);
        }
        rows << row;
    }
    return rows;
}

} // namespace

/// Robots that another program has drawn, without a word about their colour or size, by the command line.
class TestOtherWorld : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void isMeasuredWithoutAWord_data()
    {
        QTest::addColumn<QString>("colour");
        QTest::newRow("red buggy, blue upper part") << QStringLiteral("red");
        QTest::newRow("white buggy, blue upper part") << QStringLiteral("white");
    }
    void isMeasuredWithoutAWord()
    {
        ODOGRAPH_NEED_REAL("other-world");
        QFETCH(QString, colour);
        const QString data = QString::fromStdString((realMaterial() / "other-world").string()) +
                             QStringLiteral("/buggy-") + colour + u'/';
        const QTemporaryDir folder;
        const QString project = folder.filePath(QStringLiteral("p.odo")),
                      out = folder.filePath(QStringLiteral("out.csv"));
        const auto done = [&](const QString &line) {
            const ProgramRun run = runProgram(QString(line)
                                                  .replace(QStringLiteral("%P"), project)
                                                  .replace(QStringLiteral("%D"), data)
                                                  .split(u' '));
            if (run.exitStatus != 0)
                qWarning("%s: %s", qPrintable(line), run.err.constData());
            return run.exitStatus == 0;
        };
        QVERIFY(done(QStringLiteral("new %P")) && done(QStringLiteral("layout add %P floor %Dlayout.csv")) &&
                done(QStringLiteral("robot add %P buggy")));
        for (const char *camera : {"A", "B"})
            QVERIFY(done(QStringLiteral("intrinsics import %P %1 %D%1.yaml").arg(QLatin1String(camera))) &&
                    done(QStringLiteral("register %P --camera %1 --layout floor --pixels %Dpixels_%1.csv")
                             .arg(QLatin1String(camera))));
        QVERIFY(done(QStringLiteral("import %P --trial run --video A=%DA.mp4 --video B=%DB.mp4 --sync 0")) &&
                done(QStringLiteral("track %P run")) && done(QStringLiteral("export %P run -o ") + out));

        const auto measured = numbersIn(out),
                   truth = numbersIn(data + QStringLiteral("truth_%1.csv").arg(colour));
        QCOMPARE(measured.size(), truth.size());
        double squares = 0, speeds = 0, count = 0, raw = 0, inside = 0;
        for (qsizetype i = 0; i < truth.size(); ++i) {
            const auto &is = measured[i], &was = truth[i]; // t, x, y, vx, vy, …
            raw += std::isfinite(is[13]);
            if (!std::isfinite(is[1]))
                continue;
            const double dx = is[1] - was[1], dy = is[2] - was[2];
            squares += dx * dx + dy * dy;
            speeds += std::pow(is[3] - was[3], 2) + std::pow(is[4] - was[4], 2);
            inside += (std::abs(dx) < 1.96 * is[10]) + (std::abs(dy) < 1.96 * is[11]);
            count += 1;
        }
        const double rmsMm = std::sqrt(squares / count), rmsMmPerS = std::sqrt(speeds / count),
                     insidePercent = 50 * inside / count;
        const QString words = QStringLiteral("%1 of %2 frames, %3 mm, %4 mm/s, inside %5 %")
                                  .arg(raw)
                                  .arg(truth.size())
                                  .arg(rmsMm, 0, 'f', 1)
                                  .arg(rmsMmPerS, 0, 'f', 1)
                                  .arg(insidePercent, 0, 'f', 0);
        qInfo("%s", qPrintable(words));
        // Four markers picked to 0.3 px leave the floor itself in doubt by 3 to 5 mm.
        QVERIFY2(raw >= 0.99 * double(truth.size()) && rmsMm < 5 && rmsMmPerS < 25 && insidePercent >= 85,
                 qPrintable(words));
    }
};

ODOGRAPH_TEST(TestOtherWorld, QCoreApplication)
#include "tst_other_world.moc"
