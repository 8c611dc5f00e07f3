#!/usr/bin/env python3
"""The scripts of a release, without a build and without a network. From the root of the checkout:

    python3 tools/release/release_test.py
"""

from __future__ import annotations

import hashlib
import importlib.machinery
import importlib.util
import io
import json
import os
import shutil
import subprocess
import sys
import tempfile
import threading
import unittest
import zipfile
from http.server import BaseHTTPRequestHandler, HTTPServer
from pathlib import Path
from types import ModuleType

HERE = Path(__file__).resolve().parent
ROOT = HERE.parents[1]
VERSION = (ROOT / "core/src/main/resources/daphnis/version.txt").read_text("utf-8").strip()
FOLDER = f"io/github/daphnis-sim/daphnis-core/{VERSION}"


def script(name: str) -> ModuleType:
    loader = importlib.machinery.SourceFileLoader(name, str(HERE / name))
    spec = importlib.util.spec_from_loader(name, loader)
    assert spec is not None
    module = importlib.util.module_from_spec(spec)
    loader.exec_module(module)
    return module


sys.dont_write_bytecode = True
central = script("central")
sbom = script("sbom")

POM = f"""<?xml version="1.0"?>
<project xmlns="http://maven.apache.org/POM/4.0.0"><modelVersion>4.0.0</modelVersion>
<groupId>io.github.daphnis-sim</groupId><artifactId>daphnis-core</artifactId><version>{VERSION}</version>
<name>daphnis-core</name><description>Spheres.</description><url>https://example.org</url>
<licenses><license><name>Apache-2.0</name></license></licenses>
<developers><developer><name>The developers of daphnis</name></developer></developers>
<scm><url>https://example.org</url><connection>scm:git:a</connection>
<developerConnection>scm:git:b</developerConnection></scm>
</project>"""


class Temporary(unittest.TestCase):
    def setUp(self) -> None:
        folder = tempfile.TemporaryDirectory(prefix="r")
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)


class ReadyTest(Temporary):
    """In a copy of the few files that it reads."""

    def setUp(self) -> None:
        super().setUp()
        self.write("core/src/main/resources/daphnis/version.txt", "1.2.0\n")
        self.write("docs/releases/1.2.0.md", "# daphnis 1.2.0\n")
        self.write("CHANGELOG.md", "- [1.2.0](docs/releases/1.2.0.md): all is new.\n")
        (self.folder / "tools/release").mkdir(parents=True)
        shutil.copy(HERE / "ready", self.folder / "tools/release/ready")

    def write(self, path: str, text: str) -> None:
        (self.folder / path).parent.mkdir(parents=True, exist_ok=True)
        (self.folder / path).write_text(text, "utf-8")

    def ready(self, *words: str) -> tuple[int, str]:
        done = subprocess.run([self.folder / "tools/release/ready", *words], capture_output=True, text=True)
        return done.returncode, (done.stdout + done.stderr).strip()

    def test_a_release_that_is_whole(self) -> None:
        self.assertEqual((0, "1.2.0"), self.ready("v1.2.0"))
        self.assertEqual((0, "1.2.0"), self.ready())

    def test_a_tag_that_is_not_the_version(self) -> None:
        for tag in ("v1.2.1", "1.2.0", "v1.2.0-rc1", ""):
            self.assertEqual((1, f"release: the tag is {tag}, and version.txt says 1.2.0"), self.ready(tag))

    def test_no_page(self) -> None:
        (self.folder / "docs/releases/1.2.0.md").unlink()
        self.assertEqual((1, "release: there is no docs/releases/1.2.0.md"), self.ready("v1.2.0"))

    def test_no_line_among_the_changes(self) -> None:
        self.write("CHANGELOG.md", "- [1.1.0](docs/releases/1.1.0.md)\n")
        self.assertEqual((1, "release: CHANGELOG.md has no link to docs/releases/1.2.0.md"), self.ready("v1.2.0"))

    def test_a_line_that_says_not_yet(self) -> None:
        self.write("CHANGELOG.md", "- [1.2.0](docs/releases/1.2.0.md), not released yet\n")
        self.assertEqual((1, "release: CHANGELOG.md says that 1.2.0 is not released yet"), self.ready("v1.2.0"))
        self.assertEqual((0, "1.2.0"), self.ready())

    def test_a_snapshot(self) -> None:
        self.write("core/src/main/resources/daphnis/version.txt", "1.2.0-SNAPSHOT\n")
        self.assertEqual((1, "release: 1.2.0-SNAPSHOT is no version to release"), self.ready("v1.2.0-SNAPSHOT"))


