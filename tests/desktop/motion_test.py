#!/usr/bin/env python3
"""What moves, and what goes out with it: a clip of the library, an engine's names for joints."""
import json, pathlib

from editor_window import Window, examples, run


def choose(window, button, line):
    """A line of the menu that a button opens, once it stands where it stays."""
    window.click(button)
    window.has(line)
    places = []

    def still():
        places.append(window.control(line))
        return len(places) > 1 and places[-1] == places[-2]
    window.wait(still, why=f"the menu with {line}")
    window.click(line)


def a_clip_is_chosen_and_exported_for_an_engine():
    window = Window("1440x900", examples / "hero/hero.artisketch")
    window.click("Reconstruct")
    window.wait(lambda: window.state()["hasModel"], "the model")
    window.click("Result mode")
    choose(window, "Library", "Add walk")
    window.has("Clip walk")
    window.picture("walk")
    window.click("Export")
    choose(window, "Joints' names", "Unreal's mannequin")
    window.picture("export-unreal")
    window.click("Export hero.glb")
    out = pathlib.Path(window.home, "hero.glb")
    window.type_path(out)
    window.wait(out.exists, why="the file")
    glb = out.read_bytes()
    model = json.loads(glb[20:20 + int.from_bytes(glb[12:16], "little")])
    names = {node.get("name") for node in model["nodes"]}
    assert {"pelvis", "spine_01", "clavicle_l", "hand_r", "ball_l"} <= names, names
    assert "walk" in {clip["name"] for clip in model["animations"]}
    window.close()


run(a_clip_is_chosen_and_exported_for_an_engine)
