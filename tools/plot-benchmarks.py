#!/usr/bin/env python3
"""Table and plots from JMH results of AdvanceBenchmark (docs/performance.md).

    python3 tools/plot-benchmarks.py bench/results/MACHINE/engines.json [bench/results/MACHINE/sizes.json docs/images]

Prints a Markdown table; with a folder, writes engines.svg (time a step against threads) and sizes.svg (cost against N) there. Needs Matplotlib for the plots.
"""
import json
import statistics
import sys

STEPS = {"PAPER_1": 300, "PAPER_2": 300, "PAPER_3": 100, "DENSE": 20, "CLUMPED": 20, "GAS_1E4": 100, "GAS_1E5": 20, "GAS_1E6": 5}
SIZES = {"GAS_1E4": 1e4, "GAS_1E5": 1e5, "GAS_1E6": 1e6}
NAMES = {"PAPER_1": "figure 1", "PAPER_2": "figure 2", "PAPER_3": "figure 3", "DENSE": "φ = 0.45", "CLUMPED": "clumped"}
ENGINES = {"SERIAL": "serial", "ISLANDS": "islands", "THREAD_POOL": "thread-pool", "ACTORS": "actors", "PEKKO": "pekko"}


def read(path):
    """(workload, engine, threads) -> times of an operation in ms, collisions an operation"""
    rows = {}
    for run in json.load(open(path)):
        p = run["params"]
        times = run["primaryMetric"]["rawData"][0]
        collisions = run["secondaryMetrics"]["collisions"]["score"] / len(times)
        rows[p["workload"], p["engine"], int(p.get("threads", 1))] = times, collisions
    return rows


def table(rows):
    print("| workload | engine | threads | ms a step | best | µs a collision | against serial |")
    print("|---|---|---|---|---|---|---|")
    for workload in NAMES:
        base = [t for (w, e, n), (t, c) in rows.items() if w == workload and e == "SERIAL"]
        base = statistics.median(sum(base, [])) if base else None
        for engine in ENGINES:
            for threads in (1, 2):
                if engine == "SERIAL" and threads > 1 or (workload, engine, threads) not in rows:
                    continue
                times, collisions = rows[workload, engine, threads]
                if engine == "SERIAL" and (workload, engine, 2) in rows:
                    times = times + rows[workload, engine, 2][0]
                m = statistics.median(times)
                print(f"| {NAMES[workload]} | {ENGINES[engine]} | {threads} | {m / STEPS[workload]:.1f} | {min(times) / STEPS[workload]:.1f} "
                      f"| {m * 1e3 / collisions:.2f} | {base / m:.2f} × |")


def plots(rows, sizes, folder):
    import matplotlib
    matplotlib.use("svg")
    import matplotlib.pyplot as plt
    plt.rcParams["svg.hashsalt"] = "daphnis"
    colors = {"SERIAL": "0.4", "ISLANDS": "#0072b2", "THREAD_POOL": "#d55e00", "ACTORS": "#009e73", "PEKKO": "#cc79a7"}
    workloads = [w for w in NAMES if any(k[0] == w for k in rows)]
    figure, axes = plt.subplots(1, len(workloads), figsize=(2.3 * len(workloads), 3.2), layout="constrained")
    for axis, workload in zip(axes, workloads):
        for engine in ENGINES:
            points = sorted((n, statistics.median(t) / STEPS[workload]) for (w, e, n), (t, c) in rows.items() if w == workload and e == engine)
            if engine == "SERIAL":
                axis.axhline(statistics.median([p[1] for p in points]), color=colors[engine], ls="--", label="serial")
            else:
                axis.plot(*zip(*points), "o-", color=colors[engine], label=ENGINES[engine])
        axis.set_title(NAMES[workload], fontsize=10)
        axis.set_xlabel("threads")
        axis.set_xticks([1, 2])
        axis.set_xlim(0.8, 2.2)
        axis.set_ylim(bottom=0)
    axes[0].set_ylabel("ms a step")
    figure.legend(*axes[0].get_legend_handles_labels(), loc="outside lower center", ncols=5, frameon=False, fontsize=9)
    figure.savefig(f"{folder}/engines.svg", metadata={"Date": None})
    figure, axis = plt.subplots(figsize=(5, 3.4), layout="constrained")
    for engine, threads, style in (("SERIAL", 1, "o--"), ("ISLANDS", 1, "o:"), ("ISLANDS", 2, "o-")):
        points = sorted((SIZES[w], statistics.median(t) * 1e3 / c) for (w, e, n), (t, c) in sizes.items() if w in SIZES and e == engine and n == threads)
        label = ENGINES[engine] + ("" if engine == "SERIAL" else f", {threads} thread" + "s" * (threads > 1))
        axis.plot(*zip(*points), style, color=colors[engine], label=label)
    axis.set_xscale("log")
    axis.set_ylim(bottom=0)
    axis.set_xlabel("spheres")
    axis.set_ylabel("µs a collision (φ = 0.1, dt = 0.1 τ)")
    axis.legend(frameon=False)
    figure.savefig(f"{folder}/sizes.svg", metadata={"Date": None})


results = read(sys.argv[1])
table(results)
if len(sys.argv) > 3:
    plots(results, read(sys.argv[2]), sys.argv[3])
