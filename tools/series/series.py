#!/usr/bin/env python3
"""How fast daphnis is from commit to commit: one fixed suite, one row a case in bench/series.csv, one page.

    python3 tools/series/series.py              measures all of it, adds it to the file, draws the page anew
    python3 tools/series/series.py --loss       measures the short part, warns of what takes a tenth longer than in the
                                                last entry of this machine and Java; adds nothing
    python3 tools/series/series.py --page       only draws the page
    … --only figure-1,ring-patch                only these cases

Warm is a scenario's steps over and over in one process, engines in turns (`daphnis bench`); cold is a whole
`daphnis run` as a user types it. The machine should do nothing else: twenty minutes for all, a third of that for the
short part. DAPHNIS names another program, JAVA_HOME another Java. Needs Python 3.10 and nothing else.
"""

import argparse
import csv
import datetime
import json
import math
import os
import platform
import re
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import page

ROOT = Path(__file__).resolve().parents[2]
FILE = ROOT / "bench" / "series.csv"
PROGRAM = os.environ.get("DAPHNIS") or str(ROOT / "daphnis")

COLUMNS = (
    "date commit machine cores java case way engine threads spheres steps collisions rounds seconds "
    "processor_seconds memory_mib arithmetic_ns memory_ns"
).split()
NUMBERS = COLUMNS[8:] + ["cores"]
# What a system need not tell.
UNKNOWN = ("processor_seconds", "memory_mib")

# A run is repeated until it has had so many seconds, so many times at most; the fastest counts.
ENOUGH = 10.0
MOST = 3
LOSS = 1.1


def gas(count):
    """The words for the elastic gas of so many spheres, at its filling factor of 0.1."""
    edge = f"{(count * math.pi / 6 / 0.1) ** (1 / 3):.4f}"
    return ["elastic-gas", "--set", f"particles.count={count}", "--set", f"box.lengths=[{edge},{edge},{edge}]"]


# What is timed warm: words of `daphnis bench`, and the steps of a round, None for the whole scenario.
LARGE = {
    "figure-1": (["paper-figure-1"], None),
    "figure-2": (["paper-figure-2"], None),
    "figure-3": (["paper-figure-3"], None),
    "ring-1e5": (["ring-patch", "--set", "box.lengths=[1200,1200,20]"], 60),
    "gas-1e4": (gas(10_000), 100),
    "gas-1e5": (gas(100_000), 30),
    "gas-1e6": (gas(1_000_000), 5),
}

# Steps of a round of the built-in scenarios, about two seconds each; a new one has so many as STEPS says.
STEPS = 200
BUILT_IN = {
    "accretion": 200, "cooling-gas": None, "crystal": 500, "driven-gas": 200, "drum": 2000, "effusion": 2000,
    "elastic-gas": 100, "glass": 100, "hard-discs": None, "mixture": 1000, "moonlet": 50, "moonlet-walk": 100,
    "overstability": 1000, "perturbed-ring": 2000, "pouring": 1000, "ring-patch": 2000, "rough-gas": None,
    "rough-ring": 1000, "satellite-wake": 200, "self-gravity-wakes": 200, "shear-cell": 1000, "shepherds": 500,
    "square-well": 200, "vibrated-bed": 2000, "wet-grains": 500,
}

# What --loss measures cold: those that are done in some seconds.
SHORT = ("elastic-gas", "cooling-gas", "driven-gas", "ring-patch", "shear-cell", "hard-discs", "drum", "square-well")


class SeriesError(Exception):
    """What ends the program with one line."""


def words_of(*command):
    try:
        return subprocess.run(command, cwd=ROOT, check=True, capture_output=True, text=True)
    except FileNotFoundError:
        raise SeriesError(f"{command[0]} is not there") from None
    except subprocess.CalledProcessError as e:
        said = (e.stderr or e.stdout).strip()[-400:]
        raise SeriesError(f"{' '.join(command)} ended with {e.returncode}: {said}") from None


def machine():
    """The processor in words, as the system has them."""
    name = ""
    if Path("/proc/cpuinfo").exists():
        found = re.search(r"^model name\s*:\s*(.*)$", Path("/proc/cpuinfo").read_text(), re.M)
        name = found.group(1) if found else ""
    elif platform.system() == "Darwin":
        name = words_of("sysctl", "-n", "machdep.cpu.brand_string").stdout
    return " ".join((name or platform.processor() or platform.machine()).replace(",", " ").split())


def java():
    home = os.environ.get("JAVA_HOME")
    return str(Path(home) / "bin" / "java") if home else "java"


def java_version():
    found = re.search(r'version "([^"]+)"', words_of(java(), "-version").stderr)
    if not found:
        raise SeriesError(f"{java()} -version says no version")
    return found.group(1)


