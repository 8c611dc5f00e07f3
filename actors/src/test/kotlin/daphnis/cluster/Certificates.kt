package daphnis.cluster

import java.nio.file.Files
import java.nio.file.Path
import java.security.KeyStore
import java.util.Base64

/** A certificate that signs itself and its key, made by the JDK's tool, as files in PEM form in [folder]. */
internal class Certificates(private val folder: Path, private val name: String) {
    val key: Path = folder.resolve("$name.key.pem")
    val certificate: Path = folder.resolve("$name.pem")

    init {
        val store = folder.resolve("$name.p12")
        val tool = Path.of(System.getProperty("java.home"), "bin", "keytool").toString()
        val words = listOf(
            tool, "-genkeypair", "-alias", "a", "-keyalg", "RSA", "-keysize", "2048", "-dname", "CN=$name",
            "-ext", "san=ip:127.0.0.1", "-validity", "2", "-keystore", "$store", "-storepass", PASSWORD,
        )
        check(ProcessBuilder(words).start().waitFor() == 0) { "keytool has failed" }
        val keys = KeyStore.getInstance("PKCS12")
        Files.newInputStream(store).use { keys.load(it, PASSWORD.toCharArray()) }
        write(key, "PRIVATE KEY", keys.getKey("a", PASSWORD.toCharArray()).encoded)
        write(certificate, "CERTIFICATE", keys.getCertificate("a").encoded)
    }

    /** Settings of a process with this certificate that trusts those of [authority]. */
    fun config(authority: Certificates): Path = Files.writeString(
        folder.resolve("$name.conf"),
        Files.readString(TestedFleet.quick(folder)) +
            "\ndaphnis.cluster.tls { key = \"$key\", certificate = \"$certificate\", " +
            "authority = \"${authority.certificate}\" }\n",
    )

    private fun write(path: Path, kind: String, bytes: ByteArray) {
        val text = Base64.getMimeEncoder(64, "\n".toByteArray()).encodeToString(bytes)
        Files.writeString(path, "-----BEGIN $kind-----\n$text\n-----END $kind-----\n")
    }

    private companion object {
        const val PASSWORD = "changeit"
    }
}
