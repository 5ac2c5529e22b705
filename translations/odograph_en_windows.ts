<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="en" sourcelanguage="en">
<context>
    <name>capture.cameras_are_listed</name>
    <message>
        <source>odograph cameras lists them</source>
        <translation>Cameras… in Record lists them</translation>
    </message>
</context>
<context>
    <name>capture.choose_listed</name>
    <message>
        <source>choose a camera that odograph cameras lists</source>
        <translation>choose a camera that Cameras… in Record lists</translation>
    </message>
</context>
<context>
    <name>capture.plug_in_or_choose</name>
    <message>
        <source>plug it in, or choose a camera that odograph cameras lists</source>
        <translation>plug it in, or choose a camera that Cameras… in Record lists</translation>
    </message>
</context>
<context>
    <name>capture.serial_advice</name>
    <message>
        <source>check its power and cable; odograph cameras lists those that answer</source>
        <translation>check its power and cable; Cameras… in Record lists those that answer</translation>
    </message>
</context>
<context>
    <name>exchange.write_task_as_shown</name>
    <message>
        <source>write the task as odograph task list --json shows one</source>
        <translation>make the task in Testbed, or write the file as the manual shows</translation>
    </message>
</context>
<context>
    <name>files.replace_by_force</name>
    <message>
        <source>choose another name, or replace it with --force</source>
        <translation>choose another name, or delete the file first</translation>
    </message>
</context>
<context>
    <name>project.adopt_or_remove</name>
    <message>
        <source>make a trial of it with odograph check P.odo --adopt, or remove it with --remove-strays; the window offers both under &apos;Find stray files…&apos;</source>
        <translation>make a trial of it or remove it under Find stray files…</translation>
    </message>
</context>
<context>
    <name>project.choose_its_own</name>
    <message>
        <source>choose one of its own (odograph revisions P.odo CAMERA --use), or restore the project from a backup copy</source>
        <translation>choose one of its own (Testbed, Older calibrations…), or restore the project from a backup copy</translation>
    </message>
</context>
<context>
    <name>project.complete_recording</name>
    <message>
        <source>to complete it, open the project for writing: odograph record P.odo --recover</source>
        <translation>to complete it, open the project for writing</translation>
    </message>
</context>
<context>
    <name>project.find_or_put_back</name>
    <message>
        <source>take it from there with odograph check P.odo --find FOLDER or Find lost videos… in the window, or move it back to its folder</source>
        <translation>take it from there with Find lost videos…, or move it back to its folder</translation>
    </message>
</context>
<context>
    <name>project.open_again</name>
    <message>
        <source>open it again; if you were recording, find stray files (odograph check --adopt)</source>
        <translation>open it again; if you were recording, look under Find stray files…</translation>
    </message>
</context>
<context>
    <name>project.put_back_or_find</name>
    <message>
        <source>move the file back to its folder, or find it by its content with odograph check P.odo --find FOLDER or Find lost videos… in the window</source>
        <translation>move the file back to its folder, or find it by its content with Find lost videos…</translation>
    </message>
</context>
<context>
    <name>school.connect_first</name>
    <message>
        <source>connect it with odograph school connect P.odo postgresql://user@host/database</source>
        <translation>connect it in Class ▸ School hub…</translation>
    </message>
</context>
<context>
    <name>school.connect_with_media</name>
    <message>
        <source>connect it again with --media FOLDER</source>
        <translation>connect it again with a media folder</translation>
    </message>
</context>
<context>
    <name>school.check_connection</name>
    <message>
        <source>check the address, the login in ~/.pgpass, and the network; what is recorded meanwhile is sent later</source>
        <translation>check the address and the network; what is recorded meanwhile is sent later</translation>
    </message>
</context>
<context>
    <name>school.password_place</name>
    <message>
        <source>put the correct one into ~/.pgpass or PGPASSWORD</source>
        <translation>enter it here, or put it into ~/.pgpass</translation>
    </message>
</context>
<context>
    <name>school.run_init</name>
    <message>
        <source>have its administrator run odograph school init</source>
        <translation>have its administrator make the hub</translation>
    </message>
</context>
<context>
    <name>synchronisation.clap_twice</name>
    <message>
        <source>clap twice near the middle of the floor while both cameras record, or give --sync SECONDS</source>
        <translation>clap twice near the middle of the floor while both cameras record, or enter the time offset</translation>
    </message>
</context>
<context>
    <name>synchronisation.flash_lights</name>
    <message>
        <source>flash the room lights once while both cameras record, or give --sync SECONDS</source>
        <translation>flash the room lights once while both cameras record, or enter the time offset</translation>
    </message>
</context>
<context>
    <name>synchronisation.flash_or_clap</name>
    <message>
        <source>flash the room lights or clap twice while both cameras record, or give --sync SECONDS</source>
        <translation>flash the room lights or clap twice while both cameras record, or enter the time offset</translation>
    </message>
