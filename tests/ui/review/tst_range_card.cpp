// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/analysis/range_statistics.h"
#include "tests/support/registered_test.h"
#include "tests/ui/support/example_scene.h"
#include "tests/ui/support/found_widgets.h"
#include "ui/models/timeline.h"
#include "ui/review/internal/range_card.h"
#include "ui/views/widgets/fact_list.h"

#include <QApplication>
#include <QClipboard>
#include <QComboBox>
#include <QDialog>
#include <QLabel>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QSignalSpy>
#include <QTest>
#include <QToolButton>

using namespace odo;
using namespace std::chrono_literals;

namespace {

/// The card in a window, over ten seconds of a figure eight.
struct Shown
{
    TrialScenePtr scene;
    Timeline timeline;
    QWidget window;
    RangeCard card{timeline, &window};
    std::optional<FitOverlay> fit;

    explicit Shown(TrialScenePtr of) : scene(std::move(of))
    {
        QObject::connect(&card, &RangeCard::fitChanged, &window, [this](const auto &now) { fit = now; });
        timeline.setFrameTimes(scene->frameTimes());
        card.setScene(scene);
        card.setQuantities({Quantity::Speed, Quantity::Acceleration});
        window.resize(320, 600);
        card.setGeometry(0, 0, 320, 600);
        window.show();
    }
    QComboBox &choice(const QString &name)
    {
        for (QComboBox *each : card.findChildren<QComboBox *>())
            if (each->accessibleName() == name)
                return *each;
        qFatal("no such choice");
    }
    QString text() const
    {
        QStringList all;
        for (const QLabel *label : card.findChildren<QLabel *>())
            all << label->text();
        return all.join(u'|');
    }
};

} // namespace

class TestRangeCard : public QObject
{
    Q_OBJECT
    TrialScenePtr m_scene = exampleScene({.frames = 300});

private Q_SLOTS:
    void comesWithARangeAndGoes()
    {
        Shown shown(m_scene);
        QSignalSpy changes(&shown.card, &RangeCard::shownChanged);
        QVERIFY(!shown.card.isVisible());
        shown.timeline.setSelection(TimeSpan{2s, 6s});
        QVERIFY(shown.card.isVisible());
        QTRY_VERIFY(shown.text().contains(QStringLiteral("2.00\u00a0s to 6.00\u00a0s: 4.00\u00a0s")));
        QVERIFY(shown.text().contains(QStringLiteral("Acceleration|")));
        shown.timeline.setSelection(std::nullopt);
        QVERIFY(!shown.card.isVisible());
        QCOMPARE(changes.count(), 2);
    }
    void figuresAreThoseOfTheCore()
    {
        const TimeSpan span{2s, 6s};
        const Profile &profile = m_scene->robots[0].analysis->profile;
        const RangeReport report = reportOf({m_scene, 0, span, {Quantity::Speed, Quantity::PositionX}});
        const auto speed = statisticsOf(profile, Quantity::Speed, span);
        QCOMPARE(report.statistics.size(), std::size_t(2));
        QCOMPARE(report.statistics[0]->mean.value, speed->mean.value);
        QVERIFY(!report.fit);
        QVERIFY(fitFacts(report).isEmpty());
        QString most;
        for (const Fact &fact : rangeFacts(report))
            if (fact.name == QStringLiteral("most") && most.isEmpty())
                most = fact.value;
        QVERIFY2(most.contains(QStringLiteral("m/s at ")), qPrintable(most));
    }
    void fitIsToldAndDrawn()
    {
        Shown shown(m_scene);
        shown.timeline.setSelection(TimeSpan{2s, 6s});
        QVERIFY(!shown.choice(QStringLiteral("Fitted quantity")).isEnabled());
        shown.choice(QStringLiteral("Function to fit to the curve")).setCurrentIndex(2);
        QTRY_VERIFY(shown.fit && shown.fit->fit.shape == FitShape::Line);
        QCOMPARE(shown.fit->quantity, Quantity::Speed);
        QTRY_VERIFY(shown.text().contains(QStringLiteral("slope|")));
        QVERIFY(shown.text().contains(QStringLiteral("does not fit"))); // the speed swings
        QVERIFY(shown.text().contains(QStringLiteral("m/s²")));
        shown.choice(QStringLiteral("Fitted quantity")).setCurrentIndex(1);
        QTRY_VERIFY(shown.fit && shown.fit->quantity == Quantity::Acceleration);
        shown.timeline.setSelection(std::nullopt);
        QVERIFY(!shown.fit);
    }
    void tooShortARangeSaysSo()
    {
        Shown shown(m_scene);
        shown.choice(QStringLiteral("Function to fit to the curve")).setCurrentIndex(3);
        shown.timeline.setSelection(TimeSpan{2s, 2s + 34ms});
        QTRY_VERIFY(shown.text().contains(
            QStringLiteral("fit of a parabola: 2 points are too few for it; choose a longer range")));
        QVERIFY(!shown.fit);
    }
    void noCurveNoCard()
    {
        auto untracked = std::make_shared<TrialScene>(*m_scene);
        untracked->robots[0].analysis.reset();
        Shown shown(untracked);
        shown.timeline.setSelection(TimeSpan{2s, 6s});
        QVERIFY(!shown.card.isVisible());
        shown.card.setScene(nullptr);
        QVERIFY(!shown.card.isVisible());
    }
    void everyNumberTellsHowItWasComputed()
    {
        Shown shown(m_scene);
        shown.choice(QStringLiteral("Function to fit to the curve")).setCurrentIndex(2);
        shown.timeline.setSelection(TimeSpan{2s, 6s});
        QTRY_VERIFY(shown.text().contains(QStringLiteral("slope|")));
        int told = 0;
        for (QToolButton *button : shown.card.findChildren<QToolButton *>()) {
            if (!button->accessibleName().endsWith(howComputedWords()))
                continue;
            button->click();
            auto *dialog = shown.window.findChild<QDialog *>(QStringLiteral("explanation"));
            QVERIFY(dialog);
            test::button(*dialog, "Copy")->click();
            const QString text = QApplication::clipboard()->text();
            QCOMPARE(QString(text).replace(QChar::Nbsp, u' '),
                     dialog->findChild<QPlainTextEdit *>()->toPlainText());
            for (const char *part : {"How it is computed", "What ± contains", "from 2.00", "samples used"})
                QVERIFY2(text.contains(QString::fromUtf8(part)), qPrintable(text));
            delete dialog;
            ++told;
        }
        QCOMPARE(told, 4); // fit, path, two quantities
    }
};

ODOGRAPH_TEST(TestRangeCard, QApplication)
#include "tst_range_card.moc"
