#!/usr/bin/env python3
"""Tracing, cutting, outlines, the skeleton and drawings on their way in, through the pointer."""
import json, math, pathlib, subprocess, time

from editor_window import Window, examples, pictures, run


def at(window, x, y):
    """A pixel of the drawing in view, as it stands in the window."""
    return window.ask(f"project {window.state()['frame']} {x} {y}")


def click(window, place):
    window.x("mousemove", *map(round, place))
    window.x("click", 1)


def undo_is(window, words):
    window.wait(lambda: window.state()["undo"] == words, why=f"'{words}' to undo")


def cell_says(window, label, words):
    """The words of a part in a drawing stand in the inspector once its mark is clicked."""
    window.click(label)
    window.wait(lambda: words in window.labels(), why=f"{words!r} at {label}")


def hand_of(path):
    """The points of the hand's outline in the first drawing of a document."""
    contours = json.loads(path.read_text())["frames"][0]["contours"]
    return next(c["points"] for c in contours if c["joint"] == "hand.R")


def save_as(window, name):
    saved = pathlib.Path(window.home, name)
    window.key("ctrl+shift+s")
    window.type_path(saved)
    window.wait(saved.exists, why="the file")
    return saved


def moves_adds_and_redraws_points():
    document = examples / "hero/hero.artisketch"
    window = Window("1440x900", document)
    before = hand_of(document)
    low = max(before, key=lambda p: p[1])
    point = at(window, *low)
    click(window, point)  # chooses the outline
    window.wait(lambda: "Redraw" in window.labels(), why="the outline's buttons")
    time.sleep(0.4)  # not a double click
    window.drag([point, [point[0] + 2, point[1] + 6], [point[0] + 4, point[1] + 12]])
    undo_is(window, "Move point")
    window.picture("point-moved")
    moved = hand_of(save_as(window, "moved.artisketch"))
    assert len(moved) == len(before)
    zoom = math.dist(at(window, 0, 0), at(window, 1, 0))
    assert abs(max(p[1] for p in moved) - low[1] - 12 / zoom) < 3, "it came to where it was let go"
    window.key("ctrl+z")

    # An edge bends where it is held: half-way along the longest, seen from near.
    window.x("click", "--repeat", 8, "--delay", 60, 4)
    ends = max(zip(before, before[1:]), key=lambda e: math.dist(*e))
    edge = at(window, *[(a + b) / 2 for a, b in zip(*ends)])
    window.drag([edge, [edge[0] + 4, edge[1] - 4], [edge[0] + 9, edge[1] - 9]])
    undo_is(window, "Move point")
    assert len(hand_of(save_as(window, "bent.artisketch"))) == len(before) + 1
    window.key("ctrl+z")
    window.wait(lambda: not window.state()["undo"], why="the first state")
    window.double_click(*edge, lambda: window.state()["undo"] == "Add point", "the added point")
    assert len(hand_of(save_as(window, "added.artisketch"))) == len(before) + 1
    window.key("ctrl+z")

    # A stroke from the outline to the outline takes the place of what runs between.
    window.click("Draw tool")
    left, right = (pick(before, key=lambda p: p[0]) for pick in (min, max))
    bulge = [(left[0] + right[0]) / 2, low[1] + 25]
    window.drag([at(window, *[(1 - t) ** 2 * a + 2 * t * (1 - t) * b + t * t * c
                              for a, b, c in zip(left, bulge, right)])
                 for t in (i / 24 for i in range(25))])
    undo_is(window, "Redraw Hand R")
    window.picture("redrawn")
    window.close()


def outlines_and_names_on_a_tablet():
    window = Window("820x1180", examples / "hero/hero.artisketch")
    window.click("Draw tool")
    x, y = at(window, 250, 330)
    window.drag([(x + 40 * math.cos(t / 5), y + 40 * math.sin(t / 5)) for t in range(32)])
    window.wait(lambda: "Keep" in window.labels(), why="the new outline")
    window.picture("tablet-new-outline")
    window.click("Keep")
    window.wait(lambda: window.state()["undo"].startswith("Draw "), why="the outline")
    window.wait(lambda: {"Redraw", "Other joint", "Join"} <= window.labels(), why="its buttons")
    window.picture("tablet-outline")
    window.key("ctrl+z")
    window.click("Skeleton mode")
    click(window, window.middle("Joint Hand L"))
    window.wait(lambda: "Joint name" in window.labels(), why="the joint's name")
    window.picture("tablet-skeleton")
    window.click("Joint name")
    window.key("ctrl+a")
    window.x("type", "--delay", "40", "paw")
    window.key("Return")
    undo_is(window, "Rename Hand L")
    window.close()


