// SPDX-License-Identifier: GPL-3.0-or-later
// An area to ignore or to search is drawn corner by corner in a view of Review, and removed there.
#include "ui/review/guidance_tool.h"

#include "tests/support/registered_test.h"
#include "tests/ui/support/example_scene.h"
#include "ui/models/timeline.h"

#include <QAction>
#include <QApplication>
#include <QImage>
#include <QMenu>
#include <QPainter>
#include <QTest>
#include <QWidget>

using namespace odo;
using Kind = GuidanceItem::Kind;

class TestGuidanceTool : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void init()
    {
        m_scene = std::make_shared<TrialScene>(*exampleScene({}));
        for (std::size_t view = 0; view < m_scene->views.size(); ++view)
            m_scene->views[view].recording.id = RecordId(view + 1);
        m_timeline = std::make_unique<Timeline>();
        m_timeline->setFrameTimes(m_scene->frameTimes());
        m_tool = std::make_unique<GuidanceTool>(*m_timeline);
        m_asked.reset();
        connect(m_tool.get(), &GuidanceTool::requested, this,
                [this](const QString &trial, const GuidanceEdit &edit) {
                    QCOMPARE(trial, QString::fromStdString(m_scene->trial.name));
                    m_asked = edit;
                });
        m_tool->setScene(m_scene);
    }

    void anAreaIsDrawnAndClosed_data()
    {
        QTest::addColumn<int>("action");
        QTest::addColumn<bool>("byKey");
        QTest::newRow("ignore, Enter") << 0 << true;
        QTest::newRow("search, double click") << 1 << false;
    }
    void anAreaIsDrawnAndClosed()
    {
        QFETCH(int, action);
        QFETCH(bool, byKey);
        QWidget window;
        window.show();
        m_tool->actions().at(action)->setChecked(true);
        QVERIFY(m_tool->isDrawing());
        m_tool->addCorner(0, {1, 1}); // another view begins it there
        for (const QPointF &corner : {QPointF(10, 20), QPointF(110, 20), QPointF(60, 90), QPointF(9, 9)})
            m_tool->addCorner(1, corner);
        QTest::keyClick(&window, Qt::Key_Backspace); // the last one
        if (byKey)
            QTest::keyClick(&window, Qt::Key_Return);
        else
            m_tool->finish();
        QVERIFY(!m_tool->isDrawing());
        QVERIFY(m_asked.has_value());
        QCOMPARE(m_asked->added.size(), std::size_t(1));
        const GivenGuidance &area = m_asked->added.front();
        QVERIFY(area.kind == (action == 0 ? Kind::Ignore : Kind::Search));
        QCOMPARE(area.view, m_scene->views[1].camera);
        QVERIFY((area.pointsPx == std::vector<Eigen::Vector2d>{{10, 20}, {110, 20}, {60, 90}}));
    }

    void itIsGivenUp()
    {
        QWidget window;
        window.show();
        m_tool->actions().front()->setChecked(true);
        for (int i = 0; i < 4; ++i)
            m_tool->addCorner(0, {10.0 * i, 5.0 * i * i});
        QTest::keyClick(&window, Qt::Key_Escape);
        QVERIFY(!m_tool->isDrawing() && !m_asked);
        m_tool->actions().front()->setChecked(true);
        m_tool->addCorner(0, {10, 10});
        m_tool->addCorner(0, {20, 10});
        m_tool->finish(); // no area
        QVERIFY(!m_tool->isDrawing() && !m_asked);
        m_tool->actions().at(0)->setChecked(true);
        m_tool->actions().at(1)->setChecked(true); // one at a time
        QVERIFY(!m_tool->actions().at(0)->isChecked() && m_tool->isDrawing());
    }

    void oneIsRemovedWhereItIs()
    {
        m_scene->guidance = {{7, 1, 0, Kind::Ignore, 0, 0, {{0, 0}, {100, 0}, {100, 100}, {0, 100}}, 0},
                             {8, 1, 0, Kind::Search, 0, 0, {{50, 50}, {300, 50}, {300, 300}}, 0}};
        m_tool->setScene(m_scene);
        QMenu menu;
        m_tool->fill(menu, 0, {80, 60});
        QVERIFY(offered(menu, "Remove this ignored area"));
        offered(menu, "Remove this search area")->trigger();
        QVERIFY((m_asked->removed == std::vector<RecordId>{8}));
        QMenu elsewhere;
        m_tool->fill(elsewhere, 1, {80, 60}); // of the other view
        QVERIFY(!offered(elsewhere, "Remove this ignored area"));
        m_tool->actions().back()->trigger();
        QVERIFY(m_asked->clearsAll);
    }

    /// Of the selected time, in a view or in all; and of the frame shown it is removed.
    void aRobotIsNotVisible()
    {
        const std::string robot = m_scene->robots.front().robot.name;
        const auto text = [&](const char *words) {
            return QString::fromUtf8(words).arg(QString::fromStdString(robot));
        };
        const QString here = text("%1 is not visible here in the selected time"),
                      anywhere = text("%1 is not visible in any view in the selected time");
        std::optional<GuidanceEdit> edit;
        connect(m_tool.get(), &GuidanceTool::byHandRequested, this,
                [&](const QString &, const GuidanceEdit &asked) { edit = asked; });
        QMenu without;
        m_tool->fill(without, 1, {5, 5});
        QVERIFY(!offered(without, here) && offered(without, text("Set %1 here by hand…")));
        m_timeline->setSelection(TimeSpan{m_scene->frameTimes()[3], m_scene->frameTimes()[9]});
        QMenu menu;
        m_tool->fill(menu, 1, {5, 5});
        offered(menu, here)->trigger();
        const GivenGuidance hidden = edit->added.front();
        QVERIFY(hidden.kind == Kind::Hidden && hidden.view == m_scene->views[1].camera &&
                hidden.robot == robot);
        QCOMPARE(hidden.fromS, toSeconds(m_scene->frameTimes()[3]));
        QCOMPARE(hidden.toS, toSeconds(m_scene->frameTimes()[9]));
        offered(menu, anywhere)->trigger();
        QVERIFY(edit->added.front().view.empty());
        m_scene->guidance = {{5, 1, 0, Kind::Hidden, 3, 9, {}, 0}};
        m_tool->setScene(m_scene);
        m_timeline->setCurrentFrame(5);
        QMenu within;
        m_tool->fill(within, 0, {5, 5});
        offered(within, QStringLiteral("It is visible after all"))->trigger();
        QVERIFY((edit->removed == std::vector<RecordId>{5}));
        m_timeline->setCurrentFrame(12);
        QMenu behind;
        m_tool->fill(behind, 0, {5, 5});
        QVERIFY(!offered(behind, QStringLiteral("It is visible after all")));
    }

    void nothingWithoutVideos()
    {
        m_scene->imported.resize(1);
        m_tool->setScene(m_scene);
        for (const QAction *action : m_tool->actions())
            QVERIFY(!action->isEnabled());
    }

    /// Inside of an ignored area, and outside of the searched ones, the image is darker.
    void areasAreSeen()
    {
        m_scene->guidance = {{7, 1, 0, Kind::Ignore, 0, 0, {{20, 20}, {80, 20}, {80, 80}, {20, 80}}, 0},
                             {8, 1, 0, Kind::Search, 0, 0, {{0, 0}, {150, 0}, {150, 150}, {0, 150}}, 0}};
        m_tool->setScene(m_scene);
        QImage image(200, 200, QImage::Format_RGB32);
        image.fill(QColor(200, 200, 200));
        {
            QPainter painter(&image);
            painter.setClipRect(image.rect());
            m_tool->overlay()(painter, 0, 3, [](const QPointF &pixel) { return pixel; });
        }
        const auto meanIn = [&image](const QRect &part) {
            int sum = 0;
            for (int y = part.top(); y <= part.bottom(); ++y)
                for (int x = part.left(); x <= part.right(); ++x)
                    sum += qGray(image.pixel(x, y));
            return sum / (part.width() * part.height());
        };
        QCOMPARE(meanIn({100, 100, 30, 30}), 200);
        QVERIFY(meanIn({40, 50, 30, 20}) < 170);
        QVERIFY(meanIn({160, 160, 30, 30}) < 150);
    }

private:
    static QAction *offered(const QMenu &menu, const QString &text)
    {
        const QList<QAction *> all = menu.actions();
        const auto its = std::ranges::find(all, text, &QAction::text);
        return its == all.end() ? nullptr : *its;
    }
    static QAction *offered(const QMenu &menu, const char *text)
    {
        return offered(menu, QString::fromUtf8(text));
    }

    std::shared_ptr<TrialScene> m_scene;
    std::unique_ptr<Timeline> m_timeline;
    std::unique_ptr<GuidanceTool> m_tool;
    std::optional<GuidanceEdit> m_asked;
};

ODOGRAPH_TEST(TestGuidanceTool, QApplication)
#include "tst_guidance_tool.moc"
