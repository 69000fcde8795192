// SPDX-License-Identifier: MIT
#include "app/desktop/actions/action_table.h"

#include <QtGlobal>

namespace app {

namespace {

constexpr const char* kFile = QT_TRANSLATE_NOOP("app::ActionTable", "&File");
constexpr const char* kEdit = QT_TRANSLATE_NOOP("app::ActionTable", "&Edit");
constexpr const char* kView = QT_TRANSLATE_NOOP("app::ActionTable", "&View");
constexpr const char* kAnnotate = QT_TRANSLATE_NOOP("app::ActionTable", "&Annotate");
constexpr const char* kGo = QT_TRANSLATE_NOOP("app::ActionTable", "&Go");
constexpr const char* kFit = QT_TRANSLATE_NOOP("app::ActionTable", "F&it");
constexpr const char* kRaters = QT_TRANSLATE_NOOP("app::ActionTable", "&Raters");
constexpr const char* kHelp = QT_TRANSLATE_NOOP("app::ActionTable", "&Help");
// Parts of the menus above.
constexpr const char* kMaximise = QT_TRANSLATE_NOOP("app::ActionTable", "One &view");
constexpr const char* kMarks = QT_TRANSLATE_NOOP("app::ActionTable", "Mar&ks");
constexpr const char* kMesh = QT_TRANSLATE_NOOP("app::ActionTable", "&Mesh");
constexpr const char* kLayers = QT_TRANSLATE_NOOP("app::ActionTable", "&Layers of the methods");
constexpr const char* kComparison = QT_TRANSLATE_NOOP("app::ActionTable", "C&omparison");
constexpr const char* kBenchmark = QT_TRANSLATE_NOOP("app::ActionTable", "&Benchmark");
constexpr const char* kColumns = QT_TRANSLATE_NOOP("app::ActionTable", "Col&umns of the comparison");
constexpr const char* kScene = QT_TRANSLATE_NOOP("app::ActionTable", "3D s&cene");
constexpr const char* kStep = QT_TRANSLATE_NOOP("app::ActionTable", "&Joint and view");
constexpr const char* kNudge = QT_TRANSLATE_NOOP("app::ActionTable", "&Nudge");
constexpr const char* kReview = QT_TRANSLATE_NOOP("app::ActionTable", "R&eview of proposals");
constexpr const char* kJoints = QT_TRANSLATE_NOOP("app::ActionTable", "Li&st of joints");

constexpr auto kPlain = ActionKind::Plain;
constexpr auto kCheck = ActionKind::Check;
constexpr auto kHold = ActionKind::Hold;

// clang-format off
const std::vector<ActionRow> kRows = {
    {"file.open", kFile, QT_TRANSLATE_NOOP("app::ActionTable", "&Open a dataset..."), "Ctrl+O", "document-open-folder", ""},
    {"file.new", kFile, QT_TRANSLATE_NOOP("app::ActionTable", "Make a &new dataset..."), "Ctrl+N", "document-new", QT_TRANSLATE_NOOP("app::ActionTable", "Of a calibration and videos or folders of images")},
    {"file.demo", kFile, QT_TRANSLATE_NOOP("app::ActionTable", "Open the &demo"), "Ctrl+Shift+O", "", ""},
    {"file.import", kFile, QT_TRANSLATE_NOOP("app::ActionTable", "&Import annotations..."), "Ctrl+I", "document-import", "", kPlain, true},
    {"file.export", kFile, QT_TRANSLATE_NOOP("app::ActionTable", "&Export annotations..."), "Ctrl+E", "document-export", QT_TRANSLATE_NOOP("app::ActionTable", "Writes the annotations of this sequence: of all raters where the format names them, else yours")},
    {"file.report", kFile, QT_TRANSLATE_NOOP("app::ActionTable", "&Report on the annotations..."), "Ctrl+R", "document-preview", QT_TRANSLATE_NOOP("app::ActionTable", "A page with progress, raters, worst joints and figures")},
    {"file.savePicture", kFile, QT_TRANSLATE_NOOP("app::ActionTable", "&Save the views as a picture..."), "Ctrl+Shift+S", "document-save-as", ""},
    {"file.quit", kFile, QT_TRANSLATE_NOOP("app::ActionTable", "&Quit"), "Ctrl+Q", "application-exit", "", kPlain, true},

    {"edit.undo", kEdit, QT_TRANSLATE_NOOP("app::ActionTable", "&Undo"), "Ctrl+Z", "edit-undo", ""},
    {"edit.redo", kEdit, QT_TRANSLATE_NOOP("app::ActionTable", "&Redo"), "Ctrl+Shift+Z", "edit-redo", ""},
    {"edit.note", kEdit, QT_TRANSLATE_NOOP("app::ActionTable", "&Note on this frame..."), "Ctrl+M", "edit-comment", "", kPlain, true},
    {"edit.preferences", kEdit, QT_TRANSLATE_NOOP("app::ActionTable", "&Preferences..."), "Ctrl+,", "configure", QT_TRANSLATE_NOOP("app::ActionTable", "Language, your name, keys, colours, memory"), kPlain, true},
    {"edit.shortcuts", kEdit, QT_TRANSLATE_NOOP("app::ActionTable", "Change the &shortcuts..."), "Shift+F1", "configure-shortcuts", "", kPlain, false, false},

    {"workspace.annotate", kView, QT_TRANSLATE_NOOP("app::ActionTable", "&Annotate"), "Ctrl+1", "", "", kCheck},
    {"workspace.inspect", kView, QT_TRANSLATE_NOOP("app::ActionTable", "&Inspect"), "Ctrl+2", "", "", kCheck},
    {"workspace.benchmark", kView, QT_TRANSLATE_NOOP("app::ActionTable", "&Benchmark"), "Ctrl+3", "", "", kCheck},
    {"view.frameHands", kView, QT_TRANSLATE_NOOP("app::ActionTable", "Fra&me the hands"), "9", "zoom-fit-selection", QT_TRANSLATE_NOOP("app::ActionTable", "Zooms every view to the hands, where they are known"), kPlain, true},
    {"view.zoomJoint", kView, QT_TRANSLATE_NOOP("app::ActionTable", "&Zoom all views to the joint"), "V", "", ""},
    {"view.fitAll", kView, QT_TRANSLATE_NOOP("app::ActionTable", "Sho&w whole images"), "0", "zoom-original", QT_TRANSLATE_NOOP("app::ActionTable", "Ends zoom and pan in all views")},
    {"view.followJoint", kView, QT_TRANSLATE_NOOP("app::ActionTable", "&Follow the selected joint"), "Y", "", QT_TRANSLATE_NOOP("app::ActionTable", "Keeps the selected joint in the middle of every zoomed view"), kCheck},
    {"view.maximise1", kMaximise, QT_TRANSLATE_NOOP("app::ActionTable", "Maximise view 1"), "1", "", ""},
    {"view.maximise2", kMaximise, QT_TRANSLATE_NOOP("app::ActionTable", "Maximise view 2"), "2", "", ""},
    {"view.maximise3", kMaximise, QT_TRANSLATE_NOOP("app::ActionTable", "Maximise view 3"), "3", "", ""},
    {"view.maximise4", kMaximise, QT_TRANSLATE_NOOP("app::ActionTable", "Maximise view 4"), "4", "", ""},
    {"view.maximise5", kMaximise, QT_TRANSLATE_NOOP("app::ActionTable", "Maximise view 5"), "5", "", ""},
    {"view.maximise6", kMaximise, QT_TRANSLATE_NOOP("app::ActionTable", "Maximise view 6"), "6", "", ""},
    {"view.maximise7", kMaximise, QT_TRANSLATE_NOOP("app::ActionTable", "Maximise view 7"), "7", "", ""},
    {"view.maximise8", kMaximise, QT_TRANSLATE_NOOP("app::ActionTable", "Maximise view 8"), "8", "", ""},
    {"view.restore", kMaximise, QT_TRANSLATE_NOOP("app::ActionTable", "All views again"), "Esc", "", "", kPlain, true},
    {"view.skeleton", kMarks, QT_TRANSLATE_NOOP("app::ActionTable", "S&keleton"), "K", "", "", kCheck, true},
    {"view.guides", kMarks, QT_TRANSLATE_NOOP("app::ActionTable", "&Epipolar guides"), "J", "", QT_TRANSLATE_NOOP("app::ActionTable", "Lines on which the selected joint must lie, as the other views say"), kCheck},
    {"view.proposals", kMarks, QT_TRANSLATE_NOOP("app::ActionTable", "P&re-placed marks"), "Shift+R", "", QT_TRANSLATE_NOOP("app::ActionTable", "Marks that wait to be accepted"), kCheck},
    {"view.otherRaters", kMarks, QT_TRANSLATE_NOOP("app::ActionTable", "Other people's marks"), "Ctrl+Shift+U", "", QT_TRANSLATE_NOOP("app::ActionTable", "What others have marked in this sequence, muted; it cannot be changed here"), kCheck},
    {"view.residuals", kMarks, QT_TRANSLATE_NOOP("app::ActionTable", "Residual a&rrows"), "Ctrl+Shift+E", "", QT_TRANSLATE_NOOP("app::ActionTable", "How far all clicks of each camera are off, place by place, ten times as long; green: refined"), kCheck},
    {"view.labels", kMarks, QT_TRANSLATE_NOOP("app::ActionTable", "Joint &names"), "L", "", "", kCheck},
    {"view.handLabels", kMarks, QT_TRANSLATE_NOOP("app::ActionTable", "Which hand is &left and which right"), "Ctrl+Shift+L", "", QT_TRANSLATE_NOOP("app::ActionTable", "L and R beside the hands, where they are known"), kCheck},
    {"view.leftMarks", kMarks, QT_TRANSLATE_NOOP("app::ActionTable", "L&eft hand"), "Shift+F5", "", QT_TRANSLATE_NOOP("app::ActionTable", "Marks and mesh of the left hand"), kCheck, true},
    {"view.rightMarks", kMarks, QT_TRANSLATE_NOOP("app::ActionTable", "Ri&ght hand"), "Shift+F6", "", QT_TRANSLATE_NOOP("app::ActionTable", "Marks and mesh of the right hand"), kCheck},
    {"view.hideOverlays", kMarks, QT_TRANSLATE_NOOP("app::ActionTable", "&Hide all overlays"), "H", "view-hidden", QT_TRANSLATE_NOOP("app::ActionTable", "While the key is held"), kHold, true},
    {"view.longErrors", kMarks, QT_TRANSLATE_NOOP("app::ActionTable", "Error lines three times as &long"), "T", "", QT_TRANSLATE_NOOP("app::ActionTable", "While the key is held"), kHold},
    {"view.meshShaded", kMesh, QT_TRANSLATE_NOOP("app::ActionTable", "Mesh: sha&ded"), "F2", "", "", kCheck},
    {"view.meshWireframe", kMesh, QT_TRANSLATE_NOOP("app::ActionTable", "Mesh: &wireframe"), "F3", "", "", kCheck},
    {"view.meshOff", kMesh, QT_TRANSLATE_NOOP("app::ActionTable", "Mesh: o&ff"), "F4", "", "", kCheck},
    {"view.meshNext", kMesh, QT_TRANSLATE_NOOP("app::ActionTable", "Next mesh st&yle"), "M", "", ""},
    {"view.meshMore", kMesh, QT_TRANSLATE_NOOP("app::ActionTable", "Mesh more &opaque"), "+", "", "", kPlain, true},
    {"view.meshLess", kMesh, QT_TRANSLATE_NOOP("app::ActionTable", "Mesh more &transparent"), "-", "", ""},
    {"view.leftHand", kMesh, QT_TRANSLATE_NOOP("app::ActionTable", "Mesh of the left hand"), "F5", "", "", kCheck, true},
    {"view.rightHand", kMesh, QT_TRANSLATE_NOOP("app::ActionTable", "Mesh of the right hand"), "F6", "", "", kCheck},
    {"view.recordedMesh", kMesh, QT_TRANSLATE_NOOP("app::ActionTable", "Mesh of the recorded pose"), "F7", "", "", kCheck, true},
    {"view.startMesh", kMesh, QT_TRANSLATE_NOOP("app::ActionTable", "Mesh of the fit's start pose"), "F8", "", "", kCheck},
    {"view.modelOfMarks", kMesh, QT_TRANSLATE_NOOP("app::ActionTable", "Hand &model of the marks"), "F9", "edit-node", QT_TRANSLATE_NOOP("app::ActionTable", "The hand model, fitted to the 3D joints of this frame"), kCheck},
    {"view.resetScene", kScene, QT_TRANSLATE_NOOP("app::ActionTable", "Reset the 3D sc&ene"), "Ctrl+0", "", ""},
    {"view.lookThrough", kScene, QT_TRANSLATE_NOOP("app::ActionTable", "Look thro&ugh the current camera"), "Shift+V", "", QT_TRANSLATE_NOOP("app::ActionTable", "The 3D scene from the current camera"), kCheck},
    {"view.loupe", kView, QT_TRANSLATE_NOOP("app::ActionTable", "Lou&pe"), "Z", "edit-find", QT_TRANSLATE_NOOP("app::ActionTable", "Magnifies the pixels around the pointer"), kCheck, true},
    {"view.adjust", kView, QT_TRANSLATE_NOOP("app::ActionTable", "&Brightness, contrast, gamma..."), "Ctrl+B", "", QT_TRANSLATE_NOOP("app::ActionTable", "Of the current view or of all")},
    {"view.cameras", kView, QT_TRANSLATE_NOOP("app::ActionTable", "&Cameras: hide, reorder..."), "Ctrl+Shift+C", "", ""},
    {"view.toolbar", kView, QT_TRANSLATE_NOOP("app::ActionTable", "&Toolbar"), "Ctrl+Shift+T", "", "", kCheck, true},
    {"view.light", kView, QT_TRANSLATE_NOOP("app::ActionTable", "Li&ght colours"), "F12", "", "", kCheck},
    {"view.fullScreen", kView, QT_TRANSLATE_NOOP("app::ActionTable", "Full scree&n"), "F11", "view-fullscreen", "", kCheck},

    {"annotation.accept", kAnnotate, QT_TRANSLATE_NOOP("app::ActionTable", "&Accept the pre-placed mark"), "Space", "dialog-ok-apply", QT_TRANSLATE_NOOP("app::ActionTable", "In the current view or, if that has a mark, in the next one without")},
    {"annotation.acceptAll", kAnnotate, QT_TRANSLATE_NOOP("app::ActionTable", "Accept in all &views"), "Shift+Space", "", ""},
    {"annotation.acceptFrame", kAnnotate, QT_TRANSLATE_NOOP("app::ActionTable", "Accept all joints of the &frame"), "Ctrl+Space", "", ""},
    {"annotation.propose", kAnnotate, QT_TRANSLATE_NOOP("app::ActionTable", "Propose the &rest from the hand model"), "R", "tools-wizard", QT_TRANSLATE_NOOP("app::ActionTable", "Fits the hand model to the 3D joints of this frame and places the others, to be checked")},
    {"annotation.firstPass", kAnnotate, QT_TRANSLATE_NOOP("app::ActionTable", "First &pass..."), "Ctrl+Alt+F", "media-seek-forward", QT_TRANSLATE_NOOP("app::ActionTable", "Finds the joints of both hands in many frames without a click, as proposals to be checked")},
    {"firstPass.run", kAnnotate, QT_TRANSLATE_NOOP("app::ActionTable", "Start the first pass now"), "Ctrl+Alt+R", "media-playback-start", QT_TRANSLATE_NOOP("app::ActionTable", "With what is chosen for the first pass"), kPlain, false, false},
    {"review.accept", kReview, QT_TRANSLATE_NOOP("app::ActionTable", "&Accept the frame, go on to the next"), "Shift+E", "dialog-ok-apply", QT_TRANSLATE_NOOP("app::ActionTable", "Accepts all proposed joints of the frame as they stand")},
    {"review.correct", kReview, QT_TRANSLATE_NOOP("app::ActionTable", "&Correct the most doubtful joint"), "Shift+C", "document-edit", QT_TRANSLATE_NOOP("app::ActionTable", "Selects it: click it in two views, then accept the frame")},
    {"review.next", kReview, QT_TRANSLATE_NOOP("app::ActionTable", "&Next frame to review"), "Shift+W", "go-next", QT_TRANSLATE_NOOP("app::ActionTable", "Frames whose look teaches most come first")},
    {"review.show", kReview, QT_TRANSLATE_NOOP("app::ActionTable", "&Show the review queue"), "Ctrl+Alt+Q", "view-list-details", ""},
    {"annotation.occluded", kAnnotate, QT_TRANSLATE_NOOP("app::ActionTable", "&Occluded, estimated"), "O", "view-hidden", QT_TRANSLATE_NOOP("app::ActionTable", "The joint is hidden here; its place is a guess"), kPlain, true},
    {"annotation.unplaceable", kAnnotate, QT_TRANSLATE_NOOP("app::ActionTable", "&Cannot be placed here"), "U", "dialog-cancel", ""},
    {"annotation.remove", kAnnotate, QT_TRANSLATE_NOOP("app::ActionTable", "&Delete the mark"), "X", "edit-delete", QT_TRANSLATE_NOOP("app::ActionTable", "Of the selected joint in the current view")},
    {"annotation.removeAll", kAnnotate, QT_TRANSLATE_NOOP("app::ActionTable", "Delete in all vie&ws"), "Shift+X", "", ""},
    {"annotation.previousJoint", kStep, QT_TRANSLATE_NOOP("app::ActionTable", "&Previous joint"), "W", "", "", kPlain, true},
    {"annotation.nextJoint", kStep, QT_TRANSLATE_NOOP("app::ActionTable", "&Next joint"), "S", "", ""},
    {"annotation.previousView", kStep, QT_TRANSLATE_NOOP("app::ActionTable", "Previous view"), "Q", "", ""},
    {"annotation.nextView", kStep, QT_TRANSLATE_NOOP("app::ActionTable", "Next view"), "E", "", ""},
    {"annotation.nudgeLeft", kNudge, QT_TRANSLATE_NOOP("app::ActionTable", "Nudge left"), "Left", "", QT_TRANSLATE_NOOP("app::ActionTable", "By a quarter of an image pixel")},
    {"annotation.nudgeRight", kNudge, QT_TRANSLATE_NOOP("app::ActionTable", "Nudge right"), "Right", "", QT_TRANSLATE_NOOP("app::ActionTable", "By a quarter of an image pixel")},
    {"annotation.nudgeUp", kNudge, QT_TRANSLATE_NOOP("app::ActionTable", "Nudge up"), "Up", "", QT_TRANSLATE_NOOP("app::ActionTable", "By a quarter of an image pixel")},
    {"annotation.nudgeDown", kNudge, QT_TRANSLATE_NOOP("app::ActionTable", "Nudge down"), "Down", "", QT_TRANSLATE_NOOP("app::ActionTable", "By a quarter of an image pixel")},
    {"annotation.nudgeLeftFar", kNudge, QT_TRANSLATE_NOOP("app::ActionTable", "Nudge left by a pixel"), "Shift+Left", "", "", kPlain, true},
    {"annotation.nudgeRightFar", kNudge, QT_TRANSLATE_NOOP("app::ActionTable", "Nudge right by a pixel"), "Shift+Right", "", ""},
    {"annotation.nudgeUpFar", kNudge, QT_TRANSLATE_NOOP("app::ActionTable", "Nudge up by a pixel"), "Shift+Up", "", ""},
    {"annotation.nudgeDownFar", kNudge, QT_TRANSLATE_NOOP("app::ActionTable", "Nudge down by a pixel"), "Shift+Down", "", ""},
    {"annotation.copyPrevious", kAnnotate, QT_TRANSLATE_NOOP("app::ActionTable", "Copy the pose of the previous annotated frame"), "C", "edit-copy", QT_TRANSLATE_NOOP("app::ActionTable", "As marks that wait to be checked"), kPlain, true},
    {"annotation.interpolate", kAnnotate, QT_TRANSLATE_NOOP("app::ActionTable", "&Interpolate between annotated frames"), "I", "", QT_TRANSLATE_NOOP("app::ActionTable", "In 3D, along straight lines, over the gap around this frame")},
    {"annotation.interpolateCubic", kAnnotate, QT_TRANSLATE_NOOP("app::ActionTable", "Interpolate along a curve"), "Shift+I", "", QT_TRANSLATE_NOOP("app::ActionTable", "In 3D, cubic, over the gap around this frame")},
    {"annotation.swapHands", kAnnotate, QT_TRANSLATE_NOOP("app::ActionTable", "&Swap left and right from here on"), "Ctrl+Shift+X", "", "", kPlain, true},
    {"annotation.deleteFrame", kAnnotate, QT_TRANSLATE_NOOP("app::ActionTable", "Delete all marks of this frame"), "Ctrl+Del", "", ""},
    {"annotation.deleteRange", kAnnotate, QT_TRANSLATE_NOOP("app::ActionTable", "Delete a range of frames..."), "Ctrl+Shift+Del", "", ""},
    {"annotation.jointsFourteen", kJoints, QT_TRANSLATE_NOOP("app::ActionTable", "14 joints per hand"), "Ctrl+4", "", "", kCheck, true},
    {"annotation.jointsTwentyOne", kJoints, QT_TRANSLATE_NOOP("app::ActionTable", "21 joints per hand"), "Ctrl+5", "", QT_TRANSLATE_NOOP("app::ActionTable", "With wrist and finger tips"), kCheck},
    {"annotation.jointsAll", kJoints, QT_TRANSLATE_NOOP("app::ActionTable", "All joints of the model"), "Ctrl+6", "", "", kCheck},
    {"annotation.jointsFile", kJoints, QT_TRANSLATE_NOOP("app::ActionTable", "Joints from a &file..."), "Ctrl+7", "", ""},
    {"annotation.jointUp", kJoints, QT_TRANSLATE_NOOP("app::ActionTable", "Move the joint up in the list"), "Ctrl+Up", "", "", kPlain, true},
    {"annotation.jointDown", kJoints, QT_TRANSLATE_NOOP("app::ActionTable", "Move the joint down in the list"), "Ctrl+Down", "", ""},
    {"annotation.makeSilhouettes", kAnnotate, QT_TRANSLATE_NOOP("app::ActionTable", "Make the silhouettes now"), "Ctrl+Shift+G", "run-build", QT_TRANSLATE_NOOP("app::ActionTable", "Of the frames that are chosen in the window for silhouettes"), kPlain, false, false},
    {"annotation.silhouetteBrush", kAnnotate, QT_TRANSLATE_NOOP("app::ActionTable", "Brush for silhouettes"), "Shift+H", "draw-brush", QT_TRANSLATE_NOOP("app::ActionTable", "Left button adds, right button takes away, Ctrl and the wheel change its size"), kCheck, false, false},
    {"annotation.largerBrush", kAnnotate, QT_TRANSLATE_NOOP("app::ActionTable", "Larger brush"), "]", "", QT_TRANSLATE_NOOP("app::ActionTable", "Of the brush for silhouettes"), kPlain, false, false},
    {"annotation.smallerBrush", kAnnotate, QT_TRANSLATE_NOOP("app::ActionTable", "Smaller brush"), "[", "", QT_TRANSLATE_NOOP("app::ActionTable", "Of the brush for silhouettes"), kPlain, false, false},
    {"annotation.autoAdvance", kAnnotate, QT_TRANSLATE_NOOP("app::ActionTable", "Next joint when all views are done"), "Ctrl+Shift+A", "", "", kCheck},

    {"go.previousFrame", kGo, QT_TRANSLATE_NOOP("app::ActionTable", "&Previous frame"), "A", "media-skip-backward", ""},
    {"go.nextFrame", kGo, QT_TRANSLATE_NOOP("app::ActionTable", "&Next frame"), "D", "media-skip-forward", ""},
    {"go.back10", kGo, QT_TRANSLATE_NOOP("app::ActionTable", "Ten frames back"), "Shift+A", "", ""},
    {"go.forward10", kGo, QT_TRANSLATE_NOOP("app::ActionTable", "Ten frames forward"), "Shift+D", "", ""},
    {"go.firstFrame", kGo, QT_TRANSLATE_NOOP("app::ActionTable", "&First frame"), "Home", "go-first", ""},
    {"go.lastFrame", kGo, QT_TRANSLATE_NOOP("app::ActionTable", "&Last frame"), "End", "go-last", ""},
    {"go.frame", kGo, QT_TRANSLATE_NOOP("app::ActionTable", "&Go to frame..."), "G", "", ""},
    {"go.play", kGo, QT_TRANSLATE_NOOP("app::ActionTable", "Pla&y"), "P", "media-playback-start", "", kCheck},
    {"go.nextBad", kGo, QT_TRANSLATE_NOOP("app::ActionTable", "Next &bad joint"), "N", "flag-red", QT_TRANSLATE_NOOP("app::ActionTable", "Error above the threshold, an outlier, or no 3D point"), kPlain, true},
    {"go.previousBad", kGo, QT_TRANSLATE_NOOP("app::ActionTable", "Previous b&ad joint"), "Shift+N", "", ""},
    {"go.nextUnlabelled", kGo, QT_TRANSLATE_NOOP("app::ActionTable", "Next &unlabelled frame"), "B", "", QT_TRANSLATE_NOOP("app::ActionTable", "The next frame in which a joint is not done"), kPlain, true},
    {"go.previousUnlabelled", kGo, QT_TRANSLATE_NOOP("app::ActionTable", "Previous unlab&elled frame"), "Shift+B", "", ""},
    {"go.nextAnnotated", kGo, QT_TRANSLATE_NOOP("app::ActionTable", "Next annotated frame"), "Ctrl+D", "", ""},
    {"go.previousAnnotated", kGo, QT_TRANSLATE_NOOP("app::ActionTable", "Previous annotated frame"), "Ctrl+A", "", ""},
    {"go.nextTest", kGo, QT_TRANSLATE_NOOP("app::ActionTable", "Next &test frame"), "Ctrl+Right", "", QT_TRANSLATE_NOOP("app::ActionTable", "The frames that the benchmark draws from this sequence")},
    {"go.previousTest", kGo, QT_TRANSLATE_NOOP("app::ActionTable", "Previous test frame"), "Ctrl+Left", "", ""},
    {"go.lastEdited", kGo, QT_TRANSLATE_NOOP("app::ActionTable", "Last e&dited frame"), "Ctrl+G", "", ""},
    {"go.threshold", kGo, QT_TRANSLATE_NOOP("app::ActionTable", "Error &threshold..."), "Ctrl+T", "", QT_TRANSLATE_NOOP("app::ActionTable", "Joints with a larger error count as bad"), kPlain, true},

    {"fit.run", kFit, QT_TRANSLATE_NOOP("app::ActionTable", "&Fit the current frame"), "F", "run-build", QT_TRANSLATE_NOOP("app::ActionTable", "With the chosen methods, from the pose of some frames before")},
    {"fit.stop", kFit, QT_TRANSLATE_NOOP("app::ActionTable", "&Stop"), "Shift+F", "process-stop", ""},
    {"fit.show", kFit, QT_TRANSLATE_NOOP("app::ActionTable", "Show the fit &panel"), "Ctrl+F", "", ""},
    {"file.attachMasks", kFit, QT_TRANSLATE_NOOP("app::ActionTable", "&Attach masks..."), "Ctrl+Shift+M", "", QT_TRANSLATE_NOOP("app::ActionTable", "Gives this sequence the silhouettes of a folder")},
    {"annotation.silhouettes", kFit, QT_TRANSLATE_NOOP("app::ActionTable", "Silhouettes..."), "Ctrl+H", "image-x-generic", QT_TRANSLATE_NOOP("app::ActionTable", "Finds the hands' silhouettes in the pictures, to be looked at, touched up and kept")},
    {"rig.health", kFit, QT_TRANSLATE_NOOP("app::ActionTable", "How the &cameras fit the clicks"), "Ctrl+Shift+Q", "", QT_TRANSLATE_NOOP("app::ActionTable", "What all clicks of the dataset say of its calibration"), kPlain, true},
    {"rig.refine", kFit, QT_TRANSLATE_NOOP("app::ActionTable", "Re&fine the calibration..."), "Ctrl+Shift+D", "", QT_TRANSLATE_NOOP("app::ActionTable", "Adjusts the cameras to all clicks and shows what changes; also to return to an earlier calibration")},
    {"rig.apply", kFit, QT_TRANSLATE_NOOP("app::ActionTable", "&Use the refined calibration"), "Ctrl+Shift+P", "", QT_TRANSLATE_NOOP("app::ActionTable", "As a new calibration file; the old one is kept")},
    {"subject.measure", kFit, QT_TRANSLATE_NOOP("app::ActionTable", "Measure this person's &hands..."), "Ctrl+Shift+H", "", QT_TRANSLATE_NOOP("app::ActionTable", "Bone lengths, scale and girth from annotated frames and masks, as a new dataset")},
    {"subject.run", kFit, QT_TRANSLATE_NOOP("app::ActionTable", "Measure the hands now"), "Ctrl+Shift+V", "", QT_TRANSLATE_NOOP("app::ActionTable", "With what is chosen in the window for measuring hands"), kPlain, false, false},
    {"compare.previousIteration", kFit, QT_TRANSLATE_NOOP("app::ActionTable", "&Previous iteration"), ",", "", QT_TRANSLATE_NOOP("app::ActionTable", "Shows the poses as they were before"), kPlain, true},
    {"compare.nextIteration", kFit, QT_TRANSLATE_NOOP("app::ActionTable", "&Next iteration"), ".", "", ""},
    {"compare.lastIteration", kFit, QT_TRANSLATE_NOOP("app::ActionTable", "&Result of the fit"), "/", "", ""},
    {"compare.nextMethod", kFit, QT_TRANSLATE_NOOP("app::ActionTable", "Next &method in the 3D scene"), ";", "", ""},
    {"compare.layerContour", kLayers, QT_TRANSLATE_NOOP("app::ActionTable", "&Contour"), "Alt+1", "", QT_TRANSLATE_NOOP("app::ActionTable", "The observed outline over the inspected views; its colour is its direction"), kCheck},
    {"compare.layerRim", kLayers, QT_TRANSLATE_NOOP("app::ActionTable", "&Rim"), "Alt+2", "", QT_TRANSLATE_NOOP("app::ActionTable", "Rim points of the posed hands with their normals"), kCheck},
    {"compare.layerMatches", kLayers, QT_TRANSLATE_NOOP("app::ActionTable", "&Matches"), "Alt+3", "", QT_TRANSLATE_NOOP("app::ActionTable", "From rim points to their contour points, by distance or finger; a dash pattern for every reason to refuse one"), kCheck},
    {"compare.layerDifference", kLayers, QT_TRANSLATE_NOOP("app::ActionTable", "&Difference"), "Alt+4", "", QT_TRANSLATE_NOOP("app::ActionTable", "Silhouettes: red is seen but not covered, blue is covered but not seen, a hatched forearm does not count"), kCheck},
    {"compare.layerField", kLayers, QT_TRANSLATE_NOOP("app::ActionTable", "&Field"), "Alt+5", "", QT_TRANSLATE_NOOP("app::ActionTable", "What a rim point of one direction costs at every pixel"), kCheck},
    {"compare.layerError", kLayers, QT_TRANSLATE_NOOP("app::ActionTable", "&Error"), "Alt+6", "", QT_TRANSLATE_NOOP("app::ActionTable", "The mesh by its distance to the recorded pose"), kCheck},
    {"compare.layerUncertainty", kLayers, QT_TRANSLATE_NOOP("app::ActionTable", "&Uncertainty"), "Alt+7", "", QT_TRANSLATE_NOOP("app::ActionTable", "Where the joints of a result lie with 95 % probability, as the fit judged it"), kCheck},
    {"compare.nextMatches", kLayers, QT_TRANSLATE_NOOP("app::ActionTable", "Matches of the next finger"), "Alt+8", "", QT_TRANSLATE_NOOP("app::ActionTable", "All matches by distance, all by finger, then those of one finger or the palm after the other")},
    {"compare.addStart", kColumns, QT_TRANSLATE_NOOP("app::ActionTable", "Add the &start"), "Ctrl+Alt+1", "", QT_TRANSLATE_NOOP("app::ActionTable", "The pose that every method began with, as a column")},
    {"compare.addTruth", kColumns, QT_TRANSLATE_NOOP("app::ActionTable", "Add the &truth"), "Ctrl+Alt+2", "", QT_TRANSLATE_NOOP("app::ActionTable", "The recorded pose, as a column")},
    {"compare.addTracker", kColumns, QT_TRANSLATE_NOOP("app::ActionTable", "Add a tracker's &estimates..."), "Ctrl+Alt+3", "", QT_TRANSLATE_NOOP("app::ActionTable", "A file of joints per frame pair, as handlens-batch benchmark takes it")},
    {"compare.removeColumn", kColumns, QT_TRANSLATE_NOOP("app::ActionTable", "&Remove the column"), "Ctrl+Alt+0", "list-remove", ""},
    {"compare.previousColumn", kColumns, QT_TRANSLATE_NOOP("app::ActionTable", "&Previous column"), "Alt+Left", "", QT_TRANSLATE_NOOP("app::ActionTable", "What the settings and the wipe are about"), kPlain, true},
    {"compare.nextColumn", kColumns, QT_TRANSLATE_NOOP("app::ActionTable", "&Next column"), "Alt+Right", "", ""},
    {"compare.columnLeft", kColumns, QT_TRANSLATE_NOOP("app::ActionTable", "Move the column to the &left"), "Alt+Shift+Left", "", ""},
    {"compare.columnRight", kColumns, QT_TRANSLATE_NOOP("app::ActionTable", "Move the column to the ri&ght"), "Alt+Shift+Right", "", ""},
    {"compare.hideHere", kColumns, QT_TRANSLATE_NOOP("app::ActionTable", "&Hide or show the hands in this view"), "Alt+0", "", QT_TRANSLATE_NOOP("app::ActionTable", "The column in the current view")},
    {"compare.wipe", kColumns, QT_TRANSLATE_NOOP("app::ActionTable", "&Wipe to the next column"), "Ctrl+Alt+W", "", QT_TRANSLATE_NOOP("app::ActionTable", "The next column lies over this one, behind a line that can be dragged"), kCheck, true},
    {"compare.wipeLeft", kColumns, QT_TRANSLATE_NOOP("app::ActionTable", "Line of the wipe to the left"), "Ctrl+Alt+,", "", ""},
    {"compare.wipeRight", kColumns, QT_TRANSLATE_NOOP("app::ActionTable", "Line of the wipe to the right"), "Ctrl+Alt+.", "", ""},
    {"compare.blink", kColumns, QT_TRANSLATE_NOOP("app::ActionTable", "&Blink with the next column"), "Ctrl+Alt+B", "", QT_TRANSLATE_NOOP("app::ActionTable", "Shows this column and the next one by turns"), kCheck},
    {"compare.whatIf", kColumns, QT_TRANSLATE_NOOP("app::ActionTable", "What &if..."), "Ctrl+Alt+I", "configure", QT_TRANSLATE_NOOP("app::ActionTable", "Settings of the column's method, cameras and noise: drag one, and the methods run again"), kPlain, true},
    {"compare.useSettings", kColumns, QT_TRANSLATE_NOOP("app::ActionTable", "&Use these settings"), "Ctrl+Alt+U", "dialog-ok-apply", QT_TRANSLATE_NOOP("app::ActionTable", "Gives the column what was tried under What if")},
    {"compare.addSettings", kColumns, QT_TRANSLATE_NOOP("app::ActionTable", "&Add these settings as a column"), "Ctrl+Alt+A", "list-add", QT_TRANSLATE_NOOP("app::ActionTable", "What was tried under What if, beside the column")},
    {"compare.resetSettings", kColumns, QT_TRANSLATE_NOOP("app::ActionTable", "Bac&k to what was fitted"), "Ctrl+Alt+K", "", QT_TRANSLATE_NOOP("app::ActionTable", "Ends what was tried under What if")},
    {"compare.sweep", kColumns, QT_TRANSLATE_NOOP("app::ActionTable", "Sweep the setting"), "Ctrl+Alt+V", "office-chart-line", QT_TRANSLATE_NOOP("app::ActionTable", "Fits at a row of values of the setting that was changed last, and draws the error over it; once more stops")},
    {"compare.measureCameras", kColumns, QT_TRANSLATE_NOOP("app::ActionTable", "What does each &camera add?"), "Ctrl+Alt+C", "", QT_TRANSLATE_NOOP("app::ActionTable", "Fits without each camera in turn")},
    {"file.saveWorkspace", kComparison, QT_TRANSLATE_NOOP("app::ActionTable", "Save this &comparison..."), "Ctrl+Alt+S", "", QT_TRANSLATE_NOOP("app::ActionTable", "Pair, methods, cameras, layers and iteration, as a small file that opens again")},
    {"file.openWorkspace", kComparison, QT_TRANSLATE_NOOP("app::ActionTable", "Open a com&parison..."), "Ctrl+Alt+O", "", ""},
    {"file.comparisonPicture", kComparison, QT_TRANSLATE_NOOP("app::ActionTable", "Save as a &picture..."), "Ctrl+Alt+G", "document-save-as", QT_TRANSLATE_NOOP("app::ActionTable", "Views, titles and curves on white paper: PNG, or SVG or PDF with lines and marks as vectors")},
    {"file.comparisonFilm", kComparison, QT_TRANSLATE_NOOP("app::ActionTable", "Save the iterations as a &film..."), "Ctrl+Alt+M", "video-x-generic", QT_TRANSLATE_NOOP("app::ActionTable", "The comparison from the start pose to the last iteration")},
    {"file.comparisonReport", kComparison, QT_TRANSLATE_NOOP("app::ActionTable", "&Report of this comparison..."), "Ctrl+Alt+H", "text-html", QT_TRANSLATE_NOOP("app::ActionTable", "One page with pictures, tables, settings and the command that makes it again")},
    {"benchmark.run", kBenchmark, QT_TRANSLATE_NOOP("app::ActionTable", "&Run or stop the benchmark"), "Ctrl+Shift+F", "", ""},
    {"benchmark.filter", kBenchmark, QT_TRANSLATE_NOOP("app::ActionTable", "Fil&ter the benchmark's pairs"), "Ctrl+Alt+P", "view-filter", QT_TRANSLATE_NOOP("app::ActionTable", "By errors, differences of methods, sequences and frames, such as A-B>1")},
    {"benchmark.runSelected", kBenchmark, QT_TRANSLATE_NOOP("app::ActionTable", "Run the selected &pairs"), "Ctrl+Alt+N", "run-build", QT_TRANSLATE_NOOP("app::ActionTable", "Adds what the ticked methods make of them to the results that are shown")},
    {"file.saveResults", kBenchmark, QT_TRANSLATE_NOOP("app::ActionTable", "&Save the benchmark's results..."), "Ctrl+Shift+K", "", QT_TRANSLATE_NOOP("app::ActionTable", "Tables, pairs and a report, in a folder")},
    {"file.openResults", kBenchmark, QT_TRANSLATE_NOOP("app::ActionTable", "&Open a benchmark's results..."), "Ctrl+Shift+J", "", QT_TRANSLATE_NOOP("app::ActionTable", "A folder that was saved here or written by handlens-batch benchmark")},

    {"edit.rater", kRaters, QT_TRANSLATE_NOOP("app::ActionTable", "Your n&ame..."), "Ctrl+U", "user-identity", QT_TRANSLATE_NOOP("app::ActionTable", "The name that your marks are kept under")},
    {"annotation.raters", kRaters, QT_TRANSLATE_NOOP("app::ActionTable", "Compare ra&ters"), "Ctrl+Shift+B", "", "", kPlain, true},
    {"annotation.repeat", kRaters, QT_TRANSLATE_NOOP("app::ActionTable", "&Start a repeat round"), "Ctrl+Shift+R", "", QT_TRANSLATE_NOOP("app::ActionTable", "A random tenth of your finished joints, your first marks hidden; once more to end the round"), kPlain, true},
    {"annotation.repeatNext", kRaters, QT_TRANSLATE_NOOP("app::ActionTable", "Next joint of the repeat round"), "Ctrl+Shift+N", "", ""},

    {"help.shortcuts", kHelp, QT_TRANSLATE_NOOP("app::ActionTable", "&Shortcuts"), "F1", "help-contents", ""},
    {"help.hints", kHelp, QT_TRANSLATE_NOOP("app::ActionTable", "&Four hints"), "Ctrl+F1", "", ""},
    {"help.about", kHelp, QT_TRANSLATE_NOOP("app::ActionTable", "&About Handlens"), "Ctrl+Shift+F1", "help-about", "", kPlain, true},
};
// clang-format on

const std::vector<MenuRow> kMenus = {
    {kFile, nullptr},     {kEdit, nullptr},     {kView, nullptr},   {kMaximise, kView},   {kMarks, kView},
    {kLayers, kFit},      {kComparison, kFit},  {kBenchmark, kFit}, {kColumns, kFit},     {kMesh, kView},
    {kScene, kView},      {kAnnotate, nullptr}, {kStep, kAnnotate}, {kReview, kAnnotate}, {kNudge, kAnnotate},
    {kJoints, kAnnotate}, {kGo, nullptr},       {kFit, nullptr},    {kRaters, nullptr},   {kHelp, nullptr}};

} // namespace

const std::vector<ActionRow>& actionTable() {
    return kRows;
}

const std::vector<MenuRow>& menuTable() {
    return kMenus;
}

} // namespace app
