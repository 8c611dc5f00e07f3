package daphnis.core.collision

/** Sums by axis over the collisions of two spheres: the heat that they carry from centre to centre. */
internal class HeatSums : RecordSums() {
    override fun add(record: CollisionRecord) {
        for (k in 0 until record.size) {
            if (record.isWall(k)) continue
            for (axis in 0..2) sum(axis).add(record.handedOver(k) * record.separation(k, axis))
        }
    }
}
