package daphnis.core.run

import daphnis.core.boundary.Box
import daphnis.core.boundary.Periodic
import daphnis.core.collision.ConstantRestitution
import daphnis.core.randomSpheres
import daphnis.core.simulationOf
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertNotEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import java.math.BigDecimal

class CollisionStatisticsTest {
    private val boundary = Periodic(Box.centred(12.0, 12.0, 12.0))
    private val gas = randomSpheres(400, boundary, 3, 1.0) { 0.5 }

    private fun simulation() = simulationOf(gas.copy(), boundary, 0.2, ConstantRestitution(0.8))

    private fun numbers(s: CollisionStatistics) =
        listOf(s.count.toDouble(), s.sumSpeed, s.sumSpeedSquared, s.dissipated) + s.virial.asList() + s.sums()

    @Test
    fun `sums are those of all collisions, rounded once`() {
        val statistics = CollisionStatistics()
        val simulation = simulation()
        var speed = BigDecimal.ZERO
        var squared = BigDecimal.ZERO
        repeat(20) {
            simulation.advance()
            statistics.write(simulation)
            val record = simulation.collisions!!.record!!
            for (k in 0 until record.size) {
                speed += BigDecimal(record.impactSpeed(k))
                squared += BigDecimal(record.impactSpeed(k) * record.impactSpeed(k))
            }
        }
        assertTrue(statistics.count > 1000)
        assertEquals(speed.toDouble(), statistics.sumSpeed)
        assertEquals(squared.toDouble(), statistics.sumSpeedSquared)
    }

    @Test
    fun `sums that are written down and taken up again end with the same bits as those kept in one go`() {
        val whole = CollisionStatistics()
        var resumed = CollisionStatistics()
        var rounded = CollisionStatistics()
        val simulation = simulation()
        repeat(40) {
            simulation.advance()
            for (s in listOf(whole, resumed, rounded)) s.write(simulation)
            resumed = again(resumed.sums(), resumed.speeds)
            // As a checkpoint of an earlier version has it.
            rounded = again(rounded.sums().take(13), rounded.speeds)
        }
        assertEquals(numbers(whole), numbers(resumed))
        assertNotEquals(numbers(whole), numbers(rounded)) { "what is left of rounding matters" }
        for ((a, b) in numbers(whole).zip(numbers(rounded)).take(13)) assertEquals(a, b, 1e-9)
    }

    private fun again(sums: List<Double>, speeds: LongArray) =
        CollisionStatistics().apply { restore(sums, speeds.copyOf()) }

    @Test
    fun `what are no sums is refused`() {
        val speeds = CollisionStatistics().speeds
        val sums = CollisionStatistics().sums()
        val wrongPairs = listOf(12.0, -1.0, 0.5).map { sums + listOf(it, 1.0) }
        for (bad in wrongPairs + listOf(sums.drop(1), sums + 1.0)) {
            assertThrows(IllegalArgumentException::class.java) { CollisionStatistics().restore(bad, speeds) }
        }
        assertThrows(IllegalArgumentException::class.java) { CollisionStatistics().restore(sums, LongArray(3)) }
    }
}
