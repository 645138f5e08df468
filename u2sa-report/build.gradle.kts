plugins {
    id("u2sa.java-conventions")
}

description = "Reports of runs: maps, charts, pages, tables and exports."

dependencies {
    api(project(":u2sa-recorder"))
    api(libs.jackson.core)
    testImplementation(testFixtures(project(":u2sa-abstract")))
    testImplementation(libs.jackson.databind)
}
