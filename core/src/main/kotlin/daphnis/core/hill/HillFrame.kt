package daphnis.core.hill

import daphnis.core.force.Drift
import daphnis.core.force.PerSphereEnergy
import daphnis.core.orbit.OrbitalFrequencies
import daphnis.core.parallel.InlineLoop
import daphnis.core.parallel.RangeLoop
import daphnis.core.population.Population
import kotlin.math.abs

/**
 * Hill's frame: coordinates that rotate around a planet with angular speed Ω, x radially outward, y along the orbit, z
 * vertical,
 *
 * ẍ = 2Ω ẏ + (4Ω² − κ²) x, ÿ = −2Ω ẋ, z̈ = −ν² z; around a point mass κ = ν = Ω.
 *
 * **Free paths are exact although the drift is straight.** The solution over a time h is linear in the state, r₁ = r₀ +
 * h (A r₀ + B v₀). Before the drift every velocity is replaced by that of the chord, w = A r₀ + B v₀; a sphere that
 * does not collide then ends the step where its epicycle does. After the drift the chord's velocity is mapped to the
 * true one at its end, by the same map backwards in time, in which y and v_x change sign. So a free particle keeps its
 * epicycle to round-off.
 *
 * **What collisions conserve.** Both maps are the same for all spheres. A collision conserves Σ m w, hence Σ m r₁ and Σ
 * m v₁ are the same as without any collision. Σ m X and Σ m Y are those of free motion, to round-off, for any length of
 * the step.
 *
 * **Spins** are relative to the frame. One that rests among the stars turns backwards in it, so [afterDrift] turns its
 * horizontal part by −Ω h.
 *
 * Images of the shearing sheet stay images: the chord of a path displaced by L_x in x and −s L_x t in y, with s the
 * rate of shear, is displaced likewise. (Free motion: Hill 1878; kick–drift–kick in this frame: Quinn, Perrine, Richardson & Barnes 2010,
 * AJ 139, 803; Rein & Tremaine 2011, MNRAS 415, 3168.)
 *
 * @property frequencies Ω, κ and ν
 */
