// What a person does to the result: clips of keys, joints' spheres, fatness.
#pragma once

#include <string>

#include "document/document.h"

namespace artisketch {

// ---------------------------------------------------------------- clips

inline constexpr double kLeastStep = 0.05;       // seconds between keys
inline constexpr std::size_t kMostKeys = 10000;  // of all clips

// A clip with one key at its start, under a name that no clip has yet: "clip 1".
Document with_clip(Document document, Pose first);
// A whole clip, under its name, or the first of "walk 2", "walk 3" … that no clip has yet.
Document with_animation(Document document, Animation animation);
Document without_clip(Document document, int clip);

// A key of the pose at a time (seconds, ≥ 0); in place of one that is nearer than kLeastStep.
Document with_key(Document document, int clip, double time, Pose pose);
// The last key goes with its clip.
Document without_key(Document document, int clip, int key);
// The key at another time, kLeastStep from its neighbours at least; it doesn't pass them.
Document with_key_moved(Document document, int clip, int key, double time);

// ---------------------------------------------------------------- parts

// A joint's stitching sphere: radius ≥ 0 (units), and offset from the joint in rest space.
Document with_sphere(Document document, int joint, double radius, const Vec3& offset);

inline constexpr double kThinnest = 0.2, kFattest = 3;
// How far a part bulges between its rims, within kThinnest … kFattest.
Document with_fatness(Document document, int joint, double fatness);
double fatness_of(const Document& document, int joint);

// Whether both make the same model: all but names and clips is equal.
bool same_model(const Document& a, const Document& b);

}  // namespace artisketch
