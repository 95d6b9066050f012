#!/usr/bin/env python3
"""Posing, fit marks and the result, through the pointer."""
import math, time

from editor_window import Window, examples, run


def in_pose(frame=1, size="1440x900"):
    """The hero's second drawing in Pose."""
    window = Window(size, examples / "hero/hero.artisketch")
    window.key("3")
    window.wait(lambda: window.state()["mode"] == "pose", why="the mode")
    for _ in range(frame):
        window.key("period")
    window.wait(lambda: window.state()["frame"] == frame, why="the drawing")
    return window


def joint(window, name):
    """Where a joint of the drawing stands in the window."""
    return window.middle("Joint " + name)


def near(a, b, points):
    return math.dist(a, b) <= points


def drags_a_limb():
    window = in_pose()
    window.picture("pose")
    hand, elbow = joint(window, "Hand L"), joint(window, "Forearm L")
    to = [hand[0] - 30, hand[1] - 40]
    window.drag([hand, [hand[0] - 10, hand[1] - 15], to])
    window.wait(lambda: near(joint(window, "Hand L"), to, 6), why="the hand under the pointer")
    assert not near(joint(window, "Forearm L"), elbow, 1), "the elbow did not follow"
    assert window.state()["undo"] == "Bend Upper arm L", window.state()["undo"]
    window.picture("pose-drag")
    window.key("ctrl+z")
    window.wait(lambda: near(joint(window, "Hand L"), hand, 0.5), why="undo in one step")
    window.close()


def turns_twists_flips_and_locks():
    window = in_pose()
    hand, head = joint(window, "Hand R"), joint(window, "Head")
    x, y = window.middle("Turn the body")
    window.drag([[x, y], [x + 8, y], [x + 25, y]])
    window.wait(lambda: not near(joint(window, "Hand R"), hand, 2), why="the turned body")
    assert abs(joint(window, "Head")[1] - head[1]) < 6, "it turned about the upright"
    assert window.state()["undo"] == "Turn body"
    elbow = joint(window, "Forearm L")
    window.x("mousemove", *map(round, elbow))
    window.x("click", 1)
    hand = joint(window, "Hand L")
    window.key("f")
    window.wait(lambda: window.state()["undo"] == "Flip Forearm L", why="the flip")
    assert near(joint(window, "Hand L"), hand, 6), "a flip shows much the same"
    window.x("click", 4)
    window.wait(lambda: window.state()["undo"] == "Twist Forearm L", why="the twist")
    window.key("l")
    window.wait(lambda: window.state()["undo"] == "Lock Forearm L", why="the lock")
    window.picture("pose-locked")
    window.close()


def changes_depth_from_the_side_and_copies():
    window = in_pose()
    side = window.control("From the side")
    hand = joint(window, "Hand L")
    at = window.middle("Hand L from the side")
    assert side["x"] < at[0] < side["x"] + side["width"]
    window.drag([at, [at[0] - 5, at[1]], [at[0] - 14, at[1]]])
    window.wait(lambda: window.state()["undo"] == "Depth of Hand L", why="the depth")
    assert near(joint(window, "Hand L"), hand, 3), "it stays where it is seen"
    window.key("c")
    window.wait(lambda: any(w["label"] == "Pose of Front" for w in window.widgets()), why="the list")
    window.picture("pose-copy")
    window.click("Pose of Front")
    window.wait(lambda: window.state()["undo"] == "Copy pose of Front", why="the copied pose")
    window.close()


def suggests_and_asks_which_way():
    window = in_pose()
    window.click("Reset tool")
    window.wait(lambda: window.state()["undo"] == "Reset pose", why="the rest pose")
    window.picture("suggest-before")
    hand = joint(window, "Hand R")
    window.key("s")
    window.wait(lambda: window.state()["undo"] == "Suggest pose", why="the suggestion")
    assert not near(joint(window, "Hand R"), hand, 20), "the hand stayed"
    if any(w["label"] == "Keep" for w in window.widgets()):
        window.picture("suggest-rivals")
        window.click("Keep")
    way = window.control("Toward you")
    window.picture("suggest")
    window.click("Away" if way["active"] else "Toward you")
    window.wait(lambda: window.state()["undo"].startswith("Bend "), why="the other way")
    window.picture("suggest-other-way")
    window.key("Escape")
    window.wait(lambda: not any(w["label"] == "Away" for w in window.widgets()), why="Esc")
    window.close()