def settles_what_a_drawing_hides():
    window = Window("1440x900", examples / "hero/hero.artisketch")
    cell = "Hand R in 2"
    window.click(cell)
    window.key("Delete")
    undo_is(window, "Delete Hand R")
    cell_says(window, cell, "Missing in Side")
    window.picture("missing")
    window.click("Hidden here")
    undo_is(window, "Hide Hand R")
    cell_says(window, cell, "Hidden in Side")
    window.picture("hidden")
    window.key("ctrl+z")
    cell_says(window, cell, "Missing in Side")
    window.key("ctrl+shift+z")
    cell_says(window, cell, "Hidden in Side")
    saved = save_as(window, "hidden.artisketch")
    assert json.loads(saved.read_text())["frames"][1]["hidden"] == ["hand.R"]
    window.close()
    again = Window("1440x900", saved)
    cell_says(again, cell, "Hidden in Side")
    # The key takes it back.
    again.key("shift+h")
    undo_is(again, "Unhide Hand R")
    again.close()


def says_that_a_part_inside_others_shows_no_edge():
    window = Window("1440x900", examples / "hero/hero.artisketch")
    window.click("Forearm R in 2")
    words = "Inside other parts: no edge to compare"
    assert words not in window.labels(), "its edge shows in front of the body"
    for _ in range(8):
        window.key("bracketleft")
    cell_says(window, "Forearm R in 2", words)
    window.picture("inside")
    window.key("3")
    window.wait(lambda: "1 part lies inside others: no edge to compare." in window.labels(),
                why="the words")
    assert not any(w.startswith("Off Forearm R ") for w in window.labels())
    assert any(w.startswith("Off Forearm L ") for w in window.labels())
    window.picture("inside-pose")
    window.close()


def drawing(name="hero/front.png"):
    window = Window("1440x900", examples / name)
    window.wait(lambda: window.state()["frames"] == 1, why="the drawing")
    return window


def traces_and_cuts():
    window = drawing()
    window.key("t")
    click(window, at(window, 8, 8))
    window.wait(lambda: "paper" in window.state()["message"], why="what to do about paper")
    body = at(window, 285, 600)
    click(window, body)
    window.wait(lambda: "Tolerance" in window.labels(), why="the traced outline")
    window.picture("trace-part")
    window.key("Escape")
    window.wait(lambda: "Tolerance" not in window.labels(), why="Esc to let it go")
    # All the way to the right takes in the whole figure.
    window.drag([body, [body[0] + 90, body[1]], [body[0] + 260, body[1]]])
    window.wait(lambda: "Tolerance" in window.labels(), why="the whole figure")
    window.picture("trace-all")
    window.key("Tab")
    window.key("Return")
    window.wait(lambda: window.state()["undo"].startswith("Trace "), why="the outline")
    whole = window.state()["undo"].removeprefix("Trace ")
    window.key("k")
    window.drag([at(window, 250, 345), at(window, 330, 345), at(window, 410, 345)])
    undo_is(window, f"Cut {whole}")
    window.picture("cut")
    window.key("ctrl+z")
    undo_is(window, f"Trace {whole}")
    window.close()


def gives_outlines_to_parts():
    window = drawing()
    window.key("p")
    corners = [at(window, *p) for p in ((100, 100), (200, 100), (200, 200), (100, 200))]
    click(window, corners[0])
    click(window, corners[1])
    # A dragged point is round.
    window.drag([corners[2], [corners[2][0] - 20, corners[2][1] + 20],
                 [corners[2][0] - 30, corners[2][1] + 30]])
    click(window, corners[3])
    window.picture("points")
    click(window, corners[0])
    window.wait(lambda: "Redraw" in window.labels(), why="the new outline")
    assert any(label.startswith("Assign ") for label in window.labels())
    window.click("Other joint")
    window.click("Foot L")
    window.key("Return")
    undo_is(window, "Draw Foot L")
    window.click("Mirror tool")
    undo_is(window, "Mirror Foot L")
    window.key("bracketleft")
    undo_is(window, "Foot R behind")
    window.key("bracketright")
    undo_is(window, "Foot R in front")
    window.key("Delete")
    undo_is(window, "Delete Foot R")
    window.close()


