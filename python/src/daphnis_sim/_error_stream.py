"""The error stream of the process, which Java writes to as well."""

from __future__ import annotations

import os
import shutil
import subprocess
from collections.abc import Iterator
from contextlib import contextmanager


@contextmanager
def without(line: str) -> Iterator[None]:
    """Takes `line` off the error stream meanwhile; all else comes through, also if the process ends within.

    A process of its own does so, which outlives this one. Where there is none for it, as on Windows, nothing is taken.
    """
    program = shutil.which("grep")
    try:
        stream = os.dup(2) if program is not None else -1
    except OSError:
        stream = -1
    if program is None or stream < 0:
        yield
        return
    words = [program, "-vxF", line]
    try:
        sieve = subprocess.Popen(words, stdin=subprocess.PIPE, stdout=stream, stderr=stream, env={"LC_ALL": "C"})
    except OSError:
        os.close(stream)
        yield
        return
    assert sieve.stdin is not None
    os.dup2(sieve.stdin.fileno(), 2)
    sieve.stdin.close()
    try:
        yield
    finally:
        os.dup2(stream, 2)
        os.close(stream)
        try:
            # Who was started by another thread meanwhile may hold the stream for longer.
            sieve.wait(5)
        except subprocess.TimeoutExpired:
            pass
