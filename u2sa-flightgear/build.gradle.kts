plugins {
    id("u2sa.java-conventions")
}

description = "FlightGear link (thesis 4.5), Cessna 172 control, stand-in simulator."

dependencies {
    api(project(":u2sa-core"))
    api(project(":u2sa-sim"))
    api(project(":u2sa-gcs"))
    testImplementation(testFixtures(project(":u2sa-abstract")))
    testImplementation(libs.archunit)
}
