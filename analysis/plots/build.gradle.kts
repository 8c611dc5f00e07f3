plugins {
    alias(libs.plugins.kotlin.jvm)
    `java-library`
    `maven-publish`
}

description = "Reports, pictures, plots and movies of what daphnis-analysis computes."

kotlin {
    explicitApi()
    sourceSets.test { kotlin.srcDir("../src/testFixtures/kotlin") }
}
dependencies {
    api(project(":analysis"))
    implementation(libs.jcodec)
    testImplementation(libs.jimfs)
    testRuntimeOnly(libs.slf4j.nop)
}