def ring(window, low, high):
    """A square from corner to corner, made point by point; its part is the one proposed."""
    window.key("p")
    corners = [low, (high[0], low[1]), high, (low[0], high[1]), low]
    for corner in corners:
        click(window, at(window, *corner))
    window.wait(lambda: "Redraw" in window.labels(), why="the new outline")


def joins_copies_and_picks_joints():
    window = Window("1440x900", examples / "hero" / "hero.artisketch")
    window.wait(lambda: window.state()["frames"] == 3, why="the drawings")
    window.key("3")
    window.wait(lambda: "Joint Foot L" in window.labels(), why="the joints")
    foot = window.middle("Joint Foot L")  # there in every mode
    window.key("1")
    ring(window, (60, 60), (140, 140))
    window.click("Other joint")
    click(window, foot)
    window.key("Return")
    undo_is(window, "Draw Foot L")
    ring(window, (120, 80), (200, 160))
    window.click("Other joint")
    window.click("Foot L")
    window.key("Return")
    undo_is(window, "Draw Foot L")
    window.key("v")
    click(window, at(window, 180, 120))
    window.click("Join")
    click(window, at(window, 80, 100))
    undo_is(window, "Join Foot L")
    window.x("mousemove", *map(round, at(window, 60, 60)))
    window.key("Delete")
    undo_is(window, "Delete point")
    window.picture("joined")
    window.click("Copy to tool")
    window.wait(lambda: "Copy to Side" in window.labels(), why="the drawings to choose from")
    window.click("Copy to Side")
    window.wait(lambda: "Keep both" in window.labels(), why="the question")
    window.picture("copy-question")
    window.click("Keep both")
    undo_is(window, "Copy Foot L")
    assert window.state()["frame"] != 0
    window.close()


def offers_what_can_be_done_to_an_outline_or_joint():
    window = Window("1440x900", examples / "hero" / "hero.artisketch")
    window.wait(lambda: window.state()["frames"] == 3, why="the drawings")
    window.key("1")
    window.wait(lambda: "Edit tool" in window.labels(), why="Outline")
    nose = at(window, 320, 260)  # within the head alone
    window.x("mousemove", *map(round, nose))
    window.x("click", 3)
    window.wait(lambda: "Delete" in window.labels(), why="the menu")
    assert "Copy to" in window.labels() and "Mirror" not in window.labels()  # the head has no other side
    window.picture("outline-menu")
    window.click("Delete")
    undo_is(window, "Delete Head")
    window.wait(lambda: "Delete" not in window.labels(), why="the menu's end")
    window.key("3")
    window.wait(lambda: "Joint Hand L" in window.labels(), why="the joints")
    window.point_at("Joint Hand L")
    window.x("click", 3)
    window.wait(lambda: "Lock" in window.labels(), why="the joint's menu")
    window.click("Lock")
    undo_is(window, "Lock Hand L")
    window.close()


def mends_a_crossing():
    window = drawing()
    window.key("p")
    for p in ((80, 80), (220, 220), (220, 80), (80, 220), (80, 80)):
        click(window, at(window, *p))
    window.wait(lambda: "Mend new" in window.labels(), why="the ring")
    window.picture("crosses-itself")
    window.click("Mend new")
    window.wait(lambda: "Mend new" not in window.labels(), why="the outline mended")
    window.key("Return")
    window.wait(lambda: window.state()["undo"].startswith("Draw "), why="the outline")
    assert not any(label.startswith("Mend ") for label in window.labels())
    window.close()


