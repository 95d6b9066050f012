#include "editor/session/commands.h"

#include "editor/ui/icons.h"

namespace artisketch {
namespace {

constexpr CommandWords kCommands[] = {
    {Command::new_document, "New", icon::kFileDocumentBox, ImGuiKey_N, true},
    {Command::open, "Open", icon::kFolderOutline, ImGuiKey_O, true},
    {Command::save, "Save", icon::kContentSave, ImGuiKey_S, true},
    {Command::save_as, "Save as", icon::kContentSaveSettings, ImGuiKey_S, true, true},
    {Command::add_drawings, "Add drawings", icon::kImageMultiple},
    {Command::blank_drawing, "Blank paper", icon::kPencil},
    {Command::export_model, "Export", icon::kExport, ImGuiKey_E, true},
    {Command::undo, "Undo", icon::kUndoVariant, ImGuiKey_Z, true},
    {Command::redo, "Redo", icon::kRedoVariant, ImGuiKey_Z, true, true},
    {Command::reconstruct, "Reconstruct", icon::kCubeOutline, ImGuiKey_R, false, false,
     "Make the model from the drawings"},
    {Command::calibrate, "Calibrate", icon::kCrosshairsGps, ImGuiKey_C, false, true,
     "Turn the bones until the outlines of all drawings agree"},
    {Command::cancel_job, "Cancel", icon::kClose, ImGuiKey_Escape},
    {Command::mode_outline, "Outline", icon::kPencil, ImGuiKey_1, false, false,
     "Outline each part"},
    {Command::mode_skeleton, "Skeleton", icon::kBone, ImGuiKey_2, false, false,
     "One skeleton for all drawings"},
    {Command::mode_pose, "Pose", icon::kWalk, ImGuiKey_3, false, false,
     "Match the skeleton to each drawing"},
    {Command::mode_result, "Result", icon::kCubeOutline, ImGuiKey_4, false, false,
     "See the model move"},
    {Command::previous_drawing, "Previous drawing", icon::kChevronLeft, ImGuiKey_Comma},
    {Command::next_drawing, "Next drawing", icon::kChevronRight, ImGuiKey_Period},
    {Command::show_drawing, "Drawing", icon::kImage, ImGuiKey_H, false, false,
     "Show or hide the drawing"},
    {Command::show_bones, "Bones", icon::kBone, ImGuiKey_B, false, false,
     "Show or hide the skeleton"},
    {Command::show_model, "Model", icon::kCubeOutline, ImGuiKey_G, false, false,
     "Lay the model over the drawing"},
    {Command::fit, "Fit", icon::kArrowExpandAll, ImGuiKey_0, false, false,
     "Fit the drawing into view"},
    {Command::home, "Home", nullptr, ImGuiKey_Home, false, false, "See the whole model"},
    {Command::zoom_in, "Zoom in", icon::kPlus, ImGuiKey_Equal},
    {Command::zoom_out, "Zoom out", icon::kMinus, ImGuiKey_Minus},
    {Command::play, "Play", icon::kPlay, ImGuiKey_Space},
    {Command::fade, "Fade", nullptr, ImGuiKey_Slash, false, false,
     "Fade the drawing, or bring it back"},
    {Command::theme, "Light or dark", icon::kThemeLightDark},
    {Command::help, "Shortcuts", icon::kHelpCircleOutline, ImGuiKey_Slash, false, true},
    {Command::tool_edit, "Edit", icon::kCursorDefaultOutline, ImGuiKey_V},
    {Command::tool_draw, "Draw", icon::kPencil, ImGuiKey_D},
    {Command::tool_points, "Points", icon::kVectorPolyline, ImGuiKey_P},
    {Command::tool_trace, "Trace", icon::kAutoFix, ImGuiKey_T, false, false,
     "Outline what you click"},
    {Command::tool_cut, "Cut", icon::kContentCut, ImGuiKey_K},
    {Command::mirror, "Mirror", icon::kCompare, ImGuiKey_M, false, false,
     "Mirror the outline for the other side"},
    {Command::copy_to, "Copy to", icon::kContentCopy, ImGuiKey_C, false, false,
     "Copy the outline to the next drawing"},
    {Command::behind, "Behind", icon::kFlipToBack, ImGuiKey_LeftBracket},
    {Command::in_front, "In front", icon::kFlipToFront, ImGuiKey_RightBracket},
    {Command::remove, "Delete", icon::kDelete, ImGuiKey_Delete},
    {Command::redraw, "Redraw", icon::kPencil, ImGuiKey_D, false, true, "Draw this outline anew"},
    {Command::other_joint, "Other joint", icon::kCrosshairsGps, ImGuiKey_O, false, false,
     "Give the outline to the joint that you click next"},
    {Command::join, "Join", icon::kLink, ImGuiKey_J, false, false,
     "Join with the outline that you click next"},
    {Command::mend, "Mend", icon::kAutoFix, ImGuiKey_M, false, true,
     "Put right where the outline crosses itself"},
    {Command::hidden_here, "Hidden here", icon::kEyeOff, ImGuiKey_H, false, true,
     "This drawing doesn't show the part: nothing is missing"},
    {Command::both_sides, "Mirror", icon::kCompare, ImGuiKey_X, false, false,
     "Do to both sides what is done to one"},
    {Command::equalise, "Equalise", icon::kSwapHorizontal, ImGuiKey_L, false, false,
     "Make the bone as long as its mirror image; all pairs where none is chosen"},
    {Command::rename, "Rename", icon::kKeyboard, ImGuiKey_F2, false, false, "Name the joint"},
    {Command::tool_pose, "Pose", icon::kCursorMove, ImGuiKey_V},
    {Command::flip, "Flip", icon::kSwapHorizontal, ImGuiKey_F, false, false,
     "Flip the bone toward you or away"},
    {Command::tool_twist, "Twist", icon::kRotateRight, ImGuiKey_T},
    {Command::tool_turn, "Turn", icon::kRotate3d, ImGuiKey_A, false, false, "Turn the whole body"},
    {Command::lock, "Lock", icon::kLockOutline, ImGuiKey_L, false, false,
     "Calibration keeps this part's turn, or may change it again"},
    {Command::suggest, "Suggest", icon::kAutoFix, ImGuiKey_S, false, false,
     "Find a pose from the outlines"},
    {Command::copy_pose, "Copy", icon::kContentCopy, ImGuiKey_C, false, false,
     "Take the pose of another drawing"},
    {Command::tool_orbit, "Orbit", icon::kRotate3d, ImGuiKey_O, false, false, "Look around"},
    {Command::tool_joints, "Joints", icon::kVectorCircleVariant, ImGuiKey_J, false, false,
     "The spheres that join the parts: drag a rim or a middle"},
    {Command::tool_fatness, "Fatness", icon::kArrowExpand, ImGuiKey_W, false, false,
     "Drag a part sideways: thinner or fatter"},
    {Command::set_key, "Set key", icon::kKeyVariant, ImGuiKey_I, false, false,
     "Keep this pose at the playhead"},
    {Command::new_clip, "New clip", icon::kPlus, ImGuiKey_None, false, false,
     "An animation of your own, from this pose on"},
    {Command::reset, "Reset", icon::kBackupRestore},
};

const char* key_name(ImGuiKey key) {
  switch (key) {
    case ImGuiKey_Comma:
      return ",";
    case ImGuiKey_Period:
      return ".";
    case ImGuiKey_Slash:
      return "/";
    case ImGuiKey_Equal:
      return "+";
    case ImGuiKey_Minus:
      return "−";
    case ImGuiKey_LeftBracket:
      return "[";
    case ImGuiKey_RightBracket:
      return "]";
    case ImGuiKey_Escape:
      return "Esc";
    default:
      return ImGui::GetKeyName(key);
  }
}

}  // namespace

std::span<const CommandWords> all_commands() {
  return kCommands;
}

const CommandWords& words_of(Command command) {
  for (const CommandWords& words : kCommands)
    if (words.command == command) return words;
  static const CommandWords none{Command::none, "", nullptr};
  return none;
}

std::string key_words(const CommandWords& words, bool mac) {
  if (words.key == ImGuiKey_None) return "";
  if (words.command == Command::help) return "?";
  std::string text;
  if (words.ctrl) text += mac ? "⌘" : "Ctrl+";
  if (words.shift) text += mac ? "⇧" : "Shift+";
  return text + key_name(words.key);
}

std::vector<Command> pressed_commands() {
  std::vector<Command> pressed;
  const ImGuiIO& io = ImGui::GetIO();
  if (io.WantTextInput) return pressed;
  const bool ctrl = io.KeyCtrl || io.KeySuper;
  for (const CommandWords& words : kCommands) {
    const bool repeats = words.command == Command::undo || words.command == Command::redo ||
                         words.command == Command::zoom_in || words.command == Command::zoom_out;
    const bool plus = words.command == Command::zoom_in;  // '+' needs Shift on many keyboards
    if (words.key != ImGuiKey_None && words.ctrl == ctrl && (plus || words.shift == io.KeyShift) &&
        ImGui::IsKeyPressed(words.key, repeats))
      pressed.push_back(words.command);
  }
  if (ctrl && ImGui::IsKeyPressed(ImGuiKey_Y)) pressed.push_back(Command::redo);
  if (!ctrl && ImGui::IsKeyPressed(ImGuiKey_Backspace, false)) pressed.push_back(Command::remove);
  return pressed;
}

}  // namespace artisketch
