<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="en">
<context>
    <name>app::CalibrationPage</name>
    <message numerus="yes">
        <source>Recognised as %1: %n camera(s).</source>
        <translation>
            <numerusform>Recognised as %1: %n camera.</numerusform>
            <numerusform>Recognised as %1: %n cameras.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>app::MainWindow</name>
    <message numerus="yes">
        <source>%n mark(s) imported from %1</source>
        <translation>
            <numerusform>%n mark imported from %1</numerusform>
            <numerusform>%n marks imported from %1</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>The hand model meets %n marked joint(s) within %1 mm.</source>
        <translation>
            <numerusform>The hand model meets %n marked joint within %1 mm.</numerusform>
            <numerusform>The hand model meets %n marked joints within %1 mm.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n piece(s) of footage found; the dataset keeps the new places.</source>
        <translation>
            <numerusform>%n piece of footage found; the dataset keeps the new place.</numerusform>
            <numerusform>%n pieces of footage found; the dataset keeps the new places.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>and %n more: see handlens-batch check</source>
        <translation>
            <numerusform>and %n more: see handlens-batch check</numerusform>
            <numerusform>and %n more: see handlens-batch check</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n mark(s) of %1</source>
        <translation>
            <numerusform>%n mark of %1</numerusform>
            <numerusform>%n marks of %1</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n note(s)</source>
        <translation>
            <numerusform>%n note</numerusform>
            <numerusform>%n notes</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n frame(s)</source>
        <translation>
            <numerusform>%n frame</numerusform>
            <numerusform>%n frames</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Stopped: %n mark(s) in %1 frames are proposed; the next start goes on from there.</source>
        <translation>
            <numerusform>Stopped: %n mark in %1 frames is proposed; the next start goes on from there.</numerusform>
            <numerusform>Stopped: %n marks in %1 frames are proposed; the next start goes on from there.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>First pass: hands in %1 of %2 frames, %n mark(s) proposed.</source>
        <translation>
            <numerusform>First pass: hands in %1 of %2 frames, %n mark proposed.</numerusform>
            <numerusform>First pass: hands in %1 of %2 frames, %n marks proposed.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n mark(s) around frame %1 are proposed anew.</source>
        <translation>
            <numerusform>%n mark around frame %1 is proposed anew.</numerusform>
            <numerusform>%n marks around frame %1 are proposed anew.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n mark(s) of frame %1 follow the corrected joint.</source>
        <translation>
            <numerusform>%n mark of frame %1 follows the corrected joint.</numerusform>
            <numerusform>%n marks of frame %1 follow the corrected joint.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>app::NewDatasetWindow</name>
    <message numerus="yes">
        <source>%n piece(s) of footage</source>
        <translation>
            <numerusform>%n piece of footage</numerusform>
            <numerusform>%n pieces of footage</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n camera(s)</source>
        <translation>
            <numerusform>%n camera</numerusform>
            <numerusform>%n cameras</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>widgets::Advice</name>
    <message numerus="yes">
        <source>%1 clicked, %2 accepted, %3 proposed; %n view(s) have a picture</source>
        <translation>
            <numerusform>%1 clicked, %2 accepted, %3 proposed; %n view has a picture</numerusform>
            <numerusform>%1 clicked, %2 accepted, %3 proposed; %n views have a picture</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 of %n view(s)</source>
        <translation>
            <numerusform>%1 of %n view</numerusform>
            <numerusform>%1 of %n views</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>widgets::BenchmarkRunner</name>
    <message numerus="yes">
        <source>This benchmark is not finished: %n fit(s) are in.</source>
        <translation>
            <numerusform>This benchmark is not finished: %n fit is in.</numerusform>
            <numerusform>This benchmark is not finished: %n fits are in.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>widgets::CameraChoice</name>
    <message numerus="yes">
        <source>%n chosen</source>
        <translation>
            <numerusform>%n chosen</numerusform>
            <numerusform>%n chosen</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>widgets::EditText</name>
    <message numerus="yes">
        <source>accept %n mark(s)</source>
        <translation>
            <numerusform>accept %n mark</numerusform>
            <numerusform>accept %n marks</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>copy a pose (%n mark(s))</source>
        <translation>
            <numerusform>copy a pose (%n mark)</numerusform>
            <numerusform>copy a pose (%n marks)</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>interpolate (%n mark(s))</source>
        <translation>
            <numerusform>interpolate (%n mark)</numerusform>
            <numerusform>interpolate (%n marks)</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>swap left and right (%n mark(s))</source>
        <translation>
            <numerusform>swap left and right (%n mark)</numerusform>
            <numerusform>swap left and right (%n marks)</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>delete %n mark(s)</source>
        <translation>
            <numerusform>delete %n mark</numerusform>
            <numerusform>delete %n marks</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>import %n mark(s)</source>
        <translation>
            <numerusform>import %n mark</numerusform>
            <numerusform>import %n marks</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>propose %n mark(s)</source>
        <translation>
            <numerusform>propose %n mark</numerusform>
            <numerusform>propose %n marks</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>change %n mark(s)</source>
        <translation>
            <numerusform>change %n mark</numerusform>
            <numerusform>change %n marks</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>first pass (%n proposed mark(s))</source>
        <translation>
            <numerusform>first pass (%n proposed mark)</numerusform>
            <numerusform>first pass (%n proposed marks)</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>widgets::FirstPassForm</name>
    <message numerus="yes">
        <source>%n frame(s). Marks that are there already stay.</source>
        <translation>
            <numerusform>%n frame. Marks that are there already stay.</numerusform>
            <numerusform>%n frames. Marks that are there already stay.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>widgets::FootageText</name>
    <message numerus="yes">
        <source>%1 and %n more place(s)</source>
        <translation>
            <numerusform>%1 and %n more place</numerusform>
            <numerusform>%1 and %n more places</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1: %n frame(s) missing after frame %2.</source>
        <translation>
            <numerusform>%1: %n frame missing after frame %2.</numerusform>
            <numerusform>%1: %n frames missing after frame %2.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1: %n frame(s) missing: %2.</source>
        <translation>
            <numerusform>%1: %n frame missing: %2.</numerusform>
            <numerusform>%1: %n frames missing: %2.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1: %n picture(s) missing: %2.</source>
        <translation>
            <numerusform>%1: %n picture missing: %2.</numerusform>
            <numerusform>%1: %n pictures missing: %2.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 goes on for %n frame(s) after the last instant.</source>
        <translation>
            <numerusform>%1 goes on for %n frame after the last instant.</numerusform>
            <numerusform>%1 goes on for %n frames after the last instant.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 has %n frame(s) more than the shortest footage: are they all of the same instants?</source>
        <translation>
            <numerusform>%1 has %n frame more than the shortest footage: are they all of the same instants?</numerusform>
            <numerusform>%1 has %n frames more than the shortest footage: are they all of the same instants?</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1: %n mask(s) of no frame of the sequence: its frames need the numbers %2 to %3, the masks have %4 to %5.</source>
        <translation>
            <numerusform>%1: %n mask of no frame of the sequence: its frames need the numbers %2 to %3, the masks have %4 to %5.</numerusform>
            <numerusform>%1: %n masks of no frame of the sequence: its frames need the numbers %2 to %3, the masks have %4 to %5.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>widgets::ImportText</name>
    <message numerus="yes">
        <source>%1 and %n more</source>
        <translation>
            <numerusform>%1 and %n more</numerusform>
            <numerusform>%1 and %n more</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Left out: %n item(s) of frames that sequence %1 does not have (it has 0 to %2).</source>
        <translation>
            <numerusform>Left out: %n item of frames that sequence %1 does not have (it has 0 to %2).</numerusform>
            <numerusform>Left out: %n items of frames that sequence %1 does not have (it has 0 to %2).</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Left out: %n mark(s) in camera %1, which the dataset does not have.</source>
        <translation>
            <numerusform>Left out: %n mark in camera %1, which the dataset does not have.</numerusform>
            <numerusform>Left out: %n marks in camera %1, which the dataset does not have.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Left out: %n row(s) of the view of camera %1.</source>
        <translation>
            <numerusform>Left out: %n row of the view of camera %1.</numerusform>
            <numerusform>Left out: %n rows of the view of camera %1.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Left out: %n row(s) of other videos: %1.</source>
        <translation>
            <numerusform>Left out: %n row of other videos: %1.</numerusform>
            <numerusform>Left out: %n rows of other videos: %1.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n mark(s) outside the picture of %1: kept, but not used for 3D points.</source>
        <translation>
            <numerusform>%n mark outside the picture of %1: kept, but not used for 3D points.</numerusform>
            <numerusform>%n marks outside the picture of %1: kept, but not used for 3D points.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Left out: %n mark(s) with a likelihood below %1.</source>
        <translation>
            <numerusform>Left out: %n mark with a likelihood below %1.</numerusform>
            <numerusform>Left out: %n marks with a likelihood below %1.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Left out: %n guess(es) of joints that are labelled or guessed in the same picture already.</source>
        <translation>
            <numerusform>Left out: %n guess of a joint that is labelled or guessed in the same picture already.</numerusform>
            <numerusform>Left out: %n guesses of joints that are labelled or guessed in the same picture already.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Left out: %n label(s) marked as not visible.</source>
        <translation>
            <numerusform>Left out: %n label marked as not visible.</numerusform>
            <numerusform>Left out: %n labels marked as not visible.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Left out: %n mark(s) of %1, which is not in the joint map.</source>
        <translation>
            <numerusform>Left out: %n mark of %1, which is not in the joint map.</numerusform>
            <numerusform>Left out: %n marks of %1, which is not in the joint map.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Left out: %n annotation(s) of category %1, which says neither left nor right.</source>
        <translation>
            <numerusform>Left out: %n annotation of category %1, which says neither left nor right.</numerusform>
            <numerusform>Left out: %n annotations of category %1, which says neither left nor right.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Left out: %n mark(s) of body parts that are not joints: %1. A name that fits is %2; the command line takes a map of names (annotations --map).</source>
        <translation>
            <numerusform>Left out: %n mark of body parts that are not joints: %1. A name that fits is %2; the command line takes a map of names (annotations --map).</numerusform>
            <numerusform>Left out: %n marks of body parts that are not joints: %1. A name that fits is %2; the command line takes a map of names (annotations --map).</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>widgets::OtherMarks</name>
    <message numerus="yes">
        <source>%n mark(s)</source>
        <translation>
            <numerusform>%n mark</numerusform>
            <numerusform>%n marks</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n frame(s)</source>
        <translation>
            <numerusform>%n frame</numerusform>
            <numerusform>%n frames</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>widgets::QualityPanel</name>
    <message numerus="yes">
        <source>%n proposed mark(s) wait to be checked.</source>
        <translation>
            <numerusform>%n proposed mark waits to be checked.</numerusform>
            <numerusform>%n proposed marks wait to be checked.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n frame(s) with marks of %1.</source>
        <translation>
            <numerusform>%n frame with marks of %1.</numerusform>
            <numerusform>%n frames with marks of %1.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>widgets::RatersPanel</name>
    <message numerus="yes">
        <source>%n shared click(s), %1 px apart (RMS)</source>
        <translation>
            <numerusform>%n shared click, %1 px apart (RMS)</numerusform>
            <numerusform>%n shared clicks, %1 px apart (RMS)</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>All raters together: %1 ± %2 mm, from %n click(s).</source>
        <translation>
            <numerusform>All raters together: %1 ± %2 mm, from %n click.</numerusform>
            <numerusform>All raters together: %1 ± %2 mm, from %n clicks.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>widgets::RefinementPage</name>
    <message numerus="yes">
        <source>%n wrong click(s) took no part.</source>
        <translation>
            <numerusform>%n wrong click took no part.</numerusform>
            <numerusform>%n wrong clicks took no part.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>widgets::ReviewText</name>
    <message numerus="yes">
        <source>%n joint(s) of the left hand missing</source>
        <translation>
            <numerusform>%n joint of the left hand missing</numerusform>
            <numerusform>%n joints of the left hand missing</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n joint(s) of the right hand missing</source>
        <translation>
            <numerusform>%n joint of the right hand missing</numerusform>
            <numerusform>%n joints of the right hand missing</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>All %n frame(s) are reviewed.</source>
        <translation>
            <numerusform>%n frame is reviewed, none is left.</numerusform>
            <numerusform>All %n frames are reviewed.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n frame(s) left, </source>
        <translation>
            <numerusform>%n frame left, </numerusform>
            <numerusform>%n frames left, </numerusform>
        </translation>
    </message>
