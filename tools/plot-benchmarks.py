#!/usr/bin/env python3
"""The plots of docs/performance.md: time a step against threads, cost against N.

    python3 tools/plot-benchmarks.py bench/results/MACHINE/compare.md bench/results/MACHINE/sizes.json docs/images

The first file is what daphnis.bench.CompareKt printed, the second the JMH results of AdvanceBenchmark with GAS_1E4, GAS_1E5, GAS_1E6. Needs Matplotlib.
"""
import json
import statistics
import sys

import matplotlib

matplotlib.use("svg")
import matplotlib.pyplot as plt  # noqa: E402

plt.rcParams["svg.hashsalt"] = "daphnis"
SIZES = {"GAS_1E4": 1e4, "GAS_1E5": 1e5, "GAS_1E6": 1e6}
NAMES = {"PAPER_1": "figure 1", "PAPER_2": "figure 2", "PAPER_3": "figure 3", "DENSE": "φ = 0.45", "CLUMPED": "clumped"}
COLORS = {"serial": "0.4", "islands": "#0072b2", "bricks": "#e69f00", "thread-pool": "#d55e00", "actors": "#009e73", "pekko": "#cc79a7"}

rows = [[c.strip() for c in line.strip().strip("|").split("|")] for line in open(sys.argv[1]) if line.startswith("|")]
figure, axes = plt.subplots(1, len(NAMES), figsize=(2.3 * len(NAMES), 3.3), layout="constrained")
for axis, workload in zip(axes, NAMES):
    for engine, color in COLORS.items():
        points = [(int(r[2]), float(r[3])) for r in rows if r[0] == workload and r[1] == engine]
        if engine == "serial":
            axis.axhline(points[0][1], color=color, ls="--", label=engine)
        elif points:
            axis.plot(*zip(*points), "o-", color=color, label=engine)
    axis.set_title(NAMES[workload], fontsize=10)
    axis.set_xlabel("threads")
    axis.set_xticks([1, 2])
    axis.set_xlim(0.8, 2.2)
    axis.set_ylim(bottom=0)
axes[0].set_ylabel("ms a step")
figure.legend(*axes[0].get_legend_handles_labels(), loc="outside lower center", ncols=5, frameon=False, fontsize=9)
figure.savefig(f"{sys.argv[3]}/engines.svg", metadata={"Date": None})

figure, axis = plt.subplots(figsize=(5, 3.4), layout="constrained")
runs = json.load(open(sys.argv[2]))
for engine, threads, style in (("serial", 1, "o--"), ("islands", 1, "o:"), ("islands", 2, "o-")):
    points = []
    for run in runs:
        p = run["params"]
        times = run["primaryMetric"]["rawData"][0]
        collisions = run["secondaryMetrics"]["collisions"]["score"] / len(times)
        if p["engine"].lower() == engine and int(p["threads"]) == threads:
            points.append((SIZES[p["workload"]], min(times) * 1e3 / collisions))
    axis.plot(*zip(*sorted(points)), style, color=COLORS[engine], label=f"{engine}, {threads} thread" + "s" * (threads > 1))
axis.set_xscale("log")
axis.set_ylim(bottom=0)
axis.set_xlabel("spheres")
axis.set_ylabel("µs a collision (φ = 0.1, dt = 0.1 τ)")
axis.legend(frameon=False)
figure.savefig(f"{sys.argv[3]}/sizes.svg", metadata={"Date": None})
