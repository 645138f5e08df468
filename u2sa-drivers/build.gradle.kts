plugins {
    id("u2sa.java-conventions")
}

description = "Real devices: GPS, compass, range finders, motors, IOIO, MAVLink."

dependencies {
    api(project(":u2sa-abstract"))
    api(libs.ioio.core)
    api(libs.jserialcomm)
    api(libs.marineapi)
    api(libs.mavlink)
    testImplementation(testFixtures(project(":u2sa-abstract")))
    testImplementation(project(":u2sa-sim"))
    testImplementation(libs.awaitility)
}
