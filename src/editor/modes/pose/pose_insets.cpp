#include "editor/modes/pose/pose_insets.h"

#include <cmath>
#include <utility>

#include "document/edit.h"
#include "document/posing.h"
#include "editor/canvas/controls.h"
#include "editor/canvas/pointer.h"
#include "editor/modes/pose/pose_edits.h"
#include "editor/modes/pose/pose_suggest.h"
#include "editor/ui/menu.h"

namespace artisketch {
namespace {

constexpr float kMargin = 12, kBall = 46, kBallGround = 60, kSide = 188, kSideHead = 28;

// Three great circles in the body's own axes; their far halves are faint.
void paint_ball(ImVec2 centre, const Mat3& turn, bool active) {
  const ImDrawListFlags flags = draw().Flags;
  draw().AddCircleFilled(centre, kBallGround, rgb(0x1F2227, 0.92f), 48);
  draw().AddCircle(centre, kBall, rgb(0xFFFFFF, active ? 0.9f : 0.55f), 48, 1.5f);
  constexpr unsigned kAxis[] = {0xE05A6A, 0x67B552, 0x4A90E2};
  constexpr int kSteps = 48;
  for (const bool front : {false, true})
    for (int axis = 0; axis < 3; ++axis)
      for (int i = 0; i < kSteps; ++i) {
        const auto at = [&](int step) {
          const double a = 2 * kPi * step / kSteps;
          Vec3 p = Vec3::Zero();
          p[(axis + 1) % 3] = std::cos(a);
          p[(axis + 2) % 3] = std::sin(a);
          return Vec3(turn * p);
        };
        const Vec3 a = at(i), b = at(i + 1);
        if ((a.z() + b.z() > 0) != front) continue;
        const auto place = [&](const Vec3& p) {
          return ImVec2{centre.x + kBall * float(p.x()), centre.y - kBall * float(p.y())};
        };
        draw().AddLine(place(a), place(b), rgb(kAxis[axis], front ? 1 : 0.35f), front ? 2 : 1.25f);
      }
  draw().Flags = flags;
}

// In the other lower corner; where tools float that far down, beside them.
Rect ball_place(const Layout& layout, const Rect& rail) {
  const Rect& canvas = layout.canvas;
  Rect place{canvas.x + kMargin, canvas.bottom() - kMargin - 2 * kBallGround, 2 * kBallGround,
             2 * kBallGround};
  if (layout.tablet && rail.bottom() > place.y) place.x = rail.right() + kMargin;
  return place;
}

// In the lower corner, or above the model where that stands there: smaller if need be.
Rect side_place(const Layout& layout) {
  const Rect& canvas = layout.canvas;
  if (!layout.inset)
    return {canvas.right() - kMargin - kSide, canvas.bottom() - kMargin - kSide - kSideHead, kSide,
            kSide + kSideHead};
  const float top = canvas.y + (layout.tablet ? 68 : kMargin);
  const float free = layout.view.y - kMargin - top - kSideHead;
  const float side = std::clamp(free, 96.0f, std::min(kSide, 0.4f * canvas.w));
  return {canvas.right() - kMargin - side, top, side, side + kSideHead};
}

void turning_ball(App& app, const Rect& place) {
  const Press press = press_area("Turn the body", place);
  if (ImGui::IsItemActivated()) app.session.begin_gesture();
  const ImGuiIO& io = ImGui::GetIO();
  const ImVec2 centre = place.centre();
  if (item_dragged() && pointer_moved()) {
    const Vec2 to(io.MousePos.x - centre.x, io.MousePos.y - centre.y);
    turn_body(app, ball_turn(to - Vec2(io.MouseDelta.x, io.MouseDelta.y), to, kBall));
  }
  const std::vector<Transform> posed = posed_joints(app.document().skeleton, app.drawn_pose());
  paint_ball(centre, posed[0].rotation(), press.held || press.hovered);
  if (press.hovered && !press.held) tooltip("Drag to turn the whole body", "");
}

// From the viewer's right, without perspective: what is nearer to the viewer stands farther left.
ViewProjection side_projection(const Skeleton& skeleton, const Vec3& root, const Rect& place) {
  const std::vector<Vec3> rest = rest_positions(skeleton);
  Box3 box;
  for (const Vec3& joint : rest) box.extend(joint);
  const double reach = std::max({1e-6, box.sizes().y() / 2, box.sizes().z() / 2});
  const Vec3 middle = root + Vec3(0, box.center().y() - rest[0].y(), 0);
  ViewProjection projection;
  projection.place = place;
  projection.turn << 0, 0, -1, 0, 1, 0, 1, 0, 0;
  const double scale = 0.72 / reach;
  projection.clip.setIdentity();
  const Vec3 shifted = projection.turn * middle;
  projection.clip.topLeftCorner<3, 3>() = scale * projection.turn;
  projection.clip.topRightCorner<3, 1>() = -scale * shifted;
  projection.clip.row(2) *= -0.02;  // nearer is smaller, and nothing is cut off
  return projection;
}

void side_view(App& app, const Rect& place, float pixel_ratio) {
  const Theme& t = theme();
  const Skeleton& skeleton = app.document().skeleton;
  shadow(place, kRadiusPanel);
  draw().AddRectFilled(place.min(), place.max(), rgb(0x1F2227, 0.96f), kRadiusPanel);
  draw().AddRect(place.min(), place.max(), rgb(0x343940), kRadiusPanel);
  Rect body = place;
  Rect head = body.cut_top(kSideHead).inset(12, 0);
  write(head, Font::caption_bold, rgb(0xE8EAED), "From the side");
  const std::string use = "drag: depth";
  if (head.w > text_width(Font::caption_bold, "From the side") + 8 + text_width(Font::caption, use))
    write(head, Font::caption, rgb(0xA3A9B2), use, Align::right);
  body = body.inset(4, 2);
  const Pose pose = app.drawn_pose();
  const ViewProjection projection = side_projection(skeleton, pose.root_position, body);
  if (const BuiltModel* shown = app.shown();
      shown && shown->model.skeleton.size() == skeleton.size()) {
    shown->picture->pose(pose, Vec3::Zero());
    PaintOptions options;
    options.surface = Surface::shaded;
    options.rough = app.services.hurried;
    show_model(*shown, projection, options, app.services.model_beside, 0.34f, pixel_ratio,
               kRadiusPanel);
  }
  std::vector<ImVec2> at;
  const std::vector<Transform> posed = posed_joints(skeleton, pose);
  for (const Transform& joint : posed) at.push_back(projection.project(joint.translation()));

  press_area("From the side", body);
  const ImGuiIO& io = ImGui::GetIO();
  if (ImGui::IsItemActivated()) {
    app.session.side_drag = {app.session.begin_gesture(), -1};
    float nearest = 12;
    for (int j = 0; j < int(at.size()); ++j)
      if (const float distance = apart(at[std::size_t(j)], io.MousePos); distance < nearest) {
        nearest = distance;
        app.session.side_drag.joint = app.session.selection.joint = j;
      }
  }
  const auto [gesture, joint] = app.session.side_drag;
  if (joint >= 0 && joint < skeleton.size() && app.session.goes_on(gesture) && item_dragged() &&
      pointer_moved()) {
    app.session.proposal.reset();
    const double per_unit = std::abs(projection.clip(0, 2)) * place.w / 2;
    const double z = pose.root_position.z() - (io.MousePos.x - body.centre().x) / per_unit;
    const FrameCamera camera = frame_camera(app.document(), app.session.selection.frame);
    app.session.change("Depth of " + part_words(app, joint),
                       with_pose(app.document(), app.session.selection.frame,
                                 with_joint_depth(skeleton, app.frame().pose, camera, joint, z)));
  }
  draw().PushClipRect(body.min(), body.max(), true);
  for (int j = 1; j < skeleton.size(); ++j)
    draw().AddLine(at[std::size_t(skeleton.joints[std::size_t(j)].parent)], at[std::size_t(j)],
                   rgb(0xFFFFFF, 0.9f), 1.5f);
  for (int j = 0; j < skeleton.size(); ++j) {
    const bool chosen = j == app.session.selection.joint;
    const ImVec2 p = at[std::size_t(j)];
    record(part_words(app, j) + " from the side", {p.x - 6, p.y - 6, 12, 12}, true, chosen);
    if (chosen) draw().AddCircle(p, 9, t.accent, 0, 2);
    draw().AddCircleFilled(p, chosen ? 5.5f : 3, rgb(0xFFFFFF));
    if (chosen) draw().AddCircleFilled(p, 4, joint_tint(j));
  }
  draw().PopClipRect();
}

// The drawings whose pose this one can take.
void poses_to_copy(App& app, const Rect& canvas) {
  ImGui::SetNextWindowPos({canvas.x + kMargin, canvas.y + kMargin}, ImGuiCond_Appearing);
  Menu menu("poses to copy", std::exchange(app.view.choosing_pose, false));
  for (int f = 0; menu && f < int(app.document().frames.size()); ++f) {
    if (f == app.session.selection.frame) continue;
    const std::string name = drawing_words(app.document(), f);
    if (menu.line("Pose of " + name))
      app.session.commit("Copy pose of " + name,
                         with_pose_copied(app.document(), f, app.session.selection.frame));
  }
}

}  // namespace

std::vector<Rect> pose_inset_places(const Layout& layout, const Rect& rail) {
  return {ball_place(layout, rail), side_place(layout)};
}

void pose_insets(App& app, const Layout& layout, const Rect& rail, float pixel_ratio) {
  const Rect& canvas = layout.canvas;
  poses_to_copy(app, canvas);
  if (app.document().skeleton.size() == 0 || !app.view.layer().bones) return;
  const Rect ball = ball_place(layout, rail);
  turning_ball(app, ball);
  // Above the ball; on tablets the tools float there, and it stands beside.
  ImVec2 corner{ball.x, canvas.bottom() - kMargin};
  (layout.tablet ? corner.x : corner.y) += (layout.tablet ? 1 : -1) * (ball.w + kMargin);
  pose_chooser(app, corner);
  side_view(app, side_place(layout), pixel_ratio);
}

}  // namespace artisketch
