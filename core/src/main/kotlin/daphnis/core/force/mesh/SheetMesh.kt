package daphnis.core.force.mesh

import daphnis.core.parallel.RangeLoop

/**
 * The potential of masses on a mesh that repeats along x and y, with images at +L_x displaced along y, and is alone
 * along z. Fill [values] with masses, call [solve], and read potentials.
 *
 * Transforms along y come first. A row of wave number k_y is shifted by s where it is multiplied by e^(−i k_y s), by
 * any distance. Multiplied by e^(+i k_y s x/L_x), with s the displacement of the image, rows repeat along x, and are
 * transformed along it. So the mesh itself is never sheared, and every wave is an exact wave of the sheet, with k_x =
 * 2π/L_x (n − j s/L_y) (Gammie 2001, ApJ 553, 174, has the same waves).
 *
 * Two planes are the real and the imaginary part of one. Every loop is over parts that do not overlap, and each number
 * is made by the same operations whoever makes it.
 *
 * ```
 *   values   x column │ y │ z z z z …        one column after the other; planes of a point side by side
 * ```
 */
internal class SheetMesh(val points: MeshPoints) {
    private val nx = points.nx
    private val ny = points.ny
    private val nz = points.nz
    private val pairs = nz / 2

    /** By column, row and plane: first masses, then potentials (positive, per G). */
    val values = DoubleArray(Math.multiplyExact(Math.multiplyExact(nx, ny), nz))

    private val alongX = BatchTransform(nx)
    private val alongY = BatchTransform(ny)
    private val correctionY = DoubleArray(ny / 2 + 1) { CubicSpline.correction(2 * Math.PI * it / ny) }
    private val correctionX = DoubleArray(ROWS + 2) { CubicSpline.correction(Math.PI * it / ROWS) }
    private val stresses = DoubleArray(ny / 2 + 1)

    /** The greatest wave number that is kept. */
    private val largest = CUT / points.reach
    private val kernel = SheetKernel(CompactShape(points.reach), largest, points.hz, nz)
    private var workers = arrayOf<MeshWorker>()

    /** Replaces masses by potentials; the image at +L_x is displaced by [offset] along y. */
    fun solve(loop: RangeLoop, offset: Double) {
        val slide = slide(offset)
        waves(loop, slide, false)
        rows(loop, slide, false)
    }

    /**
     * Σ_ij m_i m_j K(r_j − r_i), where K is −x ∂ψ/∂y of the potential ψ of one cloud. Takes masses, and leaves nothing
     * of use in [values].
     */
    fun stress(loop: RangeLoop, offset: Double): Double {
        waves(loop, slide(offset), true)
        return stresses.sum()
    }

    /** Transforms masses, and multiplies their waves by the kernel, or takes the stress of each. */
    private fun waves(loop: RangeLoop, slide: Double, isStress: Boolean) {
        prepare(loop)
        rows(loop, slide, true)
        loop.run(ny / 2 + 1, WAVES) { worker, from, to ->
            for (j in from until to) waves(worker, j, slide, isStress)
        }
    }

    private fun rows(loop: RangeLoop, slide: Double, there: Boolean) {
        loop.run(nx, COLUMNS) { worker, from, to ->
            forEachGroup(from, to) { a, b -> rows(worker, a, b, slide, there) }
        }
    }

    private fun prepare(loop: RangeLoop) {
        if (workers.size < loop.workers) workers = Array(loop.workers) { MeshWorker(nz) }
    }

    /** The displacement over the length of the box along it, within ±½. */
    private fun slide(offset: Double): Double = (offset / points.ly).let { it - Math.rint(it) }

    private inline fun forEachGroup(from: Int, to: Int, body: (Int, Int) -> Unit) {
        var first = from
        while (first < to) {
            val end = minOf(first + COLUMNS, to)
            body(first, end)
            first = end
        }
    }

    /** Transforms the columns [first] until [end] along y, there or back, and shifts their rows. */
    private fun rows(worker: Int, first: Int, end: Int, slide: Double, there: Boolean) {
        val work = workers[worker]
        val width = (end - first) * pairs
        work.a.ensure(ny * width)
        load(work.a, first, end, width)
        val result = if (there) {
            alongY.forward(work.a, work.b, width)
        } else {
            for (x in first until end) shift(work.a, x, (x - first) * pairs, width, -slide)
            alongY.backward(work.a, work.b, width)
        }
        if (there) for (x in first until end) shift(result, x, (x - first) * pairs, width, slide)
        store(result, first, end, width)
    }

    private fun load(into: ComplexRows, first: Int, end: Int, width: Int) {
        val re = into.re
        val im = into.im
        for (x in first until end) {
            var p = x * ny * nz
            for (y in 0 until ny) {
                val q = y * width + (x - first) * pairs
                for (pair in 0 until pairs) {
                    re[q + pair] = values[p]
                    im[q + pair] = values[p + 1]
                    p += 2
                }
            }
        }
    }

    private fun store(from: ComplexRows, first: Int, end: Int, width: Int) {
        val re = from.re
        val im = from.im
        for (x in first until end) {
            var p = x * ny * nz
            for (y in 0 until ny) {
                val q = y * width + (x - first) * pairs
                for (pair in 0 until pairs) {
                    values[p] = re[q + pair]
                    values[p + 1] = im[q + pair]
                    p += 2
                }
            }
        }
    }

