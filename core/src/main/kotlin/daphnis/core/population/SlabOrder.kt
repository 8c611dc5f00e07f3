package daphnis.core.population

/** Puts the particles of a block in the order of their slabs. */
internal class SlabOrder {
    private val slabs = IntArray(ParticleBlock.SPHERES)
    private val sorted = IntArray(ParticleBlock.SPHERES)
    private val starts = IntArray(FlowFit.MOST_SLABS + 2)

    /** The place of the first particle in [slab], or the place after the last one. */
    fun start(slab: Int): Int = starts[slab]

    fun sort(block: ParticleBlock, position: DoubleArray, means: Means) {
        val n = block.size
        val index = block.index
        starts.fill(0)
        for (i in 0 until n) {
            slabs[i] = means.slab(position[index[i]])
            starts[slabs[i] + 2]++
        }
        for (slab in 2..<starts.size) starts[slab] += starts[slab - 1]
        for (i in 0 until n) sorted[starts[slabs[i] + 1]++] = index[i]
        sorted.copyInto(index, 0, 0, n)
    }
}