class BundleTest(Temporary):
    def setUp(self) -> None:
        super().setUp()
        self.repository = self.folder / "repository"
        place = self.repository / FOLDER
        place.mkdir(parents=True)
        (place / f"daphnis-core-{VERSION}.pom").write_text(POM, "utf-8")
        for kind in ("", "-sources", "-javadoc"):
            (place / f"daphnis-core-{VERSION}{kind}.jar").write_bytes(b"PK" + kind.encode())
        (place.parent / "maven-metadata.xml").write_text("<metadata/>", "utf-8")
        self.zip = self.folder / "bundle.zip"

    def contents(self) -> dict[str, bytes]:
        with zipfile.ZipFile(self.zip) as archive:
            return {name: archive.read(name) for name in archive.namelist()}

    def problems(self, contents: dict[str, bytes]) -> list[str]:
        archive = io.BytesIO()
        with zipfile.ZipFile(archive, "w") as target:
            for name, content in contents.items():
                target.writestr(name, content)
        with zipfile.ZipFile(archive) as target:
            return list(central.problems(target))

    def sign(self) -> None:
        """With a key that nobody else has."""
        if not shutil.which("gpg"):
            self.skipTest("no gpg here")
        home = self.folder / "home"
        home.mkdir(mode=0o700)
        gpg = ["gpg", "--homedir", str(home), "--batch", "--quiet", "--pinentry-mode", "loopback"]
        gpg += ["--passphrase", "pass"]
        subprocess.run([*gpg, "--quick-gen-key", "nobody@example.org", "ed25519", "sign", "1d"], check=True,
                       capture_output=True)
        key = subprocess.run([*gpg, "--armor", "--export-secret-keys"], check=True, capture_output=True).stdout.decode()
        subprocess.run(["gpgconf", "--homedir", str(home), "--kill", "all"])
        with self.assertRaisesRegex(SystemExit, "gpg does not sign"):
            central.bundle(self.repository, self.zip, key, "another")
        with self.assertRaisesRegex(SystemExit, "SIGNING_KEY is no key"):
            central.bundle(self.repository, self.zip, "key", "pass")
        central.bundle(self.repository, self.zip, key, "pass")

    def test_a_bundle_is_as_central_asks(self) -> None:
        self.sign()
        contents = self.contents()
        self.assertEqual(4 * 4, len(contents))
        self.assertEqual([], self.problems(contents))
        for name in contents:
            found = self.problems({other: content for other, content in contents.items() if other != name})
            self.assertTrue(found, f"{name} is not missed")
        jar = f"{FOLDER}/daphnis-core-{VERSION}.jar"
        self.assertEqual([f"{jar}.md5 is wrong", f"{jar}.sha1 is wrong"], self.problems({**contents, jar: b"other"}))
        self.assertEqual([f"{jar}.asc is no signature"], self.problems({**contents, f"{jar}.asc": b"other"}))
        moved = {name.replace(f"/{VERSION}/", "/1/"): content for name, content in contents.items()}
        self.assertEqual(4, len([line for line in self.problems(moved) if "does not lie as in" in line]))
        self.assertEqual(["there is no POM"], self.problems({}))

    def test_a_bundle_that_is_none_or_of_another_version(self) -> None:
        self.sign()
        with self.assertRaisesRegex(SystemExit, "there is no …/daphnis-bom/"):
            central.check(self.zip)
        pom = POM.replace(f"<version>{VERSION}", "<version>0.1.0")
        found = self.problems({f"{FOLDER}/daphnis-core-{VERSION}.pom": pom.encode()})
        self.assertTrue([line for line in found if f"is of 0.1.0, and version.txt says {VERSION}" in line], found)
        self.zip.write_bytes(b"")
        with self.assertRaisesRegex(SystemExit, "is no bundle"):
            central.check(self.zip)
        with self.assertRaisesRegex(SystemExit, "is no bundle"):
            central.check(self.folder / "none.zip")

    def test_a_pom_that_lacks_something(self) -> None:
        parts = ("name", "description", "url", "licenses", "developers", "scm", "connection", "developerConnection")
        for part in parts:
            pom = POM.replace(f"<{part}>", f"<no-{part}>").replace(f"</{part}>", f"</no-{part}>")
            found = self.problems({f"{FOLDER}/daphnis-core-{VERSION}.pom": pom.encode()})
            self.assertTrue([line for line in found if f"has no {part}" in line or f"/{part}" in line], (part, found))
        pom = POM.replace("<name>daphnis-core", "<parent/><name>").replace(VERSION, "1-SNAPSHOT")
        found = "\n".join(self.problems({f"{FOLDER}/daphnis-core-{VERSION}.pom": pom.encode()}))
        for part in ("has a parent", "is a snapshot", "has no name"):
            self.assertIn(part, found)

    def test_what_the_portal_is_asked(self) -> None:
        seen = []

        class Portal(BaseHTTPRequestHandler):
            def do_POST(self) -> None:
                body = self.rfile.read(int(self.headers["Content-Length"]))
                seen.append((self.path, dict(self.headers), body))
                known = self.headers["Authorization"] == "Bearer bmFtZTp3b3Jk"
                self.send_response(201 if known else 401)
                self.end_headers()
                self.wfile.write(b"28570f16-da32-4c14-bd2e-c1acc0782365" if known else b"who?")

            def log_message(self, *words: object) -> None:
                pass

        server = HTTPServer(("127.0.0.1", 0), Portal)
        thread = threading.Thread(target=server.serve_forever)
        thread.start()
        self.addCleanup(thread.join)
        self.addCleanup(server.server_close)
        self.addCleanup(server.shutdown)
        self.zip.write_bytes(b"zip\r\n")
        url = f"http://127.0.0.1:{server.server_port}/api/v1/publisher/upload"
        identifier = central.upload(self.zip, "name:word", url, "daphnis-1")
        self.assertEqual("28570f16-da32-4c14-bd2e-c1acc0782365", identifier)
        path, headers, body = seen[0]
        self.assertEqual("/api/v1/publisher/upload?name=daphnis-1&publishingType=USER_MANAGED", path)
        border = headers["Content-Type"].removeprefix("multipart/form-data; boundary=").encode()
        self.assertEqual(
            b'--' + border + b'\r\nContent-Disposition: form-data; name="bundle"; filename="bundle.zip"\r\n'
            b"Content-Type: application/octet-stream\r\n\r\nzip\r\n\r\n--" + border + b"--\r\n", body)
        with self.assertRaisesRegex(SystemExit, "the Portal answers 401: who?"):
            central.upload(self.zip, "name:other", url, "daphnis-1")

    def test_no_key_and_no_token(self) -> None:
        environment = {name: value for name, value in os.environ.items() if name != "SIGNING_KEY"}
        done = subprocess.run([HERE / "central", "bundle"], env=environment, capture_output=True, text=True)
        self.assertEqual((1, "release: SIGNING_KEY is not set\n"), (done.returncode, done.stderr))


