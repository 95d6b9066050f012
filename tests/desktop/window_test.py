#!/usr/bin/env python3
"""Drives the real editor window on a screen of its own: the pointer and the keys are X's, the
window is found through its own list of controls.

    window_test.py EDITOR EXAMPLES FOLDER     pictures of each step go to FOLDER
"""
import json, math, os, pathlib, signal, subprocess, sys, tempfile, time

signal.alarm(240)  # a window that hangs is a failure, not a wait

editor_path, examples, pictures = map(pathlib.Path, sys.argv[1:4])
pictures.mkdir(parents=True, exist_ok=True)


class Window:
    """The editor, under Xvfb and a window manager that gives it the whole screen."""

    open = []  # windows that a failed test would leave behind

    def __init__(self, size, document=None, home=None):
        Window.open.append(self)
        self.home = home or tempfile.mkdtemp()
        read, write = os.pipe()
        self.screen = subprocess.Popen(
            ["Xvfb", "-displayfd", str(write), "-screen", "0", f"{size}x24"],
            pass_fds=[write], stderr=subprocess.DEVNULL)
        display = ":" + os.read(read, 16).decode().strip()
        self.environment = dict(os.environ, DISPLAY=display, XDG_STATE_HOME=self.home)
        rules = pathlib.Path(self.home, "openbox.xml")
        rules.write_text(
            '<openbox_config xmlns="http://openbox.org/3.4/rc"><applications><application class="*">'
            "<decor>no</decor><maximized>yes</maximized><focus>yes</focus>"
            "</application></applications></openbox_config>")
        self.manager = subprocess.Popen(["openbox", "--config-file", str(rules)],
                                        env=self.environment, stderr=subprocess.DEVNULL)
        time.sleep(0.5)
        self.editor = subprocess.Popen(
            [str(editor_path), "--script"] + ([str(document)] if document else []),
            env=self.environment, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True)
        self.wait(lambda: self.widgets())

    def ask(self, question):
        self.editor.stdin.write(question + "\n")
        self.editor.stdin.flush()
        return json.loads(self.editor.stdout.readline())

    def widgets(self):
        return self.ask("widgets")

    def state(self):
        return self.ask("state")

    def wait(self, condition, seconds=10, why=""):
        end = time.time() + seconds
        while time.time() < end:
            result = condition()
            if result:
                return result
            time.sleep(0.05)
        raise AssertionError(f"waited {seconds} s for {why}; the state is {self.state()}")

    def control(self, label):
        found = [w for w in self.widgets() if w["label"] == label]
        assert found, f"no control {label!r} among {sorted(w['label'] for w in self.widgets())}"
        return found[0]

    def x(self, *words):
        subprocess.run(["xdotool", *map(str, words)], env=self.environment, check=True)
        time.sleep(0.12)

    def click(self, label):
        self.point_at(label)
        self.x("click", 1)

    def point_at(self, label):
        w = self.control(label)
        assert w["enabled"], f"{label} is not enabled"
        self.x("mousemove", round(w["x"] + w["width"] / 2), round(w["y"] + w["height"] / 2))

    def drag(self, points):
        self.x("mousemove", *map(round, points[0]))
        self.x("mousedown", 1)
        for p in points[1:]:
            subprocess.run(["xdotool", "mousemove", str(round(p[0])), str(round(p[1]))],
                           env=self.environment, check=True)
            time.sleep(0.02)
        self.x("mouseup", 1)

    def key(self, key):
        *held, last = key.split("+")
        for k in held:
            self.x("keydown", k)
        self.x("key", last)
        for k in held:
            self.x("keyup", k)

    def picture(self, name):
        subprocess.run(["import", "-window", "root", str(pictures / (name + ".png"))],
                       env=self.environment, check=True)

    def close(self):
        if self.editor.poll() is None:
            self.editor.stdin.write("quit\n")
            self.editor.stdin.flush()
            self.editor.wait(10)
        self.kill()

    def kill(self):
        for process in (self.editor, self.manager, self.screen):
            process.kill()
            process.wait(10)
        Window.open.remove(self)


def greets_with_the_hero():
    window = Window("1440x900")
    window.wait(lambda: window.state()["hasModel"], 5, "the hero")
    assert window.state()["mode"] == "welcome"
    window.picture("first-run")
    window.click("Example Fox")
    window.wait(lambda: window.state()["mode"] == "outline", why="the fox")
    window.picture("fox")
    window.close()


def reconstructs_and_cancels():
    window = Window("1440x900", examples / "heart/heart.artisketch")
    window.click("Reconstruct")
    window.wait(lambda: window.state()["busy"] or window.state()["hasModel"], why="the job")
    window.wait(lambda: window.state()["hasModel"], 60, "the model")
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
    taken = time.time() - began
    print(f"cancelled {taken:.2f} s after the click")
    assert taken < 2, taken  # 0.3 on a machine that does nothing else
    window.close()


def exports_every_format():
    window = Window("1440x900", examples / "circles/circles.artisketch")
    window.click("Reconstruct")
    window.wait(lambda: window.state()["hasModel"], 60, "the model")
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
    time.sleep(3.2)
    window.editor.kill()
    window.editor.wait()
    window.close()
    again = Window("1440x900", home=window.home)
    again.wait(lambda: any(w["label"] == "Keep" for w in again.widgets()), why="the offer")
    again.picture("recovery")
    again.click("Keep")
    again.wait(lambda: again.state()["unsaved"] and again.state()["frames"] == 3, why="the work")
    again.close()


def fits_every_screen():
    for size in ("1280x720", "820x1180"):
        window = Window(size, examples / "hero/hero.artisketch")
        width, height = map(int, size.split("x"))
        for w in window.widgets():
            inside = w["x"] >= -8 and w["y"] >= 0 and w["x"] + w["width"] <= width + 8
            assert inside and w["y"] + w["height"] <= height, f"{w} is off the {size} screen"
        window.picture(size)
        window.close()


def out_of_time(*_):
    raise TimeoutError("the window does not answer")


signal.signal(signal.SIGALRM, out_of_time)
try:
    for test in (greets_with_the_hero, reconstructs_and_cancels, exports_every_format,
                 draws_and_undoes,
                 recovers_what_was_lost, fits_every_screen):
        began = time.time()
        test()
        print(f"ok {test.__name__} ({time.time() - began:.1f} s)", flush=True)
finally:
    for window in list(Window.open):
        window.kill()
