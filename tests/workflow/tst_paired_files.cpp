// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/workflow/calibrate/paired_files.h"

#include "tests/support/registered_test.h"

#include <QTest>

using namespace odo;

class TestPairedFiles : public QObject
{
    Q_OBJECT

    static std::vector<std::filesystem::path> files(const QStringList &names)
    {
        std::vector<std::filesystem::path> paths;
        for (const QString &name : names)
            paths.emplace_back(name.toStdString());
        return paths;
    }

private Q_SLOTS:
    void pairs_data()
    {
        QTest::addColumn<QStringList>("a");
        QTest::addColumn<QStringList>("b");
        QTest::addColumn<QStringList>("pairs"); // "a+b"; the whole message where it is an error
        const auto row = [](const char *name, QStringList a, QStringList b, QStringList pairs) {
            QTest::newRow(name) << std::move(a) << std::move(b) << std::move(pairs);
        };
        row("in order", {QStringLiteral("x.png"), QStringLiteral("y.png")},
            {QStringLiteral("p.png"), QStringLiteral("q.png")},
            {QStringLiteral("x.png+p.png"), QStringLiteral("y.png+q.png")});
        row("by number", {QStringLiteral("left1.jpg"), QStringLiteral("left2.jpg")},
            {QStringLiteral("right2.jpg"), QStringLiteral("right1.jpg")},
            {QStringLiteral("left1.jpg+right1.jpg"), QStringLiteral("left2.jpg+right2.jpg")});
        row("zeros in front",
            {QStringLiteral("l08.jpg"), QStringLiteral("l009.jpg"), QStringLiteral("l10.jpg")},
            {QStringLiteral("r8.jpg"), QStringLiteral("r9.jpg"), QStringLiteral("r10.jpg")},
            {QStringLiteral("l08.jpg+r8.jpg"), QStringLiteral("l009.jpg+r9.jpg"),
             QStringLiteral("l10.jpg+r10.jpg")});
        row("one is missing",
            {QStringLiteral("l1.jpg"), QStringLiteral("l2.jpg"), QStringLiteral("l3.jpg"),
             QStringLiteral("l4.jpg"), QStringLiteral("l5.jpg")},
            {QStringLiteral("r1.jpg"), QStringLiteral("r3.jpg"), QStringLiteral("r4.jpg"),
             QStringLiteral("r5.jpg")},
            {QStringLiteral("l1.jpg+r1.jpg"), QStringLiteral("l2.jpg+"), QStringLiteral("l3.jpg+r3.jpg"),
             QStringLiteral("l4.jpg+r4.jpg"), QStringLiteral("l5.jpg+r5.jpg")});
        row("one is missing in each",
            {QStringLiteral("l1.jpg"), QStringLiteral("l2.jpg"), QStringLiteral("l3.jpg"),
             QStringLiteral("l4.jpg"), QStringLiteral("l6.jpg"), QStringLiteral("l7.jpg")},
            {QStringLiteral("r1.jpg"), QStringLiteral("r3.jpg"), QStringLiteral("r4.jpg"),
             QStringLiteral("r5.jpg"), QStringLiteral("r6.jpg"), QStringLiteral("r7.jpg")},
            {QStringLiteral("l1.jpg+r1.jpg"), QStringLiteral("l2.jpg+"), QStringLiteral("l3.jpg+r3.jpg"),
             QStringLiteral("l4.jpg+r4.jpg"), QStringLiteral("l6.jpg+r6.jpg"),
             QStringLiteral("l7.jpg+r7.jpg"), QStringLiteral("+r5.jpg")});
        row("the camera has a number", {QStringLiteral("3_cam1.png"), QStringLiteral("4_cam1.png")},
            {QStringLiteral("3_cam2.png"), QStringLiteral("4_cam2.png")},
            {QStringLiteral("3_cam1.png+3_cam2.png"), QStringLiteral("4_cam1.png+4_cam2.png")});
        row("counters of their own", {QStringLiteral("IMG_101.png"), QStringLiteral("IMG_102.png")},
            {QStringLiteral("DSC_7.png"), QStringLiteral("DSC_8.png")},
            {QStringLiteral("IMG_101.png+DSC_7.png"), QStringLiteral("IMG_102.png+DSC_8.png")});
        row("other counts", {QStringLiteral("x.png"), QStringLiteral("y.png")}, {QStringLiteral("p.png")},
            {QStringLiteral(
                "the files of the two cameras: 2 files of the first camera cannot be paired with 1 of the "
                "second one; give as many of each, in the same order, or number their names alike")});
        row("twice", {QStringLiteral("x.png"), QStringLiteral("y.png")},
            {QStringLiteral("p.png"), QStringLiteral("./x.png")},
            {QStringLiteral(
                "the files of the two cameras: 'x.png' is given twice; give each file once, to its camera")});
    }
    void pairs()
    {
        QFETCH(QStringList, a);
        QFETCH(QStringList, b);
        QFETCH(QStringList, pairs);
        const auto paired = pairFiles(files(a), files(b));
        QStringList found;
        if (!paired)
            found << QString::fromStdString(paired.error().message());
        else
            for (const FilePair &pair : *paired)
                found << QString::fromStdString(pair.a.string() + "+" + pair.b.string());
        QCOMPARE(found, pairs);
    }

    void anImageIsNoVideo()
    {
        const auto visited = visitFramePairs({"a.png", "b.mp4"}, [](const FramePair &) { return true; }, {});
        QCOMPARE(visited.error().why.english(), std::string("one is an image and the other a video"));
    }
};

ODOGRAPH_TEST(TestPairedFiles, QCoreApplication)
#include "tst_paired_files.moc"
