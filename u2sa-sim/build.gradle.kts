plugins {
    id("u2sa.java-conventions")
}

description = "Simulated vehicles, worlds and sensors."

dependencies {
    api(project(":u2sa-abstract"))
    api(libs.ejml)
    testImplementation(testFixtures(project(":u2sa-abstract")))
}
