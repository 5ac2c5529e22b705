<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="en" sourcelanguage="en">
<context>
    <name>Certificate</name>
    <message numerus="yes">
        <source>%n simulated run(s) of %1 s and %2 at up to %3, %4.</source>
        <translation>
            <numerusform>%n simulated run of %1 s and %2 at up to %3, %4.</numerusform>
            <numerusform>%n simulated runs of %1 s and %2 at up to %3, %4.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ClassReport</name>
    <message numerus="yes">
        <source>of %n team(s)</source>
        <translation>
            <numerusform>of %n team</numerusform>
            <numerusform>of %n teams</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n trial(s) not counted: analysed with a different course. Reanalyse them.</source>
        <translation>
            <numerusform>%n trial not counted: analysed with a different course. Reanalyse it.</numerusform>
            <numerusform>%n trials not counted: analysed with a different course. Reanalyse them.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n trial(s) not counted: bad results.</source>
        <translation>
            <numerusform>%n trial not counted: bad results.</numerusform>
            <numerusform>%n trials not counted: bad results.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>! %n trial(s) with doubtful results counted.</source>
        <translation>
            <numerusform>! %n trial with doubtful results counted.</numerusform>
            <numerusform>! %n trials with doubtful results counted.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>HtmlPage</name>
    <message numerus="yes">
        <source>Spikes: %n</source>
        <translation>
            <numerusform>Spikes: %n</numerusform>
            <numerusform>Spikes: %n</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>and %n more</source>
        <translation>
            <numerusform>and %n more</numerusform>
            <numerusform>and %n more</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>Hub</name>
    <message numerus="yes">
        <source>%n item(s) sent.</source>
        <translation>
            <numerusform>%n item sent.</numerusform>
            <numerusform>%n items sent.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n item(s) received.</source>
        <translation>
            <numerusform>%n item received.</numerusform>
            <numerusform>%n items received.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n more warning(s).</source>
        <translation>
            <numerusform>%n more warning.</numerusform>
            <numerusform>%n more warnings.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n change(s)</source>
        <translation>
            <numerusform>%n change</numerusform>
            <numerusform>%n changes</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Hub: %n pending, %1</source>
        <translation>
            <numerusform>Hub: %n pending, %1</numerusform>
            <numerusform>Hub: %n pending, %1</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Hub: %n pending</source>
        <translation>
            <numerusform>Hub: %n pending</numerusform>
            <numerusform>Hub: %n pending</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Hub: publishing, %n pending</source>
        <translation>
            <numerusform>Hub: publishing, %n pending</numerusform>
            <numerusform>Hub: publishing, %n pending</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>RangeFacts</name>
    <message numerus="yes">
        <source>%n points</source>
        <translation>
            <numerusform>%n point</numerusform>
            <numerusform>%n points</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>Report</name>
    <message numerus="yes">
        <source>and %n more</source>
        <translation>
            <numerusform>and %n more</numerusform>
            <numerusform>and %n more</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ReportMethod</name>
    <message numerus="yes">
        <source>%n missing</source>
        <translation>
            <numerusform>%n missing</numerusform>
            <numerusform>%n missing</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>RunEvents</name>
    <message numerus="yes">
        <source>(%n samples)</source>
        <translation>
            <numerusform>(%n sample)</numerusform>
            <numerusform>(%n samples)</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>Scoreboard</name>
    <message numerus="yes">
        <source>%n trial(s) not counted: analysed with a different course.</source>
        <translation>
            <numerusform>%n trial not counted: analysed with a different course.</numerusform>
            <numerusform>%n trials not counted: analysed with a different course.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n trial(s) not counted: bad results.</source>
        <translation>
            <numerusform>%n trial not counted: bad results.</numerusform>
            <numerusform>%n trials not counted: bad results.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>! %n trial(s) with doubtful results counted.</source>
        <translation>
            <numerusform>! %n trial with doubtful results counted.</numerusform>
            <numerusform>! %n trials with doubtful results counted.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>TrialLines</name>
    <message numerus="yes">
        <source>, entered %n time(s)</source>
        <translation>
            <numerusform>, entered %n time</numerusform>
            <numerusform>, entered %n times</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>TrialReport</name>
    <message numerus="yes">
        <source>… and %n more</source>
        <translation>
            <numerusform>… and %n more</numerusform>
            <numerusform>… and %n more</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>odo::BackupsDialog</name>
    <message numerus="yes">
        <source>One is made each day on which you open the project, and kept for %n day(s).</source>
        <translation>
            <numerusform>One is made each day on which you open the project, and kept for %n day.</numerusform>
            <numerusform>One is made each day on which you open the project, and kept for %n days.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n trial(s) in this backup.</source>
        <translation>
            <numerusform>%n trial in this backup.</numerusform>
            <numerusform>%n trials in this backup.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n of its video(s) no longer exist.</source>
        <translation>
            <numerusform>%n of its videos no longer exists.</numerusform>
            <numerusform>%n of its videos no longer exist.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Restoring it discards %n change(s) made since:</source>
        <translation>
            <numerusform>Restoring it discards %n change made since:</numerusform>
            <numerusform>Restoring it discards %n changes made since:</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>It brings back %n change(s).</source>
        <translation>
            <numerusform>It brings back %n change.</numerusform>
            <numerusform>It brings back %n changes.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>odo::ClassesDialog</name>
    <message numerus="yes">
        <source>%1 (archived, %n team(s))</source>
        <translation>
            <numerusform>%1 (archived, %n team)</numerusform>
            <numerusform>%1 (archived, %n teams)</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 (%n team(s))</source>
        <translation>
            <numerusform>%1 (%n team)</numerusform>
            <numerusform>%1 (%n teams)</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>odo::EditTrialDialog</name>
    <message numerus="yes">
        <source>Edit %n trial(s)</source>
        <translation>
            <numerusform>Edit %n trial</numerusform>
            <numerusform>Edit %n trials</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>odo::HistoryActions</name>
    <message numerus="yes">
        <source>%n trial(s) removed for good.</source>
        <translation>
            <numerusform>%n trial was removed for good.</numerusform>
            <numerusform>%n trials were removed for good.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Removed %1 of %n trial(s) for good; the rest is still in the bin.</source>
        <translation>
            <numerusform>Removed %1 of %n trial for good; the rest is still in the bin.</numerusform>
            <numerusform>Removed %1 of %n trials for good; the rest is still in the bin.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Export %n trial(s): choose a folder</source>
        <translation>
            <numerusform>Export %n trial: choose a folder</numerusform>
            <numerusform>Export %n trials: choose a folder</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Videos of %n trial(s)</source>
        <translation>
            <numerusform>Video of %n trial</numerusform>
            <numerusform>Videos of %n trials</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Export %n trial(s)</source>
        <translation>
            <numerusform>Export %n trial</numerusform>
            <numerusform>Export %n trials</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>odo::HistoryPage</name>
    <message numerus="yes">
        <source>%n trial(s)</source>
        <translation>
            <numerusform>%n trial</numerusform>
            <numerusform>%n trials</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 of %n trial(s)</source>
        <translation>
            <numerusform>%1 of %n trial</numerusform>
            <numerusform>%1 of %n trials</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>odo::HubDialog</name>
    <message numerus="yes">
        <source>%n change(s) are not sent yet. They stay in the project.</source>
        <translation>
            <numerusform>%n change is not sent yet. It stays in the project.</numerusform>
            <numerusform>%n changes are not sent yet. They stay in the project.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>odo::HubPanel</name>
    <message numerus="yes">
        <source>&amp;Changed twice: %n…</source>
        <translation>
            <numerusform>&amp;Changed twice: %n…</numerusform>
            <numerusform>&amp;Changed twice: %n…</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>odo::HubRunsPanel</name>
    <message numerus="yes">
        <source>%n run(s)</source>
        <translation>
            <numerusform>%n run</numerusform>
            <numerusform>%n runs</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>the newest %n run(s)</source>
        <translation>
            <numerusform>the newest run</numerusform>
            <numerusform>the newest %n runs</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>odo::IntervalHistogram</name>
    <message numerus="yes">
        <source>%1 to %2: %n interval(s)</source>
        <translation>
            <numerusform>%1 to %2: %n interval</numerusform>
            <numerusform>%1 to %2: %n intervals</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>longer than %1: %n interval(s)</source>
        <translation>
            <numerusform>longer than %1: %n interval</numerusform>
            <numerusform>longer than %1: %n intervals</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>odo::IntervalPanel</name>
    <message numerus="yes">
        <source>%1 missing in %n gap(s)</source>
        <translation>
            <numerusform>%1 missing in %n gap</numerusform>
            <numerusform>%1 missing in %n gaps</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>odo::LensWizard</name>
    <message numerus="yes">
        <source>%n image(s) of the board</source>
        <translation>
            <numerusform>%n image of the board</numerusform>
            <numerusform>%n images of the board</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>odo::MarkActions</name>
    <message numerus="yes">
        <source>Remove %n trial(s) for good?</source>
        <translation>
            <numerusform>Remove %n trial for good?</numerusform>
            <numerusform>Remove %n trials for good?</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>odo::MessagePanel</name>
    <message numerus="yes">
        <source>%1, %n times</source>
        <translation>
            <numerusform>%1, %n time</numerusform>
            <numerusform>%1, %n times</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>odo::ReportActions</name>
    <message numerus="yes">
        <source>%n trial(s), a page each</source>
        <translation>
            <numerusform>%n trial</numerusform>
            <numerusform>%n trials, a page each</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>odo::ReportDialog</name>
    <message numerus="yes">
        <source>%n page(s)</source>
        <translation>
            <numerusform>%n page</numerusform>
            <numerusform>%n pages</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>The first %n page(s); the file has all of them.</source>
        <translation>
            <numerusform>The first page; the file has all of them.</numerusform>
            <numerusform>The first %n pages; the file has all of them.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>odo::ReportPreview</name>
    <message numerus="yes">
        <source>%n page(s)</source>
        <translation>
            <numerusform>%n page</numerusform>
            <numerusform>%n pages</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>odo::ResultsPanel</name>
    <message numerus="yes">
        <source>%n run(s)</source>
        <translation>
            <numerusform>%n run</numerusform>
            <numerusform>%n runs</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 of %n run(s)</source>
        <translation>
            <numerusform>%1 of %n run</numerusform>
            <numerusform>%1 of %n runs</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Statistics of %n run(s) shown</source>
        <translation>
            <numerusform>Statistics of %n run shown</numerusform>
            <numerusform>Statistics of %n runs shown</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Statistics of %n selected run(s)</source>
        <translation>
            <numerusform>Statistics of %n selected run</numerusform>
            <numerusform>Statistics of %n selected runs</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>odo::SampleTable</name>
    <message numerus="yes">
        <source>%n sample(s)</source>
        <translation>
            <numerusform>%n sample</numerusform>
            <numerusform>%n samples</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>odo::SpikeList</name>
    <message numerus="yes">
        <source>%n selected</source>
        <translation>
            <numerusform>%n selected</numerusform>
            <numerusform>%n selected</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>odo::StandingsModel</name>
    <message numerus="yes">
        <source>%1, %n doubtful</source>
        <translation>
            <numerusform>%1, %n doubtful</numerusform>
            <numerusform>%1, %n doubtful</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>odo::TasksDialog</name>
    <message numerus="yes">
        <source>%n trial(s)</source>
        <translation>
            <numerusform>%n trial</numerusform>
            <numerusform>%n trials</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Earlier version of the course: %n result(s) still use it.</source>
        <translation>
            <numerusform>Earlier version of the course: %n result still uses it.</numerusform>
            <numerusform>Earlier version of the course: %n results still use it.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n trial(s) have this task.</source>
        <translation>
            <numerusform>%n trial has this task.</numerusform>
            <numerusform>%n trials have this task.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n of them were measured with another course: their gate times and distances from the path belong to that one, and they have no score until you reanalyse them.</source>
        <translation>
            <numerusform>%n of them was measured with another course: its gate times and distances from the path belong to that one, and it has no score until you reanalyse it.</numerusform>
            <numerusform>%n of them were measured with another course: their gate times and distances from the path belong to that one, and they have no score until you reanalyse them.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>It is scored by %n metric(s).</source>
        <translation>
            <numerusform>It is scored by %n metric.</numerusform>
            <numerusform>It is scored by %n metrics.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n result(s) measured with this course stay valid: if you change the course, they keep the earlier version. Reanalyse the trials to update their times and scores.</source>
        <translation>
            <numerusform>%n result measured with this course stays valid: if you change the course, it keeps the earlier version. Reanalyse the trial to update its times and score.</numerusform>
            <numerusform>%n results measured with this course stay valid: if you change the course, they keep the earlier version. Reanalyse the trials to update their times and scores.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Show %n archived task(s)</source>
        <translation>
            <numerusform>Show %n archived task</numerusform>
            <numerusform>Show %n archived tasks</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>odo::TeamDialog</name>
    <message numerus="yes">
        <source>%n member(s)</source>
        <translation>
            <numerusform>%n member</numerusform>
            <numerusform>%n members</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>odo::TeamsPanel</name>
    <message numerus="yes">
        <source>%n team(s)</source>
        <translation>
            <numerusform>%n team</numerusform>
            <numerusform>%n teams</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n trial(s) not counted: analysed with a different course. Reanalyse them</source>
        <translation>
            <numerusform>%n trial not counted: analysed with a different course. Reanalyse it</numerusform>
            <numerusform>%n trials not counted: analysed with a different course. Reanalyse them</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n trial(s) not counted: bad results</source>
        <translation>
            <numerusform>%n trial not counted: bad results</numerusform>
            <numerusform>%n trials not counted: bad results</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>odo::TrackPreview</name>
    <message numerus="yes">
        <source>%1: %2, %n lines in %3 s</source>
        <translation>
            <numerusform>%1: %2, %n line in %3 s</numerusform>
            <numerusform>%1: %2, %n lines in %3 s</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>odo::TransferActions</name>
    <message numerus="yes">
        <source>%n file(s) in the media folder belong to no trial, lens calibration or floor registration.</source>
        <translation>
            <numerusform>%n file in the media folder belongs to no trial, lens calibration or floor registration.</numerusform>
            <numerusform>%n files in the media folder belong to no trial, lens calibration or floor registration.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n trial(s) added. Their names begin with &quot;recovered&quot;.</source>
        <translation>
            <numerusform>%n trial added. Its name begins with &quot;recovered&quot;.</numerusform>
            <numerusform>%n trials added. Their names begin with &quot;recovered&quot;.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n stray file(s) removed.</source>
        <translation>
            <numerusform>%n stray file removed.</numerusform>
            <numerusform>%n stray files removed.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n other file(s), listed last, stay: missing recordings, projects, and files that are neither videos nor images.</source>
        <translation>
            <numerusform>%n other file, listed last, stays: a missing recording, a project, or a file that is neither a video nor an image.</numerusform>
            <numerusform>%n other files, listed last, stay: missing recordings, projects, and files that are neither videos nor images.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>odo::TrialActions</name>
    <message numerus="yes">
        <source>%n trial(s) changed. Choose Undo to reverse this.</source>
        <translation>
            <numerusform>%n trial changed. Choose Undo to reverse this.</numerusform>
            <numerusform>%n trials changed. Choose Undo to reverse this.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n samples of %1 are not used. Choose Undo to use them.</source>
        <translation>
            <numerusform>%n sample of %1 is not used. Choose Undo to use it.</numerusform>
            <numerusform>%n samples of %1 are not used. Choose Undo to use them.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n samples of %1 are used. Choose Undo to reverse this.</source>
        <translation>
            <numerusform>%n sample of %1 is used. Choose Undo to reverse this.</numerusform>
            <numerusform>%n samples of %1 are used. Choose Undo to reverse this.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>odo::WindowMessages</name>
    <message numerus="yes">
        <source>%n message(s)</source>
        <translation>
            <numerusform>%n message</numerusform>
            <numerusform>%n messages</numerusform>
        </translation>
    </message>
</context>
</TS>
