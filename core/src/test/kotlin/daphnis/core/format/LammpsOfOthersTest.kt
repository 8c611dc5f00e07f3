package daphnis.core.format

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import java.nio.file.Files
import java.nio.file.Path
import kotlin.math.PI

/** What LAMMPS itself writes of style sphere: spins in data files, and boxes of two dimensions. */
class LammpsOfOthersTest {
    @TempDir
    lateinit var home: Path

    private fun data(
        velocities: String,
        z: String = "-5 5",
        style: String = " # sphere",
        third: String = "0",
    ): List<Snapshot> {
        val text = "LAMMPS data file via write_data, version 22 Jul 2025, timestep = 0, units = lj\n\n2 atoms\n" +
            "1 atom types\n\n-5 5 xlo xhi\n-5 5 ylo yhi\n$z zlo zhi\n\nAtoms$style\n\n2 1 2 0.5 3 0 $third 0 0 0\n" +
            "1 1 1 2 0 0 0 0 0 0\n\nVelocities\n\n$velocities"
        return LammpsData.read(Files.writeString(home.resolve("a.data"), text), ArrayList())
    }

    @Test
    fun `spins stand behind the velocities of a data file of spheres`() {
        val state = data("2 0.1 0.2 0.3 4 5 6\n1 1 2 3 0 0 -3\n")[0]
        assertTrue(state.hasSpin)
        val spins = state.columns(daphnis.core.population.SphereQuantity.SPIN)
        assertEquals(listOf(0.0, 4.0), spins[0].toList())
        assertEquals(listOf(0.0, 5.0), spins[1].toList())
        assertEquals(listOf(-3.0, 6.0), spins[2].toList())
        assertEquals(listOf(1.0, 0.1), state.velocity[0].toList())
        assertFalse(data("2 0.1 0.2 0.3\n1 1 2 3\n")[0].hasSpin)
        val told = assertThrows(FormatException::class.java) { data("2 0.1 0.2 0.3 4 5 6\n1 1 2 3\n") }.message!!
        assertTrue("a.data:18: 4 values" in told && "wx wy wz" in told) { told }
    }

    @Test
    fun `a box of two dimensions is one of discs, and a thin one of spheres is refused as before`() {
        val flat = data("2 0 0 0 0 0 -1\n1 1 0 0 0 0 3\n", "-0.5 0.5")[0]
        assertTrue(flat.isFlat && !flat.periodic[2] && flat.lengths[2].isNaN())
        assertEquals(listOf(true, true), flat.periodic.take(2))
        // LAMMPS writes the density of a sphere in two dimensions too.
        assertEquals(2 * 4.0 / 3 * PI * 0.125, flat.mass[0], 1e-12)
        for (bad in listOf(
            Triple("2 0 0 0\n1 0 0 1e-9\n", "-0.5 0.5", "0"),
            Triple("2 0 0 0\n1 0 0 0\n", "-0.5 0.5", "0.1"),
        )) {
            val told = assertThrows(FormatException::class.java) {
                data(bad.first, bad.second, third = bad.third)
            }.message!!
            assertTrue("it must exceed the largest diameter" in told) { told }
        }
        val dump = "ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n2\nITEM: BOX BOUNDS pp pp pp\n-5 5\n-5 5\n-0.5 0.5\n" +
            "ITEM: ATOMS id type mass radius x y z vx vy vz omegax omegay omegaz\n" +
            "1 1 1.0472 0.5 0 0 0 1 0 0 0 0 3\n2 1 2.0944 1 3 0 0 0 0 0 0 0 -1\n"
        assertTrue(LammpsDump.read(Files.writeString(home.resolve("a.lammpstrj"), dump), ArrayList())[0].isFlat)
    }
}
