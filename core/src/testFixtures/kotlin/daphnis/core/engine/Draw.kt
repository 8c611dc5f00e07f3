package daphnis.core.engine

import daphnis.core.FixedTimeStep
import daphnis.core.Simulation
import daphnis.core.boundary.BoundaryConditions
import daphnis.core.boundary.Box
import daphnis.core.boundary.ContactFaces
import daphnis.core.boundary.LeesEdwards
import daphnis.core.boundary.Open
import daphnis.core.boundary.Periodic
import daphnis.core.boundary.ShearedPeriodic
import daphnis.core.boundary.Walls
import daphnis.core.collision.ContactDurationGuard
import daphnis.core.collision.FloorSpeedGuard
import daphnis.core.collision.NoGuard
import daphnis.core.compression.GrowingSpheres
import daphnis.core.force.Force
import daphnis.core.force.SelfGravity
import daphnis.core.force.thermostat.Andersen
import daphnis.core.force.thermostat.Rescaling
import daphnis.core.force.thermostat.WhiteNoise
import daphnis.core.hill.Epicycle
import daphnis.core.hill.HillFrame
import daphnis.core.hill.HillSheet
import daphnis.core.hill.Satellite
import daphnis.core.initial.EqualSizes
import daphnis.core.initial.Lattice
import daphnis.core.initial.LatticePlacement
import daphnis.core.initial.PlacementException
import daphnis.core.initial.Positions
import daphnis.core.initial.RandomPlacement
import daphnis.core.initial.SeededRandom
import daphnis.core.merging.BreakRule
import daphnis.core.merging.MergeRule
import daphnis.core.orbit.OrbitalFrequencies
import daphnis.core.population.Population
import daphnis.core.search.SearchStructure
import daphnis.core.source.Inflow
import daphnis.core.source.Outflow
import daphnis.core.source.Reservoir
import daphnis.core.source.Source
import daphnis.core.source.Sources
import daphnis.core.source.Supply
import daphnis.core.surface.BridgesRestitution
import daphnis.core.surface.ConstantRestitution
import daphnis.core.swap.SwapRule

/** A random gas for engines: everything follows from [seed]. */
class Draw(override val seed: Long) : Case {
    override val random = SeededRandom(seed)
    private val surface = SurfaceDraw(seed)
    private val driven = WallDraw(seed)
    private val filling = Math.exp(random.nextDouble(Math.log(0.01), Math.log(0.5)))
    private val clumped = random.nextInt(4) == 0
    private val flat = random.nextInt(3) == 0

    /** How neighbours are looked for. */
    private val search = SearchStructure.entries[random.nextInt(3)]

    /** Of Hill's frame, where the boundary is its sheet. */
    private val omega = random.nextDouble(0.02, 0.2)
    private val orbits = OrbitalFrequencies(omega, if (seed % 2 == 0L) 1.0 else 0.8, 1.5)
    private val radii = drawRadii()
    private val volume = radii.sumOf { 4.0 / 3 * Math.PI * it * it * it } / filling
    private val box = drawBox()
    private val shapes = ShapeDraw(seed)

    /** The walls around spheres that have their places. */
    private var shaped: ((Positions) -> Walls)? = null
    override var boundary = drawBoundary()
        private set
    override val population = populate()

    /**
     * Three decades, in units of the mean time between collisions, so that some steps have a collision a thousand
     * spheres and some several each.
     */
    override val dt =
        Math.exp(random.nextDouble(Math.log(1e-3), Math.log(1.0))) * radii.average() / (6 * population.fillingNow())
    private val restitution = listOf(
        ConstantRestitution(1.0),
        // Plastic ones gather in clusters: where these are dense, they have very many collisions.
        ConstantRestitution(if (filling > 0.05 || clumped) 0.6 else 0.0),
        BridgesRestitution(),
    )[random.nextInt(3)]

    // Inelastic spheres in dense heaps collapse without one.
    private val guards = listOf(FloorSpeedGuard(1e-3), ContactDurationGuard(1e-4 * dt), NoGuard)
    private val guard = guards[random.nextInt(if (filling > 0.05 || clumped) 2 else 3)]

    private val interactions = InteractionDraw(seed).of(population, boundary)

    /** In some all spheres merge that meet, or those that meet slowly. */
    private val mergeRule = when (seed % 6) {
        2L -> MergeRule.always()
        5L -> MergeRule.below(1.0)
        else -> null
    }.takeIf { interactions == null }

    /** In some spheres break that meet fast. */
    private val breakRule = BreakRule(1.5, 2 + (seed % 5).toInt(), 0.3, 0.4 * radii.average(), seed)
        .takeIf { (seed % 12 == 5L || seed % 12 == 9L) && interactions == null && !population.hasSpin }

    /** In some spheres swap places, about as often as some of them collide. */
    private val swapRule = SwapRule(0.3 / dt, seed).takeIf {
        seed % 5 == 3L && interactions == null && mergeRule == null && breakRule == null && boundary.meanFlow == null
    }

