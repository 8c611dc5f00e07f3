"""``python -m daphnis_sim``, or ``daphnis-sim``: the command line of daphnis, with the jars of the wheel."""

import os
import sys
from typing import NoReturn

from ._errors import JavaError
from ._jvm import find_java, flags, jars


def main() -> NoReturn:
    """Becomes Java with the words of the command line."""
    try:
        java = find_java()
        path = os.pathsep.join(str(jar) for jar in jars())
    except JavaError as e:
        sys.exit(f"daphnis: {e}")
    program = str(java.home / "bin" / "java")
    os.execv(program, [program, *flags(java), "-cp", path, "daphnis.app.MainKt", *sys.argv[1:]])


if __name__ == "__main__":
    main()