def builds_a_skeleton():
    window = drawing("fox/side.png")
    window.key("2")
    window.wait(lambda: window.state()["mode"] == "skeleton", why="the mode")
    window.click("Template Quadruped")
    undo_is(window, "Quadruped skeleton")
    window.picture("quadruped")
    window.click("Template Blank")
    window.wait(lambda: window.state()["joints"] == ["root"], why="one joint")
    root = window.middle("Joint Root")
    window.drag([root, [root[0] + 5, root[1] + 5], [root[0] + 20, root[1]]])
    undo_is(window, "Move body")
    root = window.middle("Joint Root")
    click(window, [root[0] + 140, root[1] - 60])
    undo_is(window, "Add joint")
    assert window.state()["joints"] == ["root", "joint.L", "joint.R"], window.state()["joints"]
    window.key("F2")
    for letter in "wing":
        window.key(letter)
    window.key("Return")
    window.wait(lambda: window.state()["joints"][1:] == ["wing.L", "wing.R"], why="the name")
    window.picture("skeleton")
    window.key("x")
    click(window, [root[0] + 200, root[1] - 120])
    window.wait(lambda: len(window.state()["joints"]) == 4, why="a joint on one side")
    window.key("Delete")
    window.wait(lambda: len(window.state()["joints"]) == 3, why="one joint less")
    window.key("l")
    window.wait(lambda: window.state()["undo"].startswith("Equalise "), why="equal lengths")
    window.close()


def takes_drawings_in():
    pictures.mkdir(parents=True, exist_ok=True)
    gif, sheet = pictures / "two.gif", pictures / "sheet.png"
    subprocess.run(["convert", "-size", "60x80", "xc:red", "xc:blue", str(gif)], check=True)
    front = str(examples / "hero/front.png")
    subprocess.run(["convert", front, front, front, "+append", "-resize", "50%", str(sheet)],
                   check=True)
    window = Window("1440x900", gif)
    window.wait(lambda: window.state()["frames"] == 2, why="the GIF's frames")
    window.close()

    window = Window("1440x900", sheet)
    window.wait(lambda: "Cut it up" in window.labels(), why="the question")
    window.picture("sheet")
    window.click("Cut it up")
    window.wait(lambda: window.state()["frames"] == 3, why="three drawings")
    undo_is(window, "Add 3 drawings")
    first, last = window.middle("Drawing card 1"), window.middle("Drawing card 3")
    window.drag([first, [first[0] + 60, first[1]], [last[0] - 40, last[1]], last])
    undo_is(window, "Move drawing")
    assert window.state()["frame"] == 2
    window.x("mousemove", *map(round, first))
    window.x("click", 3)
    window.wait(lambda: "Duplicate drawing" in window.labels(), why="the menu")
    window.click("Duplicate drawing")
    window.wait(lambda: window.state()["frames"] == 4, why="the copy")
    window.click("Orthographic")
    undo_is(window, "Perspective camera")
    window.picture("drawings")
    window.close()


def lightness(picture, place):
    """How light a picture is at a place, 0 to 99."""
    x, y = map(int, place)
    words = ["convert", picture, "-crop", f"1x1+{x}+{y}", "-format", "%[fx:round(99*mean)]", "info:"]
    return int(subprocess.run(words, check=True, capture_output=True, text=True).stdout)


def shows_pixels_as_squares():
    """Near a pixel's border a picture seen large has the colour of its middle, not a blend of two."""
    chequers = pictures / "chequers.png"
    pictures.mkdir(parents=True, exist_ok=True)
    subprocess.run(["convert", "-size", "16x16", "pattern:gray50", str(chequers)], check=True)
    window = Window("1440x900", chequers)
    window.wait(lambda: window.state()["frames"] == 1, why="the drawing")
    time.sleep(0.5)
    window.picture("squares")
    picture = pictures / "squares.png"
    inside = {lightness(picture, at(window, 3 + i / 10, 12.5)) for i in range(1, 10)}
    beside = {lightness(picture, at(window, 4 + i / 10, 12.5)) for i in range(1, 10)}
    assert len(inside) == 1 and len(beside) == 1, f"{inside} and {beside} are blends"
    assert inside != beside, "no chequers"
    window.close()


run(moves_adds_and_redraws_points, traces_and_cuts, gives_outlines_to_parts, joins_copies_and_picks_joints,
    offers_what_can_be_done_to_an_outline_or_joint, mends_a_crossing,
    builds_a_skeleton, takes_drawings_in, outlines_and_names_on_a_tablet, settles_what_a_drawing_hides,
    says_that_a_part_inside_others_shows_no_edge, shows_pixels_as_squares)
