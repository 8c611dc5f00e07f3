plugins {
    alias(libs.plugins.kotlin.jvm)
    alias(libs.plugins.kotlin.serialization)
    `java-library`
}
kotlin { explicitApi() }
dependencies {
    api(libs.serialization.json)
    implementation(libs.jhdf)
    testRuntimeOnly(libs.slf4j.nop)
}

// Tests hold these against the code.
tasks.test {
    inputs.files(rootProject.file("docs/library.md"), rootProject.file("docs/guide.md"))
        .withPathSensitivity(PathSensitivity.NONE)
}
