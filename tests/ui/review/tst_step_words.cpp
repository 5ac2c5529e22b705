// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/registered_test.h"
#include "tests/ui/support/example_scene.h"
#include "ui/models/timeline.h"
#include "ui/review/internal/trial_facts.h"
#include "ui/views/image/camera_view.h"

#include <QApplication>
#include <QLabel>
#include <QTest>

using namespace odo;

/// What Review says of how the second view is in step with the first one: on its card and among the trial's
/// facts.
class TestStepWords : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { QLocale::setDefault(QLocale::c()); }

    void eachWayHasItsWords_data()
    {
        QTest::addColumn<QString>("method");
        QTest::addColumn<double>("rate");
        QTest::addColumn<QString>("onCard");
        QTest::addColumn<QString>("fact");
        QTest::addColumn<bool>("doubted");
        QTest::newRow("motion") << "auto" << 0.0 << "synchronised to 0.4 ms"
                                << "B: synchronised to 0.4 ms by the motion; started 12.5 ms earlier"
                                << false;
        QTest::newRow("motion, another rate")
            << "auto" << 80e-6 << "synchronised to 0.4 ms"
            << "B: synchronised to 0.4 ms by the motion; started 12.5 ms earlier, clock 80 ppm fast" << false;
        QTest::newRow("flash") << "flash" << 0.0 << "synchronised to 0.4 ms"
                               << "B: synchronised to 0.4 ms by a flash of light; started 12.5 ms earlier"
                               << false;
        QTest::newRow("sound") << "audio" << 0.0 << "synchronised to 0.4 ms"
                               << "B: synchronised to 0.4 ms by sound; started 12.5 ms earlier" << false;
        QTest::newRow("by hand") << "told" << 0.0 << "manual offset"
                                 << "B: started 12.5 ms earlier, set by hand" << false;
        QTest::newRow("none") << "none" << 0.0 << "not synchronised"
                              << "B: assumed to start at the same time" << true;
        QTest::newRow("a word of a later program") << "wire" << 0.0 << "not synchronised"
                                                   << "B: assumed to start at the same time" << true;
    }
    void eachWayHasItsWords()
    {
        QFETCH(QString, method);
        QFETCH(double, rate);
        QFETCH(QString, onCard);
        QFETCH(QString, fact);
        QFETCH(bool, doubted);
        auto scene = std::make_shared<TrialScene>(*exampleScene({.frames = 30}));
        RecordingRecord &second = scene->views[1].recording;
        second.syncMethod = method.toStdString();
        second.startOffsetS = -0.0125;
        second.startOffsetSigmaS = 0.0004;
        second.clockRate = rate;

        const auto facts = trialFacts(*scene);
        const auto step = std::find_if(facts.begin(), facts.end(),
                                       [](const Fact &one) { return one.name == u"Synchronisation"; });
        QVERIFY(step != facts.end());
        QCOMPARE(step->value, fact);
        QCOMPARE(step->badge.state == BadgeState::Warning, doubted);

        Timeline timeline;
        CameraView card(timeline);
        card.setScene(scene, 1);
        card.resize(900, 500); // room for all of it
        card.show();
        QStringList words;
        for (const QLabel *label : card.findChildren<QLabel *>())
            words << label->text();
        QVERIFY2(words.join(u'|').contains(onCard), qPrintable(words.join(u'|')));
    }
};

ODOGRAPH_TEST(TestStepWords, QApplication)
#include "tst_step_words.moc"