def calibrates_on_a_tablet():
    window = in_pose(size="820x1180")
    model, side = window.control("Turn the model"), window.control("From the side")
    ball = window.control("Turn the body")
    for name in ("Head", "Hand L", "Hand R", "Foot L", "Foot R"):
        x, y = joint(window, name)
        for over in (model, side, ball):
            assert not (over["x"] < x < over["x"] + over["width"]
                        and over["y"] < y < over["y"] + over["height"]), f"{name} is covered"
    window.click("Calibrate")
    window.wait(lambda: any(w["label"] == "Keep calibrated" for w in window.widgets()),
                "the proposal")
    time.sleep(1)
    window.picture("tablet-calibrated")
    window.click("Mine")
    window.click("Keep calibrated")
    window.wait(lambda: window.state()["undo"] == "Keep calibrated", why="the kept pose")
    window.close()


def shows_the_parts_and_where_they_miss():
    window = Window("1440x900", examples / "hero/hero.artisketch")
    window.wait(lambda: window.state()["liveParts"] == 15, why="the parts without a word")
    assert not window.state()["busy"] and not window.state()["hasModel"]
    window.picture("live-outline")
    window.key("3")
    window.key("period")
    tag = window.wait(lambda: [w["label"] for w in window.widgets() if w["label"].startswith("Tag ")],
                      why="a part that is off")[0]
    assert tag.endswith(" px off"), tag
    window.picture("fit-marks")
    hand = joint(window, "Hand R")
    before = [w["label"] for w in window.widgets() if w["label"].startswith("Off ")]
    window.drag([hand, [hand[0] + 20, hand[1]], [hand[0] + 60, hand[1] + 60]])
    window.wait(lambda: [w["label"] for w in window.widgets() if w["label"].startswith("Off ")]
                != before, why="new distances")
    window.picture("fit-marks-drag")
    window.close()


def compares_a_model_at_the_poses_it_was_made_at():
    window = in_pose()
    window.wait(lambda: [w for w in window.widgets() if w["label"].startswith("Tag ")],
                why="a part that is off in the pose as drawn")
    mine = joint(window, "Hand R")
    window.click("Reconstruct")
    window.wait(lambda: window.state()["hasModel"] and not window.state()["busy"], "the model")
    window.wait(lambda: window.state()["liveRevision"] == window.state()["revision"], "parts")

    def distances():
        return [int(w["label"].split()[-2]) for w in window.widgets()
                if w["label"].startswith("Off ") and w["label"].endswith(" px")]
    window.wait(lambda: distances() and max(distances()) <= 3, why="a model that fits")
    assert not [w for w in window.widgets() if w["label"].startswith("Tag ")]
    assert near(joint(window, "Hand R"), mine, 0.5), "the person's pose stays"
    window.picture("fit-of-model")
    # A pose that is changed is compared itself.
    window.drag([mine, [mine[0] + 20, mine[1]], [mine[0] + 60, mine[1] + 60]])
    window.wait(lambda: [w for w in window.widgets() if w["label"].startswith("Tag ")],
                why="the moved part's distance")
    window.key("ctrl+z")
    window.wait(lambda: distances() and max(distances()) <= 3, why="undo")
    window.close()


def in_result(name="heart"):
    window = Window("1440x900", examples / f"{name}/{name}.artisketch")
    window.click("Reconstruct")
    window.wait(lambda: window.state()["hasModel"], "the model")
    window.key("4")
    window.wait(lambda: window.state()["mode"] == "result", why="the mode")
    return window


