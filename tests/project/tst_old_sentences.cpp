// SPDX-License-Identifier: GPL-3.0-or-later
// The sentences that projects held before messages were stored: what they became.
#include "core/project/internal/old_sentences.h"
#include "core/project/message_json.h"
#include "tests/support/patience.h"
#include "tests/support/registered_test.h"

#include <QElapsedTimer>
#include <QTest>
#include <array>
#include <set>

using namespace odo;

class TestOldSentences : public QObject
{
    Q_OBJECT

    using Of = OldSentences;
    static constexpr std::array all{Of::Calibrations, Of::Registrations, Of::Spikes, Of::Pictures,
                                    Of::Origins,      Of::Readings,      Of::Changes};

    /// A message whose words may be those of a part of the program that is not here.
    static Message said(const char *code, std::vector<MessageArgument> with = {})
    {
        return {messageText(code), std::move(with)};
    }
    static MessageArgument mm(double value, int decimals) { return quantity(value, decimals, "mm"); }
    static MessageArgument px(double value, int decimals) { return quantity(value, decimals, "px"); }
    static void expect(Of of, const std::string &text, const Message &message)
    {
        const Message read = fromOldSentence(of, text);
        QVERIFY2(read == message,
                 (text + "\n" + storedMessage(read) + "\n" + storedMessage(message)).c_str());
    }

private Q_SLOTS:
    void eachTellsOfItsArguments()
    {
        for (const Of of : all) {
            for (const OldSentence &sentence : oldSentences(of)) {
                const std::string_view english = sentence.english, letters = sentence.arguments;
                std::set<char> numbers;
                for (std::size_t i = 0; i + 1 < english.size(); ++i) {
                    if (english[i] == '%' && english[i + 1] >= '1' && english[i + 1] <= '9')
                        numbers.insert(english[i + 1]);
                }
                QVERIFY2(numbers.size() == letters.size(), sentence.english);
                QVERIFY2(numbers.empty() || *numbers.rbegin() == char('0' + numbers.size()),
                         sentence.english);
                QVERIFY2(letters.find_first_not_of("nwscrekatlmfCRMFP") == std::string_view::npos,
                         sentence.english);
            }
        }
    }

    void aVerdictOnALens()
    {
        const Message reason =
            said("calibration.foretells_as_well", {px(0.055, 3), said("calibration.fisheye"), px(0.059, 3)});
        expect(Of::Calibrations,
               "it foretells pictures held out to 0.055 px, the fisheye one no better (0.059 px)", reason);
        const Message floor = said("calibration.typical_testbed",
                                   {quantity(3, 0, "m"), quantity(2, 0, "m"), quantity(2, 0, "m")});
        expect(
            Of::Calibrations,
            "Good: ±0.1 mm in the middle and ±0.2 mm at worst (in the near right corner) on a 3 m × 2 m "
            "floor "
            "seen from 2 m above, as far as the lens is concerned; 14 pictures fit to 0.05 px, focal length "
            "960.0 px ± 0.02 %; each half of them foretells the other to 0.05 px, 2.1 mm apart at worst on "
            "that "
            "floor. Standard lens: it foretells pictures held out to 0.055 px, the fisheye one no better "
            "(0.059 "
            "px).",
            joined(
                {said("calibration.good",
                      {joined({said("calibration.lens_on_floor",
                                    {mm(0.1, 1), mm(0.2, 1), said("calibration.near_right_corner"), floor}),
                               said("calibration.pictures_fit",
                                    {14, px(0.05, 2), px(960, 1), quantity(0.02, 2, "%")}),
                               said("calibration.halves_foretell_apart", {px(0.05, 2), mm(2.1, 1)})},
                              Join::Semicolon)}),
                 said("calibration.sentence",
                      {joined({said("calibration.standard_lens"), reason}, Join::Colon)})},
                Join::Space));
    }

    void picturesAreCounted()
    {
        const auto image = [](const char *name, int count) {
            return said("calibration.picture_with_corners", {std::string(name), count});
        };
        expect(
            Of::Calibrations,
            "Fisheye lens: told. 3 corners that stand out were left out, most in a 1.png (2) and b.png (1).",
            joined({said("calibration.sentence",
                         {joined({said("calibration.fisheye_lens"), said("calibration.lens_told")},
                                 Join::Colon)}),
                    said("calibration.corners_left_out_most_in",
                         {3, listed({image("a 1.png", 2), image("b.png", 1)})})},
                   Join::Space));
    }

