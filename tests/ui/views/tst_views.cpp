// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/registered_test.h"
#include "tests/ui/support/example_scene.h"
#include "ui/models/timeline.h"
#include "ui/views/charts/profile_chart.h"
#include "ui/views/charts/timeline_bar.h"
#include "ui/views/image/camera_view.h"
#include "ui/views/map/floor_map.h"
#include "ui/views/widgets/fact_list.h"
#include "ui/views/widgets/spike_list.h"
#include "ui/views/widgets/theme.h"

#include <QAbstractSlider>
#include <QApplication>
#include <QComboBox>
#include <QGridLayout>
#include <QHelpEvent>
#include <QLabel>
#include <QSignalSpy>
#include <QTableView>
#include <QTemporaryDir>
#include <QTest>
#include <QToolButton>
#include <QToolTip>

using namespace odo;

namespace {

/// A window like Review's, of the views alone.
struct Desk
{
    Timeline timeline;
    QWidget window;
    CameraView a{timeline}, b{timeline};
    FloorMap map{timeline};
    ProfileChart speed{timeline, Quantity::Speed}, acceleration{timeline, Quantity::Acceleration};
    TimelineBar bar{timeline};
    ResultPanel result;
    SpikeList spikes{timeline};

    explicit Desk(const TrialScenePtr &scene, QSize size = {1500, 940})
    {
        auto *grid = new QGridLayout(&window);
        grid->setContentsMargins(8, 8, 8, 8);
        grid->setSpacing(8);
        grid->addWidget(&a, 0, 0);
        grid->addWidget(&b, 0, 1);
        grid->addWidget(&map, 0, 2);
        grid->addWidget(&speed, 1, 0, 1, 3);
        grid->addWidget(&acceleration, 2, 0, 1, 3);
        grid->addWidget(&bar, 3, 0, 1, 3);
        auto *column = new QVBoxLayout;
        column->addWidget(&result);
        column->addWidget(&spikes, 1);
        grid->addLayout(column, 0, 3, 4, 1);
        grid->setRowStretch(0, 10);
        grid->setRowStretch(1, 6);
        grid->setRowStretch(2, 5);
        for (const int part : {0, 1, 2})
            grid->setColumnStretch(part, 10);
        grid->setColumnStretch(3, 7);
        show(scene);
        window.resize(size);
        window.show();
    }
    ~Desk()
    {
        // The views are members, not children to be deleted.
        for (QWidget *view :
             std::initializer_list<QWidget *>{&a, &b, &map, &speed, &acceleration, &bar, &result, &spikes})
            view->setParent(nullptr);
    }
    void show(const TrialScenePtr &scene)
    {
        timeline.setFrameTimes(scene ? scene->frameTimes() : std::vector<Nanoseconds>());
        a.setScene(scene, 0);
        b.setScene(scene, 1);
        map.setScene(scene);
        speed.setScene(scene);
        acceleration.setScene(scene);
        bar.setScene(scene);
        result.setScene(scene);
        spikes.setScene(scene);
    }
    bool isSettled() const { return a.isSettled() && b.isSettled() && map.isSettled(); }
};

QImage shot(QWidget *widget)
{
    return widget->grab().toImage().convertToFormat(QImage::Format_RGB32);
}

/// True when a pixel like this is within some logical pixels of a place.
bool hasColourNear(const QImage &image, const QPointF &position, const QColor &colour, int within = 3,
                   int tolerance = 60)
{
    const double ratio = image.devicePixelRatio();
    const int reach = int(within * ratio);
    for (int dy = -reach; dy <= reach; ++dy) {
        for (int dx = -reach; dx <= reach; ++dx) {
            const QPoint at = (position * ratio).toPoint() + QPoint(dx, dy);
            if (!image.rect().contains(at))
                continue;
            const QColor got = image.pixelColor(at);
            const int apart = std::abs(got.red() - colour.red()) + std::abs(got.green() - colour.green()) +
                              std::abs(got.blue() - colour.blue());
            if (apart < tolerance)
                return true;
        }
    }
    return false;
}

} // namespace

class TestViews : public QObject
{
    Q_OBJECT
    QTemporaryDir m_folder;
    TrialScenePtr m_scene;
    QString m_said;

private Q_SLOTS:
    void initTestCase()
    {
        QVERIFY(m_folder.isValid());
        QApplication::setStyle(QStringLiteral("Fusion"));
        QApplication::setPalette(lightPalette());
        const bool images = !qEnvironmentVariableIsEmpty("ODOGRAPH_PICTURES");
        m_scene = exampleScene({.frames = images ? 300 : 60,
                                .widthPx = images ? 1280 : 640,
                                .heightPx = images ? 720 : 360,
                                .videoFolder = m_folder.path().toStdString()});
    }
    void cleanup() { QApplication::setPalette(lightPalette()); }

