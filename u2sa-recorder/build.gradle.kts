plugins {
    id("u2sa.java-conventions")
}

description = "Recordings of runs: every message, in MCAP files."

dependencies {
    api(project(":u2sa-abstract"))
    api(libs.lz4)
    testImplementation(testFixtures(project(":u2sa-abstract")))
    testImplementation(libs.jackson.databind)
}
