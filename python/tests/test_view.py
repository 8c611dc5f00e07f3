"""The page of a run: served by this process."""

from __future__ import annotations

import json
import struct
import urllib.error
import urllib.request
from pathlib import Path

import numpy as np
import pytest

import daphnis_sim as daphnis


def test_a_page_is_served_for_a_frame_until_it_is_closed(ring: daphnis.Run) -> None:
    view = ring.view(height=600)
    assert f'src="{view.address}"' in view._repr_html_() and 'height="600"' in view._repr_html_()
    with urllib.request.urlopen(view.address) as answer:
        assert "frame-ancestors http://localhost:*" in answer.headers["Content-Security-Policy"]
        assert b"canvas" in answer.read()
    with urllib.request.urlopen(f"{view.address}state/60") as answer:
        data = answer.read()
    (length,) = struct.unpack("<I", data[:4])
    head = json.loads(data[4 : 4 + length])
    assert head["count"] == len(ring.last().radius)
    radius = np.frombuffer(data, "<f4", head["count"], 4 + length + 12 * head["count"])
    assert np.allclose(radius, ring.last().radius)
    view.close()
    with pytest.raises(urllib.error.URLError):
        urllib.request.urlopen(view.address)


def test_a_run_without_states_is_refused(tmp_path: Path) -> None:
    run = daphnis.run("cooling-gas", tmp_path / "run", steps=1, set={"particles.count": 10})
    for file in [*run.path.glob("snapshots/*"), *run.path.glob("checkpoint*")]:
        file.unlink()
    with pytest.raises(daphnis.InputError, match="no state"):
        run.view()
