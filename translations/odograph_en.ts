<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="en" sourcelanguage="en">
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
        <source>%n trial(s) left out: measured by another course; measure them again.</source>
        <translation>
            <numerusform>%n trial left out: measured by another course; measure it again.</numerusform>
            <numerusform>%n trials left out: measured by another course; measure them again.</numerusform>
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
    <name>odo::HistoryActions</name>
    <message numerus="yes">
        <source>%n trial(s) removed for good.</source>
        <translation>
            <numerusform>%n trial was removed for good.</numerusform>
            <numerusform>%n trials were removed for good.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 of %n trial(s) removed for good; the rest is still there.</source>
        <translation>
            <numerusform>%1 of %n trial was removed for good; the rest is still there.</numerusform>
            <numerusform>%1 of %n trials were removed for good; the rest is still there.</numerusform>
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
    <name>odo::TasksDialog</name>
    <message numerus="yes">
        <source>%n trial(s)</source>
        <translation>
            <numerusform>%n trial</numerusform>
            <numerusform>%n trials</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>The course as it was before it was changed: %n result(s) measured by it keep it.</source>
        <translation>
            <numerusform>The course as it was before it was changed: %n result measured by it keeps it.</numerusform>
            <numerusform>The course as it was before it was changed: %n results measured by it keep it.</numerusform>
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
        <source>%n of them measured by another course: times at gates and distances from the path are of that one, and there is no score until they are measured again.</source>
        <translation>
            <numerusform>%n of them was measured by another course: times at gates and distances from the path are of that one, and there is no score until it is measured again.</numerusform>
            <numerusform>%n of them were measured by another course: times at gates and distances from the path are of that one, and there is no score until they are measured again.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>It is scored by %n figure(s).</source>
        <translation>
            <numerusform>It is scored by %n figure.</numerusform>
            <numerusform>It is scored by %n figures.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n result(s) measured by this course stay true: a course that is changed is kept for them as an earlier version. The trials go over to the new one; their times and scores follow once they are measured again.</source>
        <translation>
            <numerusform>%n result measured by this course stays true: a course that is changed is kept for it as an earlier version. The trial goes over to the new one; its times and score follow once it is measured again.</numerusform>
            <numerusform>%n results measured by this course stay true: a course that is changed is kept for them as an earlier version. The trials go over to the new one; their times and scores follow once they are measured again.</numerusform>
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
        <source>%n trial(s) left out: measured by another course; measure them again</source>
        <translation>
            <numerusform>%n trial left out: measured by another course; measure it again</numerusform>
            <numerusform>%n trials left out: measured by another course; measure them again</numerusform>
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
        <source>%n other file(s), listed last, stay: missing recordings, projects, and what is neither a video nor a picture.</source>
        <translation>
            <numerusform>%n other file, listed last, stays: a missing recording, a project, or what is neither a video nor a picture.</numerusform>
            <numerusform>%n other files, listed last, stay: missing recordings, projects, and what is neither a video nor a picture.</numerusform>
        </translation>
    </message>
</context>
</TS>
