package daphnis.core.collision

import daphnis.core.FixedTimeStep
import daphnis.core.Simulation
import daphnis.core.Sphere
import daphnis.core.boundary.Box
import daphnis.core.boundary.LeesEdwards
import daphnis.core.boundary.Open
import daphnis.core.boundary.Walls
import daphnis.core.boundary.prepare
import daphnis.core.engine.CollisionForcing
import daphnis.core.initial.SeededRandom
import daphnis.core.population.Population
import daphnis.core.populationOf
import daphnis.core.space.Images
import daphnis.core.surface.ConstantRestitution
import daphnis.core.surface.ConstantRoughness
import daphnis.core.surface.CoulombRoughness
import daphnis.core.surface.Roughness
import daphnis.core.wall.WallContact
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Tag
import org.junit.jupiter.api.Test
import java.math.BigDecimal
import kotlin.math.abs
import kotlin.math.sqrt

class RoughImpactTest {
    private val still = Images().apply { prepare(Open, 0.0) }
    private val outcome = CollisionOutcome()

    /** An impact with all that is drawn of it. */
    private class Drawn(seed: Int) {
        val random = SeededRandom(seed.toLong())
        val e = random.nextDouble(0.0, 1.0)
        val q = random.nextDouble(0.05, 0.66)
        val mu = Math.exp(random.nextDouble(-4.0, 1.0))
        val beta = random.nextDouble(-1.0, 1.0)
        val isCoulomb = random.nextInt(2) == 0
        val roughness = if (isCoulomb) CoulombRoughness(mu, beta) else ConstantRoughness(beta)
        private val r1 = Math.exp(random.nextGaussian())
        private val r2 = Math.exp(random.nextGaussian())
        private val spins = List(2) { Exact(gauss(), gauss(), gauss()) }
        val spheres = drawSpheres()

        private fun gauss() = random.nextGaussian()

        private fun drawSpheres(): List<Sphere> {
            val d = doubleArrayOf(gauss(), gauss(), gauss())
            val far = sqrt(d.sumOf { it * it })
            for (axis in 0..2) d[axis] *= (r1 + r2) / far
            while (true) {
                val v = List(2) { DoubleArray(3) { gauss() } }
                if ((0..2).sumOf { d[it] * (v[1][it] - v[0][it]) } > -1e-3) continue
                val masses = List(2) { Math.exp(3 * gauss()) }
                return listOf(
                    Sphere(0.0, 0.0, 0.0, v[0][0], v[0][1], v[0][2], r1, masses[0]),
                    Sphere(d[0], d[1], d[2], v[1][0], v[1][1], v[1][2], r2, masses[1]),
                )
            }
        }

        val exact = List(2) { ExactSphere(spheres[it], spins[it]) }
        val population = spun(spheres, spins)
        val scale = spheres.maxOf { s ->
            maxOf(abs(s.vx), abs(s.vy), abs(s.vz), s.r * spins.maxOf { it.numbers.maxOf { w -> abs(w) } })
        }
    }

    private fun rows(p: Population) = StepRows().apply { load(p, IntArray(p.size) { it }, 1.0, false) }

    private fun StepRows.velocity(slot: Int) = List(3) { state[slot * StepRows.STRIDE + StepRows.VX + it] }

    private fun StepRows.spin(slot: Int) = listOf(wx[slot], wy[slot], wz[slot])

    private fun StepRows.sphere(slot: Int, like: ExactSphere): ExactSphere {
        val (v, w) = velocity(slot) to spin(slot)
        return ExactSphere(like.at, Exact(v[0], v[1], v[2]), Exact(w[0], w[1], w[2]), like.r, like.m)
    }

    private fun assertSame(expected: ExactSphere, rows: StepRows, slot: Int, scale: Double, story: String) {
        for (axis in 0..2) {
            val r = expected.r.toDouble()
            assertEquals(expected.v.numbers[axis], rows.velocity(slot)[axis], CLOSE * scale) { "$story, v $axis" }
            assertEquals(expected.w.numbers[axis] * r, rows.spin(slot)[axis] * r, CLOSE * scale) { "$story, ω $axis" }
        }
    }

    @Tag("thorough")
    @Test
    fun `ten thousand impacts, sticking and sliding, are those of sixty digits`() {
        var sliding = 0
        for (seed in 1..DRAWS) {
            val drawn = Drawn(seed)
            val (a, b) = drawn.exact
            val q = BigDecimal(drawn.q)
            val impact = ExactImpact(a, b, (b.at - a.at).let { it * (BigDecimal.ONE / it.length) }, q)
            val stick = impact.sticking(drawn.beta)
            val slip = impact.slipping(drawn.mu, drawn.e)
            val slips = drawn.isCoulomb && slip.length < stick.length
            if (slips) sliding++
            val (first, second) = impact.after(drawn.e, if (slips) slip else stick)
            val rows = rows(drawn.population)
            val law = CollisionLaw(ConstantRestitution(drawn.e), NoGuard, drawn.roughness, drawn.q)
            assertTrue(law.collide(rows, 0, 1, 0, still, 0.0, outcome))
            assertSame(first, rows, 0, drawn.scale, "seed $seed, first")
            assertSame(second, rows, 1, drawn.scale, "seed $seed, second")
            conserves(drawn, impact, rows, if (slips) null else drawn.beta, seed)
            // From the other side, to the bit.
            val other = rows(drawn.population)
            law.collide(other, 1, 0, 0, still, 0.0, outcome)
            for (slot in 0..1) {
                assertEquals(rows.velocity(slot), other.velocity(slot)) { "seed $seed" }
                assertEquals(rows.spin(slot), other.spin(slot)) { "seed $seed" }
            }
        }
        assertTrue(sliding in DRAWS / 10..DRAWS / 2) { "$sliding of $DRAWS slide" }
    }

