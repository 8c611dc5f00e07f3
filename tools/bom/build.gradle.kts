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
    }
}
