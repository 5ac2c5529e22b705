// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/workflow/import/clip_groups.h"

#include "tests/support/registered_test.h"

#include <QTest>
#include <random>

using namespace odo;
using namespace std::chrono_literals;

namespace {

constexpr Nanoseconds noon = std::chrono::hours(24 * 365 * 56) + std::chrono::hours(12); // of some day

FoundClip clip(const std::string &file, double atS, double lengthS)
{
    const std::filesystem::path path(file);
    const std::string stem = path.stem().string();
    return {path, (path.parent_path() / stem.substr(0, stem.find_first_of("0123456789"))).string(),
            RecordedSpan{noon + fromSeconds(atS), fromSeconds(lengthS)}};
}

FoundClip timeless(const std::string &file)
{
    FoundClip one = clip(file, 0, 0);
    one.span.reset();
    return one;
}

/// "a1+b1 a2+-"
std::string shown(const std::vector<ClipGroup> &groups)
{
    std::string all;
    for (const ClipGroup &group : groups) {
        if (!all.empty())
            all += ' ';
        for (std::size_t i = 0; i < group.views.size(); ++i)
            all += (i > 0 ? "+" : "") + (group.views[i].empty() ? "-" : group.views[i].filename().string());
    }
    return all;
}

} // namespace

class TestClipGroups : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void runsAreTheClipsOfOneTime();
    void clocksMayBeSecondsApart();
    void oneMayNoteTheEnd();
    void equalPhonesAreToldApartByNumber();
    void namesThatAreTimesTellNoPhonesApart();
    void numbersAreNoWords();
    void aMissingClipLeavesItsPlaceEmpty();
    void runsThatFollowAtOnceStayApart();
    void aLessonInAnyOrder();
    void withoutTimesByTheOrderOfNames();
    void withoutAnyOrderEachIsByItself();
    void saysWhenItWas();
};

void TestClipGroups::runsAreTheClipsOfOneTime()
{
    QVERIFY(groupClips({}).empty());
    QCOMPARE(shown(groupClips({clip("x/PXL_1.mp4", 0, 20), clip("x/IMG_7.mov", 1, 24),
                               clip("x/IMG_8.mov", 100, 15), clip("x/PXL_2.mp4", 101, 18)})),
             std::string("IMG_7.mov+PXL_1.mp4 IMG_8.mov+PXL_2.mp4"));
    QCOMPARE(shown(groupClips({clip("left/VID_1.mp4", 0, 20), clip("right/VID_1.mp4", 1, 20)})),
             std::string("VID_1.mp4+VID_1.mp4"));
}

void TestClipGroups::clocksMayBeSecondsApart()
{
    QCOMPARE(shown(groupClips({clip("a/1.mp4", 0, 20), clip("b/1.mp4", 4.5, 20), clip("a/2.mp4", 60, 20),
                               clip("b/2.mp4", 64.5, 20)})),
             std::string("1.mp4+1.mp4 2.mp4+2.mp4"));
}

/// Android notes when a recording ended, an iPhone when it began.
void TestClipGroups::oneMayNoteTheEnd()
{
    QCOMPARE(shown(groupClips({clip("a/1.mp4", 0, 30), clip("b/1.mp4", 31, 30), clip("a/2.mp4", 120, 30),
                               clip("b/2.mp4", 151, 31)})),
             std::string("1.mp4+1.mp4 2.mp4+2.mp4"));
}

/// What was recorded at once is of two cameras, whatever the names.
void TestClipGroups::equalPhonesAreToldApartByNumber()
{
    QCOMPARE(shown(groupClips({clip("x/IMG_0456.MOV", 1, 20), clip("x/IMG_1234.MOV", 0, 20),
                               clip("x/IMG_0457.MOV", 90, 20), clip("x/IMG_1235.MOV", 91, 20)})),
             std::string("IMG_0456.MOV+IMG_1234.MOV IMG_0457.MOV+IMG_1235.MOV"));
}

/// By their order the phone that was started first would be another one in each run.
void TestClipGroups::namesThatAreTimesTellNoPhonesApart()
{
    QCOMPARE(shown(groupClips(
                 {clip("x/PXL_20260309_101500123.mp4", 0, 20), clip("x/PXL_20260309_101501456.mp4", 1, 20)})),
             std::string("PXL_20260309_101500123.mp4 PXL_20260309_101501456.mp4"));
    QCOMPARE(shown(groupClips({clip("a/20260309_101500.mp4", 0, 20), clip("b/20260309_101501.mp4", 1, 20)})),
             std::string("20260309_101500.mp4+20260309_101501.mp4"));
}