class SteadyTest(Temporary):
    def jar(self, name: str, year: int, rights: int) -> Path:
        file = self.folder / name
        with zipfile.ZipFile(file, "w") as archive:
            for entry, content in (("META-INF/", b""), ("META-INF/MANIFEST.MF", b"Manifest-Version: 1.0"), ("a", b"b")):
                info = zipfile.ZipInfo(entry, (year, 7, 7, 7, 7, 8))
                info.external_attr = rights << 16
                archive.writestr(info, content)
        return file

    def test_time_and_rights_do_not_matter(self) -> None:
        one, two = self.jar("one", 2001, 0o755), self.jar("two", 2022, 0o600)
        self.assertNotEqual(one.read_bytes(), two.read_bytes())
        (self.folder / "two.sha1").write_text("old", "utf-8")
        subprocess.run([HERE / "steady", one, two], check=True)
        self.assertEqual(one.read_bytes(), two.read_bytes())
        with zipfile.ZipFile(one) as archive:
            self.assertEqual(["META-INF/", "META-INF/MANIFEST.MF", "a"], archive.namelist())
            self.assertEqual(b"b", archive.read("a"))
        self.assertEqual(hashlib.sha1(two.read_bytes()).hexdigest(), (self.folder / "two.sha1").read_text("utf-8"))
        self.assertFalse((self.folder / "one.sha1").exists())

    def test_the_time_is_that_of_maven(self) -> None:
        pom = (ROOT / "pom.xml").read_text("utf-8")
        time = "{}-{:02}-{:02}T{:02}:{:02}:{:02}Z".format(*script("steady").TIME)
        self.assertIn(f"<project.build.outputTimestamp>{time}<", pom)


