// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/workflow/import/chapter_names.h"
#include "core/workflow/import/recording_source.h"
#include "tests/support/registered_test.h"
#include "tests/support/said_error.h"
#include "tests/video/coded_frames.h"
#include "tests/video/foreign_files.h"

#include <QTemporaryDir>
#include <QTest>
#include <fstream>

using namespace odo;
using namespace odo::test;

using Kind = RecordingSource::Kind;

/// What a person means by the video of a view.
class TestRecordingSource : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void init();
    void aNameThatIsThereIsThatFile();
    void chaptersAreJoinedByAPlus();
    void eachChapterOnce();
    void imagesOfAFolderOrPattern();
    void refusesOtherFolders();
    void numbersAreFrames();
    void namesSayTheirPlace();
    void proposesChapters();

private:
    std::filesystem::path path(const std::string &name) const
    {
        return std::filesystem::path(m_folder->path().toStdString()) / name;
    }
    void make(const std::string &name) const
    {
        std::filesystem::create_directories(path(name).parent_path());
        std::ofstream(path(name)) << "x";
    }
    std::vector<std::string> filesOf(const std::string &name) const
    {
        const auto source = recordingSourceOf(path(name));
        if (!source)
            return {withoutFolder(source.error().message())};
        std::vector<std::string> names;
        for (const auto &file : source->files)
            names.push_back(withoutFolder(file.string()));
        return names;
    }
    std::string withoutFolder(const std::string &text) const
    {
        return QString::fromStdString(text).remove(m_folder->path() + u'/').toStdString();
    }
    using Names = std::vector<std::string>;
    std::unique_ptr<QTemporaryDir> m_folder;
};

void TestRecordingSource::init()
{
    m_folder = std::make_unique<QTemporaryDir>();
}

void TestRecordingSource::aNameThatIsThereIsThatFile()
{
    for (const char *name : {"a.mp4", "b.mp4", "a.mp4+b.mp4", "c+d.mp4", "%d.png"})
        make(name);
    QCOMPARE(filesOf("a.mp4"), Names{"a.mp4"});
    QCOMPARE(filesOf("a.mp4+b.mp4"), Names{"a.mp4+b.mp4"});
    QVERIFY(recordingSourceOf(path("a.mp4+b.mp4"))->kind == Kind::File);
    QCOMPARE(filesOf("%d.png"), Names{"%d.png"});
    QCOMPARE(filesOf("c+d.mp4+b.mp4"), (Names{"c+d.mp4", "b.mp4"})); // of parts as well
    QCOMPARE(filesOf("not+there.mp4"), Names{"not+there.mp4"});
    QVERIFY(recordingSourceOf(path("not+there.mp4"))->kind == Kind::File);
}

void TestRecordingSource::chaptersAreJoinedByAPlus()
{
    for (const char *name : {"x/1.mp4", "x/2.mp4", "y/3.mp4"})
        make(name);
    const auto source = recordingSourceOf(path("x/1.mp4+2.mp4+") += path("y/3.mp4"));
    QVERIFY(source && source->kind == Kind::Chapters);
    QCOMPARE(source->files, (std::vector{path("x/1.mp4"), path("x/2.mp4"), path("y/3.mp4")}));
    QCOMPARE(joinedNames(source->files), path("x/1.mp4+2.mp4+") += path("y/3.mp4"));
    // one that is missing is named as such
    QCOMPARE(filesOf("x/1.mp4+9.mp4").size(), std::size_t(2));
    QCOMPARE(filesOf("x/1.mp4+9.mp4").back(), std::string("9.mp4"));
}

void TestRecordingSource::eachChapterOnce()
{
    make("x/1.mp4");
    make("x/2.mp4");
    std::filesystem::create_hard_link(path("x/1.mp4"), path("x/same.mp4"));
    QCOMPARE(filesOf("x/1.mp4+2.mp4+same.mp4"),
             Names{"videos 'x/1.mp4+2.mp4+same.mp4': 'same.mp4' is given twice; give each file once, in "
                   "their order"});
}

void TestRecordingSource::imagesOfAFolderOrPattern()
{
    for (const char *name :
         {"p/a_9.png", "p/a_10.png", "p/a_0011.png", "p/notes.txt", "p/cover.png", "p/b_1.png"})
        make(name);
    const Names all{"p/a_9.png", "p/a_10.png", "p/a_0011.png"};
    QCOMPARE(filesOf("p"), all); // by number; a single one of another name is no series
    QVERIFY(recordingSourceOf(path("p"))->kind == Kind::Images);
    QCOMPARE(recordingSourceOf(path("p"))->numbers, (std::vector<std::int64_t>{9, 10, 11}));
    QCOMPARE(filesOf("p/a_%d.png"), all);
    QCOMPARE(filesOf("p/a_%02d.png"), (Names{"p/a_10.png", "p/a_0011.png"}));
}