void TestClipGroups::numbersAreNoWords()
{
    QCOMPARE(shown(groupClips({timeless("a/IMG_99.mov"), timeless("a/IMG_100.mov"), timeless("b/VID_9.mov"),
                               timeless("b/VID_10.mov")})),
             std::string("IMG_99.mov+VID_9.mov IMG_100.mov+VID_10.mov"));
    QCOMPARE(shown(groupClips({clip("x/IMG_1000.mov", 1, 20), clip("x/IMG_999.mov", 0, 20)})),
             std::string("IMG_999.mov+IMG_1000.mov"));
}

void TestClipGroups::aMissingClipLeavesItsPlaceEmpty()
{
    QCOMPARE(shown(groupClips({clip("a/1.mp4", 0, 20), clip("b/1.mp4", 1, 20), clip("b/2.mp4", 100, 20),
                               clip("a/3.mp4", 200, 20), clip("b/3.mp4", 200, 20)})),
             std::string("1.mp4+1.mp4 -+2.mp4 3.mp4+3.mp4"));
}

void TestClipGroups::runsThatFollowAtOnceStayApart()
{
    QCOMPARE(shown(groupClips({clip("a/1.mp4", 0, 20), clip("a/2.mp4", 22, 20), clip("a/3.mp4", 44, 20)})),
             std::string("1.mp4 2.mp4 3.mp4"));
    QCOMPARE(shown(groupClips({clip("a/1.mp4", 0, 20), clip("b/1.mp4", 0, 20), clip("a/2.mp4", 22, 20),
                               clip("b/2.mp4", 22, 20)})),
             std::string("1.mp4+1.mp4 2.mp4+2.mp4"));
    QCOMPARE(shown(groupClips({clip("a/1.mp4", 0, 2), clip("a/2.mp4", 3, 2)})), std::string("1.mp4 2.mp4"));
}

/// Thirty runs of two phones whose clocks are up to 4 s apart, handed over in any order.
void TestClipGroups::aLessonInAnyOrder()
{
    std::mt19937 random(3);
    std::uniform_real_distribution<double> share(0, 1);
    std::vector<FoundClip> clips;
    std::string wanted;
    double atS = 0;
    const double apartS = 8 * share(random) - 4;
    for (int run = 100; run < 130; ++run) {
        const double lengthS = 10 + 50 * share(random);
        const std::string a = "IMG_" + std::to_string(run) + ".mov",
                          b = "PXL_" + std::to_string(run) + ".mp4";
        clips.push_back(clip("x/" + a, atS, lengthS));
        clips.push_back(clip("x/" + b, atS + apartS, lengthS + 2 * share(random)));
        wanted += (wanted.empty() ? "" : " ") + a + '+' + b;
        atS += lengthS + 15 + 100 * share(random);
    }
    for (int time = 0; time < 20; ++time) {
        std::ranges::shuffle(clips, random);
        QCOMPARE(shown(groupClips(clips)), wanted);
    }
}

void TestClipGroups::withoutTimesByTheOrderOfNames()
{
    QCOMPARE(shown(groupClips(
                 {timeless("b/2.mp4"), timeless("a/1.mp4"), timeless("a/2.mp4"), timeless("b/1.mp4")})),
             std::string("1.mp4+1.mp4 2.mp4+2.mp4"));
    // One that has no time is enough: those that have it prove nothing of the others.
    QCOMPARE(shown(groupClips({clip("b/2.mp4", 0, 10), timeless("a/1.mp4"), timeless("a/2.mp4"),
                               clip("b/1.mp4", 50, 10)})),
             std::string("1.mp4+1.mp4 2.mp4+2.mp4"));
}

void TestClipGroups::withoutAnyOrderEachIsByItself()
{
    QCOMPARE(shown(groupClips({timeless("a/1.mp4"), timeless("a/2.mp4"), timeless("b/1.mp4")})),
             std::string("1.mp4+- 2.mp4+- -+1.mp4"));
}

void TestClipGroups::saysWhenItWas()
{
    const auto groups = groupClips({clip("a/1.mp4", 1, 20), clip("b/1.mp4", 0, 25.5)});
    QCOMPARE(groups.size(), std::size_t(1));
    QVERIFY(groups.front().recorded);
    QCOMPARE(groups.front().lengthS, 25.5);
    const auto apart = groups.front().recorded->time_since_epoch() - noon;
    QVERIFY(apart == 0s || apart == 1s); // that of the first camera's clip
    QVERIFY(!groupClips({timeless("a/1.mp4")}).front().recorded);
}

ODOGRAPH_TEST(TestClipGroups, QCoreApplication)
#include "tst_clip_groups.moc"