    /** Angular momentum about the centre of the first; energy as the coefficients say, [beta] null where surfaces slip. */
    private fun conserves(drawn: Drawn, impact: ExactImpact, rows: StepRows, beta: Double?, seed: Int) {
        val q = BigDecimal(drawn.q)
        val before = listOf(impact.a, impact.b)
        val after = List(2) { rows.sphere(it, before[it]) }
        val size = before.sumOf { (it.m!! * it.r.max((it.at).length)).toDouble() } * drawn.scale
        val change = after.map { it.angularMomentum(q) }.reduce { x, y -> x + y } -
            before.map { it.angularMomentum(q) }.reduce { x, y -> x + y }
        for (c in change.numbers) assertTrue(abs(c) < 4 * CLOSE * size) { "seed $seed: angular momentum off by $c" }
        val loss = before.sumOf { it.energy(q) }.subtract(after.sumOf { it.energy(q) }).toDouble()
        val energy = before.sumOf { it.energy(q) }.toDouble()
        assertTrue(loss > -1e-13 * energy) { "seed $seed gains ${-loss}" }
        if (beta == null) return
        val u = impact.approach.toDouble()
        val g = impact.sliding.length.toDouble()
        val mass = impact.reduced.toDouble()
        val expected =
            mass / 2 * ((1 - drawn.e * drawn.e) * u * u + drawn.q / (1 + drawn.q) * (1 - beta * beta) * g * g)
        assertEquals(expected, loss, 1e-13 * energy) { "seed $seed" }
    }

    @Test
    fun `ten thousand impacts on rough walls are those of sixty digits`() {
        val box = Box.centred(20.0, 20.0, 20.0)
        for (seed in 1..DRAWS) {
            val drawn = Drawn(seed)
            val sphere = drawn.exact[0]
            val axis = drawn.random.nextInt(3)
            // The one that it moves to.
            val face = 2 * axis + if (sphere.v.numbers[axis] > 0) 1 else 0
            val side = if (face % 2 == 0) -1.0 else 1.0
            fun along(axis: Int) = if (axis == face / 2) side else 0.0
            val normal = Exact(along(0), along(1), along(2))
            val wall = ExactSphere(sphere.at, Exact(0.0, 0.0, 0.0), Exact(0.0, 0.0, 0.0), BigDecimal.ONE, null)
            val impact = ExactImpact(sphere, wall, normal, BigDecimal(drawn.q))
            val stick = impact.sticking(drawn.beta)
            val slip = impact.slipping(drawn.mu, drawn.e)
            val slips = drawn.isCoulomb && slip.length < stick.length
            val (expected, _) = impact.after(drawn.e, if (slips) slip else stick)
            val rows = rows(drawn.population)
            val roughness = List(6) { if (it == face) drawn.roughness else null }
            val law = CollisionLaw(ConstantRestitution(1.0), momentFactor = drawn.q)
            val walls = WallContact().apply { prepare(Walls(box, drawn.e, roughness = roughness).walls, law) }
            walls.reflect(rows, 0, face, 0.0, outcome)
            assertSame(expected, rows, 0, drawn.scale, "seed $seed, face $face")
            // The opposite one is smooth.
            val other = rows(drawn.population)
            walls.reflect(other, 0, face xor 1, 0.0, outcome)
            assertEquals(rows(drawn.population).spin(0), other.spin(0))
        }
    }

    @Test
    fun `a surface slides on an image that slides as on a sphere with its velocity, and spins are not sheared`() {
        val law = CollisionLaw(ConstantRestitution(0.7), NoGuard, CoulombRoughness(0.4, 0.3))
        val images = Images().apply { prepare(LeesEdwards(Box.centred(8.0, 8.0, 8.0), 0.5), 0.0) }
        val code = Images.code(0, 1, 0)
        val spins = listOf(Exact(0.3, -0.2, 0.9), Exact(-0.5, 0.4, 0.1))
        val first = Sphere(y = 3.5, vx = 0.2, vy = 1.0, vz = 0.3)
        val through = rows(spun(listOf(first, Sphere(y = -2.5, vx = -0.1, vy = -0.5)), spins))
        val beside = rows(spun(listOf(first, Sphere(y = 5.5, vx = -0.1 + images.slide(code, 0), vy = -0.5)), spins))
        assertEquals(4.0, images.slide(code, 0))
        law.collide(through, 0, 1, code, images, 0.0, outcome)
        law.collide(beside, 0, 1, 0, still, 0.0, outcome)
        for (slot in 0..1) for (axis in 0..2) assertEquals(beside.spin(slot)[axis], through.spin(slot)[axis], 1e-15)
        assertEquals(beside.velocity(0)[0], through.velocity(0)[0], 1e-15)
        assertEquals(beside.velocity(1)[0] - 4.0, through.velocity(1)[0], 1e-15)
        assertTrue(abs(through.spin(0)[2] - 0.9) > 0.1)
    }

