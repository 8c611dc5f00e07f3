#!/usr/bin/env python3
"""The page of `daphnis view` and of `run --live` in a real browser, without a screen. From the root of the checkout:

    python3 tools/browser/view_test.py

takes Chromium from the PATH, or CHROMIUM, and ./daphnis, or DAPHNIS; about a minute, five on a machine that is busy.
Without a browser it says so and is done.
"""

import json
import os
import signal
import subprocess
import sys
import tempfile
import time
import unittest
from collections import Counter
from pathlib import Path

from browser import Browser, found
from png import pixels

PROGRAM = os.environ.get("DAPHNIS") or str(Path(__file__).parents[2] / "daphnis")
MARKUP = "<img src=x onerror=document.title=1>"
HELD = "document.getElementById('shape').value = 'spheres'"


# Made states: 20 × 10 with 2,000 spheres of mass 0.8, of which cells of the grid have two; as many in a clump.
DENSITIES = """({ densityOf }) => {
    const [lx, ly, count] = [20, 10, 2000];
    const cells = [Math.round(Math.sqrt(count)), Math.round(Math.sqrt(count / 4))];
    const of = (places, shear, bodies = 0) => {
        const head = { count: places.length, bodies, every: 1, halves: [lx / 2, ly / 2, 1], repeats: [true, true], shear };
        return densityOf({ head, x: Float32Array.from(places, (p) => p[0]), y: Float32Array.from(places, (p) => p[1]),
            mass: new Float32Array(places.length).fill(0.8) });
    };
    const wrapped = (x, length) => x - length * Math.floor(x / length + 0.5);
    let seed = 1;
    const random = () => (seed = (seed * 48271) % 2147483647) / 2147483647;
    const cloud = Array.from({ length: count }, () => [(random() ** 2 - 0.5) * lx, (random() - 0.5) * ly]);
    const offset = (7 * ly) / cells[1];
    const moved = (dx, dy, slid) => cloud.map(([x, y]) => {
        const boxes = Math.floor((x + dx) / lx + 0.5);
        return [wrapped(x + dx, lx), wrapped(y + dy - boxes * slid, ly)];
    });
    const apart = (a, b) => a.reduce((most, d, k) => Math.max(most, Math.abs(d - b[k])), 0);
    const shear = { normal: 0, slide: 1, offset };
    const step = (17 * lx) / cells[0];
    const even = of(Array.from({ length: count }, (_, k) => [((k % 80) * 20 + 10) / 80 - 10,
        (Math.floor(k / 80) * 10 + 5) / 25 - 5]));
    const many = Array.from({ length: 100000 }, () => [(random() - 0.5) * lx, (random() - 0.5) * ly]);
    const begun = performance.now();
    of(many, shear);
    const milliseconds = performance.now() - begun;
    const clump = of([[3, 3], ...cloud.map(([x, y]) => [x / 10, y])], null, 1);
    return { even: [Math.min(...even), Math.max(...even)], milliseconds,
        alongX: apart(of(cloud, null), of(moved(step, 0, 0), null)),
        alongY: apart(of(cloud, null), of(moved(0, (9 * ly) / cells[1], 0), null)),
        sheared: apart(of(cloud, shear), of(moved(step, 0, offset), shear)),
        notSheared: apart(of(cloud, null), of(moved(step, 0, offset), null)),
        clump: clump.reduce((sum, d) => sum + d) / count, mean: (0.8 * count) / (lx * ly), body: clump[0] };
}"""


class Server:
    """A daphnis that serves a page, which its output names; kept in a file, so that it never waits for a reader."""

    def __init__(self, *words):
        self.file = tempfile.TemporaryFile("w+")
        self.process = subprocess.Popen([PROGRAM, *words], stdout=self.file, stderr=subprocess.STDOUT,
                                        start_new_session=True)
        for _ in range(1200):
            said = [word for word in self.said().split() if word.startswith("http://")]
            if said:
                self.address = said[0]
                return
            if self.process.poll() is not None:
                break
            time.sleep(0.1)
        raise AssertionError(self.said())

    def said(self):
        self.file.seek(0)
        return self.file.read()

    def interrupt(self):
        os.killpg(self.process.pid, signal.SIGINT)

    def close(self):
        if self.process.poll() is None:
            os.killpg(self.process.pid, signal.SIGKILL)
        self.process.wait()
        self.file.close()


def is_shown(browser):
    browser.wait("document.getElementById('when').textContent.startsWith('t =')")
    settle(browser)


