package daphnis.app

import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import java.nio.file.Files
import java.nio.file.Path

/** What `analyze` is asked of the brightness of a patch, as a user meets it. */
class BrightnessFlagsTest {
    @TempDir
    lateinit var home: Path

    private fun at(name: String) = home.resolve(name).toString()

    private fun file(name: String, text: String) = Files.writeString(home.resolve(name), text).toString()

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

    private val columns = "elevation,azimuth,light_elevation,phase_angle,i_over_f,error\n"

    @Test
    fun `brightness over elevations, azimuths and phases is asked for by flags, and compared`() {
        ring()
        val whole = file("whole.csv", "phase_angle,phase_function\n0,4\n90,1\n180,0\n")
        val seen = file("seen.csv", "${columns}28,0,24,6,0.1,0.01\n")
        assertDone(
            analyze(
                "--brightness=tabulated",
                "--albedo=0.4",
                "--phase-function=$whole",
                "--elevations=20,40",
                "--azimuths=3",
                "--light-elevation=-24",
                "--phase-angle=-70",
                "--phase-angles=60,100",
                "--orders=2",
                "--paths=30",
                "--brightness-seed=7",
                "--observed-brightness=$seen",
            ),
        )
        for (table in listOf("grid", "elevation", "phase", "observed")) {
            assertTrue(Files.exists(home.resolve("ring/tables/brightness-$table.csv"))) { table }
        }
        val grid = Files.readAllLines(home.resolve("ring/tables/brightness-grid.csv"))
        assertTrue(grid.size == 13 && grid[1].startsWith("20.0,0.0,-24.0,")) { grid[1] }
        assertDone(analyze("--brightness=lambert", "--azimuths=3"))
        assertTrue("There is no darkest azimuth" in Files.readString(home.resolve("ring/report.html")))
    }

    @Test
    fun `each fault is one line, which names the flag, or the file and its line`() {
        ring()
        val unsorted = file("unsorted.csv", "phase_angle,phase_function\n0,1\n20,1\n10,1\n")
        val part = file("part.csv", "phase_angle,phase_function\n0,1\n20,1\n")
        val bright = file("bright.csv", "phase_angle,phase_function\n0,9\n180,1\n")
        val low = file("low.csv", "${columns}0,0,24,6,0.1,0.01\n")
        val far = file("far.csv", "${columns}28,0,24,60,0.1,0.01\n")
        for ((flags, words) in listOf(
            listOf("--brightness=lamber") to
                "--brightness: is lamber; did you mean 'lambert'? it must be one of lambert, lommel-seeliger, t",
            listOf("--brightness=tabulated") to "--brightness: is tabulated; it must be given with --phase-function",
            listOf("--brightness=lambert", "--albedo=-0.1") to "--albedo: is -0.1; it must be in 0..1",
            listOf("--brightness=lambert", "--albedo=1.1") to "--albedo: is 1.1; it must be in 0..1",
            listOf("--brightness=lambert", "--phase-function=$part") to
                "--phase-function: is $part; it must be given with",
            listOf("--brightness=tabulated", "--phase-function=$unsorted") to
                "unsorted.csv:4: phase_angle is '10'; it must be more than that of the row before, 20",
            listOf("--brightness=lambert", "--light-elevation=0") to "--light-elevation: is 0.0; it must be in 0.1..90",
            listOf("--brightness=lambert", "--light-elevation=91") to
                "--light-elevation: is 91.0; it must be in 0.1..90",
            listOf("--brightness=lambert", "--elevation=0") to "--elevation: is 0.0; it must be in 0.1..90 degrees",
            listOf("--brightness=lambert", "--elevations=20,91") to "--elevations: is 91.0; it must be in 0.1..90",
            listOf("--brightness=lambert", "--phase-angle=181") to "--phase-angle: is 181.0; it must be in -180..180",
            listOf("--brightness=lambert", "--elevations=28,90", "--phase-angle=6") to
                "--phase-angle: is 6.0; it must be 0 to 0 degrees in size with the eye at 90 and the light at 90",
            listOf("--brightness=lambert", "--phase-angles=0,high") to "--phase-angles: is 0,high; it must be numbers",
            listOf("--brightness=lambert", "--phase-angles=0,130") to
                "--phase-angles: is 130.0; it must be 0 to 124 degrees in size with the eye at 28 and the light at 28",
            listOf("--brightness=tabulated", "--phase-function=$part", "--phase-angles=30") to
                "--phase-angles: is 30.0; it must be in the phase function, which covers 0 to 20 degrees",
            listOf("--brightness=tabulated", "--phase-function=$part", "--observed-brightness=$far") to
                "--observed-brightness: is 60",
            listOf("--brightness=lambert", "--orders=0") to "--orders: is 0; it must be in 1..100",
            listOf("--brightness=lambert", "--orders=2", "--paths=0") to "--paths: is 0; it must be in 1..",
            listOf("--brightness=lambert", "--paths=9") to "--paths: is 9; it must be given with --orders of 2",
            listOf("--brightness=lambert", "--brightness-seed=9") to "--brightness-seed: is 9; it must be given with",
            listOf("--brightness=tabulated", "--orders=2", "--phase-function=$part") to
                "--phase-function: covers 0 to 20 degrees; further orders take 0 to 180",
            listOf("--brightness=tabulated", "--orders=2", "--phase-function=$bright") to
                "--phase-function: makes a sphere scatter 5.00 of the light that falls on it; it must be 1 at most",
            listOf(
                "--brightness=lambert",
                "--observed-brightness=$low",
            ) to "low.csv:2: elevation is '0'; it must be in",
            listOf("--brightness=lambert", "--observed-brightness=${at("none.csv")}") to "none.csv: cannot be read",
            listOf("--albedo=0.5") to "--albedo: is 0.5; it must be given with --brightness",
            listOf("--phase-angles=0") to "--phase-angles: is 0; it must be given with --brightness",
            listOf("--azimuths=3") to "--azimuths: is 3; it must be given with --elevations or --brightness",
        )) {
            assertRefused(analyze(*flags.toTypedArray()), words)
        }
        assertTrue(Files.notExists(home.resolve("ring/report.html")))
    }
}
