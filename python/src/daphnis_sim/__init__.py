"""daphnis simulates very many colliding spheres, event by event: planetary rings and granular gases.

    import daphnis_sim as daphnis

    run = daphnis.run("ring-patch", "runs/ring", set={"particles.opticalDepth": 0.5})
    print(run.analyze().numbers)

`run`, `resume` and `open` give a `Run`, with tables as pandas and states as NumPy arrays. `Simulation` is the same in
memory, step by step. Laws and forces may be functions of Python: `restitution`, `roughness`, `contact_law`, `kick`,
`acceleration`. Lengths, times and masses are in the scenario's units. docs/python.md is the guide.
"""

from ._errors import DaphnisError, DaphnisWarning, FormatError, InputError, Interrupted, JavaError, RunError
from ._interrupts import end_by_signal as _end_by_signal
from ._jvm import start
from ._version import __version__
from .laws import (
    Contact,
    ContactLaw,
    Force,
    Restitution,
    Roughness,
    Spheres,
    acceleration,
    contact_law,
    kick,
    restitution,
    roughness,
)
from .mdanalysis import universe
from .report import Picture, Report, analyze
from .runs import Run, States

# Not in __all__: a star would put it in the place of Python's own.
from .runs import open as open
from .scenarios import Scenario, scenario, scenarios
from .simulation import Simulation
from .starting import resume, run
from .states import State
from .sweeps import Outcome, Sweep, Task, collect, run_task, sweep

_end_by_signal()

__all__ = [
    "Contact",
    "ContactLaw",
    "DaphnisError",
    "DaphnisWarning",
    "Force",
    "FormatError",
    "InputError",
    "Interrupted",
    "JavaError",
    "Outcome",
    "Picture",
    "Report",
    "Restitution",
    "Roughness",
    "Run",
    "RunError",
    "Scenario",
    "Simulation",
    "Spheres",
    "State",
    "States",
    "Sweep",
    "Task",
    "__version__",
    "acceleration",
    "analyze",
    "collect",
    "contact_law",
    "kick",
    "restitution",
    "resume",
    "roughness",
    "run",
    "run_task",
    "scenario",
    "scenarios",
    "start",
    "sweep",
    "universe",
]
