"""Analyses as tables, numbers and pictures."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest

import daphnis_sim as daphnis


@pytest.fixture(scope="module")
def report(ring: daphnis.Run, tmp_path_factory: pytest.TempPathFactory) -> daphnis.Report:
    return ring.analyze(out=tmp_path_factory.mktemp("report"), from_=0.0, frames=4)


def test_numbers_are_those_of_the_page(report: daphnis.Report, ring: daphnis.Run) -> None:
    numbers = report.numbers
    assert list(numbers.columns[:2]) == ["value", "standard_error"]
    assert numbers["value"]["optical_depth"] == report["optical_depth"]
    state = ring.last()
    depth = np.pi * (state.radius**2).sum() / (state.box[0] * state.box[1])
    assert report["optical_depth"] == pytest.approx(depth, rel=1e-12)
    assert numbers["unit"]["velocity_dispersion"]
    assert numbers["standard_error"].isna().any()
    assert report.html.is_file() and "optical_depth" in report._repr_html_()
    with pytest.raises(KeyError, match="no such number in this report; there are"):
        report["velocity"]


def test_tables_and_pictures_are_looked_up_by_name(report: daphnis.Report) -> None:
    assert "numbers" in report.tables and len(report.tables) > 1
    with_units = [table for table in report.tables.values() if any(table.attrs["units"].values())]
    assert with_units
    for table in with_units:
        assert not any("[" in name for name in table.columns)
    with pytest.raises(KeyError, match="no such table"):
        report.tables["nothing"]
    for picture in report.pictures.values():
        assert picture._repr_png_().startswith(b"\x89PNG")
    with pytest.raises(KeyError, match="no such picture"):
        report.pictures["nothing"]


@pytest.mark.parametrize(
    ("options", "words"),
    [
        ({"from_": 1e12}, "from_: is 1e12; the last state is at time 14345.57"),
        ({"elevation": 0}, "elevation: is 0; it must be in"),
        ({"elevations": [30, 95]}, "elevations: is 95.0; it must be in 0.1..90 degrees"),
        ({"footprint": -1}, "footprint: is -1; it must be a length"),
        ({"footprint": (500, 1)}, "footprint: is 500 m × 1 m: it must fit into the patch"),
        ({"footprint": 5, "scan_path": 400}, "scan_path: is 400.0; it must be in"),
        ({"frames": 0}, "frames: is 0; it must be at least 1"),
        ({"slabs": -1}, "slabs: is -1"),
        ({"scenario": "ring-patch"}, "scenario: is for files"),
        ({"brightness": "lamp"}, "brightness: is lamp; it must be one of lambert, lommel-seeliger, tabulated"),
        ({"brightness": "tabulated"}, "brightness: is tabulated; it must be given with phase_function"),
        ({"brightness": "lambert", "albedo": -1}, "albedo: is -1; it must be in 0..1"),
        ({"brightness": "lambert", "phase_function": "f.csv"}, "phase_function: is f.csv; it must be given with"),
        ({"brightness": "lambert", "light_elevation": 0}, "light_elevation: is 0.0; it must be in 0.1..90 degrees"),
        ({"brightness": "lambert", "phase_angle": 130}, "phase_angle: is 130.0; it must be 0 to 124 degrees in size"),
        ({"brightness": "lambert", "orders": 0}, "orders: is 0; it must be in 1..100"),
        ({"phase_angle": 6}, "brightness: is not given"),
    ],
)
def test_wrong_options_are_refused(ring: daphnis.Run, options: dict[str, Any], words: str) -> None:
    with pytest.raises(daphnis.InputError, match=words):
        ring.analyze(**options)


def test_a_file_of_states_is_analysed_with_a_scenario(ring: daphnis.Run, tmp_path: Path) -> None:
    file = ring.path / "snapshots" / "0000000060.h5"
    with pytest.raises(daphnis.InputError, match="has times"):
        daphnis.analyze(file, scenario=ring.scenario, time_step=0.1, out=tmp_path)
    with pytest.raises(daphnis.InputError, match="runs have times"):
        ring.analyze(time_step=0.1)
    found = daphnis.analyze(file, scenario=ring.scenario, out=tmp_path)
    state = ring.last()
    assert found["optical_depth"] == pytest.approx(np.pi * (state.radius**2).sum() / 1600, rel=1e-12)


def test_light_through_the_patch_is_computed_on_request(ring: daphnis.Run, tmp_path: Path) -> None:
    seen = tmp_path / "seen.csv"
    seen.write_text("elevation,azimuth,optical_depth,error\n28,0,0.6,0.1\n")
    report = ring.analyze(
        elevations=[20, 90], azimuths=3, footprint=(5, 4), scan_path=90, photons=100, observed=seen, out=tmp_path
    )
    assert len(report.tables["occultation-grid"]) == 6
    assert report.tables["occultation-scan-moments"]["mean"][0] == pytest.approx(0.5, abs=0.3)
    assert "residual" in report.tables["occultation-observed"]
    seen.write_text("elevation,azimuth,optical_depth,error\n0,0,0.6,0.1\n")
    with pytest.raises(daphnis.FormatError, match="seen.csv:2: elevation is '0'"):
        ring.analyze(observed=seen)


def test_brightness_is_computed_on_request(ring: daphnis.Run, tmp_path: Path) -> None:
    seen = tmp_path / "seen.csv"
    seen.write_text("elevation,azimuth,light_elevation,phase_angle,i_over_f,error\n28,0,28,0,0.06,0.01\n")
    grains = tmp_path / "grains.csv"
    grains.write_text("phase_angle,phase_function\n0,2\n180,1\n")
    report = ring.analyze(
        brightness="lommel-seeliger",
        albedo=0.5,
        phase_function=grains,
        elevations=[20, 90],
        azimuths=3,
        phase_angles=[0, 10],
        orders=2,
        paths=50,
        observed_brightness=seen,
        out=tmp_path,
    )
    grid = report.tables["brightness-grid"]
    assert len(grid) == 12
    # Lommel-Seeliger at opposition: albedo times f(0) over 8, of what does not come through.
    assert np.allclose(grid["single_scattering"], 0.5 * 2 / 8 * (1 - grid["transmission"]), rtol=1e-12, atol=0)
    assert len(report.tables["brightness-phase"]) == 2 and len(report.tables["brightness-elevation"]) == 2
    assert report.tables["brightness-observed"]["observed"][0] == 0.06
    assert "brightness-azimuth" in report.pictures
    grains.write_text("phase_angle,phase_function\n10,2\n0,1\n")
    with pytest.raises(daphnis.FormatError, match="grains.csv:3: phase_angle is '0'; it must be more than"):
        ring.analyze(brightness="tabulated", phase_function=grains)


def test_a_run_without_a_report_says_so(ring: daphnis.Run) -> None:
    with pytest.raises(daphnis.InputError, match=r"has no report yet; analyze\(\) writes it"):
        _ = ring.report
    assert "none, before analyze" in str(pytest.raises(KeyError, lambda: ring.tables["numbers"]).value)


def test_states_are_drawn_to_scale(ring: daphnis.Run) -> None:
    matplotlib = pytest.importorskip("matplotlib")
    matplotlib.use("Agg")
    from matplotlib import pyplot

    state = ring.last()
    axes = state.plot(color=state.vx, cmap="viridis")
    (drawn,) = axes.collections
    assert len(drawn.get_offsets()) == len(state) and axes.get_xlabel() == "y [m]" and axes.get_ylabel() == "x [m]"
    assert axes.get_xlim() == (-20, 20)
    side = state.plot(view="side")
    assert side.get_ylim()[1] >= state.z.max()
    along = state.plot(view="along")
    assert along.get_xlabel() == "x [m]" and along.get_ylabel() == "z [m]"
    # The reader is at negative y, so what has the largest y is drawn first.
    assert along.collections[0].get_offsets()[0][0] == state.x[state.y.argmax()]
    for wrong in ({"view": "below"}, {"color": np.zeros(3)}):
        with pytest.raises(daphnis.InputError):
            state.plot(**wrong)  # type: ignore[arg-type]
    pyplot.close("all")