    void cameraShowsTheRobotWhereItIs()
    {
        Desk desk(m_scene);
        desk.timeline.setCurrentFrame(40);
        QTRY_VERIFY(desk.isSettled());
        const QImage image = shot(desk.a.imageArea());
        const Observation &seen = *m_scene->observationAt(0, 0, 40);
        const QPointF centre = desk.a.fromImagePixels({seen.ellipse.centrePx.x(), seen.ellipse.centrePx.y()});
        QVERIFY(hasColourNear(image, centre, QColor(0xd7, 0x23, 0x28), 2, 90)); // the box itself
        const double reach = desk.a.fromImagePixels({seen.ellipse.semiMajorPx, 0}).x() -
                             desk.a.fromImagePixels({0, 0}).x() + 2;
        const QPointF end = centre + QPointF(std::cos(0.1), std::sin(0.1)) * reach;
        QVERIFY(hasColourNear(image, end, QColor(0x56, 0xb4, 0xe9)));
    }
    void cameraDrawsTrailAndAxesThroughItsLens()
    {
        Desk desk(m_scene);
        QTRY_VERIFY(desk.isSettled());
        const QImage image = shot(desk.b.imageArea());
        const FloorView &view = *m_scene->views[1].floorView;
        const auto position = [&](double x, double y, double z) {
            const Eigen::Vector2d pixel = *view.pixelFromWorld({x, y, z});
            return desk.b.fromImagePixels({pixel.x(), pixel.y()});
        };
        const Eigen::Vector2d late = m_scene->robots[0].analysis->profile.points[45].position;
        QVERIFY(hasColourNear(image, position(late.x(), late.y(), 0.06), QColor(0x56, 0xb4, 0xe9)));
        QVERIFY(hasColourNear(image, position(2.0, 0, 0), Qt::white, 2));
        QVERIFY(hasColourNear(image, position(0, 1.5, 0), Qt::white, 2));
    }
    void theTimeLineSaysWhenARobotIsDoubtful()
    {
        using namespace std::chrono_literals;
        auto scene = std::make_shared<TrialScene>(*m_scene);
        const auto picture = [&](const TrialScenePtr &shown) {
            Timeline timeline;
            timeline.setFrameTimes(shown->frameTimes());
            TimeSlider slider(timeline);
            slider.setScene(shown);
            slider.resize(600, slider.sizeHint().height());
            slider.show();
            const QPoint inside(int(slider.xOf(900ms)), slider.height() / 2);
            QHelpEvent ask(QEvent::ToolTip, inside, slider.mapToGlobal(inside));
            QApplication::sendEvent(&slider, &ask);
            m_said = QToolTip::text();
            QToolTip::hideText();
            return shot(&slider).copy(QRect(QPoint(int(slider.xOf(750ms)), 0), QSize(100, 12)));
        };
        const QImage without = picture(scene);
        QCOMPARE(m_said, QString());
        scene->robots[0].analysis->ambiguousNames = {{700ms, 1100ms, {7, 8}, {"Blue 1", "<b>Blue</b> 2"}}};
        const QImage with = picture(scene);
        QVERIFY(with != without);
        QVERIFY2(m_said.contains(QStringLiteral("from 0.70 s to 1.10 s this may be Red 2, "
                                                "&lt;b&gt;Blue&lt;/b&gt; 2 or Blue 1")),
                 qPrintable(m_said));
    }
    void chartsAndMapShadeWhereARobotIsHidden()
    {
        using namespace std::chrono_literals;
        auto scene = std::make_shared<TrialScene>(*m_scene);
        const auto images = [&](const TrialScenePtr &shown) {
            Timeline timeline;
            timeline.setFrameTimes(shown->frameTimes());
            ProfileChart chart(timeline, Quantity::Speed);
            FloorMap map(timeline);
            for (QWidget *one : std::initializer_list<QWidget *>{&chart, &map}) {
                one->resize(600, 300);
                one->show();
            }
            chart.setScene(shown);
            map.setScene(shown);
            if (!QTest::qWaitFor([&] { return map.isSettled() && chart.isSettled(); }))
                qFatal("chart and map do not settle");
            ChartArea *area = chart.chartArea();
            const QPoint inside = area->plot().at(0.9, 0.5).toPoint();
            QHelpEvent ask(QEvent::ToolTip, inside, area->mapToGlobal(inside));
            QApplication::sendEvent(area->viewport(), &ask);
            m_said = QToolTip::text();
            QToolTip::hideText();
            return std::pair(shot(area), shot(map.mapArea()));
        };
        const auto without = images(scene);
        QCOMPARE(m_said, QString());
        scene->robots[0].occlusions = {{{700ms, 1100ms}, OcclusionCause::HiddenBehind, "A", "<b>Blue</b> 1"}};
        const auto with = images(scene);
        QVERIFY(with.first != without.first && with.second != without.second);
        QVERIFY2(
            m_said.contains(QStringLiteral(
                "Red 2: hidden behind &lt;b&gt;Blue&lt;/b&gt; 1 in view A (0.70\u00a0s to 1.10\u00a0s)")),
            qPrintable(m_said));
    }
    void cameraSaysWhyThereIsNoPicture()
    {
        auto scene = std::make_shared<TrialScene>(*m_scene);
        scene->views[0].file = "/nowhere/lost.mkv";
        scene->views[1].floorView.reset();
        scene->views[1].registration.reset();
        Desk desk(scene);
        QTRY_VERIFY(desk.isSettled());
        QVERIFY(!shot(desk.a.imageArea()).isNull());
        bool told = false;
        for (const QLabel *label : desk.b.findChildren<QLabel *>())
            told = told || label->text() == QStringLiteral("not registered");
        QVERIFY(told);
    }
    void mapShowsTheTask()
    {
        for (const QPalette &palette : {lightPalette(), darkPalette()}) {
            QApplication::setPalette(palette);
            TrialScene scene = *m_scene;
            scene.task = Task{};
            scene.task->gates = {{"Start", GateRole::Start, {1.2, 0.2}, {1.2, 0.6}},
                                 {"a", GateRole::Split, {1.6, 0.2}, {1.6, 0.6}}};
            scene.task->path.points = {{0.4, 0.1}, {2.6, 0.1}};
            Desk desk(std::make_shared<const TrialScene>(scene));
            QTRY_VERIFY_WITH_TIMEOUT(desk.isSettled(), 20000);
            const QImage image = shot(desk.map.mapArea());
            const QColor colour = ThemeColours::of(palette).text;
            QVERIFY(hasColourNear(image, desk.map.fromWorld({1.2, 0.4}), colour));
            QVERIFY(hasColourNear(image, desk.map.fromWorld({1.6, 0.4}), colour));
            // The arrow points the way the gate is passed: to its right.
            const QPointF arrow = desk.map.fromWorld({1.2, 0.3}) + QPointF(10, 0);
            QVERIFY(hasColourNear(image, arrow, colour, 2));
            QVERIFY(!hasColourNear(image, arrow - QPointF(20, 0), colour, 2));
            int dashes = 0;
            for (double x = 0.5; x < 2.5; x += 0.05)
                dashes += hasColourNear(image, desk.map.fromWorld({x, 0.1}), colour, 2);
            QVERIFY2(dashes > 15, qPrintable(QString::number(dashes)));
        }
        QApplication::setPalette(lightPalette());
    }
    void mapShowsTrailFloorAndRobot()
    {
        Desk desk(m_scene);
        desk.timeline.setCurrentFrame(50);
        QTRY_VERIFY(desk.isSettled());
        const QImage image = shot(desk.map.mapArea());
        const Profile &profile = m_scene->robots[0].analysis->profile;
        QVERIFY(hasColourNear(image, desk.map.fromWorld(profile.points[50].position),
                              ThemeColours::of(lightPalette()).spike));
        // X to the right, Y up.
        QVERIFY(desk.map.fromWorld({1, 0}).x() > desk.map.fromWorld({0, 0}).x());
        QVERIFY(desk.map.fromWorld({0, 1}).y() < desk.map.fromWorld({0, 0}).y());
        // The floor of the pictures, half as strong as it is.
        const QColor ground =
            image.pixelColor((desk.map.fromWorld({2.62, 0.13}) * image.devicePixelRatio()).toPoint());
        QVERIFY2(ground.lightness() < ThemeColours::of(lightPalette()).mapGround.lightness() - 10,
                 qPrintable(ground.name()));
    }
    void clickOnTheMapGoesThere()
    {
        Desk desk(m_scene);
        const Profile &profile = m_scene->robots[0].analysis->profile;
        QTest::mouseClick(desk.map.mapArea(), Qt::LeftButton, {},
                          desk.map.fromWorld(profile.points[45].position).toPoint());
        QVERIFY(std::abs(desk.timeline.currentFrame() - 45) <= 1);
    }
    void chartMovesTheTime()
    {
        Desk desk(m_scene);
        const ChartArea *area = desk.speed.chartArea();
        const QRect plot = area->plot().rect.toRect();
        QTest::mouseClick(area->viewport(), Qt::LeftButton, {}, {plot.right() + 1, 60});
        QCOMPARE(desk.timeline.currentFrame(), desk.timeline.frameCount() - 1);
        QTest::mouseClick(area->viewport(), Qt::LeftButton, {}, {plot.left(), 60});
        QCOMPARE(desk.timeline.currentFrame(), 0);
    }
    void sliderAndKeysMoveTheTime()
    {
        Desk desk(m_scene);
        auto *slider = desk.bar.findChild<QAbstractSlider *>();
        QVERIFY(slider);
        desk.timeline.setCurrentFrame(20);
        QCOMPARE(slider->value(), 20);
        slider->setFocus();
        QTest::keyClick(slider, Qt::Key_Right);
        QCOMPARE(desk.timeline.currentFrame(), 21);
        QTest::mouseClick(slider, Qt::LeftButton, {}, {slider->width() - 2, slider->height() / 2});
        QCOMPARE(desk.timeline.currentFrame(), desk.timeline.frameCount() - 1);
    }
    void barShowsTheRate()
    {
        Desk desk(m_scene);
        auto *rates = desk.bar.findChild<QComboBox *>();
        QVERIFY(rates);
        QCOMPARE(rates->currentData().toDouble(), 1.0);
        const int offered = rates->count();
        desk.timeline.setRate(-2);
        QCOMPARE(rates->currentData().toDouble(), -2.0);
        desk.timeline.setRate(0.5);
        QCOMPARE(rates->currentData().toDouble(), 0.5);
        QCOMPARE(rates->count(), offered);
    }
    void choosingASpikeGoesThere()
    {
        Desk desk(m_scene);
        const auto &spikes = m_scene->robots[0].analysis->profile.spikes;
        desk.spikes.table()->setCurrentIndex(desk.spikes.table()->model()->index(1, 0));
        QCOMPARE(desk.timeline.currentFrame(), qint64(spikes[1].sampleIndex));
        desk.timeline.setCurrentFrame(qint64(spikes[0].sampleIndex));
        QCOMPARE(desk.spikes.table()->currentIndex().row(), 0);
        desk.timeline.step(1);
        QVERIFY(!desk.spikes.table()->currentIndex().isValid());
    }
    void nothingIsShownWithoutAScene()
    {
        Desk desk(nullptr);
        QTRY_VERIFY(desk.isSettled());
        QVERIFY(!shot(&desk.window).isNull());
        desk.show(m_scene);
        QTRY_VERIFY(desk.isSettled());
        desk.show(nullptr);
        QVERIFY(desk.isSettled());
        QVERIFY(!shot(&desk.window).isNull());
    }
    void everythingHasAName()
    {
        Desk desk(m_scene);
        for (QWidget *widget : desk.window.findChildren<QWidget *>()) {
            const bool reachable = widget->isVisible() && widget->focusPolicy() != Qt::NoFocus;
            if (reachable && !widget->inherits("QComboBoxPrivateContainer") && widget->parentWidget())
                QVERIFY2(!widget->accessibleName().isEmpty() ||
                             widget->objectName().startsWith(QStringLiteral("qt_")),
                         qPrintable(QString::fromLatin1(widget->metaObject()->className()) +
                                    QStringLiteral(" in ") +
                                    QString::fromLatin1(widget->parentWidget()->metaObject()->className())));
        }
    }
    /// For the eye: with ODOGRAPH_PICTURES=folder the desk is saved there, light and dark, with one and two
    /// robots.
    void looks()
    {
        const QString folder = qEnvironmentVariable("ODOGRAPH_PICTURES");
        if (folder.isEmpty())
            QSKIP("no folder for pictures named");
        auto two = std::make_shared<TrialScene>(
            *exampleScene({.frames = 300, .robots = 2, .widthPx = 1280, .heightPx = 720}));
        for (std::size_t view = 0; view < two->views.size(); ++view)
            two->views[view].file = m_scene->views[view].file;
        const auto save = [&](const QString &name, const TrialScenePtr &scene, const QPalette &palette,
                              qint64 frame) {
            QApplication::setPalette(palette);
            Desk desk(scene);
            desk.timeline.setCurrentFrame(frame);
            QTRY_VERIFY(desk.isSettled());
            QCoreApplication::processEvents();
            QVERIFY(desk.window.grab().save(folder + u'/' + name));
        };
        save(QStringLiteral("light.png"), m_scene, lightPalette(), 99);
        save(QStringLiteral("dark.png"), m_scene, darkPalette(), 130);
        save(QStringLiteral("two.png"), two, lightPalette(), 240);
        save(QStringLiteral("empty.png"), nullptr, lightPalette(), 0);
    }
};

ODOGRAPH_TEST(TestViews, QApplication)
#include "tst_views.moc"
