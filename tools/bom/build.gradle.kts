plugins {
    `java-platform`
    `maven-publish`
}

description = "Versions of the artifacts of daphnis that belong together."

dependencies {
    constraints {
        api(project(":core"))
        api(project(":actors"))
        api(project(":analysis"))
        api(project(":analysis:plots"))
        api(project(":"))
        // What libraries of daphnis-plots bring along older than it should be.
        api(libs.batik.codec)
        api(libs.batik.transcoder)
        api(libs.xmlgraphics.commons)
        api(libs.commons.io)
        api(libs.commons.logging)
    }
}
