"""The page of bench/series.csv: a chart for each case over all entries, and a table of the last ones."""

from html import escape

PAGE = "docs/reference/benchmarks.md"
PICTURE = "docs/images/benchmarks.svg"

WIDTH, HEIGHT, ACROSS = 240, 132, 4
INNER = (34, 26, 14, 16)  # left, top, right, bottom
HEAD = 44

# Each line's way: words, colour by day and by night, and the shape of its marks, for those who see no colours.
LINES = {
    ("cold", ""): ("cold, as typed", "#b5460f", "#ff9d5c", "square"),
    ("warm", "serial"): ("warm: serial", "#6b6b6b", "#a8a8a8", "circle"),
    ("warm", "horizon-1"): ("warm: horizon, one thread", "#1f6fb2", "#6cb6f5", "circle"),
    ("warm", "horizon"): ("warm: horizon, all threads", "#2b7a3d", "#6fce86", "diamond"),
}


def line_of(row):
    if row["way"] == "cold":
        return "cold", ""
    if row["engine"] == "horizon" and row["threads"] == 1:
        return "warm", "horizon-1"
    return "warm", row["engine"]


def machine_of(row):
    return row["machine"], int(row["cores"]), row["java"]


def significant(value):
    return f"{value:.3g}" if value < 1000 else f"{value:.0f}"


def draw(rows, root):
    """Writes the page and its picture below [root]."""
    (root / PICTURE).write_text(picture(rows), encoding="utf-8", newline="\n")
    (root / PAGE).write_text(text(rows), encoding="utf-8", newline="\n")


def ordered(items):
    return list(dict.fromkeys(items))


