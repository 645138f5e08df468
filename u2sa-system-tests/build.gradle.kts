plugins {
    id("u2sa.java-conventions")
}

description = "Tests of the whole: house rules, both builds, documents, faults, fuzzing, networks, the Android application."

dependencies {
    testImplementation(project(":u2sa-scenarios"))
    testImplementation(project(":u2sa-spark"))
    testImplementation(testFixtures(project(":u2sa-abstract")))
    testImplementation(libs.awaitility)
    testImplementation(libs.archunit)
}
