plugins {
    alias(libs.plugins.kotlin.jvm)
    `java-library`
    `maven-publish`
}

description =
    "Analysis of hard spheres: streamlines, profiles, transport, correlations, diffusion and occultation, with errors."

kotlin {
    explicitApi()
    sourceSets.test { kotlin.srcDir("src/testFixtures/kotlin") }
}
dependencies {
    api(project(":core"))
    testImplementation(libs.jhdf)
    testRuntimeOnly(libs.slf4j.nop)
}
