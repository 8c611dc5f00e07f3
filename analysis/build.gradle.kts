plugins {
    alias(libs.plugins.kotlin.jvm)
    `java-library`
}
kotlin {
    explicitApi()
    sourceSets.test { kotlin.srcDir("src/testFixtures/kotlin") }
}
dependencies {
    api(project(":core"))
    testRuntimeOnly(libs.slf4j.nop)
}
