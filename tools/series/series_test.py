"""python3 -m unittest discover -s tools/series -p '*_test.py'"""

import contextlib
import io
import math
import tempfile
import unittest
import xml.etree.ElementTree as xml
from pathlib import Path
from unittest import mock

import page
import series


def row(**words):
    return {
        "date": "2026-11-01 10:00", "commit": "abc", "machine": "one", "cores": 2.0, "java": "17", "case": "ring",
        "way": "warm", "engine": "serial", "threads": 1.0, "spheres": 100.0, "steps": 10.0, "collisions": 5.0,
        "rounds": 3.0, "seconds": 2.0, "processor_seconds": 2.0, "memory_mib": math.nan, "arithmetic_ns": 8.0,
        "memory_ns": 100.0, **words,
    }


class Losses(unittest.TestCase):
    def lost(self, before=(), **words):
        return [times for _, times in series.losses([row(**words)], list(before) or [row()])]

    def test_a_tenth(self):
        self.assertEqual(self.lost(seconds=2.16, processor_seconds=2.16), [])
        self.assertAlmostEqual(self.lost(seconds=2.24, processor_seconds=2.24)[0], 1.12)

    def test_only_what_both_clocks_lost(self):
        self.assertEqual(self.lost(seconds=3.0), [])
        self.assertEqual(self.lost(processor_seconds=3.0), [])
        self.assertEqual(len(self.lost(seconds=3.0, processor_seconds=math.nan)), 1)
        self.assertEqual(len(self.lost([row(processor_seconds=0.0)], seconds=3.0)), 1)

    def test_threads_that_wait_are_a_loss(self):
        self.assertEqual(self.lost([row(threads=2.0)], threads=2.0, seconds=3.0), [1.5])
        self.assertEqual(self.lost([row(threads=2.0)], threads=2.0, processor_seconds=3.0), [])

    def test_a_slower_machine_is_no_loss_and_a_faster_one_hides_none(self):
        slow = {"seconds": 3.0, "processor_seconds": 3.0}
        self.assertEqual(self.lost(memory_ns=150.0, **slow), [])
        self.assertEqual(self.lost(arithmetic_ns=12.0, **slow), [])
        self.assertEqual(self.lost(memory_ns=50.0, arithmetic_ns=4.0, **slow), [1.5])

    def test_only_the_same_work_on_the_same_machine(self):
        slow = {"seconds": 9.0, "processor_seconds": 9.0}
        for other in ({"machine": "two"}, {"java": "25"}, {"cores": 4.0}, {"threads": 2.0}, {"steps": 11.0},
                      {"case": "gas"}, {"way": "cold"}, {"engine": "horizon"}, {"spheres": 99.0}):
            self.assertEqual(self.lost(**slow, **other), [], other)

    def test_the_last_entry_counts(self):
        self.assertEqual(self.lost([row(), row(seconds=9.0, processor_seconds=9.0)], seconds=9.0,
                                   processor_seconds=9.0), [])

    def warned(self, *seconds, before=None):
        times = iter(seconds)

        def measure(folder):
            self.assertTrue(Path(folder).is_dir())
            value = next(times)
            return [row(seconds=value, processor_seconds=value)]

        with mock.patch.object(series, "yardstick", return_value=[8.0, 100.0]):
            here = {"machine": "one", "java": "17", "cores": 2.0}
            known = [row()] if before is None else before
            return list(series.warn_of_losses(here, known, [("ring", "warm", measure)], lambda line: None))

    def test_what_is_lost_twice_is_warned_of(self):
        warning, closing = self.warned(2.6, 2.5)
        self.assertIn("WARNING: ring, warm, serial on 1.0: 1.30 times as long as at abc", warning)
        self.assertEqual(closing, "1 compared with their last entry, 1 take a tenth longer")
        self.assertEqual(self.warned(2.6, 2.0), ["1 compared with their last entry, 0 take a tenth longer"])
        self.assertEqual(self.warned(2.1), ["1 compared with their last entry, 0 take a tenth longer"])
        self.assertIn("no entry of one, Java 17", self.warned(9.0, before=[])[0])


