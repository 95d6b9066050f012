// The sketch document as the user made it. FORMAT.md is the contract; the file itself is read and
// written by files/document_file. Angles are radians here and degrees in the file.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "document/camera.h"
#include "document/contour.h"
#include "document/skeleton.h"

namespace artisketch {

// Every struct keeps, in `unknown`, the fields of its JSON object that this version doesn't know
// (a JSON object as text, empty where there are none), so that writing loses nothing.

struct Contour {
  int joint = 0;
  Polyline line;
  std::string unknown;
};

struct Frame {
  std::string name;
  int width = 0, height = 0;            // pixels of the sketch
  std::string image;                    // path relative to the document or data: URI; empty: none
  std::optional<Vec2> principal_point;  // pixels; absent: the image's centre
  double scale = 1;                     // orthographic cameras: times pixels_per_unit
  Pose pose;                            // the user's estimate
  bool posed = true;                    // false: added, and nobody has given it a pose yet
  std::vector<int> set_joints;          // joints that a person has turned: no guess may
  std::vector<Contour> contours;
  std::vector<int> hidden;  // joints whose part the drawing doesn't show (is_hidden)
  std::string unknown;
};

struct CalibrationLimits {
  std::optional<double> max_rotation;     // radians from the user's rotation, per joint
  std::optional<double> max_translation;  // units from the user's root position, per frame
  std::vector<int> locked;                // joints that keep the user's rotation
  bool free_first_frame = false;
  bool scale = false;  // find each frame's scale (orthographic)
  std::string unknown;
};

struct SphereTweak {
  std::optional<double> radius;  // units
  Vec3 offset = Vec3::Zero();    // from the joint, rest space, units
  std::string unknown;
};

// Whose a part is.
enum class Role {
  body,
  held,   // a thing before the body, of one piece: its pixels paint nothing else
  apart,  // no part of the character: makes no surface, and its pixels paint nothing
};
inline constexpr const char* kRoleNames[] = {"body", "held", "apart"};  // by Role

struct PartSettings {
  double fatness = 1;
  Role role = Role::body;
  std::string unknown;
};

struct Key {
  double time = 0;  // seconds
  Pose pose;
  std::string unknown;
};

struct Animation {
  std::string name;
  std::vector<Key> keys;  // times strictly increase
  std::string unknown;
};

// Which joint a recorded motion's joint moves, where their names differ.
struct MotionMap {
  std::vector<std::pair<std::string, int>>
      joints;  // the motion's name ("": nobody), the document's joint
  std::string unknown;
};

// What the command line's flags default to for this document.
struct DocumentSettings {
  std::optional<int> grid;
  std::optional<std::string> method;
  std::optional<bool> mirror;
  std::optional<int> triangles;
  std::optional<bool> texture;
  std::string unknown;
};

struct Document {
  std::string name;
  Camera camera;
  std::string camera_unknown;
  Skeleton skeleton;
  std::string skeleton_unknown;
  std::vector<Frame> frames;
  CalibrationLimits calibration;
  std::map<int, SphereTweak> spheres;  // by joint
  std::map<int, PartSettings> parts;   // by joint
  std::vector<Animation> animations;
  MotionMap motion;
  DocumentSettings settings;
  std::string unknown;
};

// The camera of one frame, principal point and scale resolved.
FrameCamera frame_camera(const Document& document, int frame);

// Units that a pixel takes at the root's depth, the least over the frames.
double pixel_size(const Document& document);

// The lines that outline a joint's part in a frame, in the order drawn.
std::vector<Polyline> contours_of(const Frame& frame, int joint);

// The closed ones of them, which bound its part by the even-odd rule, as polygons.
std::vector<std::vector<Vec2>> closed_contours(const Frame& frame, int joint);

// Whether the drawing doesn't show the joint's part, as the artist says: where it has an outline
// all the same, that counts.
bool is_hidden(const Frame& frame, int joint);

// Whether the frame's pose is somebody's word. The first frame's is: it is what others are told
// from.
bool is_posed(const Document& document, int frame);

Role role_of(const Document& document, int joint);

// The document as it tells of the figure's shape: without the contours of what is no part of the
// character, and of frames that nobody has posed yet, which would carve the parts from wrong sides
// (with these where no other has any). Of a part that has open contours alone, those that go round
// an area are closed, end to end; without any, it has none.
Document with_shaping_contours(Document document);

// Joints that carry a contour in at least one frame, ascending.
std::vector<int> drawn_joints(const Document& document);

}  // namespace artisketch
