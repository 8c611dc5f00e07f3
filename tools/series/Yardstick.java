/**
 * Work that never changes, to tell a slower machine from slower code: nanoseconds of an operation in the arithmetic
 * unit, and of one in memory. `java tools/series/Yardstick.java` prints both, each of the fastest of its rounds.
 */
final class Yardstick {
    private static final int ROUNDS = 5;
    private static final int OPERATIONS = 4_000_000;
    /** 64 MiB of places, more than a core's caches hold. */
    private static final int PLACES = 1 << 24;

    public static void main(String[] args) {
        int[] next = new int[PLACES];
        // A full cycle through all places in no order that a processor foresees.
        for (int k = 0; k < PLACES; k++) next[k] = (int) ((k * 1_664_525L + 1_013_904_223L) & (PLACES - 1));
        double arithmetic = Double.MAX_VALUE;
        double memory = Double.MAX_VALUE;
        double seen = 0;
        for (int round = 0; round < ROUNDS; round++) {
            long begin = System.nanoTime();
            seen += roots(OPERATIONS);
            long middle = System.nanoTime();
            seen += walk(next, OPERATIONS / 4);
            long end = System.nanoTime();
            arithmetic = Math.min(arithmetic, (middle - begin) / (double) OPERATIONS);
            memory = Math.min(memory, (end - middle) / (OPERATIONS / 4.0));
        }
        if (seen == 1) System.out.println();
        System.out.println(arithmetic + " " + memory);
    }

    private static double roots(int count) {
        double x = 1;
        for (int k = 0; k < count; k++) x = Math.sqrt(x * 1.5 + 0.25);
        return x;
    }

    private static int walk(int[] next, int count) {
        int at = 0;
        for (int k = 0; k < count; k++) at = next[at];
        return at;
    }
}