    /** Multiplies wave j of column [x] by e^(2πi j [slide] x/nx), of the negative waves as well. */
    private fun shift(rows: ComplexRows, x: Int, at: Int, width: Int, slide: Double) {
        if (slide == 0.0 || x == 0) return
        val angle = 2 * Math.PI * slide * x / nx
        val cosine = StrictMath.cos(angle)
        val sine = StrictMath.sin(angle)
        var c = 1.0
        var s = 0.0
        for (j in 1 until (ny + 1) / 2) {
            val next = c * cosine - s * sine
            s = c * sine + s * cosine
            c = next
            turn(rows, j * width + at, c, s)
            turn(rows, (ny - j) * width + at, c, -s)
        }
    }

    private fun turn(rows: ComplexRows, from: Int, c: Double, s: Double) {
        val re = rows.re
        val im = rows.im
        for (p in from until from + pairs) {
            val a = re[p]
            val b = im[p]
            re[p] = a * c - b * s
            im[p] = a * s + b * c
        }
    }

    /** The waves j and −j along y, all along x: there, times the kernel, and back; or their share in the stress. */
    private fun waves(worker: Int, j: Int, slide: Double, isStress: Boolean) {
        val work = workers[worker]
        val other = (ny - j) % ny
        val isOwn = other == j
        val width = if (isOwn) pairs else 2 * pairs
        work.a.ensure(nx * width)
        loadWave(work.a, j, 0, width)
        if (!isOwn) loadWave(work.a, other, pairs, width)
        val result = alongX.forward(work.a, work.b, width)
        // The shortest wave along y stands for two that the slide would part.
        val isShortest = 2 * j == ny
        if (isStress) {
            stresses[j] = if (isShortest) 0.0 else stressOf(result, j, if (isOwn) 0 else pairs, width, slide, work)
            return
        }
        if (isShortest) {
            result.re.fill(0.0, 0, nx * width)
            result.im.fill(0.0, 0, nx * width)
        } else {
            multiply(result, j, if (isOwn) 0 else pairs, width, slide, work)
        }
        val spare = if (result === work.a) work.b else work.a
        val back = alongX.backward(result, spare, width)
        storeWave(back, j, 0, width)
        if (!isOwn) storeWave(back, other, pairs, width)
    }

    private fun loadWave(into: ComplexRows, y: Int, at: Int, width: Int) {
        for (x in 0 until nx) {
            var p = (x * ny + y) * nz
            val q = x * width + at
            for (pair in 0 until pairs) {
                into.re[q + pair] = values[p]
                into.im[q + pair] = values[p + 1]
                p += 2
            }
        }
    }

    private fun storeWave(from: ComplexRows, y: Int, at: Int, width: Int) {
        for (x in 0 until nx) {
            var p = (x * ny + y) * nz
            val q = x * width + at
            for (pair in 0 until pairs) {
                values[p] = from.re[q + pair]
                values[p + 1] = from.im[q + pair]
                p += 2
            }
        }
    }

    /** k_x of wave [n] along x beside wave [j] along y, the one within ±π/h, in units of 2π/L_x. */
    private fun waveAlongX(n: Int, j: Int, slide: Double): Double {
        val wave = n - j * slide
        return wave - nx * Math.rint(wave / nx)
    }

    private fun correction(kx: Double, j: Int): Double {
        val place = Math.abs(kx) * 2 / nx * ROWS
        val row = minOf(place.toInt(), ROWS)
        val part = place - row
        return ((1 - part) * correctionX[row] + part * correctionX[row + 1]) * correctionY[j]
    }

    private fun waveNumber(kx: Double, j: Int): Double {
        val x = 2 * Math.PI / points.lx * kx
        val y = 2 * Math.PI / points.ly * j
        return Math.sqrt(x * x + y * y)
    }

    /** @param partner where in a row the waves −j begin */
    private fun multiply(rows: ComplexRows, j: Int, partner: Int, width: Int, slide: Double, work: MeshWorker) {
        val area = points.lx * points.ly
        // Waves n and −n of j = 0 are each other's partners: half of them do.
        val end = if (j == 0) nx / 2 + 1 else nx
        for (n in 0 until end) {
            val kx = waveAlongX(n, j, slide)
            val k = waveNumber(kx, j)
            val p = n * width
            val q = (nx - n) % nx * width + partner
            if (k > largest) {
                work.clear(rows, p, q)
                continue
            }
            kernel.write(k, work.kernel)
            work.unpack(rows, p, q)
            work.convolve(correction(kx, j) / area)
            work.pack(rows, p, q)
        }
    }

    private fun stressOf(rows: ComplexRows, j: Int, partner: Int, width: Int, slide: Double, work: MeshWorker): Double {
        if (j == 0) return 0.0
        val area = points.lx * points.ly
        var sum = 0.0
        for (n in 0 until nx) {
            val kx = waveAlongX(n, j, slide)
            val k = waveNumber(kx, j)
            if (k > largest) continue
            kernel.writeSlope(k, work.kernel)
            work.unpack(rows, n * width, (nx - n) % nx * width + partner)
            val x = 2 * Math.PI / points.lx * kx
            val y = 2 * Math.PI / points.ly * j
            sum += 2 * correction(kx, j) / area * x * y / k * work.product()
        }
        return sum
    }

    private companion object {
        /** Columns that are transformed side by side. */
        const val COLUMNS = 8

        /** Waves along y in a piece of the loop. */
        const val WAVES = 2

        /** Waves shorter than 2π/[CUT] of a cloud's radius are left out: the cloud has next to none. */
        const val CUT = 10.0

        /** Of the table of corrections along x. */
        const val ROWS = 2048
    }
}
