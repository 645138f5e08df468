plugins {
    id("u2sa.java-conventions")
}

description = "Simulated vehicles, worlds and sensors."

dependencies {
    api(project(":u2sa-abstract"))
    testImplementation(testFixtures(project(":u2sa-abstract")))
}
