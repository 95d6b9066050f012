// What stands before the character in a drawing: things that it holds, and things that are no part
// of it.
#pragma once

#include <span>
#include <vector>

#include "base/image.h"
#include "document/document.h"

namespace artisketch {

// Per pixel of a frame, the joint of the held thing (Role::held) that is seen there, −1 where there
// is none; empty where the frame shows none. What is outlined after a thing stands before it.
std::vector<int> held_things(const Document& document, int frame);

// A frame's picture without what lies inside the outlines of things that are no part of the
// character (Role::apart), as if it had been cut out. Nothing where the frame shows none.
Image without_things_apart(const Document& document, int frame, const Image& picture);

}  // namespace artisketch