class File(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.path = Path(folder.name) / "series.csv"

    def test_what_is_appended_is_read(self):
        self.assertEqual(series.read(self.path), [])
        first, second = row(), row(commit="def+", memory_mib=123.0, seconds=0.0123456)
        series.append(self.path, [first])
        series.append(self.path, [second])
        read = series.read(self.path)
        self.assertEqual(self.path.read_text().count("commit"), 1)
        self.assertTrue(math.isnan(read[0]["memory_mib"]))
        self.assertEqual({**read[0], "memory_mib": 0}, {**first, "memory_mib": 0})
        self.assertEqual(read[1], second)

    def test_what_is_appended_begins_a_line(self):
        self.path.write_text("")
        series.append(self.path, [row()])
        self.path.write_text(self.path.read_text().rstrip("\n"))
        series.append(self.path, [row(case="gas")])
        self.assertEqual([r["case"] for r in series.read(self.path)], ["ring", "gas"])
        self.path.write_bytes(self.path.read_bytes().replace(b"gas", b"g\xe4s"))
        self.assertEqual(len(series.read(self.path)), 2)

    def test_a_commit_is_that_of_the_sources(self):
        said = {"status": "", "rev-parse": "abc\n"}
        with mock.patch.object(series, "words_of", lambda *c: mock.Mock(stdout=said[c[1]])):
            self.assertEqual(series.commit(), "abc")
            said["status"] = f" M bench/series.csv\n M {page.PAGE}\n M {page.PICTURE}\n"
            self.assertEqual(series.commit(), "abc")
            said["status"] += " M pom.xml\n"
            self.assertEqual(series.commit(), "abc+")

    def test_damage_is_named(self):
        series.append(self.path, [row()])
        whole = self.path.read_text()
        for text, words in (("", "no series"), (whole.replace("commit", "x"), "no series"),
                            (whole + "1,2\n", "line 3: has 2 cells; 18 are needed"),
                            (whole.replace(",3,2,", ",3,two,"), "line 2: could not convert"),
                            (whole.replace(",3,2,", ",3,,"), "nan s is no time"),
                            (whole.replace(",3,2,", ",3,-2,"), "-2.0 s is no time"),
                            (whole.replace(",3,2,", ",3,inf,"), "inf s is no time"),
                            (whole.replace(",one,2,", ",one,,"), "line 2: cores is nan")):
            self.path.write_text(text)
            with self.assertRaisesRegex(series.SeriesError, words):
                series.read(self.path)


class Program(unittest.TestCase):
    """With a script in place of daphnis."""

    SCRIPT = """#!/bin/sh
case $1 in
scenarios) printf 'elastic-gas  a gas\\nnew-one  another\\n' ;;
bench) while [ "$1" != --out ]; do shift; done; mkdir -p "$2"
printf 'scenario,spheres,engine,threads,steps,collisions,round,seconds,processor_seconds,java\\n' >"$2/bench.csv"
printf 's,8,serial,1,4,2,1,.5,.6,17\\ns,8,serial,1,4,2,2,.4,.5,17\\n' >>"$2/bench.csv"
printf 's,8,horizon,2,4,2,1,.3,.4,17\\n' >>"$2/bench.csv" ;;
run) [ "$2" = new-one ] && { echo "new-one: no" >&2; exit 2; }
mkdir -p "$4"
echo '{"engine": "horizon", "threads": 2, "particles": 8, "steps": 4, "collisions": 2}' >"$4/summary.json" ;;
esac
"""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)
        program = self.folder / "daphnis"
        program.write_text(self.SCRIPT)
        program.chmod(0o755)
        for name, value in (("PROGRAM", str(program)), ("yardstick", lambda: [8.0, 100.0])):
            patch = mock.patch.object(series, name, value)
            patch.start()
            self.addCleanup(patch.stop)

    def test_all_built_in_scenarios_take_part(self):
        cases = [(name, way) for name, way, _ in series.suite(False)]
        for case in (("figure-1", "warm"), ("gas-1e6", "warm"), ("new-one", "warm"), ("new-one", "cold")):
            self.assertIn(case, cases)
        short = [(name, way) for name, way, _ in series.suite(True)]
        self.assertLess(set(short), set(cases))
        self.assertIn(("elastic-gas", "cold"), short)

    def test_steps_are_given_for_scenarios_that_there_are(self):
        scenarios = series.ROOT / "core" / "src" / "main" / "resources" / "daphnis" / "scenarios"
        self.assertLessEqual(set(series.BUILT_IN), {path.stem for path in scenarios.glob("*.json")})

    def test_the_fastest_round_counts(self):
        serial, horizon = series.warm("ring", ["ring-patch"], 4, self.folder)
        self.assertEqual([serial[k] for k in ("seconds", "processor_seconds", "rounds", "spheres")], [.4, .5, 2, 8])
        self.assertEqual((horizon["engine"], horizon["threads"], horizon["seconds"]), ("horizon", 2, .3))

    def test_a_whole_run(self):
        run = series.cold("elastic-gas", self.folder)
        self.assertEqual((run["rounds"], run["steps"], run["way"]), (3, 4, "cold"))
        self.assertTrue(0 < run["seconds"] < 60 and run["memory_mib"] > 0)
        with self.assertRaisesRegex(series.SeriesError, "daphnis run new-one ended with 2: new-one: no"):
            series.cold("new-one", self.folder)

    def test_from_the_command_line(self):
        file = self.folder / "series.csv"
        with contextlib.redirect_stderr(io.StringIO()):
            series.main(["--file", str(file), "--only", "elastic-gas"])
        self.assertEqual([(r["way"], r["engine"]) for r in series.read(file)],
                         [("warm", "serial"), ("warm", "horizon"), ("cold", "horizon")])
        with self.assertRaisesRegex(series.SeriesError, "no case ring-pach"):
            series.main(["--file", str(file), "--only", "ring-pach"])


