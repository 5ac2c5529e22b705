// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/floor_registration.h"
#include "core/calibration/internal/layout_board.h"
#include "core/calibration/internal/layout_tags.h"
#include "core/calibration/internal/tag_labels.h"
#include "core/calibration/marker_detection.h"
#include "tests/calibration/tagged_floors.h"
#include "tests/support/contains.h"
#include "tests/support/registered_test.h"

#include <QTest>
#include <algorithm>
#include <numeric>
#include <random>

using namespace odo;
using namespace odo::test;
using Eigen::Vector2d;

namespace {

const std::vector<Vector2d> fivePlaces{{0, 0}, {2.0, 0.1}, {0.1, 1.5}, {2.2, 1.7}, {0.9, 0.6}};

int scenes()
{
    const int asked = qEnvironmentVariableIntValue("ODOGRAPH_TAGGED_FLOORS");
    return asked > 0 ? asked : 2;
}

MarkerLayout layoutOf(const std::vector<std::string> &labels, const std::vector<Vector2d> &places)
{
    MarkerLayout layout{"floor", {}};
    for (std::size_t i = 0; i < labels.size(); ++i)
        layout.markers.push_back({labels[i], places[i]});
    return layout;
}

MarkerLayout numbered(const std::vector<int> &numbers, const std::vector<Vector2d> &places,
                      const std::string &before = "")
{
    std::vector<std::string> labels;
    for (const int number : numbers)
        labels.push_back(before + std::to_string(number));
    return layoutOf(labels, places);
}

/// Tags of a family at the places, each turned by luck, in some light.
TaggedFloor floorOf(TagFamily family, const std::vector<int> &numbers, const std::vector<Vector2d> &places,
                    std::uint32_t seed)
{
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> share(0, 1);
    TaggedFloor floor;
    floor.seed = seed;
    floor.blurPx = 0.3 + 0.6 * share(random);
    floor.darkest = 0.35 + 0.65 * share(random);
    const double sideM = 0.14 + 0.08 * share(random);
    for (std::size_t i = 0; i < numbers.size(); ++i)
        floor.tags.push_back({{family, numbers[i]}, places[i], sideM, 2 * std::acos(-1.0) * share(random)});
    return floor;
}

/// The largest error; nullopt where there are more or fewer markers.
std::optional<double> worstOf(const Result<std::vector<MarkerPixel>> &found, const FloorView &view,
                              const MarkerLayout &layout, std::size_t expected)
{
    if (!found || found->size() != expected)
        return std::nullopt;
    double worst = 0;
    for (const MarkerPixel &marker : *found) {
        const Vector2d point = std::ranges::find(layout.markers, marker.label, &Marker::label)->pointInWorld;
        worst = std::max(worst, (marker.pixel - *view.pixelFromWorld({point.x(), point.y(), 0})).norm());
    }
    return worst;
}

QByteArray said(const Result<std::vector<MarkerPixel>> &found)
{
    if (!found)
        return QByteArray::fromStdString(found.error().message());
    QByteArray text = QByteArray::number(qsizetype(found->size())) + " found:";
    for (const MarkerPixel &marker : *found)
        text += " " + QByteArray::fromStdString(marker.label);
    return text;
}

/// Eight in a ring, which looks the same from eight sides.
std::vector<Vector2d> ringOfEight()
{
    std::vector<Vector2d> places;
    for (int i = 0; i < 8; ++i)
        places.emplace_back(std::cos(EIGEN_PI / 4 * i), std::sin(EIGEN_PI / 4 * i));
    return places;
}

} // namespace

