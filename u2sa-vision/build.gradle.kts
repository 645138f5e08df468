plugins {
    id("u2sa.java-conventions")
}

description = "Perception: what a camera and a laser see, as objects on the ground."

dependencies {
    api(project(":u2sa-abstract"))
    api(project(":u2sa-world"))
    // EJML is ours, which is newer.
    api(libs.boofcv.recognition) {
        exclude(group = "org.ejml")
    }
    api(libs.ejml.simple)
    testImplementation(testFixtures(project(":u2sa-abstract")))
}