class Page(unittest.TestCase):
    ROWS = [row(), row(date="2026-11-02 11:00", commit="def", seconds=3.0),
            row(case="<gas>", way="cold", engine="horizon"),
            row(machine="two", engine="horizon", threads=2.0, memory_mib=99.0)]

    def test_the_picture_has_each_case_and_its_marks(self):
        picture = xml.fromstring(page.picture(self.ROWS))
        words = [e.text for e in picture.iter("{http://www.w3.org/2000/svg}text")]
        for word in ("ring", "<gas>", "one, 2 cores, Java 17", "two, 2 cores, Java 17", "cold, as typed"):
            self.assertIn(word, words)
        marks = [e for e in picture.iter() if e.get("class") == "mark"]
        self.assertEqual(len(marks), len(self.ROWS) + len(page.LINES))
        lines = [e for e in picture.iter() if e.tag.endswith("polyline")]
        self.assertEqual(len(lines), 1)
        # The second entry takes 1.5 times as long as the first, on an axis from 0 to 2 that is 90 high.
        heights = [float(point.split(",")[1]) for point in lines[0].get("points").split()]
        self.assertAlmostEqual(heights[0] - heights[1], 90 * 0.25, delta=0.11)

    def test_the_table_has_the_last_entry_and_its_ratio(self):
        text = page.text(self.ROWS)
        self.assertIn("| ring | warm | serial, 1 | 100 | 10 | 3 | 2 | 3000 |  | 1.50 |", text)
        self.assertIn("| 99 |  |", text)

    def test_the_head_has_the_span_and_unknown_times_are_blank(self):
        self.assertIn("first entry, 2026-11-01 to 2026-11-02<", page.picture(self.ROWS[:2]))
        self.assertIn("first entry, 2026-11-01<", page.picture(self.ROWS[:1]))
        self.assertIn("| 2 |  | 2000 |", page.text([row(processor_seconds=math.nan)]))

    def test_axes_end_at_round_numbers(self):
        self.assertEqual([page.nice(v) for v in (0.03, 1, 1.1, 2.1, 7, 73)], [0.05, 1, 2, 5, 10, 100])


if __name__ == "__main__":
    unittest.main()
