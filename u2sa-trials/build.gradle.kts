plugins {
    id("u2sa.java-conventions")
}

description = "Runs of systems in simulation: simulate, campaigns, simulated boards, and what all demos share."

dependencies {
    api(project(":u2sa-estimation"))
    api(project(":u2sa-world"))
    api(project(":u2sa-mission"))
    api(project(":u2sa-planning"))
    api(project(":u2sa-control"))
    api(project(":u2sa-core"))
    api(project(":u2sa-drivers"))
    api(project(":u2sa-sim"))
    api(project(":u2sa-report"))
    api(project(":u2sa-cli"))
    api(libs.jackson.core)
    testImplementation(testFixtures(project(":u2sa-abstract")))
    testImplementation(libs.awaitility)
    testImplementation(libs.jackson.databind)
}
