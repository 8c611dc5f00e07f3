package daphnis.core.run

/** The version of daphnis, as the build wrote it. */
public object Version {
    @JvmStatic
    public val text: String by lazy {
        Version::class.java.getResourceAsStream("/daphnis/version.txt")?.use {
            String(it.readAllBytes(), Charsets.UTF_8).trim()
        }
            ?: "unknown"
    }
}
