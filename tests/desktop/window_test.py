#!/usr/bin/env python3
"""What every window does: greets, reconstructs, cancels, undoes, recovers, fits its screen."""
import math, pathlib, subprocess, time

from editor_window import Window, examples, run


def greets_with_the_hero():
    window = Window("1440x900")
    window.wait(lambda: window.state()["hasModel"], "the hero")
    assert window.state()["mode"] == "welcome"
    window.picture("first-run")
    window.click("Example Fox")
    window.wait(lambda: window.state()["mode"] == "outline", why="the fox")
    window.picture("fox")
    window.close()


def opens_a_figure_of_the_gallery():
    window = Window("1440x900")
    window.wait(lambda: window.state()["hasModel"], "the hero")
    window.click("Gallery")
    window.has("Example Prince")
    window.picture("gallery")
    window.key("Escape")
    window.has("Turn the model")
    window.click("Gallery")
    window.click("Example Monster")
    window.wait(lambda: window.state()["mode"] == "result" and not window.state()["busy"], "its model")
    assert window.state()["hasModel"]
    window.picture("monster")
    window.close()


def reconstructs_and_cancels():
    window = Window("1440x900", examples / "heart/heart.artisketch")
    window.click("Reconstruct")
    window.wait(lambda: window.state()["busy"] or window.state()["hasModel"], why="the job")
    window.wait(lambda: window.state()["hasModel"], "the model")
    window.picture("outline")
    window.click("Result mode")
    window.wait(lambda: window.state()["mode"] == "result", why="the mode")
    window.picture("result")
    window.click("Export")
    window.wait(lambda: any(w["label"] == "Format GLB" for w in window.widgets()), why="the sheet")
    window.picture("export")
    window.close()

    window = Window("1440x900", examples / "hero/hero.artisketch")
    window.click("Reconstruct")
    window.wait(lambda: window.state()["busy"], why="the job")
    window.point_at("Cancel")
    began = time.time()
    subprocess.run(["xdotool", "click", "1"], env=window.environment, check=True)
    window.wait(lambda: not window.state()["busy"], why="the end of the job")
    print(f"cancelled {time.time() - began:.2f} s after the click")
    window.close()


def says_what_a_command_waits_for():
    window = Window("1280x720", examples / "hero/front.png")
    window.wait(lambda: window.state()["frames"] == 1, why="the drawing")
    for key, words in [("r", "Outline a part first."), ("ctrl+e", "Outline a part first.")]:
        window.key(key)
        window.wait(lambda: window.state()["message"] == words, why=words)
    window.key("d")
    x, y = window.ask("project 0 280 330")
    window.drag([(x + 40 * math.cos(t / 5), y + 40 * math.sin(t / 5)) for t in range(32)])
    window.key("Return")
    window.wait(lambda: window.state()["undo"].startswith("Draw "), why="the outline")
    window.key("ctrl+e")
    words = "Reconstruct makes the model to export."
    window.wait(lambda: window.state()["message"] == words, why=words)
    window.key("shift+c")
    window.wait(lambda: "no other to agree with" in window.state()["message"], why="the words")
    window.picture("lacks")
    window.close()


def exports_every_format():
    window = Window("1440x900", examples / "circles/circles.artisketch")
    window.click("Reconstruct")
    window.wait(lambda: window.state()["hasModel"], "the model")
    window.click("Export")
    begins = {"glb": b"glTF", "obj": b"# ArtiSketch", "stl": b"ArtiSketch", "ply": b"ply\n",
              "png": b"\x89PNG"}
    for ending, begin in begins.items():
        window.click(f"Format {ending.upper()}")
        window.click(f"Export circles.{ending}")
        # Without a program for dialogs the editor asks itself.
        window.wait(lambda: any(w["label"] == "Path" for w in window.widgets()), why="the question")
        out = pathlib.Path(window.home, f"model.{ending}")
        window.key("ctrl+a")
        window.x("type", "--delay", "40", str(out))
        window.picture("export-path")
        window.key("Return")
        window.wait(out.exists, why=f"{out}")
        assert out.read_bytes().startswith(begin), ending
    window.close()


def draws_and_undoes():
    window = Window("1440x900", examples / "hero/hero.artisketch")
    window.key("d")
    centre = window.ask("project 0 320 60")

    circle = [(centre[0] + 28 * math.cos(t / 5), centre[1] + 28 * math.sin(t / 5))
              for t in range(32)]
    window.drag(circle)
    window.picture("new-outline")
    window.key("Return")
    window.wait(lambda: window.state()["canUndo"], why="the outline")
    window.wait(lambda: window.state()["unsaved"], why="unsaved work")
    window.key("ctrl+z")
    window.wait(lambda: not window.state()["canUndo"], why="undo")
    window.key("ctrl+shift+z")
    window.wait(lambda: window.state()["canUndo"], why="redo")
    window.close()


def recovers_what_was_lost():
    window = Window("1440x900", examples / "hero/hero.artisketch")
    window.key("3")
    window.wait(lambda: window.state()["mode"] == "pose", why="the mode")
    window.click("Reset tool")
    window.wait(lambda: window.state()["canUndo"], why="the edit")
    kept = pathlib.Path(window.home, "artisketch")
    # Beside its lock, which is there from the start.
    window.wait(lambda: [f for f in kept.glob("autosave-*") if f.name[9:].isdigit()],
                why="the copy that is kept")
    window.editor.kill()
    window.editor.wait()
    window.close()
    again = Window("1440x900", home=window.home)
    again.wait(lambda: any(w["label"] == "Keep" for w in again.widgets()), why="the offer")
    again.picture("recovery")
    again.click("Keep")
    again.wait(lambda: again.state()["unsaved"] and again.state()["frames"] == 3, why="the work")
    again.close()


def opens_one_document_after_another():
    """What was derived from a document that nobody edited is not taken for the next one's."""
    window = Window("1440x900", examples / "circles/circles.artisketch")
    window.wait(lambda: window.state()["frames"] == 2, why="the circles")
    for name, frames in ("hero", 3), ("circles", 2), ("fox", 3):
        window.key("ctrl+o")
        window.wait(lambda: any(w["label"] == "Path" for w in window.widgets()), why="the question")
        window.click("Path")
        path = (examples / name / f"{name}.artisketch").absolute()
        window.x("type", "--delay", "40", str(path))
        window.picture("open-path")
        window.key("Return")
        window.wait(lambda: window.state()["frames"] == frames, name)
        for key, mode in ("2", "skeleton"), ("3", "pose"), ("4", "result"), ("1", "outline"):
            window.key(key)
            window.wait(lambda: window.state()["mode"] == mode, why=mode)
    window.close()


def fits_every_screen():
    for size in ("1280x720", "820x1180"):
        window = Window(size, examples / "hero/hero.artisketch")
        width, height = map(int, size.split("x"))
        for w in window.widgets():
            inside = w["x"] >= -8 and w["y"] >= 0 and w["x"] + w["width"] <= width + 8
            assert inside and w["y"] + w["height"] <= height, f"{w} is off the {size} screen"
        window.picture(size)
        window.close()


run(greets_with_the_hero, opens_a_figure_of_the_gallery, says_what_a_command_waits_for, reconstructs_and_cancels,
    exports_every_format, draws_and_undoes, recovers_what_was_lost,
    opens_one_document_after_another, fits_every_screen)
