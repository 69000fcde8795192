// SPDX-License-Identifier: MIT
#include "app/desktop/action_table.h"

#include <QtGlobal>

namespace app {

namespace {

constexpr const char* kFile = QT_TRANSLATE_NOOP("app::ActionTable", "&File");
constexpr const char* kEdit = QT_TRANSLATE_NOOP("app::ActionTable", "&Edit");
constexpr const char* kView = QT_TRANSLATE_NOOP("app::ActionTable", "&View");
constexpr const char* kAnnotate = QT_TRANSLATE_NOOP("app::ActionTable", "&Annotate");
constexpr const char* kGo = QT_TRANSLATE_NOOP("app::ActionTable", "&Go");
constexpr const char* kFit = QT_TRANSLATE_NOOP("app::ActionTable", "F&it");
constexpr const char* kCompare = QT_TRANSLATE_NOOP("app::ActionTable", "&Compare");
constexpr const char* kHelp = QT_TRANSLATE_NOOP("app::ActionTable", "&Help");

constexpr auto kPlain = ActionKind::Plain;
constexpr auto kCheck = ActionKind::Check;
constexpr auto kHold = ActionKind::Hold;

#define HANDLENS_TEXT(source) QT_TRANSLATE_NOOP("app::ActionTable", source)

// clang-format off
const std::vector<ActionRow> kRows = {
    {"file.open", kFile, HANDLENS_TEXT("&Open a dataset..."), "Ctrl+O", "document-open-folder", ""},
    {"file.demo", kFile, HANDLENS_TEXT("Open the &demo"), "", "", ""},
    {"file.import", kFile, HANDLENS_TEXT("&Import annotations..."), "Ctrl+I", "document-import", "", kPlain, true},
    {"file.export", kFile, HANDLENS_TEXT("&Export ground truth..."), "Ctrl+E", "document-export", HANDLENS_TEXT("Writes all annotations and their 3D joints of this sequence")},
    {"file.savePicture", kFile, HANDLENS_TEXT("&Save the views as a picture..."), "Ctrl+Shift+S", "document-save-as", ""},
    {"file.quit", kFile, HANDLENS_TEXT("&Quit"), "Ctrl+Q", "application-exit", "", kPlain, true},

    {"edit.undo", kEdit, HANDLENS_TEXT("&Undo"), "Ctrl+Z", "edit-undo", ""},
    {"edit.redo", kEdit, HANDLENS_TEXT("&Redo"), "Ctrl+Shift+Z", "edit-redo", ""},
    {"edit.note", kEdit, HANDLENS_TEXT("&Note on this frame..."), "Ctrl+M", "edit-comment", "", kPlain, true},
    {"edit.rater", kEdit, HANDLENS_TEXT("Your n&ame..."), "", "user-identity", HANDLENS_TEXT("The name that your marks are kept under")},
    {"edit.shortcuts", kEdit, HANDLENS_TEXT("&Shortcuts..."), "", "configure-shortcuts", "", kPlain, true},

    {"workspace.annotate", kView, HANDLENS_TEXT("&Annotate"), "Ctrl+1", "", "", kCheck},
    {"workspace.inspect", kView, HANDLENS_TEXT("&Inspect"), "Ctrl+2", "", "", kCheck},
    {"workspace.benchmark", kView, HANDLENS_TEXT("&Benchmark"), "Ctrl+3", "", "", kCheck},
    {"view.hideOverlays", kView, HANDLENS_TEXT("&Hide all overlays"), "H", "view-hidden", HANDLENS_TEXT("While the key is held"), kHold, true},
    {"view.longErrors", kView, HANDLENS_TEXT("Error lines three times as &long"), "T", "", HANDLENS_TEXT("While the key is held"), kHold},
    {"view.loupe", kView, HANDLENS_TEXT("Lou&pe"), "Z", "zoom-in", HANDLENS_TEXT("Magnifies the pixels around the pointer"), kCheck},
    {"view.skeleton", kView, HANDLENS_TEXT("S&keleton"), "K", "", "", kCheck},
    {"view.guides", kView, HANDLENS_TEXT("&Epipolar guides"), "J", "", HANDLENS_TEXT("Lines on which the selected joint must lie, as the other views say"), kCheck},
    {"view.proposals", kView, HANDLENS_TEXT("P&re-placed marks"), "", "", HANDLENS_TEXT("Marks that wait to be accepted"), kCheck},
    {"view.labels", kView, HANDLENS_TEXT("Joint &names"), "L", "", "", kCheck},
    {"view.followJoint", kView, HANDLENS_TEXT("&Follow the selected joint"), "Y", "", HANDLENS_TEXT("Keeps the selected joint in the middle of every zoomed view"), kCheck},
    {"view.meshShaded", kView, HANDLENS_TEXT("Mesh: sha&ded"), "", "", "", kCheck, true},
    {"view.meshWireframe", kView, HANDLENS_TEXT("Mesh: &wireframe"), "", "", "", kCheck},
    {"view.meshOff", kView, HANDLENS_TEXT("Mesh: o&ff"), "", "", "", kCheck},
    {"view.meshNext", kView, HANDLENS_TEXT("Next mesh st&yle"), "M", "", ""},
    {"view.meshMore", kView, HANDLENS_TEXT("Mesh more &opaque"), "+", "", ""},
    {"view.meshLess", kView, HANDLENS_TEXT("Mesh more &transparent"), "-", "", ""},
    {"view.leftHand", kView, HANDLENS_TEXT("Mesh of the left hand"), "", "", "", kCheck},
    {"view.rightHand", kView, HANDLENS_TEXT("Mesh of the right hand"), "", "", "", kCheck},
    {"view.recordedMesh", kView, HANDLENS_TEXT("Mesh of the recorded pose"), "", "", "", kCheck},
    {"view.startMesh", kView, HANDLENS_TEXT("Mesh of the fit's start pose"), "", "", "", kCheck},
    {"view.adjust", kView, HANDLENS_TEXT("&Brightness, contrast, gamma..."), "", "", HANDLENS_TEXT("Of the current view or of all"), kPlain, true},
    {"view.cameras", kView, HANDLENS_TEXT("&Cameras: hide, reorder..."), "", "", ""},
    {"view.fitAll", kView, HANDLENS_TEXT("Sho&w whole images"), "0", "zoom-fit-best", HANDLENS_TEXT("Ends zoom and pan in all views")},
    {"view.zoomJoint", kView, HANDLENS_TEXT("&Zoom all views to the joint"), "V", "zoom-in", ""},
    {"view.maximise1", kView, HANDLENS_TEXT("Maximise view 1"), "1", "", "", kPlain, true},
    {"view.maximise2", kView, HANDLENS_TEXT("Maximise view 2"), "2", "", ""},
    {"view.maximise3", kView, HANDLENS_TEXT("Maximise view 3"), "3", "", ""},
    {"view.maximise4", kView, HANDLENS_TEXT("Maximise view 4"), "4", "", ""},
    {"view.maximise5", kView, HANDLENS_TEXT("Maximise view 5"), "5", "", ""},
    {"view.maximise6", kView, HANDLENS_TEXT("Maximise view 6"), "6", "", ""},
    {"view.maximise7", kView, HANDLENS_TEXT("Maximise view 7"), "7", "", ""},
    {"view.maximise8", kView, HANDLENS_TEXT("Maximise view 8"), "8", "", ""},
    {"view.restore", kView, HANDLENS_TEXT("All views again"), "Esc", "", ""},
    {"view.resetScene", kView, HANDLENS_TEXT("Reset the 3D sc&ene"), "", "", "", kPlain, true},
    {"view.lookThrough", kView, HANDLENS_TEXT("Look thro&ugh the current camera"), "Shift+V", "", HANDLENS_TEXT("The 3D scene from the current camera"), kCheck},
    {"view.light", kView, HANDLENS_TEXT("Li&ght colours"), "", "", "", kCheck, true},
    {"view.fullScreen", kView, HANDLENS_TEXT("Full scree&n"), "F11", "view-fullscreen", "", kCheck},

    {"annotation.accept", kAnnotate, HANDLENS_TEXT("&Accept the pre-placed mark"), "Space", "dialog-ok-apply", HANDLENS_TEXT("In the current view or, if that has a mark, in the next one without")},
    {"annotation.acceptAll", kAnnotate, HANDLENS_TEXT("Accept in all &views"), "Shift+Space", "", ""},
    {"annotation.acceptFrame", kAnnotate, HANDLENS_TEXT("Accept all joints of the &frame"), "Ctrl+Space", "", ""},
    {"annotation.remove", kAnnotate, HANDLENS_TEXT("&Delete the mark"), "X", "edit-delete", HANDLENS_TEXT("Of the selected joint in the current view")},
    {"annotation.removeAll", kAnnotate, HANDLENS_TEXT("Delete in all vie&ws"), "Shift+X", "", ""},
    {"annotation.occluded", kAnnotate, HANDLENS_TEXT("&Occluded, estimated"), "O", "", HANDLENS_TEXT("The joint is hidden here; its place is a guess")},
    {"annotation.unplaceable", kAnnotate, HANDLENS_TEXT("&Cannot be placed here"), "U", "", ""},
    {"annotation.previousJoint", kAnnotate, HANDLENS_TEXT("&Previous joint"), "W", "", "", kPlain, true},
    {"annotation.nextJoint", kAnnotate, HANDLENS_TEXT("&Next joint"), "S", "", ""},
    {"annotation.previousView", kAnnotate, HANDLENS_TEXT("Previous view"), "Q", "", ""},
    {"annotation.nextView", kAnnotate, HANDLENS_TEXT("Next view"), "E", "", ""},
    {"annotation.nudgeLeft", kAnnotate, HANDLENS_TEXT("Nudge left"), "Left", "", HANDLENS_TEXT("By a quarter of an image pixel"), kPlain, true},
    {"annotation.nudgeRight", kAnnotate, HANDLENS_TEXT("Nudge right"), "Right", "", HANDLENS_TEXT("By a quarter of an image pixel")},
    {"annotation.nudgeUp", kAnnotate, HANDLENS_TEXT("Nudge up"), "Up", "", HANDLENS_TEXT("By a quarter of an image pixel")},
    {"annotation.nudgeDown", kAnnotate, HANDLENS_TEXT("Nudge down"), "Down", "", HANDLENS_TEXT("By a quarter of an image pixel")},
    {"annotation.nudgeLeftFar", kAnnotate, HANDLENS_TEXT("Nudge left by a pixel"), "Shift+Left", "", ""},
    {"annotation.nudgeRightFar", kAnnotate, HANDLENS_TEXT("Nudge right by a pixel"), "Shift+Right", "", ""},
    {"annotation.nudgeUpFar", kAnnotate, HANDLENS_TEXT("Nudge up by a pixel"), "Shift+Up", "", ""},
    {"annotation.nudgeDownFar", kAnnotate, HANDLENS_TEXT("Nudge down by a pixel"), "Shift+Down", "", ""},
    {"annotation.copyPrevious", kAnnotate, HANDLENS_TEXT("Copy the pose of the previous annotated frame"), "C", "edit-copy", HANDLENS_TEXT("As marks that wait to be checked"), kPlain, true},
    {"annotation.interpolate", kAnnotate, HANDLENS_TEXT("&Interpolate between annotated frames"), "I", "", HANDLENS_TEXT("In 3D, along straight lines, over the gap around this frame")},
    {"annotation.interpolateCubic", kAnnotate, HANDLENS_TEXT("Interpolate along a curve"), "Shift+I", "", HANDLENS_TEXT("In 3D, cubic, over the gap around this frame")},
    {"annotation.swapHands", kAnnotate, HANDLENS_TEXT("&Swap left and right from here on"), "", "", ""},
    {"annotation.deleteFrame", kAnnotate, HANDLENS_TEXT("Delete all marks of this frame"), "", "", ""},
    {"annotation.deleteRange", kAnnotate, HANDLENS_TEXT("Delete a range of frames..."), "", "", ""},
    {"annotation.autoAdvance", kAnnotate, HANDLENS_TEXT("Next joint when all views are done"), "", "", "", kCheck, true},
    {"annotation.jointsFourteen", kAnnotate, HANDLENS_TEXT("14 joints per hand"), "", "", "", kCheck, true},
    {"annotation.jointsTwentyOne", kAnnotate, HANDLENS_TEXT("21 joints per hand"), "", "", HANDLENS_TEXT("With wrist and finger tips"), kCheck},
    {"annotation.jointsAll", kAnnotate, HANDLENS_TEXT("All joints of the model"), "", "", "", kCheck},
    {"annotation.jointUp", kAnnotate, HANDLENS_TEXT("Move the joint up in the list"), "Ctrl+Up", "", ""},
    {"annotation.jointDown", kAnnotate, HANDLENS_TEXT("Move the joint down in the list"), "Ctrl+Down", "", ""},

    {"go.previousFrame", kGo, HANDLENS_TEXT("&Previous frame"), "A", "media-skip-backward", ""},
    {"go.nextFrame", kGo, HANDLENS_TEXT("&Next frame"), "D", "media-skip-forward", ""},
    {"go.back10", kGo, HANDLENS_TEXT("Ten frames back"), "Shift+A", "", ""},
    {"go.forward10", kGo, HANDLENS_TEXT("Ten frames forward"), "Shift+D", "", ""},
    {"go.firstFrame", kGo, HANDLENS_TEXT("&First frame"), "Home", "go-first", ""},
    {"go.lastFrame", kGo, HANDLENS_TEXT("&Last frame"), "End", "go-last", ""},
    {"go.frame", kGo, HANDLENS_TEXT("&Go to frame..."), "G", "", ""},
    {"go.play", kGo, HANDLENS_TEXT("Pla&y"), "P", "media-playback-start", "", kCheck},
    {"go.nextBad", kGo, HANDLENS_TEXT("Next &bad joint"), "N", "", HANDLENS_TEXT("Error above the threshold, an outlier, or no 3D point"), kPlain, true},
    {"go.previousBad", kGo, HANDLENS_TEXT("Previous b&ad joint"), "Shift+N", "", ""},
    {"go.nextUnlabelled", kGo, HANDLENS_TEXT("Next &unlabelled frame"), "B", "", HANDLENS_TEXT("The next frame in which a joint is not done")},
    {"go.previousUnlabelled", kGo, HANDLENS_TEXT("Previous unlab&elled frame"), "Shift+B", "", ""},
    {"go.nextAnnotated", kGo, HANDLENS_TEXT("Next annotated frame"), "Ctrl+D", "", ""},
    {"go.previousAnnotated", kGo, HANDLENS_TEXT("Previous annotated frame"), "Ctrl+A", "", ""},
    {"go.lastEdited", kGo, HANDLENS_TEXT("Last e&dited frame"), "Ctrl+G", "", ""},
    {"go.threshold", kGo, HANDLENS_TEXT("Error &threshold..."), "", "", HANDLENS_TEXT("Joints with a larger error count as bad"), kPlain, true},

    {"fit.run", kFit, HANDLENS_TEXT("&Fit the current frame"), "F", "run-build", HANDLENS_TEXT("With the chosen methods, from a recorded pose some frames before")},
    {"fit.stop", kFit, HANDLENS_TEXT("&Stop"), "Shift+F", "process-stop", ""},
    {"fit.show", kFit, HANDLENS_TEXT("Show the fit &panel"), "", "", ""},

    {"compare.previousIteration", kCompare, HANDLENS_TEXT("&Previous iteration"), ",", "", HANDLENS_TEXT("Shows the poses as they were before")},
    {"compare.nextIteration", kCompare, HANDLENS_TEXT("&Next iteration"), ".", "", ""},
    {"compare.lastIteration", kCompare, HANDLENS_TEXT("&Result of the fit"), "/", "", ""},

    {"help.shortcuts", kHelp, HANDLENS_TEXT("&Shortcuts"), "F1", "help-contents", ""},
    {"help.hints", kHelp, HANDLENS_TEXT("&Four hints"), "", "", ""},
    {"help.about", kHelp, HANDLENS_TEXT("&About Handlens"), "", "help-about", "", kPlain, true},
};
// clang-format on

#undef HANDLENS_TEXT

const std::vector<const char*> kMenus = {kFile, kEdit, kView, kAnnotate, kGo, kFit, kCompare, kHelp};

} // namespace

const std::vector<ActionRow>& actionTable() {
    return kRows;
}

const std::vector<const char*>& menuTitles() {
    return kMenus;
}

} // namespace app
