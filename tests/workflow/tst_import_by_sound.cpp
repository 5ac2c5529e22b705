// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/file_system.h"
#include "core/project/project.h"
#include "core/project/repositories.h"
#include "core/workflow/import/import_trial_job.h"
#include "tests/support/registered_test.h"
#include "tests/video/sound_clips.h"

#include <QTemporaryDir>
#include <QTest>
#include <cmath>
#include <random>

using namespace odo;
using namespace odo::test;

using Sync = SyncBy;

/// Import synchronises views by the claps in their sound, or says why it does not.
class TestImportBySound : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void initTestCase();
    void findsClaps_data();
    void findsClaps();
    void everyViewByItself();
    void refuses_data();
    void refuses();
    void automaticSaysWhatIsMissing();

private:
    std::filesystem::path path(const QString &name) const { return m_folder.filePath(name).toStdString(); }
    ImportSettings settings(const QString &trial, const QStringList &files, Sync how) const;
    Result<void> run(ImportTrialJob &job) { return runToEnd(job, *m_project, {}); }

    QTemporaryDir m_folder;
    std::unique_ptr<Project> m_project;
};

namespace {

constexpr double offsetS = 1.2403;

/// Claps at these seconds of a clip, over some noise.
SoundClip clapping(const std::vector<double> &timesS, unsigned noiseSeed, int rate = 48'000)
{
    SoundClip clip;
    clip.lengthS = 6;
    clip.soundRate = rate;
    clip.sound.resize(std::size_t(clip.lengthS * rate));
    std::mt19937 noise(noiseSeed);
    std::normal_distribution<float> normal;
    for (float &value : clip.sound)
        value = 0.002F * normal(noise);
    for (std::size_t c = 0; c < timesS.size(); ++c) {
        std::mt19937 claps(unsigned(c) + 1); // the same in every clip, but for the rate
        std::vector<float> waves(48);
        for (float &wave : waves)
            wave = normal(claps);
        const double startS = timesS[c];
        for (auto i = std::size_t(startS * rate) + 1; double(i) / rate < startS + 0.05; ++i) {
            const double t = double(i) / rate - startS;
            double value = 0;
            for (std::size_t k = 0; k < waves.size(); ++k)
                value += double(waves[k]) *
                         std::sin(2 * 3.14159265 * (400 + 130.0 * double(k)) * t + double(k * k));
            clip.sound[i] += float(0.04 * value * std::exp(-t / 0.006));
        }
    }
    return clip;
}

} // namespace

void TestImportBySound::initTestCase()
{
    const std::vector<double> claps{2.5, 2.93};
    const std::vector<double> later{claps[0] - offsetS, claps[1] - offsetS};
    QVERIFY(writeSoundClip(path(QStringLiteral("a.mp4")), clapping(claps, 100)));
    SoundClip b = clapping(later, 200, 44'100);
    b.bitRate = 64'000;
    QVERIFY(writeSoundClip(path(QStringLiteral("b.mp4")), b));
    SoundClip late = clapping(later, 300);
    late.sound.erase(late.sound.begin(), late.sound.begin() + 24'000);
    late.soundLateS = 0.5;
    QVERIFY(writeSoundClip(path(QStringLiteral("late.mkv")), late));
    SoundClip mute;
    mute.lengthS = 6;
    QVERIFY(writeSoundClip(path(QStringLiteral("mute.mp4")), mute));
    QVERIFY(writeSoundClip(path(QStringLiteral("quiet.mp4")), clapping({}, 400)));
    auto project = Project::create(path(QStringLiteral("class.odo")), "Class");
    QVERIFY(project);
    m_project = std::move(*project);
}

ImportSettings TestImportBySound::settings(const QString &trial, const QStringList &files, Sync how) const
{
    ImportSettings result;
    result.trial = trial.toStdString();
    char camera = 'A';
    for (const QString &file : files)
        result.videos.emplace_back(std::string(1, camera++), path(file));
    result.steps = {{how, 0}};
    return result;
}

void TestImportBySound::findsClaps_data()
{
    QTest::addColumn<QString>("second");
    QTest::addColumn<Sync>("how");
    QTest::newRow("asked for") << QStringLiteral("b.mp4") << Sync::Sound;
    QTest::newRow("automatic") << QStringLiteral("b.mp4") << Sync::Automatic;
    QTest::newRow("the sound begins late") << QStringLiteral("late.mkv") << Sync::Sound;
}

void TestImportBySound::findsClaps()
{
    QFETCH(QString, second);
    QFETCH(Sync, how);
    const QString name = QString::fromLatin1(QTest::currentDataTag());
    ImportTrialJob job(settings(name, {QStringLiteral("a.mp4"), second}, how));
    const auto done = run(job);
    QVERIFY2(done, done ? "" : done.error().message().c_str());
    const auto trial = m_project->trials().find(name.toStdString());
    QCOMPARE(trial->syncMethod, std::string("audio"));
    QVERIFY2(std::abs(trial->syncOffsetS - offsetS) < 0.001,
             qPrintable(QString::number(trial->syncOffsetS, 'f', 5)));
    QVERIFY(trial->syncOffsetSigmaS > 0.004 &&
            trial->syncOffsetSigmaS < 0.006); // places of the cameras unknown
    QVERIFY(trial->syncScore > 0.5);
    const auto views = m_project->trials().recordings(trial->id);
    QCOMPARE((*views)[1].syncMethod, std::string("audio"));
    QVERIFY(isStepMeasured((*views)[1]));
    QCOMPARE(int(std::ranges::count_if(
                 job.warnings(),
                 [](const Message &warning) {
                     return warning.english().find("measured by the sound to only ±5.") != std::string::npos;
                 })),
             how == Sync::Automatic ? 1 : 0);
}

void TestImportBySound::everyViewByItself()
{
    ImportSettings mixed =
        settings(QStringLiteral("mixed"),
                 {QStringLiteral("a.mp4"), QStringLiteral("mute.mp4"), QStringLiteral("b.mp4")}, Sync::None);
    mixed.steps = {{Sync::Given, 0.25}, {Sync::Sound, 0}};
    ImportTrialJob job(std::move(mixed));
    const auto done = run(job);
    QVERIFY2(done, done ? "" : done.error().message().c_str());
    const auto views = m_project->trials().recordings(m_project->trials().find("mixed")->id);
    QCOMPARE((*views)[1].syncMethod, std::string("told"));
    QCOMPARE((*views)[2].syncMethod, std::string("audio"));
    QVERIFY(std::abs((*views)[2].startOffsetS - offsetS) < 0.001);
}

void TestImportBySound::refuses_data()
{
    QTest::addColumn<QString>("second");
    QTest::addColumn<Sync>("how");
    QTest::addColumn<bool>("isSlow");
    QTest::addColumn<QString>("words");
    const auto row = [](const char *title, const char *second, Sync how, const char *words,
                        bool isSlow = false) {
        QTest::newRow(title) << QString::fromLatin1(second) << how << isSlow << QString::fromLatin1(words);
    };
    row("no sound", "mute.mp4", Sync::Sound,
        "view 'B' has no sound; clap twice near the middle of the floor while both cameras record, or give "
        "--sync "
        "SECONDS");
    row("nothing loud", "quiet.mp4", Sync::Sound,
        "no clap, knock or whistle is heard clearly in both clips; clap twice near");
    row("slow motion", "b.mp4", Sync::Sound,
        "sound cannot be compared in clips that play in slow motion; clap twice near", true);
    row("no flash", "b.mp4", Sync::Flash,
        "neither view shows a flash of light; flash the room lights once while both cameras record, or give "
        "--sync "
        "SECONDS");
    row("no motion", "b.mp4", Sync::Motion, "camera 'A' is not registered to the floor");
}

void TestImportBySound::refuses()
{
    QFETCH(QString, second);
    QFETCH(Sync, how);
    QFETCH(bool, isSlow);
    QFETCH(QString, words);
    ImportSettings wanted = settings(QStringLiteral("refused"), {QStringLiteral("a.mp4"), second}, how);
    if (isSlow)
        wanted.rate = 240;
    ImportTrialJob job(std::move(wanted));
    const auto done = run(job);
    QVERIFY(!done);
    QVERIFY(done.error().code == ErrorCode::Undetermined);
    QVERIFY2(done.error().message().starts_with("synchronisation of view 'B': " + words.toStdString()),
             done.error().message().c_str());
    QVERIFY(!m_project->trials().find("refused"));
}

void TestImportBySound::automaticSaysWhatIsMissing()
{
    ImportTrialJob job(settings(QStringLiteral("silent"),
                                {QStringLiteral("a.mp4"), QStringLiteral("mute.mp4")}, Sync::Automatic));
    const auto done = run(job);
    QVERIFY2(done, done ? "" : done.error().message().c_str());
    QCOMPARE(m_project->trials().find("silent")->syncMethod, std::string("open"));
    QCOMPARE(job.warnings().front().english(),
             std::string(
                 "synchronisation of view 'B': camera 'A' is not registered to the floor, neither view shows "
                 "a flash of light, and view 'B' has no sound; tracking tries again; flash the "
                 "room lights or clap twice while both cameras record, or give --sync SECONDS"));
}

ODOGRAPH_TEST(TestImportBySound, QCoreApplication)
#include "tst_import_by_sound.moc"
