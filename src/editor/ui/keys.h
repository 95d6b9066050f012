// Keys come to the editor in the order in which they were pressed, and to the field that they are
// meant for, however slowly frames follow each other.
#pragma once

namespace artisketch {

// ImGui::NewFrame() with at most one key pressed in it: what the next key means depends on what
// this one does. The rest stays in ImGui's own queue, for the frames that follow.
void begin_frame();

// A text field is about to take the keyboard, some frames from now: until then what is typed waits.
// Where none comes, the keys go where they always do.
void await_text_field();

}  // namespace artisketch
