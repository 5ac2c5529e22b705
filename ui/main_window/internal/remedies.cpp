// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/main_window/internal/remedies.h"

#include <QCoreApplication>
#include <algorithm>
#include <array>
#include <string_view>

namespace odo {

namespace {

class RemedyWords
{
    Q_DECLARE_TR_FUNCTIONS(Remedy)
};

struct AdvisedRemedy
{
    std::string_view code; ///< of an advice
    Remedy remedy;
};

constexpr std::array advisedRemedies{
    AdvisedRemedy{"workflow.synchronise_again", Remedy::Synchronise},
    AdvisedRemedy{"workflow.synchronise_for_offset", Remedy::Synchronise},
    AdvisedRemedy{"workflow.turn_or_flash", Remedy::Synchronise},
    AdvisedRemedy{"workflow.check_files_and_offset", Remedy::Synchronise},
    AdvisedRemedy{"synchronisation.flash_lights", Remedy::Synchronise},
    AdvisedRemedy{"synchronisation.flash_or_clap", Remedy::Synchronise},
    AdvisedRemedy{"workflow.put_plate_on_it", Remedy::ChangeRobots},
    AdvisedRemedy{"workflow.look_at_outlines", Remedy::ChangeRobots},
    AdvisedRemedy{"workflow.give_own_colours", Remedy::ChangeRobots},
    AdvisedRemedy{"workflow.measure_height", Remedy::ChangeRobots},
    AdvisedRemedy{"workflow.check_robot_and_registration", Remedy::ChangeRobots},
    AdvisedRemedy{"trajectory.check_robot_and_light", Remedy::ChangeRobots},
    AdvisedRemedy{"trajectory.choose_longer_video", Remedy::ChangeRobots},
    AdvisedRemedy{"trajectory.centre_reference", Remedy::ChangeRobots},
    AdvisedRemedy{"workflow.register_a_camera", Remedy::OpenTestbed},
    AdvisedRemedy{"workflow.register_both_again", Remedy::OpenTestbed},
    AdvisedRemedy{"workflow.register_cameras_again", Remedy::OpenTestbed},
    AdvisedRemedy{"workflow.register_moved_again", Remedy::OpenTestbed},
    AdvisedRemedy{"workflow.register_in_this_video", Remedy::OpenTestbed},
    AdvisedRemedy{"workflow.register_upright", Remedy::OpenTestbed},
    AdvisedRemedy{"workflow.calibrate_and_reanalyse", Remedy::OpenTestbed},
    AdvisedRemedy{"workflow.fix_camera", Remedy::OpenTestbed},
    AdvisedRemedy{"trajectory.register_one", Remedy::OpenTestbed},
    AdvisedRemedy{"trajectory.register_them", Remedy::OpenTestbed},
    AdvisedRemedy{"trajectory.look_and_register", Remedy::OpenTestbed},
    AdvisedRemedy{"trajectory.track_first", Remedy::Track},
    AdvisedRemedy{"workflow.track_it_first", Remedy::Track},
    AdvisedRemedy{"workflow.track_or_choose_another", Remedy::Track},
    AdvisedRemedy{"project.track_again", Remedy::Track},
    AdvisedRemedy{"project.put_back_or_find", Remedy::FindVideos},
    AdvisedRemedy{"project.find_or_put_back", Remedy::FindVideos},
};

template <class Visit>
void visitParts(const Message &message, const Visit &visit)
{
    visit(message);
    for (const MessageArgument &argument : message.arguments)
        for (const Message &part : argument.parts)
            visitParts(part, visit);
}

} // namespace

QString remedyWords(Remedy remedy)
{
    switch (remedy) {
    case Remedy::Synchronise:
        return RemedyWords::tr("Synchronise…");
    case Remedy::ChangeRobots:
        return RemedyWords::tr("Robots…");
    case Remedy::OpenTestbed:
        return RemedyWords::tr("Open Testbed");
    case Remedy::Track:
        return RemedyWords::tr("Track…");
    case Remedy::FindVideos:
        break;
    }
    return RemedyWords::tr("Find lost videos…");
}

std::vector<Remedy> remediesOf(const Message &message)
{
    std::vector<Remedy> remedies;
    visitParts(message, [&](const Message &part) {
        const auto *const found = std::ranges::find(advisedRemedies, part.code(), &AdvisedRemedy::code);
        if (found != advisedRemedies.end() && std::ranges::find(remedies, found->remedy) == remedies.end())
            remedies.push_back(found->remedy);
    });
    return remedies;
}

QString trialIn(const Message &message)
{
    QString trial;
    visitParts(message, [&](const Message &part) {
        for (const MessageArgument &argument : part.arguments)
            if (trial.isEmpty() && argument.kind == MessageArgument::Kind::Trial)
                trial = QString::fromStdString(argument.text);
    });
    return trial;
}

} // namespace odo