def commit():
    """The commit in twelve digits, with a + where files differ from it."""
    changed = words_of("git", "status", "--porcelain", "--untracked-files=no").stdout.splitlines()
    own = ("bench/series.csv", page.PAGE, page.PICTURE)
    changed = [line for line in changed if not line.endswith(own)]
    return words_of("git", "rev-parse", "--short=12", "HEAD").stdout.strip() + ("+" if changed else "")


def yardstick():
    """Nanoseconds of a step of work that never changes: in the arithmetic unit, in memory."""
    return [float(word) for word in words_of(java(), str(Path(__file__).with_name("Yardstick.java"))).stdout.split()]


def warm(case, words, steps, folder):
    """Rows of `daphnis bench`: the specification, the default engine on one thread and on all."""
    cores = len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count()
    out = Path(folder) / "bench"
    command = [PROGRAM, "bench", *words, "--engines", "serial,horizon", "--threads", f"1,{cores}", "--quiet",
               "--rounds", str(MOST), "--out", str(out)]
    words_of(*command, *(["--steps", str(steps)] if steps else []))
    rounds = {}
    if not (out / "bench.csv").exists():
        raise SeriesError(f"daphnis bench {words[0]} left no bench.csv")
    with open(out / "bench.csv", newline="", encoding="utf-8") as file:
        for row in csv.DictReader(file):
            rounds.setdefault((row["engine"], int(row["threads"])), []).append(row)
    for (engine, threads), all_rounds in rounds.items():
        best = min(all_rounds, key=lambda row: float(row["seconds"]))
        yield {
            "case": case, "way": "warm", "engine": engine, "threads": threads, "rounds": len(all_rounds),
            "memory_mib": math.nan, **{k: float(best[k] or "nan") for k in
                                       ("spheres", "steps", "collisions", "seconds", "processor_seconds")},
        }


