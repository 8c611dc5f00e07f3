package daphnis.app

import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import java.nio.file.Files
import java.nio.file.Path

/** What `analyze` is asked of the light through a patch, as a user meets it. */
class OccultationFlagsTest {
    @TempDir
    lateinit var home: Path

    private fun at(name: String) = home.resolve(name).toString()

    private fun analyze(vararg more: String) = daphnis("analyze", at("ring"), "--quiet", *more)

    private fun ring() = assertDone(
        daphnis(
            "run",
            "ring-patch",
            "--set",
            "box.lengths=[40,40,20]",
            "--set",
            "untilOrbits=0.2",
            "--out",
            at("ring"),
        ),
    )

    @Test
    fun `a grid, scans and a comparison are asked for by flags`() {
        ring()
        val seen = Files.writeString(home.resolve("seen.csv"), "elevation,azimuth,optical_depth,error\n28,0,0.6,0.1\n")
        assertDone(
            analyze(
                "--elevations=20,90",
                "--azimuths=3",
                "--footprint=5x4",
                "--scan-path=90",
                "--photons=100",
                "--observed=$seen",
            ),
        )
        for (table in listOf("grid", "scan", "scan-moments", "autocorrelation", "observed")) {
            assertTrue(Files.exists(home.resolve("ring/tables/occultation-$table.csv"))) { table }
        }
        assertDone(analyze("--footprint=5"))
        assertTrue("a disc of diameter 5 m" in Files.readString(home.resolve("ring/report.html")))
    }

    @Test
    fun `each fault is one line, which names the flag, or the file and its line`() {
        ring()
        for ((flags, words) in listOf(
            listOf("--footprint=0") to "daphnis: --footprint: is 0; it must be a length > 0, or two such as 20x10",
            listOf("--footprint=3x4x5") to "--footprint: is 3x4x5",
            listOf("--footprint=wide") to "--footprint: is wide",
            listOf("--footprint=41") to "--footprint: is a disc of diameter 41 m: it must fit into the patch",
            listOf("--photons=10") to "--photons: is 10.0; it must be given with --footprint",
            listOf("--scan-path=10") to "--scan-path: is 10.0; it must be given with --footprint",
            listOf("--footprint=5", "--scan-path=361") to "--scan-path: is 361.0; it must be in -360..360 degrees",
            listOf("--footprint=5", "--photons=0") to "--photons: is 0.0; it must be in (0,",
            listOf("--elevations=10,high") to "--elevations: is 10,high; it must be numbers with commas between",
            listOf("--elevations=10,95") to "--elevations: is 95.0; it must be in 0.1..90 degrees",
            listOf("--elevations=0.001", "--azimuths=1") to "--elevations: is 0.001; it must be in 0.1..90 degrees",
            listOf("--elevation=1e-9") to "--elevation: is 1.0E-9; it must be in 0.1..90 degrees",
            listOf("--azimuths=3") to "--azimuths: is 3; it must be given with --elevations or --brightness",
            listOf("--elevations=10", "--azimuths=0") to "--azimuths: is 0; it must be in 1..180",
            listOf("--observed=${at("none.csv")}") to "none.csv: cannot be read: no such file",
            listOf(
                "--observed=${Files.writeString(
                    home.resolve("bad.csv"),
                    "elevation,azimuth,transmission,error\n0,0,1,1\n",
                )}",
            )
                to "bad.csv:2: elevation is '0'; it must be in 0.1..90 degrees",
        )) {
            assertRefused(analyze(*flags.toTypedArray()), words)
        }
        assertTrue(Files.notExists(home.resolve("ring/report.html")))
    }
}
