package daphnis.core.engine

import daphnis.core.FixedTimeStep
import daphnis.core.Simulation
import daphnis.core.boundary.BoundaryConditions
import daphnis.core.boundary.Box
import daphnis.core.boundary.LeesEdwards
import daphnis.core.boundary.Open
import daphnis.core.boundary.Periodic
import daphnis.core.boundary.Walls
import daphnis.core.collision.CollapseGuard
import daphnis.core.collision.FloorSpeedGuard
import daphnis.core.collision.NoGuard
import daphnis.core.initial.SeededRandom
import daphnis.core.population.Population
import daphnis.core.surface.ConstantRestitution

/**
 * A random case of the kinds that gases never are: exact, jammed, far too large or too small. Everything follows from
 * [seed].
 */
class OddDraw(override val seed: Long) : Case {
    override val random = SeededRandom(seed)
    private val surface = SurfaceDraw(seed)
    private val driven = WallDraw(seed)
    private val kind = Kind.entries[random.nextInt(Kind.entries.size)]

    private enum class Kind {
        TOUCHING_AT_REST,
        LATTICE,
        IMAGES,
        TIGHT,
        INELASTIC,
        ZEROS,
        CORNER,
        PILE,
        SCALES,
        THREADS,
    }

    private val spheres = ArrayList<DoubleArray>()
    override var boundary: BoundaryConditions = Open
        private set
    override var dt = 1.0
        private set
    private var coefficient = if (random.nextInt(2) == 0) 1.0 else 0.6
    private var guard: CollapseGuard = NoGuard

    init {
        when (kind) {
            Kind.TOUCHING_AT_REST -> touchingAtRest()
            Kind.LATTICE -> lattice()
            Kind.IMAGES -> images()
            Kind.TIGHT -> tight()
            Kind.INELASTIC -> inelastic()
            Kind.ZEROS -> layer()
            Kind.CORNER -> corner()
            Kind.PILE -> pile()
            Kind.SCALES -> scales()
            Kind.THREADS -> gas(300, 1.0, 0.0)
        }
    }

    override val population: Population = column().let { c ->
        surface.of(Population(c(0), c(1), c(2), c(3), c(4), c(5), c(6), c(7)))
    }

    private fun column(): (Int) -> DoubleArray = { field -> DoubleArray(spheres.size) { spheres[it][field] } }

    private fun add(
        x: Double,
        y: Double,
        z: Double,
        vx: Double,
        vy: Double,
        vz: Double,
        r: Double,
        m: Double = r * r * r,
    ) {
        spheres += doubleArrayOf(x, y, z, vx, vy, vz, r, m)
    }

    private fun walls(box: Box, restitution: Double): Walls {
        val faces = if (kind == Kind.SCALES) emptyList() else driven.faces(surface.walls)
        return Walls(box, restitution, roughness = surface.walls, faces = faces, seed = seed)
    }

    private fun gauss() = random.nextGaussian()

    private fun zero() = if (random.nextInt(2) == 0) 0.0 else -0.0

    /** Spheres at rest that touch exactly, and two that hit them. */
    private fun touchingAtRest() {
        val edge = 2 + random.nextInt(4)
        for (k in 0 until edge * edge * edge) {
            add(
                1.0 * (k % edge),
                1.0 * (k / edge % edge),
                1.0 * (k / edge / edge),
                zero(),
                zero(),
                zero(),
                0.5,
            )
        }
        add(-3.0, 0.0, 0.0, 2.0, 0.0, 0.0, 0.5)
        add(1.0 * edge + 3, random.nextDouble(0.0, 1.0), 0.0, -3.0, 0.0, 0.0, 0.5)
        boundary =
            if (random.nextInt(2) ==
                0
            ) {
                Open
            } else {
                walls(Box(-4.0, -0.5, -0.5, edge + 5.0, edge - 0.5, edge + 0.5), 1.0)
            }
        dt = 2.0
    }

    /** Neighbours close in on one another at the same speed: very many collisions at the same moment. */
    private fun lattice() {
        val edge = 2 * (1 + random.nextInt(4))
        for (k in 0 until edge * edge * edge) {
            val odd = if ((k % edge + k / edge % edge + k / edge / edge) % 2 == 0) 1.0 else -1.0
            add(
                2.0 * (k % edge),
                2.0 * (k / edge % edge),
                2.0 * (k / edge / edge),
                odd,
                if (random.nextInt(20) == 0) {
                    0.5
                } else {
                    0.0
                },
                -0.5 * odd,
                0.4,
            )
        }
        val box = Box(-1.0, -1.0, -1.0, 2.0 * edge - 1, 2.0 * edge - 1, 2.0 * edge - 1)
        boundary =
            listOf(
                Periodic(box),
                walls(box, 0.9),
                Open,
                LeesEdwards(box, 0.25),
            )[random.nextInt(4)]
        dt = 0.75
    }