def cold(case, folder):
    """The row of whole runs as they are typed, of which the fastest counts."""
    best, taken, rounds = None, 0.0, 0
    while rounds < MOST and taken < ENOUGH:
        out = Path(folder) / f"run-{rounds}"
        begin = time.monotonic()
        child = subprocess.Popen([PROGRAM, "run", case, "--out", str(out), "--quiet"], cwd=ROOT,
                                 stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
        complaint = child.stderr.read()
        _, status, used = os.wait4(child.pid, 0)
        child.returncode = os.waitstatus_to_exitcode(status)
        child.stderr.close()
        if child.returncode != 0:
            raise SeriesError(f"daphnis run {case} ended with {child.returncode}: {complaint.strip()[-400:]}")
        seconds = time.monotonic() - begin
        summary = json.loads((out / "summary.json").read_text())
        taken, rounds = taken + seconds, rounds + 1
        if best is None or seconds < best["seconds"]:
            per_mib = 1 << 20 if sys.platform == "darwin" else 1 << 10
            best = {
                "case": case, "way": "cold", "engine": summary["engine"], "threads": summary["threads"],
                "spheres": summary["particles"], "steps": summary["steps"], "collisions": summary["collisions"],
                "seconds": seconds, "processor_seconds": used.ru_utime + used.ru_stime,
                "memory_mib": used.ru_maxrss / per_mib,
            }
    return {**best, "rounds": rounds}


def built_in():
    return [line.split()[0] for line in words_of(PROGRAM, "scenarios").stdout.splitlines() if line.strip()]


def suite(short):
    """Names of cases and what measures each, in a folder for its files."""
    for case, (words, steps) in LARGE.items():
        yield case, "warm", lambda folder, c=case, w=words, s=steps: warm(c, w, s, folder)
    for case in built_in():
        if not short and not case.startswith("paper-figure"):
            steps = BUILT_IN.get(case, STEPS)
            yield case, "warm", lambda folder, c=case, s=steps: warm(c, [c], s, folder)
        if not short or case in SHORT:
            yield case, "cold", lambda folder, c=case: [cold(c, folder)]


def measured(cases, say):
    """Rows of all [cases]; beside each what the yardstick said just before."""
    for case, way, measure in cases:
        arithmetic, memory = yardstick()
        with tempfile.TemporaryDirectory(prefix="daphnis-series.") as folder:
            for row in measure(folder):
                row.update(arithmetic_ns=arithmetic, memory_ns=memory)
                say(f"{case}, {way}, {row['engine']} on {row['threads']}: {row['seconds']:.4g} s")
                yield row


def read(path):
    """Rows of the file, numbers as numbers."""
    if not path.exists():
        return []
    rows = []
    with open(path, newline="", encoding="utf-8", errors="replace") as file:
        lines = csv.reader(file)
        if next(lines, None) != COLUMNS:
            raise SeriesError(f"{path}: no series; its first line must be {','.join(COLUMNS)}")
        for number, cells in enumerate(lines, 2):
            if len(cells) != len(COLUMNS):
                raise SeriesError(f"{path}: line {number}: has {len(cells)} cells; {len(COLUMNS)} are needed")
            row = dict(zip(COLUMNS, cells))
            try:
                row.update((k, float(row[k] or "nan")) for k in NUMBERS)
            except ValueError as e:
                raise SeriesError(f"{path}: line {number}: {e}") from None
            if not 0 < row["seconds"] < math.inf:
                raise SeriesError(f"{path}: line {number}: {row['seconds']} s is no time")
            if bad := [k for k in NUMBERS if k not in UNKNOWN and not 0 <= row[k] < math.inf]:
                raise SeriesError(f"{path}: line {number}: {bad[0]} is {row[bad[0]]}")
            rows.append(row)
    return rows


def cell(value):
    if isinstance(value, float):
        return "" if math.isnan(value) else f"{value:.6g}" if value != int(value) else str(int(value))
    return str(value)


def append(path, rows):
    before = path.read_bytes() if path.exists() else b""
    is_new = not before
    with open(path, "a", newline="", encoding="utf-8") as file:
        if before and not before.endswith(b"\n"):
            file.write("\n")
        writer = csv.writer(file, lineterminator="\n")
        if is_new:
            writer.writerow(COLUMNS)
        writer.writerows([[cell(row[k]) for k in COLUMNS] for row in rows])


def key(row):
    """The same work, done the same way, on the same kind of machine with the same Java."""
    return tuple(str(row[k]) for k in ("machine", "java", "case", "way", "engine")) + tuple(
        float(row[k]) for k in ("cores", "threads", "spheres", "steps"))


def last_entries(rows):
    """The last row of each key."""
    return {key(row): row for row in rows}


def slower(new, old):
    """How many times as long [new] takes, on a machine that were as fast as it was for [old].

    On one thread real time and that of the processors, whichever lost less; the arithmetic unit or memory, whichever
    lost more: what others do on the machine then passes for a loss as seldom as it can. On several threads real time,
    or threads that wait would be no loss.
    """
    of_machine = max(new[k] / old[k] for k in ("arithmetic_ns", "memory_ns"))
    clocks = ("seconds", "processor_seconds") if new["threads"] == 1 else ("seconds",)
    times = [new[k] / old[k] for k in clocks if new[k] > 0 and old[k] > 0]
    return min(times) / max(1.0, of_machine)


def losses(rows, before):
    """Pairs of a row that takes a tenth longer and how many times as long it takes."""
    known = last_entries(before)
    pairs = [(row, slower(row, known[key(row)])) for row in rows if key(row) in known]
    return [(row, times) for row, times in pairs if times > LOSS]


def warn_of_losses(here, before, cases, say):
    """Measures what seems to have lost once more; lines that say what did, and how much could be compared."""
    rows = [{**here, **row} for row in measured(cases, say)]
    known = last_entries(before)
    compared = [row for row in rows if key(row) in known]
    if not compared:
        yield f"no entry of {here['machine']}, Java {here['java']}, to compare with"
        return
    lost = losses(rows, before)
    again = {(row["case"], row["way"]) for row, _ in lost}
    once_more = [{**here, **row} for row in measured((c for c in cases if (c[0], c[1]) in again), say)]
    both = {key(row) for row, _ in losses(once_more, before)}
    lost = [(row, times) for row, times in lost if key(row) in both]
    for row, times in lost:
        old = known[key(row)]
        yield (f"WARNING: {row['case']}, {row['way']}, {row['engine']} on {row['threads']}: {times:.2f} times as long "
               f"as at {old['commit']} ({old['date']})")
    yield f"{len(compared)} compared with their last entry, {len(lost)} take a tenth longer"


def main(words):
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--loss", action="store_true")
    parser.add_argument("--page", action="store_true")
    parser.add_argument("--only", default="")
    parser.add_argument("--file", type=Path, default=FILE)
    asked = parser.parse_args(words)
    before = read(asked.file)
    if not asked.page:
        only = set(filter(None, asked.only.split(",")))
        cases = [case for case in suite(asked.loss) if not only or case[0] in only]
        if unknown := only - {case[0] for case in cases}:
            raise SeriesError(f"no case {', '.join(sorted(unknown))}")
        today = datetime.datetime.now(datetime.timezone.utc).strftime("%Y-%m-%d %H:%M")
        here = {"date": today, "commit": commit(), "machine": machine(), "cores": os.cpu_count(),
                "java": java_version()}

        def say(line):
            print(line, file=sys.stderr, flush=True)

        if asked.loss:
            print("\n".join(warn_of_losses(here, before, cases, say)))
            return
        for row in measured(cases, say):
            append(asked.file, [{**here, **row}])
    if asked.file == FILE:
        page.draw(read(FILE), ROOT)


if __name__ == "__main__":
    try:
        main(sys.argv[1:])
    except SeriesError as e:
        sys.exit(f"series: {e}")
    except KeyboardInterrupt:
        sys.exit(130)
