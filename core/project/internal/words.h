// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/project/records.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>

namespace odo {

/// What several errors and problems of a project say, the same words everywhere.

Message fileIsDamaged();
Message restoreFile(); ///< advice
Message isNoProject();
Message chooseOurFile(); ///< advice
Message isOfNewerFormat(std::int64_t version, int newestKnown);
Message openWithThatOdograph();  ///< advice
Message openWithNewerOdograph(); ///< advice
Message cannotBeWrittenTo();
Message copyToWritableFolder(); ///< advice
Message anotherProgramWrites();
Message closeOtherProgram(); ///< advice
Message diskCannotBeRead();
Message copyToAnotherDisk(); ///< advice
Message writingFailed(const std::error_code &reason);
Message checkDiskAndRetry(); ///< advice

Message isDamagedRestoreFile();       ///< advice, of what only a damaged file holds
Message restoreProject();             ///< advice
Message hasTooManySamples();          ///< more than maxBlobRows
Message useAtMost(std::size_t count); ///< advice
Message returnFile();                 ///< advice
Message keepIt();                     ///< advice
Message projectCheck();               ///< "check of the project"
Message runProjectCheck();            ///< advice

/// The words by which enumerations are stored. They are part of the file format: never change one.
template <class Value, std::size_t Count>
using StoredWords = std::array<std::pair<Value, std::string_view>, Count>;

constexpr StoredWords<LensModel, 3> lensModelWords{
    {{LensModel::Standard, "standard"}, {LensModel::Rational, "rational"}, {LensModel::Fisheye, "fisheye"}}};
constexpr StoredWords<BoardPattern, 2> boardPatternWords{
    {{BoardPattern::Checkerboard, "checkerboard"}, {BoardPattern::Charuco, "charuco"}}};
constexpr StoredWords<RobotRecord::Height, 3> heightModeWords{{{RobotRecord::Height::Given, "told"},
                                                               {RobotRecord::Height::Automatic, "automatic"},
                                                               {RobotRecord::Height::Free, "free"}}};
constexpr StoredWords<Smoother, 4> smootherWords{{{Smoother::Rts, "rts"},
                                                  {Smoother::SavGol, "savgol"},
                                                  {Smoother::Tracker, "tracker"},
                                                  {Smoother::None, "none"}}};

constexpr StoredWords<TaskTemplate, 5> taskTemplateWords{{{TaskTemplate::Free, "free"},
                                                          {TaskTemplate::StraightLine, "straight_line"},
                                                          {TaskTemplate::Circle, "circle"},
                                                          {TaskTemplate::FigureEight, "figure_eight"},
                                                          {TaskTemplate::Slalom, "slalom"}}};
constexpr StoredWords<GateRole, 4> gateRoleWords{{{GateRole::Start, "start"},
                                                  {GateRole::Finish, "finish"},
                                                  {GateRole::StartFinish, "start_finish"},
                                                  {GateRole::Split, "split"}}};
constexpr StoredWords<ZoneRule, 2> zoneRuleWords{
    {{ZoneRule::StayInside, "stay_inside"}, {ZoneRule::StayOutside, "stay_outside"}}};
constexpr StoredWords<DrawingColour, 7> drawingColourWords{{{DrawingColour::Automatic, "automatic"},
                                                            {DrawingColour::Blue, "blue"},
                                                            {DrawingColour::Vermilion, "vermilion"},
                                                            {DrawingColour::Green, "green"},
                                                            {DrawingColour::Purple, "purple"},
                                                            {DrawingColour::Orange, "orange"},
                                                            {DrawingColour::SkyBlue, "sky_blue"}}};
constexpr StoredWords<RegistrationCheck::Outcome, 4> checkOutcomeWords{
    {{RegistrationCheck::Outcome::Still, "still"},
     {RegistrationCheck::Outcome::CameraMoved, "camera"},
     {RegistrationCheck::Outcome::MarkersMoved, "markers"},
     {RegistrationCheck::Outcome::Undetermined, "not_told"}}};
constexpr StoredWords<ChangeEntry::Kind, 3> changeKindWords{{{ChangeEntry::Kind::Made, "made"},
                                                             {ChangeEntry::Kind::Undone, "undone"},
                                                             {ChangeEntry::Kind::Redone, "redone"}}};

template <class Words, class Value>
std::string storedWord(const Words &words, Value value)
{
    for (const auto &[known, word] : words) {
        if (known == value)
            return std::string(word);
    }
    return std::string(words.front().second);
}

tl::unexpected<Error> unknownStoredWord(const std::string &word, const Message &what);

/// Error NewerFormat for a word that this version does not know.
template <class Words>
auto fromStoredWord(const Words &words, const std::string &word, const Message &what)
    -> Result<typename Words::value_type::first_type>
{
    for (const auto &[value, known] : words) {
        if (known == word)
            return value;
    }
    return unknownStoredWord(word, what);
}

} // namespace odo