    /** So long a step that spheres go several boxes; some go too far. */
    private fun images() {
        val box = Box.centred(random.nextDouble(1.0, 2.0), random.nextDouble(3.0, 6.0), random.nextDouble(3.0, 6.0))
        repeat(2 + random.nextInt(4)) { k ->
            add(
                0.0,
                -1.4 + 0.5 * k,
                random.nextDouble(-1.0, 1.0),
                2 * gauss(),
                0.1 * gauss(),
                0.1 * gauss(),
                0.2,
                Math.exp(2 * gauss()),
            )
        }
        boundary = if (random.nextInt(2) == 0) Periodic(box) else LeesEdwards(box, random.nextDouble(-1.0, 1.0))
        dt = random.nextDouble(1.0, 4.0)
    }

    /** Few spheres with hardly any room. */
    private fun tight() {
        val count = 2 + random.nextInt(4)
        val room = 2 + Math.pow(10.0, random.nextDouble(-5.0, 0.0))
        repeat(count) { add(room * (it + 0.5), room / 2, room / 2, gauss(), gauss(), gauss(), 1.0) }
        val box = Box(0.0, 0.0, 0.0, room * count, room, room)
        boundary = if (random.nextInt(2) == 0) walls(box, coefficient) else Periodic(box)
        dt = 0.2
    }

    /** Collisions that take all, with and without a guard. */
    private fun inelastic() {
        coefficient = listOf(0.0, 0.05, 0.3)[random.nextInt(3)]
        guard = if (random.nextInt(2) == 0) NoGuard else FloorSpeedGuard(1e-3)
        gas(20 + random.nextInt(100), 1.0, 0.0)
    }

    /** A flat layer whose zeros have both signs. */
    private fun layer() {
        val wide = if (random.nextInt(2) == 0) 2.5 else 2.1
        repeat(30 + random.nextInt(150)) { add(it % 12 * wide, it / 12 * wide, zero(), gauss(), gauss(), zero(), 1.0) }
        val box = Box(-1.25, -1.25, -10.0, 30.0, 40.0, 10.0)
        boundary = listOf(Open, Periodic(box), walls(box, 0.0))[random.nextInt(3)]
        dt = 0.5
    }

    /** Spheres in the corner of walls, all on their way into it. */
    private fun corner() {
        val edge = 2 + random.nextInt(3)
        for (k in 0 until edge * edge * edge) {
            fun at(c: Int) = 0.5 + 1.0001 * c
            add(
                at(k % edge),
                at(k / edge % edge),
                at(k / edge / edge),
                -1.0 + 0.1 * gauss(),
                -1.0,
                -1.0 + 0.1 * gauss(),
                0.5,
            )
        }
        boundary = walls(Box(0.0, 0.0, 0.0, 20.0, 20.0, 20.0), listOf(0.0, 0.5, 1.0)[random.nextInt(3)])
        guard = if (coefficient == 1.0) NoGuard else FloorSpeedGuard(1e-3)
        dt = 0.05
    }

    /** One sphere fifty times as large as the many that fall on it. */
    private fun pile() {
        add(0.0, 0.0, 0.0, 0.0, 0.0, 0.5, 5.0)
        repeat(150) { k ->
            add(
                0.25 * (k % 12 - 6),
                0.25 * (k / 12 - 6),
                5.3 + 0.01 * gauss(),
                0.0,
                0.0,
                -1.0 + 0.1 * gauss(),
                0.1,
            )
        }
        guard = if (coefficient == 1.0) NoGuard else FloorSpeedGuard(1e-3)
        dt = 0.3
    }

    /** A gas in units thirty orders of magnitude away, or far from the origin. */
    private fun scales() {
        val length = Math.pow(10.0, listOf(-30.0, 0.0, 30.0)[random.nextInt(3)])
        gas(60, length, if (random.nextInt(2) == 0) 0.0 else 1e5 * length)
        val speed = Math.pow(10.0, listOf(-30.0, 0.0, 30.0)[random.nextInt(3)])
        for (s in spheres) for (axis in 3..5) s[axis] *= speed
        dt *= length / speed
    }

    private fun gas(count: Int, length: Double, offset: Double) {
        val edge = Math.ceil(Math.cbrt(1.0 * count)).toInt()
        val apart = random.nextDouble(2.05, 4.0)
        fun at(c: Int) = offset + length * apart * c
        repeat(count) {
            add(
                at(it % edge),
                at(it / edge % edge),
                at(it / edge / edge),
                gauss(),
                gauss(),
                gauss(),
                length,
                Math.exp(gauss()),
            )
        }
        val low = offset - length * apart / 2
        val high = low + length * apart * edge
        val box = Box(low, low, low, high, high, high)
        boundary =
            listOf(
                Open,
                Periodic(box),
                walls(box, 0.8),
                LeesEdwards(box, 0.0),
            )[random.nextInt(4)]
        dt = random.nextDouble(0.1, 1.0)
    }

    override fun simulation(engine: CollisionEngine): Simulation = Simulation(
        population.copy(),
        boundary,
        surface.collisions(ConstantRestitution(coefficient), guard, engine),
        FixedTimeStep(dt),
        if (kind == Kind.SCALES) emptyList() else driven.forces(boundary, dt),
    )

    override fun threads(): Int = if (kind == Kind.THREADS) 16 + random.nextInt(49) else 1 + random.nextInt(4)

    override fun toString() = "seed $seed: $kind, ${population.size} spheres, ${boundary.javaClass.simpleName}, " +
        "coefficient $coefficient, dt $dt$surface"
}