    /** In some spheres come and leave, where the ends of the box are. */
    private val sources: List<Source> = if (seed % 9 != 4L || interactions != null) emptyList() else drawSources()

    private fun drawSources(): List<Source> {
        val sink = Outflow(part(0.6, 0.7))
        if (boundary.shear != null || boundary.meanFlow != null) return listOf(sink)
        val supply = Supply(EqualSizes(radii.min()), radii.min(), mass = radii.min() * radii.min() * radii.min())
        val gas = Reservoir(part(0.0, 0.3), 0.15, 1.0, supply, trials = 30)
        val stream = Inflow(part(0.75, 1.0), 3 / dt, listOf(0.5, 0.0, 0.0), 0.5, supply)
        if (boundary === Open || boundary.contactFaces(0) == ContactFaces.OPEN) return listOf(gas, sink, stream)
        return listOf(gas, sink, stream, Inflow(box, 2 / dt, listOf(0.0, 0.0, 0.0), 1.0, supply, through = 1))
    }

    /** The box from one part of its length along x to another. */
    private fun part(from: Double, to: Double): Box {
        fun at(part: Double) = if (part == 1.0) box.upperX else box.lowerX + part * box.length(0)
        return Box(at(from), box.lowerY, box.lowerZ, at(to), box.upperY, box.upperZ)
    }

    private fun Population.fillingNow() = if (clumped) maxOf(filling, 0.2) else filling

    private fun drawRadii(): DoubleArray {
        val count = if (random.nextInt(5) == 0) {
            1 + random.nextInt(30)
        } else {
            Math.exp(random.nextDouble(Math.log(30.0), Math.log(3000.0))).toInt()
        }
        val smallest = if (filling > 0.3 || random.nextInt(2) == 0) 1.0 else random.nextDouble(0.1, 1.0)
        // Some with a few much larger ones among many small, for the search by size.
        val wide = smallest < 0.5 && random.nextInt(2) == 0
        return DoubleArray(count) {
            if (smallest == 1.0) {
                1.0
            } else if (wide && it % 50 != 0) {
                random.nextDouble(0.02, 0.1)
            } else {
                random.nextDouble(smallest, 1.0)
            }
        }
    }

    private fun drawBox(): Box {
        val height = if (flat) maxOf(2.2, Math.cbrt(volume) / 5) else Math.cbrt(volume) * random.nextDouble(0.7, 1.4)
        val x = Math.sqrt(volume / height) * random.nextDouble(0.7, 1.4)
        return Box.centred(maxOf(x, 2.2), maxOf(volume / height / x, 2.2), maxOf(height, 2.2))
    }

    private fun drawBoundary(): BoundaryConditions = when (random.nextInt(10)) {
        0 -> Open
        1 -> Periodic(box, random.nextInt(2) == 0, true, random.nextInt(2) == 0)
        2 -> walls(random.nextDouble(0.5, 1.0), booleanArrayOf(true, true, true))
        3 -> walls(1.0, booleanArrayOf(false, true, false))
        4 -> ShearedPeriodic(box, random.nextDouble(-1.0, 1.0))
        5, 6 -> LeesEdwards(box, random.nextDouble(-0.3, 0.3))
        7, 8 -> sheet(radiallyOpen = random.nextInt(4) == 0)
        else -> Periodic(box)
    }

    /** In some sheets the images breathe. They are as far apart at the start as the [box] is long. */
    private fun sheet(radiallyOpen: Boolean): HillSheet {
        if (radiallyOpen || seed % 2 == 0L) return HillSheet(box, orbits, radiallyOpen)
        val q = 0.1 + 0.2 * (seed % 5)
        val by = 1 - q * StrictMath.cos(orbits.kappa * phaseTime)
        val mean =
            Box(box.lowerX / by, box.lowerY, box.lowerZ, box.upperX / by, box.upperY, box.upperZ)
        return HillSheet(mean, orbits, false, q)
    }

    private val isPerturbed: Boolean get() = (boundary as? HillSheet)?.let { it.perturbation > 0 } == true

    /** When a perturbed sheet begins: whatever it is narrowing or widening. */
    private val phaseTime: Double get() = seed % 7 * 0.9 / orbits.kappa

    private fun walls(restitution: Double, walled: BooleanArray): Walls {
        val faces = driven.faces(surface.walls, walled)
        shaped = { places ->
            shapes.around(box, walled, surface.walls, arrayOf(places.x, places.y, places.z), radii) { surfaces, room ->
                val plain = Walls(room, restitution, walled, surfaces = surfaces)
                val own = faces.mapIndexed { k, it -> it.takeIf { plain.contactFaces(k / 2) == ContactFaces.WALL } }
                Walls(room, restitution, walled, surface.walls, own, seed, surfaces)
            }
        }
        return Walls(box, restitution, walled, surface.walls, faces, seed)
    }

