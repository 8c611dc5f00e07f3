# Copyright Spack Project Developers. See COPYRIGHT file for details.
#
# SPDX-License-Identifier: (Apache-2.0 OR MIT)

from spack_repo.builtin.build_systems.generic import Package

from spack.package import *


class Daphnis(Package):
    """Event-driven simulation of very many colliding spheres: planetary rings, granular flow and
    hard-sphere gases, with analysis. All engines give the same bits."""

    homepage = "https://daphnis-sim.github.io/daphnis/"
    url = "https://github.com/daphnis-sim/daphnis/releases/download/v0.2.0/daphnis-0.2.0.zip"
    git = "https://github.com/daphnis-sim/daphnis.git"

    license("Apache-2.0", checked_by="daphnis-sim")

    version("0.2.0", sha256="0000000000000000000000000000000000000000000000000000000000000000")

    depends_on("java@17:", type="run")

    def install(self, spec, prefix):
        install_tree(".", prefix)

    def setup_run_environment(self, env: EnvironmentModifications) -> None:
        env.prepend_path("PATH", self.prefix.bin)

    @run_after("install")
    @on_package_attributes(run_tests=True)
    def check_install(self):
        daphnis = Executable(self.prefix.bin.daphnis)
        daphnis("run", "ring-patch", "--steps", "6", "--quiet", "--out", "ring")
