package daphnis.analysis.neighbour

import daphnis.analysis.insitu.State
import kotlin.math.sqrt

/**
 * A cluster of two spheres or more, measured. Vectors are x, y, z; units are those of the state. Of a cluster that
 * spans the box no centre, radius, spin or filling factor is known: all are NaN.
 *
 * @property number in [Clusters.label], from 0 on, the largest first
 * @property members number of spheres
 * @property mass their mass
 * @property centre of mass, in the box
 * @property velocity of the centre of mass, relative to the flow that the boundary drives there: in Hill's frame to
 *   −(3/2) Ω x along y
 * @property gyrationRadius R_g, the root of Σ m (|r − centre|² + (3/5) radius²)/Σ m, of discs (1/2) radius²: spheres
 *   have their extent, so √(5/3) R_g of a ball is its radius
 * @property spin angular velocity ω of the rigid body that has the angular momentum L about the centre: I ω = L, I the
 *   tensor of inertia. In Hill's frame relative to the frame; among the stars Ω more along z. Where spheres have spins,
 *   these are in L, and their own moments of inertia in I. Otherwise I is of points, and there is no component
 *   along a straight row of spheres
 * @property fillingFactor volume of the members over that of a ball of radius √(5/3) R_g (Mukai et al. 1992, A&A 262,
 *   315), 1 for a ball that is full; of discs areas, and √2 R_g
 * @property temperature ⟨c²⟩/3 by mass, of discs ⟨c²⟩/2, c the velocity of a member without the motion of the centre and
 *   the rigid rotation that fits the velocities best; divided by the degrees of freedom that are left, so that the mean
 *   is that of the granular temperature in equilibrium. Of a cluster that spans the box c is around its mean velocity
 *   against the flow
 * @property isSpanning whether it spans the box: it is linked to an image of itself
 */
public class Cluster internal constructor(
    public val number: Int,
    public val members: Int,
    public val mass: Double,
    public val centre: DoubleArray,
    public val velocity: DoubleArray,
    public val gyrationRadius: Double,
    public val spin: DoubleArray,
    public val fillingFactor: Double,
    public val temperature: Double,
    public val isSpanning: Boolean,
) {
    override fun toString(): String = "cluster $number of $members"

    public companion object {
        /**
         * The clusters [found] in [state] that have two members or more, the largest first.
         *
         * @param momentFactor moment of inertia of a sphere over mass · radius², for those that have spins; that of
         *   homogeneous ones when not given
         * @throws IllegalArgumentException for clusters of another number of spheres
         */
        @JvmStatic
        @JvmOverloads
        public fun of(
            state: State,
            found: Clusters,
            momentFactor: Double = state.boundary.space.momentFactor,
        ): List<Cluster> {
            require(found.label.size == state.population.size) {
                "clusters of ${found.label.size} spheres for ${state.population.size}"
            }
            val several = found.sizes.count { it >= 2 }
            val members = List(several) { IntArray(found.sizes[it]) }
            val next = IntArray(several)
            for (i in found.label.indices) {
                val k = found.label[i]
                if (k in 0 until several) members[k][next[k]++] = i
            }
            return List(several) { ClusterMotion(state, found, it, members[it], momentFactor).cluster() }
        }
    }
}

/** The [members] of the cluster of a [number], by their indices, and how they move about its centre. */
private class ClusterMotion(
    private val state: State,
    private val found: Clusters,
    private val number: Int,
    private val members: IntArray,
    private val momentFactor: Double,
) {
    private val p = state.population
    private val space = state.boundary.space
    private val isSpanning = found.isSpanning[number]
    private val mass = members.sumOf { p.mass[it] }
    private val middle = DoubleArray(3) { axis -> byMass { found.place(it, axis) } }
    private val velocity = DoubleArray(3) { axis -> byMass { state.againstFlow(it, axis) } }
    private val inertia = Inertia()
    private val own = Inertia()

    private inline fun byMass(value: (Int) -> Double) = members.sumOf { p.mass[it] * value(it) } / mass

    /** Position of the sphere [i] from the centre. */
    private fun place(i: Int, axis: Int) = found.place(i, axis) - middle[axis]

    /** Velocity of the sphere [i] against the centre; where it is beyond a face that slides, of its image there. */
    private fun motion(i: Int, axis: Int): Double {
        val v = state.againstFlow(i, axis) - velocity[axis]
        val flow = state.boundary.meanFlow
        val gradient = flow?.gradient(axis) ?: 0.0
        if (isSpanning || gradient == 0.0) return v
        return v + gradient * place(i, flow!!.normalAxis)
    }

    fun cluster(): Cluster {
        if (isSpanning) {
            val square = byMass { i -> (0..2).sumOf { motion(i, it) * motion(i, it) } }
            return result(NOWHERE, Double.NaN, NOWHERE, Double.NaN, temperature(square, 0))
        }
        val extent = space.dimensions / (space.dimensions + 2.0)
        var moment = 0.0
        for (i in members) {
            val r = DoubleArray(3) { place(i, it) }
            inertia.add(p.mass[i], r, DoubleArray(3) { motion(i, it) })
            moment += p.mass[i] * (r[0] * r[0] + r[1] * r[1] + r[2] * r[2] + extent * p.radius[i] * p.radius[i])
            if (p.hasSpin) own.spin(momentFactor * p.mass[i] * p.radius[i] * p.radius[i], p.wx[i], p.wy[i], p.wz[i])
        }
        val rotation = inertia.rotation(space.isPlane)
        val square = byMass { i ->
            val (x, y, z) = DoubleArray(3) { place(i, it) }
            val cx = motion(i, 0) - (rotation[1] * z - rotation[2] * y)
            val cy = motion(i, 1) - (rotation[2] * x - rotation[0] * z)
            val cz = motion(i, 2) - (rotation[0] * y - rotation[1] * x)
            cx * cx + cy * cy + cz * cz
        }
        val radius = sqrt(moment / mass)
        val volume = space.volume(radius / sqrt(extent))
        return result(
            centre(),
            radius,
            if (p.hasSpin) (inertia + own).rotation(space.isPlane) else rotation,
            members.sumOf { space.volume(p.radius[it]) } / volume,
            temperature(square, inertia.rotations(space.isPlane)),
        )
    }

    private fun temperature(square: Double, rotations: Int): Double {
        val freedom = space.dimensions * (members.size - 1) - rotations
        return if (freedom > 0) square * members.size / freedom else Double.NaN
    }

    private fun result(centre: DoubleArray, radius: Double, spin: DoubleArray, filling: Double, temperature: Double) =
        Cluster(
            number, members.size, mass, centre.copyOf(), velocity, radius, spin.copyOf(), filling, temperature,
            isSpanning,
        )

    /** In the box, where it repeats: of the images of the centre of mass that which is there. */
    private fun centre(): DoubleArray {
        val boundary = state.boundary
        val c = DoubleArray(3) { p.position(it)[members[0]] + middle[it] - found.place(members[0], it) }
        fun turns(axis: Int) = Math.floor((c[axis] - boundary.box.lower(axis)) / boundary.box.length(axis))
        boundary.shear?.let { shear ->
            val boxes = turns(shear.normalAxis)
            c[shear.normalAxis] -= boxes * boundary.box.length(shear.normalAxis)
            c[shear.slideAxis] -= boxes * shear.offset(state.time)
        }
        for (axis in 0..2) if (boundary.repeats(axis)) c[axis] -= turns(axis) * boundary.box.length(axis)
        return c
    }

    private companion object {
        val NOWHERE = DoubleArray(3) { Double.NaN }
    }
}