    private fun populate(): Population {
        val room = if (clumped) corner() else box
        val walled = BooleanArray(3) { clumped || boundary.contactFaces(it) != ContactFaces.PERIODIC }
        val places = try {
            if (filling > 0.3 && !clumped) {
                LatticePlacement(Lattice.FACE_CENTRED_CUBIC).place(radii, room, walled, random)
            } else {
                RandomPlacement(2_000).place(radii, room, walled, random)
            }
        } catch (e: PlacementException) {
            null
        }
        if (places == null) {
            // Too dense a draw: loosely packed in open space does as well.
            boundary = Open
            val edge = Math.ceil(Math.cbrt(radii.size.toDouble())).toInt()
            fun at(k: Int) = 2.01 * k
            return made(
                DoubleArray(radii.size) { at(it % edge) },
                DoubleArray(radii.size) { at(it / edge % edge) },
                DoubleArray(radii.size) { at(it / edge / edge) },
            )
        }
        shaped?.let { boundary = it(places) }
        return made(places.x, places.y, places.z)
    }

    /** A corner of the box, eight times as dense if it can be. */
    private fun corner(): Box {
        fun part(axis: Int) = box.lower(axis) + maxOf(2.2, 0.55 * box.length(axis)).coerceAtMost(box.length(axis))
        return Box(box.lowerX, box.lowerY, box.lowerZ, part(0), part(1), part(2))
    }

    private fun made(x: DoubleArray, y: DoubleArray, z: DoubleArray): Population {
        val n = x.size
        fun gauss() = DoubleArray(n) { random.nextGaussian() }
        val masses = DoubleArray(n) { radii[it] * radii[it] * radii[it] }
        return surface.of(Population(x, y, z, gauss(), gauss(), gauss(), radii, masses))
    }

    /** In some of the boxes that repeat spheres grow or shrink. */
    private fun around(): BoundaryConditions {
        if (interactions != null || mergeRule != null || breakRule != null || sources.isNotEmpty()) return boundary
        val isWhole = boundary is Periodic && (0..2).all { boundary.hasImages(it) }
        if (!isWhole || seed % 4 == 0L) return boundary
        val most = if (filling < 0.2 && !clumped) 0.05 else 0.002
        return GrowingSpheres(box, (if (seed % 8 == 1L) -most else most) / dt, -dt, thermostat = seed % 3 != 0L)
    }

    override fun simulation(engine: CollisionEngine) = Simulation(
        population.copy(),
        around(),
        CollisionForcing(
            surface.law(restitution),
            guard,
            engine,
            recordCollisions = true,
            search,
            momentFactor = surface.momentFactor,
            interactions = interactions,
            mergeRule = mergeRule,
            breakRule = breakRule,
            swapRule = swapRule,
        ),
        FixedTimeStep(dt),
        forces(),
        startTime = if (isPerturbed) phaseTime else 0.0,
        sources = if (sources.isEmpty()) null else Sources(sources, seed),
    )

    /**
     * In the sheet: Hill's frame, a moon beside it, and in some gravity, whose sums engines spread over their threads.
     * Elsewhere some have a thermostat.
     */
    private fun forces(): List<Force> {
        if (boundary !is HillSheet) return driven.forces(boundary, dt) + thermostats()
        if (dt * omega > 1) return emptyList()
        val orbit = Epicycle(2 * box.upperX, 0.0, 0.5, 1.0)
        val inertia = if (seed % 2 == 0L) 10.0 else Double.POSITIVE_INFINITY
        val moon = Satellite(omega * omega * 10, orbit, orbits, softening = 0.5, mass = inertia)
        val frame = HillFrame(orbits)
        return if (seed % 3 == 0L && !isPerturbed) {
            listOf(frame, moon, SelfGravity(boundary, omega * omega / 50))
        } else {
            listOf(moon, frame)
        }
    }

    private fun thermostats(): List<Force> = when (seed % 8) {
        1L -> listOf(WhiteNoise(seed, 0.2, 0.3, conservesMomentum = true, boundary = boundary))
        3L -> listOf(Andersen(seed, 0.5, 1.0, boundary = boundary), WhiteNoise(-seed, 0.1))
        5L -> listOf(Rescaling(1.0, dt, boundary))
        else -> emptyList()
    }

    override fun threads(): Int = 1 + random.nextInt(8)

    override fun toString() =
        "seed $seed: ${population.size} spheres, filling $filling${if (clumped) ", clumped" else ""}, " +
            "${around().javaClass.simpleName}${if (isPerturbed) ", perturbed" else ""}${boundary.walls.surfaces.map {
                ", $it"
            }.joinToString(
                "",
            )}, dt $dt$surface${if (interactions != null) ", with steps" else ""}" +
            (if (mergeRule != null) ", merging" else "") + (if (breakRule != null) ", breaking" else "") +
            (if (swapRule != null) ", swapping" else "") +
            (if (sources.isNotEmpty()) ", ${sources.size} sources" else "")
}