    @Test
    fun `a guarded impact has its roughness still, and the law is told that it is elastic`() {
        var told = 0.0
        val roughness = Roughness { contact ->
            told = contact.restitution
            0.0
        }
        val rows = rows(spun(listOf(Sphere(vx = 1e-3, vy = 1.0), Sphere(x = 2.0)), List(2) { Exact(0.0, 0.0, 0.0) }))
        CollisionLaw(ConstantRestitution(0.5), FloorSpeedGuard(0.01), roughness)
            .collide(rows, 0, 1, 0, still, 0.0, outcome)
        assertTrue(outcome.guarded)
        assertEquals(1.0, told)
        // β = 0 for solid spheres: a seventh of the sliding goes over to the other.
        assertEquals(1.0 - 1.0 / 7, rows.velocity(0)[1], 1e-15)
        assertEquals(-1.0 / 7 / 0.4, rows.spin(0)[2], 1e-15)
    }

    @Test
    fun `a law is told of the sphere with the lower id first, whichever is named first, and of a wall as infinite`() {
        val said = ArrayList<List<Double>>()
        val roughness = Roughness { contact ->
            with(contact) { said += listOf(firstRadius, secondRadius, firstMass, secondMass, momentFactor) }
            -1.0
        }
        val spheres = listOf(Sphere(vx = 1.0, vy = 1.0, r = 0.5, m = 2.0), Sphere(x = 2.0, r = 1.5, m = 7.0))
        val p = spun(spheres, List(2) { Exact(0.0, 0.0, 0.0) })
        val law = CollisionLaw(ConstantRestitution(1.0), NoGuard, roughness, 0.5)
        for ((a, b) in listOf(0 to 1, 1 to 0)) law.collide(rows(p), a, b, 0, still, 0.0, outcome)
        val rough = Walls(Box.centred(8.0, 8.0, 8.0), roughness = List(6) { roughness })
        val walls = WallContact().apply { prepare(rough.walls, law) }
        walls.reflect(rows(p), 0, 1, 0.0, outcome)
        val infinity = Double.POSITIVE_INFINITY
        val pair = listOf(0.5, 1.5, 2.0, 7.0, 0.5)
        assertEquals(listOf(pair, pair, listOf(0.5, infinity, 2.0, infinity, 0.5)), said)
    }

    @Test
    fun `what is out of range makes no law, and a law that leaves the range ends the step`() {
        val none = listOf<() -> Any>(
            { ConstantRoughness(Math.nextUp(1.0)) },
            { ConstantRoughness(Math.nextDown(-1.0)) },
            { ConstantRoughness(Double.NaN) },
            { CoulombRoughness(-0.1, 0.0) },
            { CoulombRoughness(Double.POSITIVE_INFINITY, 0.0) },
            { CoulombRoughness(0.1, 1.1) },
            { CollisionLaw(ConstantRestitution(1.0), momentFactor = 0.0) },
            { CollisionLaw(ConstantRestitution(1.0), momentFactor = 1.01) },
            { CollisionForcing(ConstantRestitution(1.0), momentFactor = 0.67).advance(populationOf(), Open, 0.0, 1.0) },
            { Walls(Box.centred(8.0, 8.0, 8.0), roughness = List(5) { null }) },
        )
        for ((k, make) in none.withIndex()) assertThrows(IllegalArgumentException::class.java, { make() }, "number $k")
        for ((bad, word) in listOf(1.5 to "1.5", -1.5 to "-1.5", Double.NaN to "NaN")) {
            val pair = populationOf(Sphere(x = -3.0, vx = 2.0), Sphere(x = 3.0, y = 0.5))
            val simulation = simulation(pair.withSpin(DoubleArray(2), DoubleArray(2), DoubleArray(2))) { bad }
            val e = assertThrows(IllegalArgumentException::class.java) { repeat(5) { simulation.advance() } }
            assertTrue(e.message!!.startsWith("the coefficient of tangential restitution is $word where")) { e.message }
        }
    }

    private fun simulation(p: Population, roughness: Roughness?) = Simulation(
        p,
        Open,
        CollisionForcing(ConstantRestitution(1.0), roughness = roughness),
        FixedTimeStep(1.0),
    )

    private companion object {
        const val DRAWS = 10_000
        const val CLOSE = 1e-14

        fun spun(spheres: List<Sphere>, w: List<Exact>): Population {
            fun column(axis: Int) = DoubleArray(spheres.size) { w[it].numbers[axis] }
            return populationOf(*spheres.toTypedArray()).withSpin(column(0), column(1), column(2))
        }
    }
}
