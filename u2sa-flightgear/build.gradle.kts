plugins {
    id("u2sa.java-conventions")
}

description = "FlightGear: protocol, link, its service (thesis 4.5), stand-in that speaks its protocol."

dependencies {
    api(project(":u2sa-mission"))
    api(project(":u2sa-control"))
    api(project(":u2sa-sim"))
    testImplementation(testFixtures(project(":u2sa-abstract")))
    testImplementation(libs.awaitility)
}