class ImageTest(Temporary):
    """With a `docker` that writes down what it is told."""

    def image(self, digest: str, *words: str) -> tuple[int, list[str]]:
        docker = self.folder / "docker"
        said = self.folder / "said"
        docker.write_text(f'#!/bin/sh\necho "$@" >>"{said}"\n[ "$1" != run ] || echo "digest {digest}"\n', "utf-8")
        docker.chmod(0o755)
        environment = {**os.environ, "PATH": f"{self.folder}:{os.environ['PATH']}", "IMAGE": "here/daphnis"}
        done = subprocess.run([HERE / "image", *words], env=environment, capture_output=True)
        return done.returncode, said.read_text("utf-8").splitlines()

    def test_an_image_is_pushed_when_it_runs_as_it_should(self) -> None:
        digests = (ROOT / "src/test/resources/golden/digests.csv").read_text("utf-8").splitlines()
        pinned = next(line.split(",")[2] for line in digests if line.startswith("ring-patch,6,"))
        code, said = self.image(pinned)
        self.assertEqual((0, ["build", "run"]), (code, [line.split()[0] for line in said]))
        self.assertIn(f"--label org.opencontainers.image.version={VERSION} ", said[0])
        (self.folder / "said").unlink()
        code, said = self.image(pinned, "--push")
        self.assertEqual(0, code)
        self.assertEqual([f"tag here/daphnis:{VERSION} here/daphnis:latest", f"push here/daphnis:{VERSION}",
                          "push here/daphnis:latest"], said[2:])
        (self.folder / "said").unlink()
        code, said = self.image("0123", "--push")
        self.assertEqual((1, 2), (code, len(said)))


class SbomTest(unittest.TestCase):
    TABLE = "| library | version | licence |\n| a.b:c-d | 1.0 | MIT or Apache-2.0 |\n| e:f | 2 | MIT |\n"
    SBOM = {"components": [
        {"group": "a.b", "name": "c-d", "version": "1.0", "licenses": [{"license": {"id": "Apache-2.0"}}]},
        {"group": "e", "name": "f", "version": "2", "licenses": [{"license": {"name": "Some"}}]},
        {"group": "io.github.daphnis-sim", "name": "daphnis-core", "version": "0.2.0"},
    ]}
    JARS = ["c-d-1.0.jar", "f-2.jar", "daphnis-core-0.2.0.jar"]

    def problems(self, table: str = TABLE, jars: list[str] = JARS) -> list[str]:
        return list(sbom.problems(sbom.listed(table), json.loads(json.dumps(self.SBOM)), jars))

    def test_the_same(self) -> None:
        self.assertEqual([], self.problems())

    def test_what_differs(self) -> None:
        self.assertEqual(["g:h is in the table only"], self.problems(self.TABLE + "| g:h | 3 | MIT |\n"))
        less = self.TABLE.replace("| e:f | 2 | MIT |", "")
        self.assertEqual(["e:f is in the list of parts only"], self.problems(less))
        self.assertEqual(["e:f is 3 in the table and 2 in the list of parts"],
                         self.problems(self.TABLE.replace("f | 2", "f | 3")))
        self.assertEqual(["a.b:c-d: ['Apache-2.0'] in the list of parts, ['MIT'] in the table"],
                         self.problems(self.TABLE.replace(" or Apache-2.0", "")))
        self.assertEqual(["lib/f-2.jar is in one of zip and list of parts"], self.problems(jars=self.JARS[::2]))
        more = self.problems(jars=[*self.JARS, "g-1.jar"])
        self.assertEqual(["lib/g-1.jar is in one of zip and list of parts"], more)


class RecipesTest(Temporary):
    def fill(self, name: str) -> subprocess.CompletedProcess[str]:
        archive = self.folder / name
        archive.write_bytes(b"zip")
        fill = ROOT / "tools/packaging/fill.sh"
        return subprocess.run([fill, archive, self.folder / "out"], capture_output=True, text=True)

    def test_each_recipe_has_version_and_checksum(self) -> None:
        done = self.fill(f"daphnis-{VERSION}.zip")
        self.assertEqual((0, ""), (done.returncode, done.stderr))
        recipes = [Path(line) for line in done.stdout.splitlines()]
        self.assertEqual({"package.py", "recipe.yaml", "apptainer.def"}, {recipe.name for recipe in recipes})
        for recipe in recipes:
            text = recipe.read_text("utf-8")
            self.assertEqual(1, text.count("4a70fe9aa6436e02c2dea340fbd1e352e4ef2d8ce6ca52ad25d4b95471fc8bf2"), recipe)
            self.assertNotIn("00000000", text)
            self.assertIn(VERSION, text)

    def test_the_zip_of_another_version(self) -> None:
        done = self.fill("daphnis-0.0.1.zip")
        self.assertEqual(1, done.returncode)
        self.assertIn(f"is not daphnis-{VERSION}.zip", done.stderr)


if __name__ == "__main__":
    unittest.main()
