#!/usr/bin/env python3
"""What a hand does in sheets and dialogs: figures picked on a sheet, a drawing cropped, a part split, the
hints of the modes, the export sheet."""
import os, pathlib, subprocess, tempfile

from editor_window import Window, examples, pictures, run


def figures_are_picked_on_a_sheet():
    sheet, front = pictures / "walk.png", str(examples / "hero/front.png")
    subprocess.run(["convert", front, front, front, "+append", "-resize", "40%", "-gravity", "north",
                    "-background", "none", "-splice", "0x60", "-pointsize", "36", "-annotate", "+0+8", "WALK",
                    str(sheet)], check=True)
    window = Window("1280x720", sheet)
    window.has("Figure 3")
    window.picture("picking")
    window.click("Figure 2")
    window.wait(lambda: not window.control("Figure 2")["active"], why="one left out")
    first = window.control("Figure 1")
    # The title, by hand: it becomes a row of its own.
    x, y = first["x"], first["y"]
    window.drag([(x + 120, y - 24), (x + 200, y - 14), (x + 300, y - 4)])
    window.has("Figure A1")
    window.picture("picking-drawn")
    window.click("Cut it up")
    window.wait(lambda: window.state()["frames"] == 3, why="two figures and the title")
    window.x("mousemove", 100, 660)
    window.x("mousemove", *(round(window.control("Drawing card 2")[k] + 40) for k in ("x", "y")))
    window.x("click", 3)
    window.has("Crop by hand")
    window.picture("drawing-menu")
    window.click("Crop by hand")
    ground = window.control("Picture to pick on")
    x, y = ground["x"] + ground["width"] / 2, ground["y"] + ground["height"] / 2
    window.drag([(x - 80, y - 90), (x, y), (x + 70, y + 100)])
    window.has("Crop box")
    window.picture("cropping")
    window.click("Crop to the box")
    window.wait(lambda: window.state()["undo"] == "Crop drawing", why="the crop")
    window.picture("cropped")
    window.close()


def each_mode_says_what_one_does():
    for size in ("1440x900", "390x844"):
        window = Window(size, examples / "hero/hero.artisketch", hints=True)
        for mode in ("Outline", "Skeleton", "Pose", "Result"):
            window.click(f"{mode} mode")
            window.has("Got it")
            window.picture(f"hints-{mode.lower()}-{size}")
            window.click("Got it")
            window.wait(lambda: "Got it" not in window.labels(), why="the card put away")
        window.click("Shortcuts")
        window.has("How this mode works")
        window.picture(f"shortcuts-{size}")
        window.click("How this mode works")
        window.has("Got it")
        window.close()


def the_guide_opens_in_the_systems_browser():
    with tempfile.TemporaryDirectory() as folder:
        tools = pathlib.Path(folder)
        shown = tools / "shown"
        opener = tools / "xdg-open"  # in the place of the system's
        opener.write_text(f'#!/bin/sh\nprintf %s "$1" > "{shown}.new" && mv "{shown}.new" "{shown}"\n')
        opener.chmod(0o755)
        usual_path = os.environ["PATH"]
        os.environ["PATH"] = f"{tools}:{usual_path}"
        window = Window("1280x720", examples / "hero/hero.artisketch")
        os.environ["PATH"] = usual_path
        window.click("Shortcuts")
        window.click("Guide")
        window.wait(shown.exists, why="the guide")
        place = shown.read_text()
        assert place.startswith("file://"), place
        page = pathlib.Path(place.removeprefix("file://"))
        assert "3. Outlines (1)" in page.read_text() and (page.parent / "skeleton.png").exists(), place
        window.close()


def a_part_is_split_by_its_menu():
    window = Window("1440x900", examples / "hero/hero.artisketch")
    joints = len(window.state()["joints"])
    window.click("Thigh R in 1")
    window.key("shift+k")
    window.wait(lambda: window.state()["undo"] == "Split Thigh R", why="the split")
    assert len(window.state()["joints"]) == joints + 2
    window.picture("split")
    window.key("ctrl+z")
    window.wait(lambda: len(window.state()["joints"]) == joints, why="all in one step")
    window.close()


def clips_and_sizes_are_chosen_to_export():
    window = Window("1440x900", examples / "circles/circles.artisketch")  # both clips in sight
    window.click("Reconstruct")
    window.wait(lambda: window.state()["hasModel"], "the model")
    window.click("Result mode")
    window.click("New clip")
    window.wait(lambda: window.state()["undo"] == "New clip", why="a clip")
    window.click("Export")
    window.has("Format GLB")
    window.has("clip 1")
    window.picture("export-clips")
    window.click("clip 1")
    window.wait(lambda: not window.control("clip 1")["active"], why="the clip left out")
    window.click("Format Sprites")
    window.wait(lambda: any(label.startswith("Export ") and label.endswith(".zip") for label in window.labels()),
                why="the sheet of sprites")
    window.picture("export-sprites")
    window.click("Format GLB")
    window.click("Export circles.glb")
    out = pathlib.Path(window.home, "small.glb")
    window.type_path(out)
    window.wait(out.exists, why="the file")
    assert out.read_bytes()[:4] == b"glTF"
    window.close()


run(figures_are_picked_on_a_sheet, each_mode_says_what_one_does, the_guide_opens_in_the_systems_browser,
    a_part_is_split_by_its_menu, clips_and_sizes_are_chosen_to_export)
