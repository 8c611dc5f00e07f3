package daphnis.core.engine.horizon;

import jdk.incubator.vector.FloatVector;
import jdk.incubator.vector.IntVector;
import jdk.incubator.vector.VectorMask;
import jdk.incubator.vector.VectorOperators;
import jdk.incubator.vector.VectorSpecies;

/**
 * {@link LineFilter} for as many lines at once as the vector unit takes, of a block of eight. In Java, since only its
 * compiler can be told of an incubating module without losing sight of the oldest Java that is supported.
 */
final class VectorFilter implements LineFilter {
    private static final VectorSpecies<Float> SPECIES =
            FloatVector.SPECIES_PREFERRED.length() >= Lines.LANES ? FloatVector.SPECIES_256 : FloatVector.SPECIES_128;
    private static final int LANES = SPECIES.length();

    /** Compilers before that of JDK 25 are not as good at this; measured on 17 and 25. */
    private static final boolean IS_QUICK = Runtime.version().feature() >= 25;

    VectorFilter() {}

    @Override
    public double getPerRun() {
        return IS_QUICK ? 21 : 24;
    }

    @Override
    public double getPerLine() {
        return IS_QUICK ? 0.85 : 1.3;
    }

    @Override
    public void near(float[] state, LineQuery query, int first, int end, KeptLines into) {
        into.reserve(end - first);
        long[] marks = into.marks;
        int size = into.size;
        FloatVector x = FloatVector.broadcast(SPECIES, query.x);
        FloatVector y = FloatVector.broadcast(SPECIES, query.y);
        FloatVector z = FloatVector.broadcast(SPECIES, query.z);
        FloatVector u = FloatVector.broadcast(SPECIES, query.u);
        FloatVector v = FloatVector.broadcast(SPECIES, query.v);
        FloatVector w = FloatVector.broadcast(SPECIES, query.w);
        FloatVector t = FloatVector.broadcast(SPECIES, query.time);
        FloatVector closing = FloatVector.broadcast(SPECIES, query.closing);
        FloatVector radius = FloatVector.broadcast(SPECIES, query.radius);
        // No fused multiply-add: without the instruction for it, Java computes it by decimal numbers of any length.
        // Lanes before the first slot and after the last hold other lines, or none: they are tested in vain. A block is
        // marked whether or not a line of it is kept, and the mark of one without any is written over: no branch.
        for (int slot = first & -LANES; slot < end; slot += LANES) {
            int p = Lines.place(slot);
            FloatVector pu = FloatVector.fromArray(SPECIES, state, p + Lines.U);
            FloatVector pv = FloatVector.fromArray(SPECIES, state, p + Lines.V);
            FloatVector pw = FloatVector.fromArray(SPECIES, state, p + Lines.W);
            FloatVector dx = pu.mul(t).add(FloatVector.fromArray(SPECIES, state, p)).sub(x);
            FloatVector dy = pv.mul(t).add(FloatVector.fromArray(SPECIES, state, p + Lines.Y)).sub(y);
            FloatVector dz = pw.mul(t).add(FloatVector.fromArray(SPECIES, state, p + Lines.Z)).sub(z);
            FloatVector a = pu.sub(u);
            FloatVector b = pv.sub(v);
            FloatVector c = pw.sub(w);
            FloatVector s = FloatVector.fromArray(SPECIES, state, p + Lines.RADIUS).add(radius);
            FloatVector gap = dx.mul(dx).add(dy.mul(dy)).add(dz.mul(dz)).sub(s.mul(s));
            FloatVector approach = dx.mul(a).add(dy.mul(b)).add(dz.mul(c));
            FloatVector speed = a.mul(a).add(b.mul(b)).add(c.mul(c));
            FloatVector late = approach.mul(closing).sub(gap);
            FloatVector miss = approach.mul(approach).mul(LineFilter.ROUNDING).sub(speed.mul(gap));
            // Near unless a sign bit says late or missed, and that of the gap says apart.
            IntVector far = late.reinterpretAsInts().or(miss.reinterpretAsInts()).and(gap.reinterpretAsInts().not());
            VectorMask<Integer> near = far.compare(VectorOperators.GE, 0);
            int lanes = (int) near.toLong();
            if (slot < first) lanes &= -1 << (first - slot);
            if (slot + LANES > end) lanes &= (1 << (end - slot)) - 1;
            marks[size] = (long) slot << Lines.LANES | lanes;
            size += -lanes >>> 31;
        }
        into.size = size;
    }
}