</context>
<context>
    <name>widgets::RigHealthModel</name>
    <message numerus="yes">
        <source>%1: %n click(s) that other cameras confirm are too few to judge it</source>
        <translation>
            <numerusform>%1: %n click that other cameras confirm is too few to judge it</numerusform>
            <numerusform>%1: %n clicks that other cameras confirm are too few to judge it</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1: mean %2, %3 ± %4 px; clicks scatter by %5 px about it; %n wrong click(s)</source>
        <translation>
            <numerusform>%1: mean %2, %3 ± %4 px; clicks scatter by %5 px about it; %n wrong click</numerusform>
            <numerusform>%1: mean %2, %3 ± %4 px; clicks scatter by %5 px about it; %n wrong clicks</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>widgets::RigText</name>
    <message numerus="yes">
        <source>%1 is %2 px off in the %n sequence(s) %3 only: it stood otherwise there.</source>
        <translation>
            <numerusform>%1 is %2 px off in sequence %3 only: it stood otherwise there.</numerusform>
            <numerusform>%1 is %2 px off in the %n sequences %3 only: it stood otherwise there.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>widgets::SilhouettePage</name>
    <message numerus="yes">
        <source>%n silhouette(s) made, %1 were there already.</source>
        <translation>
            <numerusform>%n silhouette made, %1 were there already.</numerusform>
            <numerusform>%n silhouettes made, %1 were there already.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>This frame: a silhouette in %n view(s)</source>
        <translation>
            <numerusform>This frame: a silhouette in %n view</numerusform>
            <numerusform>This frame: a silhouette in %n views</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>, %n of them kept on disk</source>
        <translation>
            <numerusform>, %n of them kept on disk</numerusform>
            <numerusform>, %n of them kept on disk</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>widgets::StatusLine</name>
    <message numerus="yes">
        <source>saved %n s ago</source>
        <translation>
            <numerusform>saved %n s ago</numerusform>
            <numerusform>saved %n s ago</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>saved %n min ago</source>
        <translation>
            <numerusform>saved %n min ago</numerusform>
            <numerusform>saved %n min ago</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>saved %n h ago</source>
        <translation>
            <numerusform>saved %n h ago</numerusform>
            <numerusform>saved %n h ago</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>, %n s left</source>
        <translation>
            <numerusform>, %n s left</numerusform>
            <numerusform>, %n s left</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>, %n min left</source>
        <translation>
            <numerusform>, %n min left</numerusform>
            <numerusform>, %n min left</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>widgets::SubjectText</name>
    <message numerus="yes">
        <source>%n annotated frame(s) were used.</source>
        <translation>
            <numerusform>%n annotated frame was used.</numerusform>
            <numerusform>%n annotated frames were used.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Outlines of %n frame(s) fit to %1 mm.</source>
        <translation>
            <numerusform>Outlines of %n frame fit to %1 mm.</numerusform>
            <numerusform>Outlines of %n frames fit to %1 mm.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n annotated frame(s)</source>
        <translation>
            <numerusform>%n annotated frame</numerusform>
            <numerusform>%n annotated frames</numerusform>
        </translation>
    </message>
</context>
</TS>