def picture(rows):
    """All machines one below another; times over those of the first entry of each line, entries in their order."""
    parts, y = [], 0
    for machine in ordered(map(machine_of, rows)):
        own = [row for row in rows if machine_of(row) == machine]
        entries = ordered((row["date"], row["commit"]) for row in own)
        dates = [date for date, _ in entries]
        name = f"{machine[0]}, {machine[1]} cores, Java {machine[2]}"
        span = dates[0][:10] if dates[0][:10] == dates[-1][:10] else f"{dates[0][:10]} to {dates[-1][:10]}"
        parts.append(f'<text class="head" x="8" y="{y + 18}">{escape(name)}</text>')
        parts.append(f'<text x="8" y="{y + 34}">time over that of the first entry, {span}</text>')
        y += HEAD
        days = {}
        for row in own:
            days.setdefault((row["date"][:10], row["commit"]), len(days))
        cases = ordered(row["case"] for row in own)
        for k, case in enumerate(cases):
            x0, y0 = (k % ACROSS) * WIDTH, y + (k // ACROSS) * HEIGHT
            parts.append(panel(case, [row for row in own if row["case"] == case], days, x0, y0))
        y += -(-len(cases) // ACROSS) * HEIGHT + 8
    legend, x = [], 8
    for kind, (words, *_rest) in LINES.items():
        legend.append(mark(kind, x + 5, y + 12) + f'<text x="{x + 14}" y="{y + 16}">{escape(words)}</text>')
        x += 22 + 6.4 * len(words)
    total = y + 28
    return "\n".join([
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH * ACROSS} {total}" '
        f'width="{WIDTH * ACROSS}" height="{total}" role="img" aria-label="time of each case over that of its first entry">',
        style(), f'<rect class="paper" width="{WIDTH * ACROSS}" height="{total}"/>', *parts, *legend, "</svg>", "",
    ])


def style():
    def colours(night):
        return " ".join(f".l{k} {{ --c: {c[1 + night]} }}" for k, c in enumerate(LINES.values()))

    return (
        "<style>text { font: 11px sans-serif; fill: #333 } .head { font-weight: bold; font-size: 13px } "
        ".paper { fill: #fff } .axis { stroke: #bbb; fill: none } .grid { stroke: #e6e6e6; fill: none } "
        "polyline { fill: none; stroke: var(--c); stroke-width: 1.5 } .mark { fill: var(--c) } " + colours(0) +
        " @media (prefers-color-scheme: dark) { text { fill: #ddd } .paper { fill: #16181c } .axis { stroke: #666 } "
        ".grid { stroke: #2c2f36 } " + colours(1) + " }</style>"
    )


def mark(kind, x, y):
    group, shape = list(LINES).index(kind), LINES[kind][3]
    r = 3.2
    if shape == "square":
        body = f'<rect class="mark" x="{x - r:.1f}" y="{y - r:.1f}" width="{2 * r}" height="{2 * r}"/>'
    elif shape == "diamond":
        d = 1.4 * r
        body = f'<path class="mark" d="M{x:.1f} {y - d:.1f}l{d:.1f} {d:.1f}l{-d:.1f} {d:.1f}l{-d:.1f} {-d:.1f}z"/>'
    else:
        body = f'<circle class="mark" cx="{x:.1f}" cy="{y:.1f}" r="{r}"/>'
    return f'<g class="l{group}">{body}</g>'


def panel(case, rows, days, x0, y0):
    left, top, right, bottom = INNER
    first = {}
    for row in rows:
        first.setdefault(kind_of(row), row["seconds"])
    most = nice(max(2.0, *(row["seconds"] / first[kind_of(row)] for row in rows)))
    width, height = WIDTH - left - right, HEIGHT - top - bottom
    last = max(days.values())

    def place(row):
        k = days[row["date"][:10], row["commit"]]
        x = x0 + left + (width * k / last if last else width / 2)
        return x, y0 + top + height * (1 - row["seconds"] / first[kind_of(row)] / most)

    parts = [f'<text x="{x0 + left}" y="{y0 + 15}">{escape(case)}</text>']
    for part in (0, 0.5, 1):
        y = y0 + top + height * (1 - part)
        parts.append(f'<path class="{"grid" if part else "axis"}" d="M{x0 + left} {y:.1f}h{width}"/>')
        parts.append(f'<text text-anchor="end" x="{x0 + left - 4}" y="{y + 4:.1f}">{significant(most * part)}</text>')
    for number, kind in enumerate(LINES):
        own = sorted((row for row in rows if line_of(row) == kind), key=lambda row: row["date"])
        if not own:
            continue
        points = [place(row) for row in own]
        if len(points) > 1:
            path = " ".join(f"{x:.1f},{y:.1f}" for x, y in points)
            parts.append(f'<g class="l{number}"><polyline points="{path}"/></g>')
        parts += [mark(kind, x, y) for x, y in points]
    return "\n".join(parts)


def nice(value):
    """The next of 1, 2, 5, 10, … at or above."""
    power = 1.0
    while power * 10 <= value:
        power *= 10
    while power > value:
        power /= 10
    return next(power * k for k in (1, 2, 5, 10) if power * k >= value)


def text(rows):
    lines = [
        "# Benchmarks as a series", "",
        "<!-- Written by tools/series/series.py from bench/series.csv. -->", "",
        "Times of a fixed suite from commit to commit. *Cold* is a whole `./daphnis run`, as it is typed; *warm* is",
        "the steps again and again in one process (`./daphnis bench`). The fastest round counts. What others do on",
        "such a machine changes times by a third: a step in all charts is the machine, not the program.",
        "",
        "```sh",
        "python3 tools/series/series.py           # measures all on a machine that does nothing else, twenty minutes",
        "python3 tools/series/series.py --loss    # warns of what takes a tenth longer than in the last entry",
        "```", "",
        "`./check --long` does the latter. Before each case work that never changes is timed, in the arithmetic unit",
        "and in memory; by how much it takes longer than it did, a case may too.", "",
        f"![Time of each case over that of its first entry](../{PICTURE.removeprefix('docs/')})", "",
    ]
    for machine in ordered(map(machine_of, rows)):
        own = [row for row in rows if machine_of(row) == machine]
        commits = ordered(row["commit"] for row in own)
        lines += [
            f"## {machine[0]}, {machine[1]} cores, Java {machine[2]}", "",
            f"Last entry: {own[-1]['date']}, commit `{own[-1]['commit']}`; entries: {len(commits)}.", "",
            "| case | way | engine, threads | spheres | steps | seconds | of processors | µs a sphere and step "
            "| MiB | over the entry before |",
            "|---|---|---|--:|--:|--:|--:|--:|--:|--:|",
        ]
        for row in last_rows(own):
            before = [r for r in own if kind_of(r) == kind_of(row) and r is not row]
            ratio = f"{row['seconds'] / before[-1]['seconds']:.2f}" if before else ""
            per_step = 1e6 * row["seconds"] / max(1, row["spheres"] * row["steps"])
            memory = f"{row['memory_mib']:.0f}" if row["memory_mib"] == row["memory_mib"] else ""
            processors = row["processor_seconds"]
            of_processors = significant(processors) if processors == processors else ""
            lines.append(
                f"| {row['case']} | {row['way']} | {row['engine']}, {row['threads']:.0f} | {row['spheres']:.0f} | "
                f"{row['steps']:.0f} | {significant(row['seconds'])} | {of_processors} | "
                f"{significant(per_step)} | {memory} | {ratio} |"
            )
        lines.append("")
    return "\n".join(lines)


def kind_of(row):
    return row["case"], row["way"], row["engine"], row["threads"], row["spheres"], row["steps"]


def last_rows(rows):
    return list({kind_of(row): row for row in rows}.values())
