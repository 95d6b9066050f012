"""A real editor window on a screen of its own: the pointer and the keys are X's, the window is found
through its own list of controls. Tests import from here; each is called with

    NAME_test.py EDITOR EXAMPLES FOLDER     pictures of each step go to FOLDER
"""
import json, os, pathlib, signal, subprocess, sys, tempfile, time

editor_path, examples, pictures = map(pathlib.Path, sys.argv[1:4])
pictures.mkdir(parents=True, exist_ok=True)

# Seconds after which what was waited for counts as never coming. Not a measure: machines differ.
PATIENCE = 300


class Window:
    """The editor, under Xvfb and a window manager that gives it the whole screen."""

    open = []  # windows that a failed test would leave behind

    def __init__(self, size, document=None, home=None, hints=False):
        """hints: of the modes, which come at the first visit; their moving pictures are drawn in software here,
        and what each key and click waits for with them."""
        Window.open.append(self)
        self.home = home or tempfile.mkdtemp()
        if not hints:
            kept = pathlib.Path(self.home, "artisketch")
            kept.mkdir(exist_ok=True)
            (kept / "hints").write_text("1234")
        read, write = os.pipe()
        self.screen = subprocess.Popen(
            ["Xvfb", "-displayfd", str(write), "-screen", "0", f"{size}x24"],
            pass_fds=[write], stderr=subprocess.DEVNULL)
        display = ":" + os.read(read, 16).decode().strip()
        self.environment = dict(os.environ, DISPLAY=display, XDG_STATE_HOME=self.home, LANGUAGE="en")
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

    def wait(self, condition, why=""):
        end = time.time() + PATIENCE
        while time.time() < end:
            result = condition()
            if result:
                return result
            time.sleep(0.05)
        raise AssertionError(f"waited in vain for {why}; the state is {self.state()}")

    def control(self, label):
        def named():
            return [w for w in self.widgets() if w["label"] == label]
        return self.wait(named, f"the control {label!r}")[0]

    def labels(self):
        return {w["label"] for w in self.widgets()}

    def middle(self, label):
        w = self.control(label)
        return [w["x"] + w["width"] / 2, w["y"] + w["height"] / 2]

    def has(self, label):
        """Waits for a control or words of that name; they need not be enabled."""
        self.control(label)

    def type_path(self, path):
        """Answers the question for a path."""
        self.has("Path")
        self.key("ctrl+a")
        self.x("type", "--delay", "40", str(path))
        self.key("Return")

    def x(self, *words):
        subprocess.run(["xdotool", *map(str, words)], env=self.environment, check=True)
        time.sleep(0.12)
        self.frame()

    def frame(self):
        """Once a frame has been drawn with what the pointer and the keys did: it is asked after one."""
        self.state()

    def click(self, label):
        self.point_at(label)
        self.x("click", 1)

    def double_click(self, x, y, done, why):
        """On a machine that draws slowly, two clicks may be too far apart: then a person tries again."""
        def tried():
            self.x("mousemove", round(x), round(y))
            self.x("click", "--repeat", 2, "--delay", 60, 1)
            return done()
        self.wait(tried, why)

    def point_at(self, label):
        assert self.control(label)["enabled"], f"{label} is not enabled"
        self.x("mousemove", *map(round, self.middle(label)))

    def drag(self, points):
        self.x("mousemove", *map(round, points[0]))
        self.x("mousedown", 1)
        for p in points[1:]:
            subprocess.run(["xdotool", "mousemove", str(round(p[0])), str(round(p[1]))],
                           env=self.environment, check=True)
            time.sleep(0.02)
            self.frame()
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
            self.editor.wait(PATIENCE)
        self.kill()

    def kill(self):
        for process in (self.editor, self.manager, self.screen):
            process.kill()
            process.wait()
        Window.open.remove(self)


def out_of_time(*_):
    raise TimeoutError("the window does not answer")


def run(*tests):
    """A window that hangs is a failure, not a wait."""
    signal.signal(signal.SIGALRM, out_of_time)
    try:
        for test in tests:
            signal.alarm(4 * PATIENCE)
            began = time.time()
            test()
            print(f"ok {test.__name__} ({time.time() - began:.1f} s)", flush=True)
    finally:
        for window in list(Window.open):
            window.kill()