    void aVerdictOnARegistration()
    {
        expect(
            Of::Registrations,
            "Good: 4 markers fit to 0.1 mm RMS (worst St. 3, 0.1 mm), and the floor among them is known to "
            "±3.4 mm. Four markers hardly check one another; a fifth would.",
            joined({said("calibration.good",
                         {said("calibration.markers_fit",
                               {4, mm(0.1, 1), Named::marker("St. 3"), mm(0.1, 1), mm(3.4, 1)})}),
                    joined({said("calibration.four_markers_unchecked"), said("calibration.fifth_would")},
                           Join::Semicolon)},
                   Join::Space));
        const Message left = said("base.camera", {Named::camera("Left 2")});
        expect(
            Of::Registrations,
            "Usable: through camera 'Left 2' 8 points of the floor fit to 1.0 mm RMS (worst 7, 2.0 mm), and "
            "the floor among them is known to ±4.0 mm, of which ±3.0 mm come from camera 'Left 2'.",
            said("calibration.usable",
                 {said("calibration.points_fit",
                       {left, 8, mm(1, 1), Named::marker("7"), mm(2, 1), mm(4, 1), mm(3, 1), left})}));
        expect(Of::Registrations,
               "Markers U and V have moved 12 px = 34 mm, A has not: put them back, or measure again and "
               "register all cameras. Not found again: none.",
               joined({joined({said("calibration.markers_moved",
                                    {listed({"U", "V"}, MessageArgument::Kind::Marker), px(12, 0), mm(34, 0),
                                     Named::camera("A")}),
                               said("calibration.put_markers_back")},
                              Join::Colon),
                       said("calibration.not_found_again", {listed({})})},
                      Join::Space));
    }

    void shortOnes()
    {
        expect(Of::Spikes, "jump of 40 mm", said("trajectory.jump_of", {mm(40, 0)}));
        expect(Of::Spikes, "views disagree by 84 mm; one left out; the tracker was not sure (score 12 %)",
               joined({said("trajectory.views_disagree", {mm(84, 0)}), said("trajectory.view_left_out"),
                       said("trajectory.tracker_unsure", {quantity(12, 0, "%")})},
                      Join::Semicolon));
        expect(Of::Pictures, "the board is cut off: only 9x5 of its 9x6 inner corners are seen",
               joined({said("calibration.board_cut_off"),
                       said("calibration.board_part_seen", {std::string("9x5"), std::string("9x6")})},
                      Join::Colon));
        expect(Of::Origins, "calibrated from 14 pictures", said("workflow.calibrated_from_pictures", {14}));
        expect(Of::Origins, "imported from A; B.yaml",
               said("workflow.lens_imported_from", {Named::file("A; B.yaml")}));
        expect(Of::Readings, "positions to 1.00 mm, as the file says; its times count from 2.500 s",
               joined({said("workflow.error_stated", {mm(1, 2)}),
                       said("workflow.times_count_from", {quantity(2.5, 3, "s")})},
                      Join::Semicolon));
    }

    void changesKeepTheirNames()
    {
        expect(Of::Changes, "mark frame 12 of Trial 1 as a spike",
               said("workflow.mark_spike", {12, Named::trial("Trial 1")}));
        expect(Of::Changes, "rename team Falcon to Heron",
               said("ui.rename_team", {Named::team("Falcon"), Named::team("Heron")}));
        expect(Of::Changes, "star Anna: 2nd. Run", said("ui.star_trial", {Named::trial("Anna: 2nd. Run")}));
        expect(Of::Changes, "star 3 trials", said("ui.star_trials", {3}));
        expect(Of::Changes, "track 007", said("workflow.track", {Named::trial("007")}));
    }

    void whatIsNoneOfThemStaysAsItIs()
    {
        for (const Of of : all) {
            QVERIFY(fromOldSentence(of, "").isEmpty());
            for (const std::string text : {"typical error 1.5 mm", "Stern an Lauf 1", "{\"code\":\"a.b\"}"})
                expect(of, text, foreignWords(text));
        }
        expect(Of::Registrations, "It was good then. Calibrate it for positions to rely on. Who knows.",
               joined({foreignWords("It was good then."), said("calibration.calibrate_to_rely"),
                       foreignWords("Who knows.")},
                      Join::Space));
    }

    /// A file may be made so that looking through it does not end.
    void noTextTakesLong()
    {
        QElapsedTimer clock;
        clock.start();
        for (const std::string part : {"jump; ", "Good: ", ". . ", "..", "A has moved 3 px = 2 mm. ",
                                       " is 3 mm off by all cameras: ", " and ", "%1 "}) {
            std::string text;
            while (text.size() < 5000 - part.size())
                text += part;
            for (const Of of : all)
                static_cast<void>(fromOldSentence(of, text));
        }
        QVERIFY2(clock.elapsed() < 10'000 * test::slowness, QByteArray::number(clock.elapsed()).constData());
        expect(Of::Changes, "track " + std::string(6000, 'x'),
               foreignWords("track " + std::string(6000, 'x')));
    }
};

ODOGRAPH_TEST(TestOldSentences, QCoreApplication)
#include "tst_old_sentences.moc"
