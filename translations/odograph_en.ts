<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<!-- Plural forms of the English words alone: every tr("%n …") of the program has its two here. -->
<TS version="2.1" language="en" sourcelanguage="en">
<context>
    <name>odo::HistoryActions</name>
    <message numerus="yes">
        <source>%n trial(s) removed for good.</source>
        <translation><numerusform>%n trial was removed for good.</numerusform><numerusform>%n trials were removed for good.</numerusform></translation>
    </message>
    <message numerus="yes">
        <source>%1 of %n trial(s) removed for good; the rest is still there.</source>
        <translation><numerusform>%1 of %n trial was removed for good; the rest is still there.</numerusform><numerusform>%1 of %n trials were removed for good; the rest is still there.</numerusform></translation>
    </message>
    <message numerus="yes">
        <source>Export %n trial(s): choose a folder</source>
        <translation><numerusform>Export %n trial: choose a folder</numerusform><numerusform>Export %n trials: choose a folder</numerusform></translation>
    </message>
</context>
<context>
    <name>odo::HistoryPage</name>
    <message numerus="yes">
        <source>%n trial(s)</source>
        <translation><numerusform>%n trial</numerusform><numerusform>%n trials</numerusform></translation>
    </message>
    <message numerus="yes">
        <source>%1 of %n trial(s)</source>
        <translation><numerusform>%1 of %n trial</numerusform><numerusform>%1 of %n trials</numerusform></translation>
    </message>
</context>
<context>
    <name>odo::MarkActions</name>
    <message numerus="yes">
        <source>Remove %n trial(s) for good?</source>
        <translation><numerusform>Remove %n trial for good?</numerusform><numerusform>Remove %n trials for good?</numerusform></translation>
    </message>
</context>
<context>
    <name>odo::TeamsPanel</name>
    <message numerus="yes">
        <source>%n team(s)</source>
        <translation><numerusform>%n team</numerusform><numerusform>%n teams</numerusform></translation>
    </message>
    <message numerus="yes">
        <source>%n trial(s) left out: measured by another course; measure them again</source>
        <translation><numerusform>%n trial left out: measured by another course; measure it again</numerusform><numerusform>%n trials left out: measured by another course; measure them again</numerusform></translation>
    </message>
</context>
</TS>
