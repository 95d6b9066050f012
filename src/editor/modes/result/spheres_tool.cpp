// Joints: the spheres that join the parts, sized by their rims and moved by their middles.
#include <algorithm>
#include <cmath>

#include "document/animate.h"
#include "editor/canvas/pointer.h"
#include "editor/session/app.h"
#include "editor/ui/icons.h"
#include "editor/ui/ui.h"

namespace artisketch {
namespace {

struct Sphere {
  int joint = 0;
  double radius = 0;                                  // units
  Vec3 offset = Vec3::Zero(), centre = Vec3::Zero();  // in rest space; in the world
};

// Where rest space stands in the pose, by joint; empty where there is no model.
std::vector<Transform> motions_of(const App& app, const ModelStage& stage) {
  const BuiltModel* shown = app.shown();
  return shown ? skinning_transforms(shown->model.skeleton, stage.pose) : std::vector<Transform>();
}

// As the document has them by now.
std::vector<Sphere> spheres_of(const App& app, const ModelStage& stage) {
  std::vector<Sphere> spheres;
  if (!app.session.built) return spheres;
  const std::vector<Transform> motions = motions_of(app, stage);
  const std::vector<Vec3> rest = rest_positions(app.session.built->model.skeleton);
  for (const JointSphere& made : app.session.built->spheres) {
    if (made.joint >= std::min(app.document().skeleton.size(), int(motions.size()))) continue;
    Sphere sphere{made.joint, made.radius, Vec3::Zero(), Vec3::Zero()};
    const auto own = app.document().spheres.find(made.joint);
    if (own != app.document().spheres.end()) {
      sphere.radius = own->second.radius.value_or(made.radius);
      sphere.offset = own->second.offset;
    }
    const std::size_t j = std::size_t(made.joint);
    sphere.centre = motions[j] * Vec3(rest[j] + sphere.offset) + stage.shift;
    spheres.push_back(sphere);
  }
  return spheres;
}

// In points.
float radius_on_screen(const ViewProjection& projection, const Sphere& sphere) {
  const Vec3 right = projection.turn.row(0).transpose();
  return float(sphere.radius) *
         apart(projection.project(sphere.centre), projection.project(sphere.centre + right));
}

class SpheresTool : public Tool {
 public:
  void pointer(App& app, const Pointer& p, const Stage& stage) override {
    const std::vector<Sphere> spheres = spheres_of(app, *stage.model);
    if (p.pressed) take_hold(app, p, stage.model->projection, spheres);
    if (!p.held) joint_ = -1;
    if (!p.dragging || !p.moved || !app.session.goes_on(gesture_)) return;
    for (const Sphere& sphere : spheres)
      if (sphere.joint == joint_) return drag(app, p, *stage.model, sphere);
  }

  void paint(const App& app, const Pointer&, const Stage& stage) const override {
    const ViewProjection& projection = stage.model->projection;
    for (const Sphere& sphere : spheres_of(app, *stage.model)) {
      const bool chosen = sphere.joint == app.session.selection.joint;
      const ImVec2 at = projection.project(sphere.centre);
      const float radius = radius_on_screen(projection, sphere);
      const std::string name = part_words(app, sphere.joint);
      record("Sphere " + name, {at.x - 4, at.y - 4, 8, 8}, true, chosen);
      record("Sphere rim " + name, {at.x + radius - 4, at.y - 4, 8, 8}, true, chosen);
      draw().AddCircleFilled(at, radius, joint_tint(sphere.joint, chosen ? 0.4f : 0.22f));
      draw().AddCircle(at, radius, rgb(0xFFFFFF, 0.9f), 0, chosen ? 3.0f : 2.0f);
      draw().AddCircle(at, radius, joint_tint(sphere.joint), 0, chosen ? 2.0f : 1.25f);
      draw().AddCircleFilled(at, 3, rgb(0xFFFFFF));
    }
  }

  std::string hint(const App&) const override {
    return "Drag a sphere's rim for its size, its middle to move it; then Reconstruct.";
  }
  void cancel(App&) override { joint_ = -1; }
  bool holds_pointer() const override { return joint_ >= 0; }
  bool shows_spheres() const override { return true; }

 private:
  void take_hold(App& app, const Pointer& p, const ViewProjection& projection,
                 const std::vector<Sphere>& spheres) {
    joint_ = -1;
    float nearest = 8;  // points
    for (const Sphere& sphere : spheres) {
      const float middle = apart(projection.project(sphere.centre), p.screen);
      const float rim = std::abs(middle - radius_on_screen(projection, sphere));
      if (std::min(rim, middle) >= nearest) continue;
      nearest = std::min(rim, middle);
      joint_ = app.session.selection.joint = sphere.joint;
      rim_ = rim < middle;
    }
    if (joint_ >= 0) gesture_ = app.session.begin_gesture();
  }

  void drag(App& app, const Pointer& p, const ModelStage& stage, const Sphere& sphere) const {
    const Vec3 target = under_pointer(stage.projection, p.screen, sphere.centre);
    double radius = sphere.radius;
    Vec3 by = Vec3::Zero();
    if (rim_)
      radius = (target - sphere.centre).norm();
    else
      by = motions_of(app, stage)[std::size_t(joint_)].linear().transpose() *
           (target - sphere.centre);
    app.session.change("Joint of " + part_words(app, joint_),
                       with_sphere(app.document(), joint_, radius, sphere.offset + by));
  }

  long gesture_ = 0;
  int joint_ = -1;    // whose sphere is dragged
  bool rim_ = false;  // by its rim
};

}  // namespace

ToolRow spheres_tool() {
  return {.id = "joints",
          .mode = Mode::result,
          .name = "Joints",
          .icon = icon::kVectorCircleVariant,
          .key = ImGuiKey_J,
          .make = make_tool<SpheresTool>,
          .about = "The spheres that join the parts: drag a rim or a middle"};
}

}  // namespace artisketch
