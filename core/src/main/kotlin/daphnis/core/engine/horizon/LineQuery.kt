package daphnis.core.engine.horizon

/** The line whose neighbours are looked for, from some time to the end of the epoch, as [LineFilter] takes it. */
internal class LineQuery(private val frame: EpochFrame) {
    /** Where it is at [time], as seen from the image that is looked at, and its velocity there. */
    @JvmField
    var x = 0f

    @JvmField
    var y = 0f

    @JvmField
    var z = 0f

    @JvmField
    var u = 0f

    @JvmField
    var v = 0f

    @JvmField
    var w = 0f

    /** Its radius and the inflation for both. */
    @JvmField
    var radius = 0f

    /** The time of the epoch from which on is looked. */
    @JvmField
    var time = 0f

    /** −2 times what is left of the epoch, with room for the rounding of floats. */
    @JvmField
    var closing = 0f

    private var start = 0.0
    private var ownX = 0f
    private var ownY = 0f
    private var ownZ = 0f
    private var ownU = 0f
    private var ownV = 0f
    private var code = 0

    /** Looks from the line in [slot] at time [from]; others are where their lines are. */
    fun begin(lines: Lines, slot: Int, from: Double) {
        val state = lines.state
        val p = Lines.place(slot)
        lookFrom(from, frame.end)
        radius = (state[p + Lines.RADIUS] + frame.inflation).toFloat()
        ownU = state[p + Lines.U]
        ownV = state[p + Lines.V]
        w = state[p + Lines.W]
        ownX = state[p] + ownU * time
        ownY = state[p + Lines.Y] + ownV * time
        ownZ = state[p + Lines.Z] + w * time
        code = -1
        toward(0)
    }

    /** Looks from time [from] to [end]. */
    fun lookFrom(from: Double, end: Double) {
        start = from
        time = from.toFloat()
        closing = (CLOSING * (end - from)).toFloat()
    }

    /** Looks at the images [code] of others. */
    fun toward(code: Int) {
        if (code == this.code) return
        this.code = code
        x = ownX
        y = ownY
        z = ownZ
        u = ownU
        v = ownV
        if (code == 0) return
        val images = frame.images
        val slideX = images.slide(code, 0)
        val slideY = images.slide(code, 1)
        x -= (images.shift(code, 0) + slideX * start).toFloat()
        y -= (images.shift(code, 1) + slideY * start).toFloat()
        z -= images.shift(code, 2).toFloat()
        u -= slideX.toFloat()
        v -= slideY.toFloat()
    }

    private companion object {
        const val CLOSING = -2 * (1 + 1e-4)
    }
}
