plugins {
    id("u2sa.java-conventions")
}

description = "Real devices: GPS, compass, range finders, motors, IOIO, MAVLink."

dependencies {
    api(project(":u2sa-abstract"))
    api(project(":u2sa-mavlink"))
    api(libs.ioio.core)
    api(libs.jserialcomm)
    api(libs.marineapi)
    testImplementation(testFixtures(project(":u2sa-abstract")))
    testImplementation(project(":u2sa-sim"))
    testImplementation(libs.awaitility)
}