void TestRecordingSource::refusesOtherFolders()
{
    std::filesystem::create_directory(path("empty"));
    QCOMPARE(filesOf("empty"),
             Names{"images 'empty': it is a folder; there are no numbered images (PNG, JPEG, TIFF, BMP, "
                   "WebP) of that "
                   "name; give a folder with images such as 000001.png, or a pattern such as "
                   "FOLDER/%06d.png"});
    for (const char *name : {"two/a1.png", "two/a2.png", "two/b1.jpg", "two/b2.jpg"})
        make(name);
    QCOMPARE(filesOf("two"), Names{"images 'two': the folder holds several series: a%d.png and b%d.jpg; "
                                   "name one of them, like FOLDER/a%d.png"});
    QCOMPARE(filesOf("two/b%d.jpg"), (Names{"two/b1.jpg", "two/b2.jpg"}));
    make("two/a01.png");
    QVERIFY(filesOf("two/a%d.png").front().find("have the same number; give each image a number") !=
            std::string::npos);
}

void TestRecordingSource::numbersAreFrames()
{
    const std::vector<std::int64_t> numbers{7, 8, 11};
    QCOMPARE(timesOfNumbers(numbers, 20),
             (std::vector<Nanoseconds>{Nanoseconds(0), Nanoseconds(50'000'000), Nanoseconds(200'000'000)}));
    QCOMPARE(missingImages("p", numbers).value().english(),
             std::string("images 'p': missing numbers: 2, the first behind 8; their frames count as lost, "
                         "and the others keep their times"));
    QVERIFY(missingImages("p", {1, 2, 3}).value().isEmpty());
    QCOMPARE(missingImages("p", {1000, 34333, 67666}).error().message(),
             std::string("images 'p': their numbers go from 1000 to 67666, and there are 3 images: they "
                         "do not count frames; give a table of their times, like --times A=stamps.csv"));
}

void TestRecordingSource::namesSayTheirPlace()
{
    const auto place = [](const char *name) {
        const auto of = SeriesName::of(name);
        return of ? of->series + " " + std::to_string(of->number) + (of->isChapter ? " chapter" : "")
                  : std::string("none");
    };
    QCOMPARE(place("GX021234.MP4"), std::string("GX1234.mp4 2 chapter"));
    QCOMPARE(place("GOPR1234.MP4"), std::string("GP1234.mp4 0 chapter"));
    QCOMPARE(place("GP011234.MP4"), std::string("GP1234.mp4 1 chapter"));
    QCOMPARE(place("DJI_0042.MP4"), std::string("DJI_#.mp4 42"));
    QCOMPARE(place("VID_20240506_part2.mp4"), std::string("VID_20240506_part#.mp4 2"));
    QCOMPARE(place("run.mp4"), std::string("none"));

    QVERIFY(chapterNameRemarks({"GX010001.MP4", "GX020001.MP4", "other.mp4"}).empty());
    QCOMPARE(
        english(chapterNameRemarks({"GX020001.MP4", "GX010001.MP4"})),
        Names{"by their names 'GX010001.MP4' comes before 'GX020001.MP4', and was joined behind it; check "
              "the order of the files"});
    QCOMPARE(english(chapterNameRemarks({"a_001.mp4", "a_003.mp4"})),
             Names{"by their names a file is missing between 'a_001.mp4' and 'a_003.mp4'; if so, all times "
                   "behind it are wrong"});
}

/// By name alone where the camera says so, else by when they were recorded, too.
void TestRecordingSource::proposesChapters()
{
    const auto groups = [&](const Names &names) {
        std::vector<std::filesystem::path> files;
        for (const std::string &name : names)
            files.push_back(path(name));
        Names found;
        for (const auto &group : chapterGroups(files))
            found.push_back(withoutFolder(joinedNames(group).string()));
        return found;
    };
    QCOMPARE(groups({"GX020001.MP4", "b.mp4", "GX010001.MP4", "GX010002.MP4"}),
             (Names{"GX010001.MP4+GX020001.MP4", "b.mp4", "GX010002.MP4"}));
    QCOMPARE(groups({"x/GX010001.MP4", "y/GX020001.MP4"}), (Names{"x/GX010001.MP4", "y/GX020001.MP4"}));
    QCOMPARE(groups({"GX010001.MP4", "GX030001.MP4"}), (Names{"GX010001.MP4", "GX030001.MP4"}));

    QVERIFY(writeCoded(path("raw.mp4"), evenTimes(60, 10), {}).isEmpty()); // 6 s
    for (const auto &[name, time] : {std::pair("a_1.mp4", "2024-05-06T10:11:10Z"),
                                     {"a_2.mp4", "2024-05-06T10:11:16Z"},
                                     {"a_3.mp4", "2024-05-06T10:12:16Z"},   // another run, later
                                     {"cam_1.mp4", "2024-05-06T10:11:10Z"}, // two cameras at once
                                     {"cam_2.mp4", "2024-05-06T10:11:10Z"}})
        QVERIFY(remux(path("raw.mp4"), path(name), {}, time));
    QCOMPARE(groups({"a_3.mp4", "a_2.mp4", "a_1.mp4"}), (Names{"a_3.mp4", "a_1.mp4+a_2.mp4"}));
    QCOMPARE(groups({"cam_1.mp4", "cam_2.mp4"}), (Names{"cam_1.mp4", "cam_2.mp4"}));
    QVERIFY(remux(path("raw.mp4"), path("c_1.mp4")) && remux(path("raw.mp4"), path("c_2.mp4"))); // no times
    QCOMPARE(groups({"c_1.mp4", "c_2.mp4"}), (Names{"c_1.mp4", "c_2.mp4"}));
}

ODOGRAPH_TEST(TestRecordingSource, QCoreApplication)
#include "tst_recording_source.moc"
