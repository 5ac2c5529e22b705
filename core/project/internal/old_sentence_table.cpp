// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/internal/old_sentences.h"

namespace odo {

// The codes of sentences that other folders make are as those folders had them while this was written; each
// must be one that the program knows (allMessageTexts).

namespace {

constexpr OldSentence calibrations[] = {
    {"Good: %1.", "calibration.good", "w"},
    {"Usable: %1.", "calibration.usable", "w"},
    {"Poor: %1.", "calibration.poor", "w"},
    {"no figure in millimetres, since this lens holds only for a part of the picture",
     "calibration.no_millimetres"},
    {"±%1 mm in the middle and ±%2 mm at worst (%3) on %4, as far as the lens is concerned",
     "calibration.lens_on_floor", "nnww"},
    {"in the far left corner", "calibration.far_left_corner"},
    {"in the far right corner", "calibration.far_right_corner"},
    {"in the near left corner", "calibration.near_left_corner"},
    {"in the near right corner", "calibration.near_right_corner"},
    {"at the far edge", "calibration.far_edge"},
    {"at the near edge", "calibration.near_edge"},
    {"at the left edge", "calibration.left_edge"},
    {"at the right edge", "calibration.right_edge"},
    {"inside", "calibration.inside"},
    {"a %1 m × %2 m floor seen from %3 m above", "calibration.typical_testbed", "nnn"},
    {"%1 pictures fit to %2 px, focal length %3 px ± %4 %", "calibration.pictures_fit", "nnnn"},
    {"%1 pictures fit to %2 px, focal length %3 px ± %4 %, %5 mm apart at worst on that floor",
     "calibration.pictures_fit_halves_apart", "nnnnn"},
    {"each half of them foretells the other to %1 px", "calibration.halves_foretell", "n"},
    {"each half of them foretells the other to %1 px, %2 mm apart at worst on that floor",
     "calibration.halves_foretell_apart", "nn"},
    {"Standard lens", "calibration.standard_lens"},
    {"Rational lens", "calibration.rational_lens"},
    {"Fisheye lens", "calibration.fisheye_lens"},
    {"standard", "calibration.standard"},
    {"rational", "calibration.rational"},
    {"fisheye", "calibration.fisheye"},
    {"told", "calibration.lens_told"},
    {"no other model fits", "calibration.no_other_lens"},
    {"too few pictures to compare it with others", "calibration.too_few_to_compare"},
    {"not all", "calibration.not_all_foretold"},
    {"it foretells pictures held out to %1, the %2 one to %3, which may be chance",
     "calibration.foretells_by_chance", "www"},
    {"it foretells pictures held out to %1, the %2 one no better (%3)", "calibration.foretells_as_well",
     "www"},
    {"it foretells pictures held out to %1, the %2 one only to %3", "calibration.foretells_better", "www"},
    {"%1 % of the corners disagree, in %2", "calibration.disagree_in", "nP"},
    {"%1 % of the corners disagree, most in %2", "calibration.disagree_most_in", "nP"},
    {"they were kept", "calibration.were_kept"},
    {"look at these pictures and leave out those that are blurred, bent or of another board.",
     "calibration.look_at_pictures"},
    {"1 corner that stands out was left out, in %1.", "calibration.corner_left_out", "P"},
    {"%1 corners that stand out were left out, in %2.", "calibration.corners_left_out_in", "nP"},
    {"%1 corners that stand out were left out, most in %2.", "calibration.corners_left_out_most_in", "nP"},
    {"%1 corners that stand out side by side were kept, in %2", "calibration.corners_kept_in", "nP"},
    {"%1 corners that stand out side by side were kept, most in %2", "calibration.corners_kept_most_in",
     "nP"},
    {"leave out these pictures if the board is bent, cut or covered there.",
     "calibration.leave_out_pictures"},
    {"More pictures (%1 or more) would make it surer.", "calibration.more_pictures", "n"},
    {"Only %1 % of the picture was covered", "calibration.picture_covered", "n"},
    {"show the board near its edges too.", "calibration.show_near_edges"},
    {"Look at %1", "calibration.look_at", "s"},
    {"its %1 px stand out.", "calibration.picture_stands_out", "n"},
};

constexpr OldSentence registrations[] = {
    {"Good: %1.", "calibration.good", "w"},
    {"Usable: %1.", "calibration.usable", "w"},
    {"Poor, measure the markers again: %1.", "calibration.poor_measure_again", "w"},
    {"%1 markers fit to %2 mm RMS (worst %3, %4 mm), and the floor among them is known to ±%5 mm",
     "calibration.markers_fit", "nnmnn"},
    {"Four markers hardly check one another", "calibration.four_markers_unchecked"},
    {"Four points hardly check one another", "calibration.four_points_unchecked"},
    {"a fifth would.", "calibration.fifth_would"},
    {"The camera was taken as free of distortion, its focal length estimated from the markers (%1 px ± %2).",
     "calibration.focal_length_estimated", "nn"},
    {"The camera was taken as free of distortion, its focal length guessed (%1 px), since this view does not "
     "determine it.",
     "calibration.focal_length_guessed", "n"},
    {"The camera was taken as free of distortion, its focal length as %1 px.",
     "calibration.focal_length_taken", "n"},
    {"Calibrate it for positions to rely on.", "calibration.calibrate_to_rely"},
    {"The camera would stand only %1 mm above the floor", "calibration.camera_stands_low", "n"},
    {"if that is wrong, the layout's numbers are no mm", "calibration.layout_not_in_mm"},
    {"convert its unit.", "calibration.convert_unit"},
    {"through %1 %2 points of the floor fit to %3 mm RMS (worst %4, %5 mm), and the floor among them is "
     "known "
     "to ±%6 mm, of which ±%7 mm come from %8",
     "calibration.points_fit", "wnnmnnnw"},
    {"camera '%1'", "base.camera", "c"},
    {"with %1 together %2 markers fit to %3 mm RMS, and the floor among them is known to ±%4 mm",
     "calibration.markers_fit_together", "Cnnn"},
    {"The markers and the cameras agree with one another.", "calibration.all_agree"},
    {"%1 is %2 mm off by all cameras", "calibration.marker_off_by_all", "mn"},
    {"measure it again.", "calibration.measure_it_again"},
    {"%1 is %2 mm off by the one camera that sees it", "calibration.marker_off_by_one", "mn"},
    {"measure it, or mark it in the picture, again.", "calibration.measure_or_mark_again"},
    {"%1 sees %2 %3 px from where the others do", "calibration.camera_sees_elsewhere", "cmn"},
    {"mark it there again.", "calibration.mark_there_again"},
    {"The world axes were changed afterwards.", "calibration.axes_changed"},
    {"The world axes were changed afterwards, and all lengths multiplied by %1.",
     "calibration.axes_changed_and_scaled", "n"},
    {"It was made through registration %1 of the project.", "workflow.made_through_registration", "n"},
    {"%1 stands where it was registered", "calibration.camera_still", "c"},
    {"%1 markers lie within %2 px = %3 mm of their places.", "calibration.markers_in_place", "nnn"},
    {"%1 has moved %2 px = %3 mm", "calibration.camera_moved", "cnn"},
    {"register it again before you record.", "calibration.register_before_recording"},
    {"Marker %1 has moved %2 px = %3 mm, %4 has not", "calibration.marker_moved", "mnnc"},
    {"Markers %1 have moved %2 px = %3 mm, %4 has not", "calibration.markers_moved", "Mnnc"},
    {"put it back, or measure again and register all cameras.", "calibration.put_marker_back"},
    {"put them back, or measure again and register all cameras.", "calibration.put_markers_back"},
    {"Not found again: %1.", "calibration.not_found_again", "M"},
};

constexpr OldSentence spikes[] = {
    {"views disagree by %1 mm", "trajectory.views_disagree", "n"},
    {"none could be trusted", "trajectory.no_view_trusted"},
    {"one left out", "trajectory.view_left_out"},
    {"jump of %1 mm", "trajectory.jump_of", "n"},
    {"jump", "trajectory.jump"},
    {"stands out in position and speed", "trajectory.stands_out_in_both"},
    {"stands out in position", "trajectory.stands_out_in_position"},
    {"stands out in speed", "trajectory.stands_out_in_speed"},
    {"faster than the limit", "trajectory.faster_than_limit"},
    {"harder than the limit of acceleration", "trajectory.harder_than_limit"},
    {"called a spike by hand", "trajectory.spike_by_hand"},
    {"cut by the picture's edge", "trajectory.cut_by_edge"},
    {"the tracker was not sure (score %1 %)", "trajectory.tracker_unsure", "n"},
};

constexpr OldSentence pictures[] = {
    {"no board found", "calibration.no_board_found"},
    {"%1 of its markers could be read", "calibration.markers_read", "n"},
    {"the board is cut off", "calibration.board_cut_off"},
    {"only %1 of its %2 inner corners are seen", "calibration.board_part_seen", "ss"},
    {"this board has %1 inner corners, %2 was asked for", "calibration.board_of_other_size", "ss"},
    {"the board is blurred", "calibration.board_blurred"},
    {"its edges are %1 pixels wide", "calibration.edges_wide", "n"},
    {"a corner of the board cannot be made out", "calibration.corner_unclear"},
    {"only %1 corners of the board are seen", "calibration.few_corners_seen", "n"},
    {"the markers that were read do not lie as on a ChArUco board", "calibration.no_charuco"},
    {"the markers that were read do not lie as on a ChArUco board of %1 inner corners",
     "calibration.no_charuco_of_size", "s"},
    {"there is no marker dictionary %1", "calibration.no_dictionary", "s"},
    {"the picture is too small to hold a board", "calibration.too_small_for_board"},
    {"a board of %1 inner corners is too small", "calibration.told_board_too_small", "s"},
    {"the squares have no size", "calibration.squares_without_size"},
    {"it is %1×%2, the first picture %3×%4", "calibration.other_picture_size", "nnnn"},
    {"it has %1 corners of the board, six are needed", "calibration.too_few_corners", "n"},
    {"show more of it", "calibration.show_more_of_it"},
    {"a corner of it is not a number", "calibration.corner_no_number"},
    {"let the board be found in it again", "calibration.find_board_again"},
    {"its corners do not lie as on a flat board", "calibration.corners_not_flat"},
    {"glue the board onto something stiff", "calibration.glue_board"},
    {"the board is seen too obliquely, at %1 degrees", "calibration.board_too_oblique", "n"},
    {"the board is too small", "calibration.board_too_small"},
    {"it fills %1 % of the picture", "calibration.board_fills", "n"},
    {"the corners do not lie as on a flat board", "calibration.board_not_flat"},
    {"the board stands as in %1 already", "calibration.board_stands_as_in", "s"},
    {"the board stands as in a picture already taken", "calibration.board_stands_as_before"},
    {"the board is not sharp", "calibration.board_not_sharp"},
    {"there is no such file", "files.no_such_file"},
    {"it is a folder", "base.is_folder"},
    {"the file is larger than 200 MB", "video.picture_file_too_large"},
    {"the file could not be read", "video.file_not_read"},
    {"the file is empty", "files.file_is_empty"},
    {"it is no PNG, JPEG, BMP, TIFF or PNM picture", "video.no_picture_format"},
    {"its content is damaged or cut short", "video.picture_damaged"},
};

constexpr OldSentence origins[] = {
    {"calibrated from %1 pictures", "workflow.calibrated_from_pictures", "n"},
    {"imported from %1", "workflow.lens_imported_from", "f"},
};

constexpr OldSentence readings[] = {
    {"positions to %1 mm, as the file says", "workflow.error_stated", "n"},
    {"positions to %1 mm, as estimated from them", "workflow.error_estimated", "n"},
    {"the file's track '%1'", "workflow.track_of_file", "s"},
    {"its times count from %1 s", "workflow.times_count_from", "n"},
};

constexpr OldSentence changes[] = {
    {"mark frame %1 of %2 as a spike", "workflow.mark_spike", "nt"},
    {"use frame %1 of %2", "workflow.use_frame", "nt"},
    {"leave frame %1 of %2 to the program", "workflow.leave_frame", "nt"},
    {"import the roster %1", "workflow.import_roster", "f"},
    {"put the axes of layout %1 elsewhere", "workflow.put_axes_elsewhere", "l"},
    {"choose calibration %1 of camera %2", "workflow.choose_calibration", "nc"},
    {"choose registration %1 of camera %2", "workflow.choose_registration", "nc"},
    {"link a lost video", "workflow.link_lost_video"},
    {"link %1 lost videos", "workflow.link_lost_videos", "n"},
    {"import trial %1", "workflow.import_trial", "t"},
    {"leave out %1, of which nothing was recorded", "workflow.leave_out_trial", "t"},
    {"complete %1, whose recording was cut off", "workflow.complete_trial", "t"},
    {"register camera %1", "workflow.register_camera", "c"},
    {"register camera %1 again", "workflow.register_camera_again", "c"},
    {"register camera %1 through camera %2", "workflow.register_camera_through", "cc"},
    {"register the cameras of layout %1 together", "workflow.register_cameras_together", "l"},
    {"calibrate camera %1", "workflow.calibrate_camera", "c"},
    {"import the lens of camera %1 from %2", "workflow.import_lens", "cf"},
    {"check whether camera %1 has moved", "workflow.check_whether_moved", "c"},
    {"remove %1 for good", "workflow.remove_for_good", "t"},
    {"track %1", "workflow.track", "t"},
    {"measure %1 again", "workflow.measure_again", "t"},
    {"record %1", "workflow.record", "t"},
    {"take over the set-up of %1", "workflow.take_over_set_up", "s"},
    {"give %1 the task %2", "workflow.give_task", "ta"},
    {"add camera %1", "ui.add_camera", "c"},
    {"connect camera %1", "ui.connect_camera", "c"},
    {"add robot %1", "ui.add_robot", "r"},
    {"change robot %1", "ui.change_robot", "r"},
    {"delete robot %1", "ui.delete_robot", "r"},
    {"add layout %1", "ui.add_layout", "l"},
    {"add task %1", "ui.add_task", "a"},
    {"change task %1", "ui.change_task", "a"},
    {"rename task %1 to %2", "ui.rename_task", "aa"},
    {"archive task %1", "ui.archive_task", "a"},
    {"take task %1 out of the archive", "ui.unarchive_task", "a"},
    {"delete task %1", "ui.delete_task", "a"},
    {"add class %1", "ui.add_class", "k"},
    {"rename class %1 to %2", "ui.rename_class", "kk"},
    {"archive class %1", "ui.archive_class", "k"},
    {"take class %1 out of the archive", "ui.unarchive_class", "k"},
    {"delete class %1", "ui.delete_class", "k"},
    {"add team %1", "ui.add_team", "e"},
    {"rename team %1 to %2", "ui.rename_team", "ee"},
    {"move team %1 to class %2", "ui.move_team", "ek"},
    {"take team %1 out of its class", "ui.take_team_out", "e"},
    {"delete team %1", "ui.delete_team", "e"},
    {"change members and robots of team %1", "ui.change_team", "e"},
    {"change the pseudonym of team %1", "ui.change_pseudonym", "e"},
    {"write notes of %1", "ui.write_notes", "t"},
    {"star %1", "ui.star_trial", "t"},
    {"take the star off %1", "ui.unstar_trial", "t"},
    {"star %1 trials", "ui.star_trials", "n"},
    {"take the star off %1 trials", "ui.unstar_trials", "n"},
    {"archive %1", "ui.archive_trial", "t"},
    {"take %1 out of the archive", "ui.unarchive_trial", "t"},
    {"archive %1 trials", "ui.archive_trials", "n"},
    {"take %1 trials out of the archive", "ui.unarchive_trials", "n"},
    {"delete %1", "ui.delete_trial", "t"},
    {"take %1 out of the bin", "ui.undelete_trial", "t"},
    {"delete %1 trials", "ui.delete_trials", "n"},
    {"take %1 trials out of the bin", "ui.undelete_trials", "n"},
    {"change the tags of %1", "ui.change_tags", "t"},
};

} // namespace

std::span<const OldSentence> oldSentences(OldSentences of)
{
    switch (of) {
    case OldSentences::Calibrations:
        return calibrations;
    case OldSentences::Registrations:
        return registrations;
    case OldSentences::Spikes:
        return spikes;
    case OldSentences::Pictures:
        return pictures;
    case OldSentences::Origins:
        return origins;
    case OldSentences::Readings:
        return readings;
    case OldSentences::Changes:
        return changes;
    }
    return {};
}

} // namespace odo