def settle(browser):
    """Until what has been asked for is drawn."""
    browser.js("new Promise(done => requestAnimationFrame(() => requestAnimationFrame(() => setTimeout(done, 60))))")


class Seen:
    """What is seen of the picture; equal when all pixels are."""

    def __init__(self, browser):
        browser.js("scrollTo(0, 0)")
        settle(browser)
        x, y, width, height = browser.js("(r => [r.x, r.y, r.width, r.height])"
                                         "(document.getElementById('frame').getBoundingClientRect())")
        # Without its round corners.
        self.png = browser.picture(clip={"x": x + 8, "y": y + 8, "width": width - 16, "height": height - 16})

    def __eq__(self, other):
        return self.png == other.png

    def __hash__(self):
        return hash(self.png)


def counted(png):
    rows = pixels(png)[2]
    return Counter(pixel for row in rows for pixel in row)


def ground(png):
    return counted(png).most_common(1)[0][0]


def covered(png):
    """Part of the pixels that are not the ground."""
    counts = counted(png)
    return 1 - counts.most_common(1)[0][1] / counts.total()


class ViewTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory(prefix="daphnis-view.")
        cls.directory = str(Path(cls.folder.name) / MARKUP)
        made = subprocess.run([PROGRAM, "run", "mixture", "--steps", "6", "--set", "output.snapshotEvery=1",
                               "--set", "output.seriesEvery=1", "--out", cls.directory, "--quiet"],
                              capture_output=True, text=True, check=False)
        assert made.returncode == 0, made.stderr
        cls.server = Server("view", cls.directory)
        cls.browser = Browser()

    @classmethod
    def tearDownClass(cls):
        cls.browser.close()
        cls.server.close()
        cls.folder.cleanup()

    def setUp(self):
        self.browser.events.clear()
        self.browser.size(800, 700)
        self.browser.open(self.server.address)
        is_shown(self.browser)
        self.browser.js(HELD)
        settle(self.browser)

    def tearDown(self):
        self.assertEqual([], self.browser.complaints())

    def text(self, element):
        return self.browser.js(f"document.getElementById('{element}').textContent")

    def choose(self, element, value):
        self.browser.js(f"(e => {{ e.value = '{value}'; e.dispatchEvent(new Event('change')); }})"
                        f"(document.getElementById('{element}'))")
        settle(self.browser)

    def test_keys_rotate_zoom_and_reset(self):
        first = Seen(self.browser)
        self.assertGreater(covered(first.png), 0.1)
        self.assertEqual(first, Seen(self.browser))
        for key in ("ArrowLeft", "ArrowUp", "t", "f"):
            self.browser.key(key)
            self.assertNotEqual(first, Seen(self.browser), key)
            self.browser.key("0")
            self.assertEqual(first, Seen(self.browser), key)
        self.browser.key("-")
        self.browser.key("-")
        self.assertLess(covered(Seen(self.browser).png), covered(first.png))

    def test_the_mouse_rotates_moves_and_zooms(self):
        first = Seen(self.browser)
        x, y = self.browser.middle("view")

        def drag(modifiers):
            self.browser.mouse("mousePressed", x, y, button="left", clickCount=1, modifiers=modifiers)
            self.browser.mouse("mouseMoved", x + 60, y + 20, button="left", buttons=1, modifiers=modifiers)
            self.browser.mouse("mouseReleased", x + 60, y + 20, button="left", clickCount=1, modifiers=modifiers)
            return Seen(self.browser)

        turned = drag(0)
        self.assertNotEqual(first, turned)
        # The mouse that is up moves nothing.
        self.browser.mouse("mouseMoved", x, y)
        self.assertEqual(turned, Seen(self.browser))
        self.browser.key("0")
        self.assertNotIn(drag(8), (first, turned))
        self.browser.key("0")
        self.browser.mouse("mouseWheel", x, y, deltaX=0, deltaY=300)
        time.sleep(0.3)
        self.assertLess(covered(Seen(self.browser).png), covered(first.png))

    def test_two_fingers_zoom(self):
        self.browser.size(390, 900, touch=True)
        settle(self.browser)
        first = Seen(self.browser)
        x, y = self.browser.middle("view")

        def fingers(kind, apart):
            points = [{"x": x - apart, "y": y, "id": 1}, {"x": x + apart, "y": y, "id": 2}] if apart else []
            self.browser.tell("Input.dispatchTouchEvent", type=kind, touchPoints=points)

        fingers("touchStart", 80)
        fingers("touchMove", 40)
        fingers("touchEnd", 0)
        self.assertLess(covered(Seen(self.browser).png), covered(first.png))

    def test_states_are_gone_through_and_played(self):
        self.assertEqual("6", self.browser.js("document.getElementById('slider').value"))
        last, late = self.text("when"), Seen(self.browser)
        self.browser.key(",")
        self.browser.wait(f"document.getElementById('when').textContent !== {json.dumps(last)}")
        self.assertNotEqual(late, Seen(self.browser))
        self.browser.key(".")
        self.browser.wait(f"document.getElementById('when').textContent === {json.dumps(last)}")
        self.assertEqual(late, Seen(self.browser))
        self.browser.js("document.getElementById('slider').focus()")
        self.browser.key("Home", number=36)
        self.browser.wait("document.getElementById('when').textContent.startsWith('t = 0.000')")
        self.browser.js("document.getElementById('view').focus()")
        self.choose("rate", "25")
        self.browser.key(" ", "Space", 32)
        self.browser.wait("document.getElementById('play').textContent === 'pause'")
        self.browser.wait("document.getElementById('play').textContent === 'play'")
        self.assertEqual(last, self.text("when"))
        self.browser.click("play")
        self.browser.wait("document.getElementById('play').textContent === 'pause'")
        self.browser.click("play")
        self.assertEqual("play", self.text("play"))

    def test_colours_have_numbers_and_units(self):
        # Of several materials who is who is seen at first.
        self.assertEqual("material", self.browser.js("document.getElementById('colour').value"))
        pictures = []
        for value, label in (("speed", "speed [units of length/time]"), ("size", "radius [units of length]"),
                             ("height", "height z [units of length]"),
                             ("density", "surface density [units of mass/length²]"), ("material", "material")):
            self.choose("colour", value)
            self.assertEqual(label, self.text("quantity"))
            pictures.append(Seen(self.browser))
            if value == "size":
                ticks = "[...document.getElementById('ticks').children].map(tick => tick.textContent).join()"
                self.assertEqual("0.5,0.625,0.75,0.875,1", self.browser.js(ticks))
        self.assertEqual(5, len(set(pictures)))
        self.assertIn("heavy", self.text("materials"))
        self.choose("shape", "points")
        self.assertNotIn(Seen(self.browser), pictures)

    def test_the_surface_density_is_that_around_and_goes_on_beyond_faces(self):
        seen = self.browser.js("import('./density.js').then(" + DENSITIES + ")")
        low, high = seen["even"]
        self.assertAlmostEqual(8, low, delta=0.5)
        self.assertAlmostEqual(8, high, delta=0.5)
        # The same cloud further on, with what leaves through one face at its image, has the same densities.
        for moved in ("alongX", "alongY", "sheared"):
            self.assertLess(seen[moved], 1e-4, moved)
        self.assertGreater(seen["notSheared"], 0.5)
        # All mass is in a tenth of the box, and bodies have none.
        self.assertGreater(seen["clump"], 5 * seen["mean"])
        self.assertEqual(0, seen["body"])
        self.assertLess(seen["milliseconds"], 1000)

    def test_it_fits_narrow_and_wide_light_and_dark(self):
        grounds = set()
        for width in (390, 768, 1280, 1920):
            for dark in (False, True):
                self.browser.size(width, 900, dark)
                settle(self.browser)
                self.assertEqual(width, self.browser.js("document.documentElement.scrollWidth"))
                outside = ("[...document.querySelectorAll('main *')].filter(e => e.offsetParent && "
                           f"(r => r.width && (r.left < 0 || r.right > {width}))(e.getBoundingClientRect()))"
                           ".map(e => e.id || e.tagName).join()")
                self.assertEqual("", self.browser.js(outside), width)
                png = Seen(self.browser).png
                self.assertGreater(covered(png), 0.05)
                grounds.add((dark, ground(png)))
        self.assertEqual(2, len(grounds), grounds)

    def test_names_with_markup_stay_text(self):
        self.assertIn(MARKUP, self.text("name"))
        self.assertEqual(0, self.browser.js("document.querySelectorAll('img[src=x]').length"))
        self.assertNotEqual("1", self.browser.js("document.title"))
        self.assertTrue(self.browser.js("document.getElementById('series').complete"
                                        " && document.getElementById('series').naturalWidth > 0"))

    def test_a_picture_is_saved(self):
        with tempfile.TemporaryDirectory() as folder:
            self.browser.tell("Page.setDownloadBehavior", behavior="allow", downloadPath=folder)
            self.browser.click("shot")
            for _ in range(200):
                saved = list(Path(folder).glob("*.png"))
                if saved:
                    break
                time.sleep(0.05)
            self.assertEqual(["mixture-6.png"], [path.name for path in saved])
            time.sleep(0.2)
            png = saved[0].read_bytes()
            width, height, _ = pixels(png)
            self.assertEqual(width, self.browser.js("document.getElementById('view').width"))
            self.assertGreater(height, self.browser.js("document.getElementById('view').height"))
            self.assertGreater(covered(png), 0.1)

    def test_without_webgl_it_says_what_else_there_is(self):
        hide = ("const get = HTMLCanvasElement.prototype.getContext; HTMLCanvasElement.prototype.getContext ="
                " function (kind, more) { return kind === 'webgl2' ? null : get.call(this, kind, more); };")
        script = self.browser.tell("Page.addScriptToEvaluateOnNewDocument", source=hide)["identifier"]
        try:
            self.browser.open("about:blank")
            self.browser.open(self.server.address)
            self.browser.wait("document.getElementById('note').textContent.includes('daphnis movie')")
            self.assertTrue(self.browser.js("document.getElementById('stage').hidden"))
        finally:
            self.browser.tell("Page.removeScriptToEvaluateOnNewDocument", identifier=script)


