#!/usr/bin/env python3
"""What stands where, and how the pointer moves it."""
from editor_window import Window, examples, run


def place(window, label):
    w = window.control(label)
    return [w["x"], w["y"], w["width"], w["height"]]


def is_large(window):
    width, height = place(window, "Turn the model")[2:]
    return width > 700 and height > 500


def panels_are_as_wide_as_they_are_dragged():
    window = Window("1440x900", examples / "hero/hero.artisketch")
    for edge, way, axis in [("Model edge", [-120, 0], 0), ("Inspector edge", [-60, 0], 0),
                            ("Strip edge", [0, -50], 1)]:
        x, y = window.middle(edge)
        window.drag([[x, y], [x + way[0] / 2, y + way[1] / 2], [x + way[0], y + way[1]]])
        moved = window.middle(edge)
        assert abs(moved[axis] - [x, y][axis] - way[axis]) < 8, (edge, [x, y], moved)
    window.picture("split")
    # As far as it goes, both sides stay usable.
    x, y = window.middle("Model edge")
    window.drag([[x, y], [600, y], [10, y]])
    assert place(window, "Model edge")[0] > 240
    x, y = window.middle("Model edge")
    window.double_click(
        x, y, lambda: abs(place(window, "Inspector edge")[0] - place(window, "Model edge")[0] - 396) < 2,
        "the usual width")
    window.close()


def on_tablets_model_and_drawing_change_places():
    window = Window("820x1180", examples / "hero/hero.artisketch")
    window.click("Result mode")
    window.click("Enlarge the model")
    window.wait(lambda: is_large(window), why="the large model")
    window.picture("tablet-swapped")
    window.click("Enlarge the drawing")
    window.wait(lambda: not is_large(window), why="the small model")
    # A drag there turns the model and leaves it where it is.
    x, y = window.middle("Turn the model")
    window.drag([[x, y], [x + 30, y], [x + 60, y]])
    assert place(window, "Turn the model")[2] < 300
    window.click("Outline mode")
    x, y = window.middle("Parts sheet")
    assert not any(w["label"] == "Hand R in 2" for w in window.widgets())
    window.drag([[x, y], [x, y - 40], [x, y - 90]])
    window.control("Hand R in 2")
    window.picture("tablet-all-drawings")
    window.close()


def on_tablets_a_card_tells_what_is_missing():
    window = Window("820x1180", examples / "hero/hero.artisketch")
    window.click("Outline mode")
    for part in ["Hand R", "Forearm R"]:
        window.click(part)
        window.key("Delete")
        window.wait(lambda: window.state()["undo"] == f"Delete {part}", why="the deleted outline")
    window.control("Hide all missing")
    window.picture("tablet-missing")
    window.click("Hide all missing")
    window.wait(lambda: window.state()["undo"] == "Hide 2 parts", why="the hidden parts")
    assert not any(w["label"] == "Hide all missing" for w in window.widgets())
    window.key("ctrl+z")
    window.click("Leave missing")
    window.wait(lambda: not any(w["label"] == "Leave missing" for w in window.widgets()), why="peace")
    window.close()


run(panels_are_as_wide_as_they_are_dragged, on_tablets_model_and_drawing_change_places,
    on_tablets_a_card_tells_what_is_missing)