def sets_keys_and_moves_them():
    window = in_result("hero")
    hand = window.middle("Pose Hand L")
    window.drag([hand, [hand[0] + 10, hand[1] - 10], [hand[0] + 20, hand[1] - 60]])
    window.picture("result-posed")
    window.key("i")
    window.wait(lambda: window.state()["undo"] == "New clip", why="a clip of one's own")
    scale = window.control("Playhead")
    window.x("mousemove", round(scale["x"] + scale["width"] * 0.4), round(scale["y"] + 6))
    window.x("click", 1)
    hand = window.middle("Pose Hand R")
    window.drag([hand, [hand[0] - 10, hand[1] - 10], [hand[0] - 20, hand[1] - 60]])
    window.key("i")
    window.wait(lambda: window.state()["undo"] == "Set key of clip 1", why="the key")
    window.picture("result-keys")
    x, y = window.middle("Key 2 of clip 1")
    window.drag([[x, y], [x - 20, y], [x - 80, y]])
    window.wait(lambda: window.state()["undo"] == "Move key of clip 1", why="the moved key")
    window.wait(lambda: window.middle("Key 2 of clip 1")[0] < x - 20, "its new time")
    window.key("Delete")
    window.wait(lambda: window.state()["undo"] == "Delete key of clip 1", why="the deleted key")
    assert not any(w["label"] == "Key 2 of clip 1" for w in window.widgets())
    window.key("ctrl+z")
    window.wait(lambda: any(w["label"] == "Key 2 of clip 1" for w in window.widgets()), why="undo")
    window.key("ctrl+e")
    window.wait(lambda: any(w["label"] == "clip 1" for w in window.widgets()), why="the sheet")
    window.picture("result-export")
    window.key("Escape")
    window.point_at("Clip clip 1")
    window.x("click", 3)
    window.click("Remove clip")
    window.wait(lambda: window.state()["undo"] == "Remove clip 1", why="the clip to go")
    assert not any(w["label"] == "Clip clip 1" for w in window.widgets())
    window.key("ctrl+z")
    window.wait(lambda: any(w["label"] == "Clip clip 1" for w in window.widgets()), why="undo")
    window.close()


def shapes_joints_and_fatness():
    window = in_result("hero")
    window.key("j")
    window.wait(lambda: any(w["label"] == "Sphere Head" for w in window.widgets()), why="spheres")
    window.picture("result-joints")
    x, y = window.middle("Sphere rim Forearm L")
    window.drag([[x, y], [x + 4, y], [x + 14, y]])
    window.wait(lambda: window.state()["undo"] == "Joint of Forearm L", why="the sphere")
    window.wait(lambda: window.middle("Sphere rim Forearm L")[0] > x + 5, "the larger sphere")
    window.key("w")
    window.wait(lambda: any(w["label"] == "Fatness of Head" for w in window.widgets()),
                why="the parts")
    x, y = window.middle("Fatness of Hips")
    window.drag([[x, y], [x + 20, y], [x + 100, y]])
    window.wait(lambda: window.state()["undo"] == "Fatness of Hips", why="the fatness")
    window.wait(lambda: window.state()["liveParts"] == 15, why="the parts")
    window.picture("result-fatness")
    window.close()


def shows_the_joints_of_an_example():
    window = Window("1440x900")
    window.wait(lambda: window.state()["hasModel"], "the example's model")
    window.click("Result mode")
    window.wait(lambda: window.state()["mode"] == "result", why="the mode")
    window.key("j")
    window.wait(lambda: any(w["label"] == "Sphere Head" for w in window.widgets()), "spheres")
    assert not window.state()["busy"] and not window.state()["canUndo"]
    window.picture("example-joints")
    window.close()


def calibrates_compares_and_keeps():
    window = in_pose()
    before = joint(window, "Hand R")
    window.key("shift+c")
    window.wait(lambda: any(w["label"] == "Keep calibrated" for w in window.widgets()),
                "the proposal")
    window.wait(lambda: not near(joint(window, "Hand R"), before, 1), why="the calibrated pose")
    window.wait(lambda: "Measuring" not in str(window.widgets()) and not window.state()["busy"])
    time.sleep(1)
    window.picture("calibrated")
    window.x("keydown", "p")
    window.wait(lambda: near(joint(window, "Hand R"), before, 0.5), why="one's own pose")
    window.x("keyup", "p")
    window.wait(lambda: not near(joint(window, "Hand R"), before, 1), why="the calibrated one")
    window.click("Take Hand R")
    window.click("Keep calibrated")
    window.wait(lambda: window.state()["undo"] == "Keep calibrated", why="the kept pose")
    window.picture("calibrated-kept")
    window.close()


run(drags_a_limb, turns_twists_flips_and_locks, changes_depth_from_the_side_and_copies,
    suggests_and_asks_which_way, calibrates_compares_and_keeps, calibrates_on_a_tablet,
    shows_the_parts_and_where_they_miss, compares_a_model_at_the_poses_it_was_made_at,
    sets_keys_and_moves_them, shapes_joints_and_fatness, shows_the_joints_of_an_example)
