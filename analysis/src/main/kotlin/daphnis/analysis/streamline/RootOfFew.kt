package daphnis.analysis.streamline

import kotlin.math.sqrt

/**
 * √Σσ² from the variances [squares] of components in [n] particles, each over n − 1, without the bias that the root of
 * few Gaussian squares has. Their sum has 1/w degrees of freedom (Satterthwaite 1946, Biometrics Bull. 2, 110; the
 * fourth powers without their bias), and the root of f degrees is smaller than that of the mean by 4f/(4f + 1).
 */
internal fun rootOfFew(squares: DoubleArray, n: Int): Double {
    val sum = squares.sum()
    if (sum == 0.0) return 0.0
    val fourth = squares.sumOf { it * it } / (n + 1)
    val w = fourth / (sum * sum - 2 * fourth)
    return sqrt(sum) * (1 + w / 4)
}
