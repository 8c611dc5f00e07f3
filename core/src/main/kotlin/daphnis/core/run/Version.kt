package daphnis.core.run

/** The version of daphnis, as the build wrote it, and its name. */
public object Version {
    @JvmStatic
    public val text: String by lazy {
        Version::class.java.getResourceAsStream("/daphnis/version.txt")?.use {
            String(it.readAllBytes(), Charsets.UTF_8).trim()
        }
            ?: "unknown"
    }

    /** What the command line was called by, such as `./daphnis` or `daphnis`: the launcher says so. */
    @JvmStatic
    public val command: String get() = System.getProperty("daphnis.called")?.takeIf { it.isNotBlank() } ?: "daphnis"
}