</context>
<context>
    <name>trajectory.register_one</name>
    <message>
        <source>run odograph register for at least one of them</source>
        <translation>register at least one of them (Testbed, Register camera…)</translation>
    </message>
</context>
<context>
    <name>trajectory.register_them</name>
    <message>
        <source>run odograph register for them</source>
        <translation>register them (Testbed, Register camera…)</translation>
    </message>
</context>
<context>
    <name>workflow.add_robot</name>
    <message>
        <source>add one with: odograph robot add PROJECT NAME --colour #rrggbb</source>
        <translation>add one in Testbed</translation>
    </message>
</context>
<context>
    <name>workflow.check_files_and_offset</name>
    <message>
        <source>check the files and the --sync offset</source>
        <translation>check the files and the time offset</translation>
    </message>
</context>
<context>
    <name>workflow.check_or_analyse_again</name>
    <message>
        <source>run odograph check, or reanalyse the trial</source>
        <translation>check the project, or reanalyse the trial</translation>
    </message>
</context>
<context>
    <name>workflow.check_rate</name>
    <message>
        <source>views are matched by time: check --rate if one is in slow motion</source>
        <translation>views are matched by time: check the camera’s real rate if one is in slow motion</translation>
    </message>
</context>
<context>
    <name>workflow.choose_with_robot</name>
    <message>
        <source>choose one with --robot</source>
        <translation>choose one of them</translation>
    </message>
</context>
<context>
    <name>workflow.give_cameras</name>
    <message>
        <source>give one or more, like --camera A=sim:A</source>
        <translation>choose one or more under Cameras…</translation>
    </message>
</context>
<context>
    <name>workflow.give_offset_for_each</name>
    <message>
        <source>give one offset for each view but the first, like --sync 0.1,0.2, or use --sync auto</source>
        <translation>enter one offset for each view but the first, or choose From the motion or a flash</translation>
    </message>
</context>
<context>
    <name>workflow.give_tracks</name>
    <message>
        <source>give one or more, like --track R=run.csv</source>
        <translation>choose one or more</translation>
    </message>
</context>
<context>
    <name>workflow.give_views</name>
    <message>
        <source>give one view or more, like --video A=a.mp4</source>
        <translation>choose one view or more</translation>
    </message>
</context>
<context>
    <name>workflow.reanalyse_tracks</name>
    <message>
        <source>reanalyse them with: odograph track PROJECT TRIAL --again</source>
        <translation>reanalyse them</translation>
    </message>
</context>
<context>
    <name>workflow.register_or_do_not_send</name>
    <message>
        <source>run odograph register for one of them, or leave --ssl-vision out</source>
        <translation>register one of them (Testbed, Register camera…), or do not send positions</translation>
    </message>
</context>
<context>
    <name>workflow.run_track_first</name>
    <message>
        <source>run odograph track first</source>
        <translation>track the trial first</translation>
    </message>
</context>
<context>
    <name>workflow.run_track_without_again</name>
    <message>
        <source>run odograph track without --again first</source>
        <translation>track the trial’s videos first</translation>
    </message>
</context>
<context>
    <name>workflow.see_flags_by_hand</name>
    <message>
        <source>see the flags by_hand in odograph export</source>
        <translation>Review marks the samples with a manual override</translation>
    </message>
</context>
<context>
    <name>workflow.show_whole_board</name>
    <message>
        <source>show the whole board, flat, sharp and evenly lit, and check --pattern and --board</source>
        <translation>show the whole board, flat, sharp and evenly lit, and check its kind and its corners</translation>
    </message>
</context>
<context>
    <name>workflow.synchronise_for_offset</name>
    <message>
        <source>synchronise it again with odograph trial set --sync auto, or enter the time offset</source>
        <translation>synchronise it again (Trial ▸ Synchronise…), or enter the time offset there</translation>
    </message>
</context>
<context>
    <name>workflow.track_or_choose_with_robot</name>
    <message>
        <source>track it, or choose another with --robot</source>
        <translation>track it, or choose another robot</translation>
    </message>
</context>
<context>
    <name>workflow.track_those_seen</name>
    <message>
        <source>track only the robots that are in view (--robot)</source>
        <translation>track only the robots that are in view</translation>
    </message>
</context>
<context>
    <name>workflow.join_or_name_camera</name>
    <message>
        <source>give each view a camera of its own, or join the files of one recording with +, like --video A=1.mp4+2.mp4</source>
        <translation>give each view a camera of its own, or join the files of one recording with +</translation>
    </message>
</context>
<context>
    <name>workflow.give_rate_or_times</name>
    <message>
        <source>give their rate or a table of their times, like --rate 30 or --times A=stamps.csv</source>
        <translation>enter the camera&apos;s real rate</translation>
    </message>
</context>
<context>
    <name>workflow.give_table_of_times</name>
    <message>
        <source>give a table of their times, like --times A=stamps.csv</source>
        <translation>number them in steps of one</translation>
    </message>
</context>
</TS>