class TestLayoutTags : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void labels()
    {
        const auto plain = tagLabel("100");
        QVERIFY(plain && !plain->family && plain->numbers == std::vector<int>{100} && !plain->corner);
        for (const char *label : {"tag 7", "Tag7", "ID 7", "id:7", "#7", "007", "AprilTag 7", "aruco 7"})
            QVERIFY2(tagLabel(label) && tagLabel(label)->numbers == std::vector<int>{7} &&
                         !tagLabel(label)->family,
                     label);
        for (const char *label : {"36h11:7", "AprilTag 36h11 7", "tag36h11:7"})
            QVERIFY2(tagLabel(label) && tagLabel(label)->family == TagFamily::AprilTag36h11, label);
        QVERIFY(tagLabel("DICT_4X4_50:7")->family == TagFamily::Aruco4x4);
        QVERIFY(tagLabel("ArUco original:7")->family == TagFamily::ArucoOriginal);
        const auto corner = tagLabel("7.BR");
        QVERIFY(corner && corner->corner == 2 && corner->numbers == std::vector<int>{7});
        QVERIFY(tagLabel("12+13+14+15")->numbers == (std::vector<int>{12, 13, 14, 15}));
        for (const char *label : {"", "O", "U", "A1", "P100", "1.5", "-1", "12 3", "7.tx", "12+", "+", "7+7",
                                  "12+13.tl", "123456", "4x4", "corner:7", "tag"})
            QVERIFY2(!tagLabel(label), label);
    }
    void aLabelThatNamesNoTagIsRefused_data()
    {
        QTest::addColumn<QStringList>("labels");
        QTest::addColumn<QString>("why"); ///< empty: they are taken
        QTest::newRow("tags") << QStringLiteral("0;36h11:0;36h11:586;3.tl;3.tr;12+13").split(u';')
                              << QStringLiteral("");
        QTest::newRow("names") << QStringLiteral("A1;+5;1.5;4x4;door + 2;2.nd;tag;1;01").split(u';')
                               << QStringLiteral("");
        QTest::newRow("beyond") << QStringLiteral("36h11:9999").split(u';')
                                << QStringLiteral(
                                       "label '36h11:9999' of the layout: AprilTag 36h11 has no tag 9999");
        QTest::newRow("cut") << QStringLiteral("1;2;12+").split(u';')
                             << QStringLiteral("label '12+' of the layout: '12+' is not the number of a tag");
        QTest::newRow("no number") << QStringLiteral("36h11:x").split(u';')
                                   << QStringLiteral(
                                          "label '36h11:x' of the layout: 'x' is not the number of a tag");
        QTest::newRow("no corner")
            << QStringLiteral("3.tl;3.tr;3.xx").split(u';')
            << QStringLiteral("label '3.xx' of the layout: the corners of a tag are tl, tr, br and bl");
        QTest::newRow("corner of two")
            << QStringLiteral("1;2;12+13.tl").split(u';')
            << QStringLiteral("label '12+13.tl' of the layout: a corner is that of one tag");
        QTest::newRow("twice") << QStringLiteral("0;tag 0").split(u';')
                               << QStringLiteral("label 'tag 0' of the layout: it names the same tag as '0'");
    }
    void aLabelThatNamesNoTagIsRefused()
    {
        QFETCH(QStringList, labels);
        QFETCH(QString, why);
        MarkerLayout layout;
        for (const QString &label : labels)
            layout.markers.push_back({label.toStdString(), {}});
        const auto checked = checkTagLabels(layout);
        QCOMPARE(checked.has_value(), why.isEmpty());
        if (!checked) {
            why += QLatin1String(
                "; write a tag as 100 or 36h11:100, its corner as 100.tl, the middle of two as 12+13");
            QCOMPARE(QString::fromStdString(checked.error().message()), why);
            QCOMPARE(int(checked.error().code), int(ErrorCode::InvalidInput));
            MarkerSearch search;
            const Frame black; // it is not even looked at
            QVERIFY(!findLayoutTags(black, layout, search));
        }
    }
    void theNumbersAreTheLabels_data()
    {
        QTest::addColumn<int>("family");
        for (const TagFamily family : allTagFamilies())
            QTest::newRow(nameOf(family).c_str()) << int(family);
    }
    void theNumbersAreTheLabels()
    {
        QFETCH(int, family);
        const std::vector<int> numbers{29, 3, 17, 11, 22};
        const MarkerLayout layout = numbered(numbers, fivePlaces);
        int good = 0;
        for (int scene = 0; scene < scenes(); ++scene) {
            const auto seed = std::uint32_t(100 * family + scene);
            TaggedFloor floor = floorOf(TagFamily(family), numbers, fivePlaces, seed);
            // Other tags on the floor, of another family with the layout's numbers and of this one.
            const TagFamily other =
                TagFamily(family) == TagFamily::Aruco6x6 ? TagFamily::AprilTag36h10 : TagFamily::Aruco6x6;
            floor.tags.push_back({{other, 29}, {1.5, 0.5}, 0.12, 0.4});
            floor.tags.push_back({{other, 3}, {1.4, 1.2}, 0.12, 1.4});
            floor.tags.push_back({{TagFamily(family), 9}, {0.6, 1.2}, 0.12, 2});
            const FloorView view = someView(fivePlaces, seed);
            const bool known = scene % 2 == 0;
            const auto found = findMarkers(drawTaggedFloor(view, floor), layout,
                                           {known ? std::optional(view.camera()) : std::nullopt, known, {}});
            const auto worst = worstOf(found, view, layout, found ? found->size() : 0);
            if (worst && *worst < 0.3)
                ++good;
            else
                qInfo("scene %d: %s, worst %.2f px", scene, said(found).constData(), worst.value_or(-1));
            // None is ever taken for another one.
            QVERIFY2(!found || worstOf(found, view, layout, found->size()).value_or(0) < 1,
                     said(found).constData());
        }
        QVERIFY2(good >= 0.95 * scenes(), qPrintable(QString::number(good)));
    }
    void tagsNumberedByPlaceAreStillFound()
    {
        // Labels 1 to 5 with the tags 0 to 4, as Odograph prints them; and where the first is hidden.
        const MarkerLayout layout = numbered({1, 2, 3, 4, 5}, fivePlaces);
        for (int scene = 0; scene < scenes(); ++scene) {
            const auto seed = std::uint32_t(2000 + scene);
            const FloorView view = someView(fivePlaces, seed);
            TaggedFloor floor = floorOf(TagFamily::AprilTag36h11, {0, 1, 2, 3, 4}, fivePlaces, seed);
            const auto found = findMarkers(drawTaggedFloor(view, floor), layout);
            QVERIFY2(worstOf(found, view, layout, 5).value_or(9) < 0.3, said(found).constData());
            floor.tags.erase(floor.tags.begin());
            const auto four = findMarkers(drawTaggedFloor(view, floor), layout);
            QVERIFY2(worstOf(four, view, layout, 4).value_or(9) < 0.3, said(four).constData());
            QVERIFY(four->front().label == "2");
        }
    }
    void twoReadingsThatFitAreAskedFor()
    {
        const auto places = ringOfEight();
        const std::vector<int> numbers{1, 2, 3, 4, 5, 6, 7, 8};
        TaggedFloor floor = floorOf(TagFamily::AprilTag36h11, numbers, places, 31);
        const FloorView view = someView(places, 31);
        // All are there: by place the last one would fit nowhere.
        const MarkerLayout layout = numbered(numbers, places);
        const auto all = findMarkers(drawTaggedFloor(view, floor), layout);
        QVERIFY2(worstOf(all, view, layout, 8).value_or(9) < 0.3, said(all).constData());
        floor.tags.pop_back();
        const Frame frame = drawTaggedFloor(view, floor);
        const auto unsure = findMarkers(frame, layout);
        QVERIFY2(!unsure && contains(unsure.error().message(), "numbered from 0"), said(unsure).constData());
        const MarkerLayout named = numbered(numbers, places, "36h11:");
        const auto sure = findMarkers(frame, named);
        QVERIFY2(worstOf(sure, view, named, 7).value_or(9) < 0.3, said(sure).constData());
        MarkerSearch search;
        search.hints = {{"3", *view.pixelFromWorld({places[2].x(), places[2].y(), 0})}};
        const auto told = findMarkers(frame, layout, search);
        QVERIFY2(worstOf(told, view, layout, 7).value_or(9) < 0.3, said(told).constData());
    }
    void tagsOfTwoFamiliesThatFitAreAskedFor()
    {
        const std::vector<int> numbers{3, 11, 17, 22};
        const std::vector<Vector2d> places{{0, 0}, {2, 0}, {0, 1.5}, {2, 1.5}};
        auto moved = places;
        for (Vector2d &place : moved)
            place += Vector2d(0.3, 0);
        TaggedFloor floor = floorOf(TagFamily::Aruco6x6, numbers, places, 41);
        const auto others = floorOf(TagFamily::Aruco5x5, numbers, moved, 42);
        floor.tags.insert(floor.tags.end(), others.tags.begin(), others.tags.end());
        auto seen = places;
        seen.insert(seen.end(), moved.begin(), moved.end());
        const FloorView view = someView(seen, 43);
        const Frame frame = drawTaggedFloor(view, floor);
        const auto unsure = findMarkers(frame, numbered(numbers, places));
        QVERIFY2(!unsure && contains(unsure.error().message(), "two families"), said(unsure).constData());
        const MarkerLayout named = numbered(numbers, places, "DICT_6X6_250:");
        const auto sure = findMarkers(frame, named);
        QVERIFY2(worstOf(sure, view, named, 4).value_or(9) < 0.3, said(sure).constData());
    }
    void cornersOfTags()
    {
        std::vector<std::string> labels;
        std::vector<Vector2d> points;
        TaggedFloor floor = floorOf(TagFamily::AprilTag36h11, {40, 41}, {{0, 0}, {1.5, 0.8}}, 51);
        static constexpr std::array corners{"tl", "tr", "br", "bl"};
        for (const DrawnTag &tag : floor.tags) {
            for (std::size_t i = 0; i < 4; ++i) {
                labels.push_back(std::to_string(tag.name.number) + "." + corners[i]);
                const Vector2d corner(i == 1 || i == 2 ? 1 : -1, i < 2 ? 1 : -1);
                points.push_back(tag.middle + Eigen::Rotation2Dd(tag.turnRad) * corner * (tag.sideM / 2));
            }
        }
        const FloorView view = someView(points, 52);
        const MarkerLayout layout = layoutOf(labels, points);
        const auto found = findMarkers(drawTaggedFloor(view, floor), layout);
        QVERIFY2(worstOf(found, view, layout, 8).value_or(9) < 0.3, said(found).constData());
    }
    void theMiddleOfSeveralTags()
    {
        // Four stations of two tags each, near and far: the mean of their pixels is not that of the floor.
        std::vector<Vector2d> places, tags;
        std::vector<std::string> labels;
        std::vector<int> numbers;
        for (int i = 0; i < 4; ++i) {
            const Vector2d place(2.0 * (i % 2), 1.5 * (i / 2)), arm(0.2, 0.35);
            places.push_back(place);
            labels.push_back(std::to_string(10 + i) + "+" + std::to_string(20 + i));
            for (const double sign : {-1, 1}) {
                tags.push_back(place + sign * arm);
                numbers.push_back(sign < 0 ? 10 + i : 20 + i);
            }
        }
        const FloorView view = simulatedView({-0.9, -1.5, 1.1}, {0.7, 0.5, 0}, 1920, 1080, 1000);
        const MarkerLayout layout = layoutOf(labels, places);
        const auto floor = floorOf(TagFamily::AprilTag25h9, numbers, tags, 62);
        const auto found = findMarkers(drawTaggedFloor(view, floor), layout, {view.camera(), true, {}});
        QVERIFY2(worstOf(found, view, layout, 4).value_or(9) < 0.3, said(found).constData());
        double off = 0;
        for (std::size_t i = 0; i < 4; ++i) {
            const auto one = *view.pixelFromWorld({tags[2 * i].x(), tags[2 * i].y(), 0}),
                       other = *view.pixelFromWorld({tags[2 * i + 1].x(), tags[2 * i + 1].y(), 0});
            off = std::max(off, (0.5 * (one + other) - (*found)[i].pixel).norm());
        }
        QVERIFY(off > 1);
    }
    void tagsWithFewCellsCountOnlyWhereTheyFit()
    {
        // A second tag of one number, on a robot: of such a family it may be no tag at all.
        const std::vector<int> numbers{3, 11, 17, 22, 29};
        TaggedFloor floor = floorOf(TagFamily::Aruco4x4, numbers, fivePlaces, 71);
        floor.tags.push_back({{TagFamily::Aruco4x4, 11}, {1.4, 1.1}, 0.15, 0.3});
        const FloorView view = someView(fivePlaces, 72);
        const MarkerLayout layout = numbered(numbers, fivePlaces);
        const Frame frame = drawTaggedFloor(view, floor);
        const auto found = findMarkers(frame, layout);
        QVERIFY2(worstOf(found, view, layout, 5).value_or(9) < 0.3, said(found).constData());
        // At other positions than the layout's they are none.
        auto other = fivePlaces;
        std::swap(other[0], other[4]);
        other[2].x() += 0.7;
        QVERIFY(!findMarkers(frame, numbered(numbers, other)));
    }
    /// Numbers that are off by one fit a grid, shifted by a column, with nine of twelve.
    void numbersThatAreOffByOneFitNowhere()
    {
        std::vector<Vector2d> grid;
        std::vector<int> printed, labels;
        for (int i = 0; i < 12; ++i) {
            grid.emplace_back(0.7 * (i % 4), 0.7 * (i / 4));
            printed.push_back(5 + i);
            labels.push_back(6 + i);
        }
        for (const TagFamily family : {TagFamily::Aruco4x4, TagFamily::AprilTag16h5, TagFamily::ArucoOriginal,
                                       TagFamily::AprilTag25h9}) {
            const FloorView view = someView(grid, 91);
            const Frame frame = drawTaggedFloor(view, floorOf(family, printed, grid, 92));
            const MarkerLayout right = numbered(printed, grid), wrong = numbered(labels, grid);
            const auto found = findMarkers(frame, right);
            QVERIFY2(worstOf(found, view, right, 12).value_or(9) < 0.5, said(found).constData());
            const auto shifted = findMarkers(frame, wrong);
            QVERIFY2(!shifted || !registerFloor(wrong, *shifted, view.camera(), true),
                     said(shifted).constData());
        }
    }
    void tagsAtRandomFitNowhere()
    {
        // A layout that has every number: whatever is read counts, of thirty tags that lie anywhere.
        std::vector<Vector2d> grid;
        std::vector<int> all, some;
        for (int i = 0; i < 100; ++i) {
            grid.emplace_back(0.22 * (i % 10), 0.18 * (i / 10));
            all.push_back(i);
        }
        for (int scene = 0; scene < scenes(); ++scene) {
            std::mt19937 random(std::uint32_t(300 + scene));
            std::uniform_real_distribution<double> share(0, 1);
            std::vector<Vector2d> places;
            while (places.size() < 30) {
                const Vector2d place(2.0 * share(random), 1.6 * share(random));
                if (std::ranges::all_of(places, [&](const Vector2d &p) { return (p - place).norm() > 0.2; }))
                    places.push_back(place);
            }
            some.resize(30);
            std::iota(some.begin(), some.end(), 0);
            std::ranges::shuffle(some, random);
            TaggedFloor floor = floorOf(TagFamily::AprilTag16h5, some, places, std::uint32_t(scene));
            for (DrawnTag &tag : floor.tags)
                tag.sideM = 0.1;
            const FloorView view = someView(places, std::uint32_t(400 + scene));
            const auto found = findMarkers(drawTaggedFloor(view, floor), numbered(all, grid));
            QVERIFY2(!found, said(found).constData());
        }
    }
    void cornersOfAChArUcoBoard()
    {
        const auto corner = boardCorner("ChArUco 9x6:12");
        QVERIFY(corner && corner->columns == 9 && corner->rows == 6 && corner->number == 12);
        for (const char *label : {"charuco", "charuco 9x6", "charuco 9x6:54", "charuco 9:12", "9x6:12",
                                  "charuco 9x6:-1", "charuco 9x6:1a", "charuco 99x6:1"})
            QVERIFY2(!boardCorner(label), label);
        // A board of 5 × 4 squares on the floor, with tags that the layout does not mean beside it.
        constexpr double squareM = 0.3, ratio = 0.7;
        TaggedFloor floor;
        floor.seed = 5;
        int number = 0;
        for (int row = 0; row < 5; ++row) {
            for (int column = 0; column < 6; ++column) {
                const Vector2d middle(squareM * (column + 0.5), squareM * (4.5 - row));
                if ((row + column) % 2 == 0)
                    floor.squares.push_back({middle, squareM});
                else
                    floor.tags.push_back({{TagFamily::Aruco6x6, number++}, middle, ratio * squareM, 0});
            }
        }
        floor.tags.push_back({{TagFamily::AprilTag36h11, 0}, {-0.3, 0.5}, 0.15, 0.3});
        std::vector<std::string> labels;
        std::vector<Vector2d> points;
        for (const int each : {0, 4, 15, 19}) {
            labels.push_back("charuco 5x4:" + std::to_string(each));
            points.emplace_back(squareM * (1 + each % 5), squareM * (4 - each / 5));
        }
        const MarkerLayout layout = layoutOf(labels, points);
        for (int scene = 0; scene < scenes(); ++scene) {
            const FloorView view =
                someView({{-0.3, 0}, {1.8, 0}, {-0.3, 1.5}, {1.8, 1.5}}, std::uint32_t(500 + scene));
            const auto found = findMarkers(drawTaggedFloor(view, floor), layout);
            QVERIFY2(worstOf(found, view, layout, 4).value_or(9) < 0.3, said(found).constData());
        }
        // Another board.
        auto other = layout;
        for (Marker &marker : other.markers)
            marker.label.replace(8, 3, "7x6");
        const FloorView view = someView({{-0.3, 0}, {1.8, 0}, {-0.3, 1.5}, {1.8, 1.5}}, 500);
        const auto wrong = findMarkers(drawTaggedFloor(view, floor), other);
        QVERIFY2(!wrong && contains(wrong.error().message(), "ChArUco"), said(wrong).constData());
    }
    void aTagSeenTwiceIsRefused()
    {
        const std::vector<int> numbers{103, 111, 117, 122, 129};
        TaggedFloor floor = floorOf(TagFamily::AprilTag36h11, numbers, fivePlaces, 81);
        floor.tags.push_back({{TagFamily::AprilTag36h11, 111}, {1.4, 1.1}, 0.15, 0.3});
        const FloorView view = someView(fivePlaces, 82);
        const auto found = findMarkers(drawTaggedFloor(view, floor), numbered(numbers, fivePlaces));
        QVERIFY2(!found && contains(found.error().message(), "tag 111 (marker 111) appears 2 times"),
                 said(found).constData());
    }
    void tagsElsewhereThanTheLayoutSays()
    {
        const std::vector<int> numbers{3, 11, 17, 22, 29};
        const FloorView view = someView(fivePlaces, 92);
        auto other = fivePlaces;
        std::swap(other[0], other[4]);
        other[2].x() += 0.7;
        const auto layout = numbered(numbers, other);
        const auto unexpected =
            findMarkers(drawTaggedFloor(view, floorOf(TagFamily::Aruco6x6, numbers, fivePlaces, 91)), layout);
        QVERIFY2(!unexpected && contains(unexpected.error().message(), "ArUco 6X6"),
                 said(unexpected).constData());
        // Those that Odograph prints go on to the registration, which says what is wrong with the layout.
        const auto expected = findMarkers(
            drawTaggedFloor(view, floorOf(TagFamily::AprilTag36h11, numbers, fivePlaces, 91)), layout);
        QVERIFY2(expected && expected->size() == 5, said(expected).constData());
    }
    void namesWhatIsMissing()
    {
        const std::vector<int> numbers{100, 101, 102, 103};
        const std::vector<Vector2d> places(fivePlaces.begin(), fivePlaces.begin() + 4);
        TaggedFloor floor = floorOf(TagFamily::AprilTag36h11, numbers, places, 95);
        const FloorView view = someView(places, 96);
        const MarkerLayout layout = numbered(numbers, places);
        const auto found = findMarkers(drawTaggedFloor(view, floor), layout);
        QVERIFY2(worstOf(found, view, layout, 4).value_or(9) < 0.3, said(found).constData());
        floor.tags.pop_back();
        const auto missing = findMarkers(drawTaggedFloor(view, floor), layout);
        QVERIFY2(!missing && contains(missing.error().message(), "3 of 4 were found") &&
                     contains(missing.error().message(), "missing: 103") &&
                     contains(missing.error().message(), "numbers of the labels"),
                 said(missing).constData());
    }
};

ODOGRAPH_TEST(TestLayoutTags, QCoreApplication)
#include "tst_layout_tags.moc"