public class HillFrame(public val frequencies: OrbitalFrequencies) :
    Drift,
    PerSphereEnergy {
    /** Around a point mass, or with another [verticalFactor]. */
    @JvmOverloads
    public constructor(omega: Double, verticalFactor: Double = 1.0) :
        this(OrbitalFrequencies(omega, verticalFactor = verticalFactor))

    /** Ω in radians per unit of time. */
    public val omega: Double get() = frequencies.omega

    /** ν/Ω. */
    public val verticalFactor: Double get() = frequencies.verticalFactor

    private var loop: RangeLoop = InlineLoop

    // For the present duration: chord = (ax x + bxx vx + q vy, ay x − q vx + byy vy, az z + bz vz).
    private var duration = Double.NaN
    private var ax = 0.0
    private var ay = 0.0
    private var az = 0.0
    private var bxx = 1.0
    private var byy = 1.0
    private var bz = 1.0
    private var q = 0.0

    /** Of Ω times the duration. */
    private var cosine = 1.0
    private var sine = 0.0

    override val turning: Double get() = omega

    override fun useLoop(loop: RangeLoop) {
        this.loop = loop
    }

    /** @throws IllegalArgumentException for a step of more than a quarter of an orbit or of a vertical oscillation */
    override fun beforeDrift(population: Population, start: Double, duration: Double) {
        prepare(duration)
        loop.runLight(population.size) { _, from, to -> toChord(population, from, to) }
    }

    override fun afterDrift(population: Population, end: Double, duration: Double) {
        prepare(duration)
        loop.runLight(population.size) { _, from, to -> fromChord(population, from, to) }
        if (population.hasSpin) loop.runLight(population.size) { _, from, to -> turn(population, from, to) }
    }

    /**
     * Tidal and centrifugal potential energy m (−(2Ω² − ½κ²)x² + ½ν²z²). With the kinetic energy its sum is Hill's
     * energy, which a free particle keeps until it is wrapped radially: then the part of x² and v_y change, and so does
     * the sum, unless the particle's guiding centre is on the face.
     */
    override fun potentialEnergies(population: Population, time: Double, from: Int, to: Int, into: DoubleArray) {
        val p = population
        val radial = -frequencies.shearFactor * omega * omega
        val vertical = 0.5 * (verticalFactor * omega) * (verticalFactor * omega)
        for (k in from until to) {
            into[k - from] = p.mass[k] * (radial * p.x[k] * p.x[k] + vertical * p.z[k] * p.z[k])
        }
    }

    private fun toChord(p: Population, from: Int, to: Int) {
        val x = p.x
        val z = p.z
        val vx = p.vx
        val vy = p.vy
        val vz = p.vz
        for (k in from until to) {
            val u = vx[k]
            val v = vy[k]
            vx[k] = ax * x[k] + (bxx * u + q * v)
            vy[k] = ay * x[k] + (byy * v - q * u)
            vz[k] = az * z[k] + bz * vz[k]
        }
    }

    /**
     * Solves bxx u − q v = w_x + ax x, q u + byy v = w_y − ay x for the velocity (u, v) at the end: the map above with
     * time reversed.
     */
    private fun fromChord(p: Population, from: Int, to: Int) {
        val x = p.x
        val z = p.z
        val vx = p.vx
        val vy = p.vy
        val vz = p.vz
        val determinant = bxx * byy + q * q
        for (k in from until to) {
            val f = vx[k] + ax * x[k]
            val g = vy[k] - ay * x[k]
            vx[k] = (byy * f + q * g) / determinant
            vy[k] = (bxx * g - q * f) / determinant
            vz[k] = (vz[k] + az * z[k]) / bz
        }
    }

    private fun turn(p: Population, from: Int, to: Int) {
        val wx = p.wx
        val wy = p.wy
        for (k in from until to) {
            val u = wx[k]
            val v = wy[k]
            wx[k] = cosine * u + sine * v
            wy[k] = cosine * v - sine * u
        }
    }

    private fun prepare(duration: Double) {
        if (duration == this.duration) return
        val h = omega * duration
        val f = frequencies.radialFactor
        val hx = h * f
        val hz = h * verticalFactor
        require(h <= LONGEST && hx <= LONGEST && hz <= LONGEST) {
            val orbits = "${h / (2 * Math.PI)} orbits (${hz / (2 * Math.PI)} vertical oscillations)"
            "a step of $duration is $orbits; it must be at most a quarter"
        }
        this.duration = Double.NaN
        // With Ω t as time, f = κ/Ω, s and c of f h, the solution is f² Δx = x (4 − f²)(1 − c) + v_x f s + v_y 2(1 − c),
        // f³ Δy = x 2(4 − f²)(s − f h) − v_x 2f(1 − c) + v_y (f³ h + 4(s − f h)).
        val square = f * f
        val versine = versine(hx)
        val lag = sineMinusArgument(hx)
        ax = (4 - square) / square * versine / duration
        ay = 2 * (4 - square) / (square * f) * lag / duration
        bxx = 1 + lag / hx
        byy = 1 + 4 * lag / (square * hx)
        q = 2 * versine / (f * hx)
        az = if (hz == 0.0) 0.0 else -versine(hz) / duration
        cosine = StrictMath.cos(h)
        sine = StrictMath.sin(h)
        bz = if (hz == 0.0) 1.0 else 1 + sineMinusArgument(hz) / hz
        this.duration = duration
    }

    /** 1 − cos h. */
    private fun versine(h: Double): Double = StrictMath.sin(h / 2).let { 2 * it * it }

    /** sin h − h, by its series where the difference would cancel. */
    private fun sineMinusArgument(h: Double): Double {
        if (abs(h) > SERIES_BELOW) return StrictMath.sin(h) - h
        var term = -h * h * h / 6
        var sum = 0.0
        var n = 3
        while (abs(term) > abs(sum) * 1e-17) {
            sum += term
            term *= -h * h / ((n + 1) * (n + 2))
            n += 2
        }
        return sum
    }

    private companion object {
        const val LONGEST = Math.PI / 2
        const val SERIES_BELOW = 0.5
    }
}