class LiveTest(unittest.TestCase):
    def test_a_run_that_is_complete_is_seen_to_its_end_and_says_so(self):
        with tempfile.TemporaryDirectory(prefix="daphnis-view.") as folder:
            server = Server("run", "drum", "--until", "4", "--live", "--out", f"{folder}/run")
            browser = Browser()
            try:
                browser.size(390, 900)
                browser.open(server.address)
                browser.wait("document.getElementById('text').dataset.end === 'complete'")
                self.assertEqual(0, server.process.wait(60))
                browser.wait("document.getElementById('when').textContent.startsWith('t = 4.000 ')")
                self.assertIn("state digest", browser.js("document.getElementById('text').textContent"))
                self.assertIn("cylinder of radius 10.00", browser.js("document.getElementById('about').textContent"))
                colours = browser.js("['text', 'note'].map(e => getComputedStyle(document.getElementById(e)).color)")
                self.assertEqual(2, len(set(colours)), colours)
                # Text of 14 points on a sheet of 380.
                self.assertGreaterEqual(browser.js("document.getElementById('series').clientWidth") * 14 / 380, 11)
                self.assertEqual([], browser.complaints())
            finally:
                browser.close()
                server.close()

    def test_a_run_is_watched_gone_back_in_and_ends(self):
        with tempfile.TemporaryDirectory(prefix="daphnis-view.") as folder:
            server = Server("run", "cooling-gas", "--set", "until=100000", "--live", "--out", f"{folder}/run")
            browser = Browser()
            try:
                browser.size(1280, 900)
                browser.open(server.address)
                is_shown(browser)
                browser.wait("Number(document.getElementById('slider').max) >= 3")
                self.assertIn("step", browser.js("document.getElementById('text').textContent"))
                newest = browser.js("document.getElementById('when').textContent")
                self.assertEqual(browser.js("document.getElementById('slider').max"),
                                 browser.js("document.getElementById('slider').value"))
                browser.js("document.getElementById('slider').focus()")
                browser.key("Home", number=36)
                browser.wait("document.getElementById('slider').value === '0'"
                             f" && document.getElementById('when').textContent !== {json.dumps(newest)}")
                settle(browser)
                kept = browser.js("document.getElementById('when').textContent")
                more = browser.js("Number(document.getElementById('slider').max)") + 2
                browser.wait(f"Number(document.getElementById('slider').max) >= {more}")
                # Who has gone back stays there.
                self.assertEqual(kept, browser.js("document.getElementById('when').textContent"))
                server.interrupt()
                browser.wait("document.getElementById('text').dataset.end === 'interrupted'")
                self.assertEqual(kept, browser.js("document.getElementById('when').textContent"))
                browser.key("End", number=35)
                browser.wait(f"document.getElementById('when').textContent !== {json.dumps(kept)}")
                self.assertEqual(130, server.process.wait(60))
                self.assertEqual([], browser.complaints())
            finally:
                browser.close()
                server.close()


if __name__ == "__main__":
    if not found():
        print("no browser: CHROMIUM or the PATH have none; nothing is tested")
        sys.exit(0)
    unittest.main()
