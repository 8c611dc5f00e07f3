plugins {
    alias(libs.plugins.kotlin.jvm)
    alias(libs.plugins.kotlin.serialization)
    `java-library`
    `maven-publish`
}

description = "Event-driven simulation of very many inelastic hard spheres: planetary rings, granular flow, gases."

kotlin { explicitApi() }
dependencies {
    api(libs.serialization.json)
    implementation(libs.jhdf)
    // What jhdf brings and, having no module descriptor, does not ask for: module-info.java does.
    implementation(libs.slf4j.api)
    implementation(libs.commons.lang)
    implementation(libs.lzf)
    testRuntimeOnly(libs.slf4j.nop)
}

// What uses the vector unit is in Java. An incubating module is of the JDK in use only: no release, but its bytecode.
tasks.compileJava {
    val target = rootProject.libs.versions.jvmTarget.get()
    options.release = null as Int?
    sourceCompatibility = target
    targetCompatibility = target
    val unit = "jdk.incubator.vector"
    options.compilerArgs.addAll(listOf("--add-modules", unit, "--add-reads", "daphnis.core=$unit"))
}

// Tests hold these against the code.
tasks.test {
    val pages = listOf("library", "columns", "runs", "scenario", "reference/scenario-keys")
    inputs.files(pages.map { rootProject.file("docs/$it.md") }).withPathSensitivity(PathSensitivity.NONE)
}
