plugins {
    id("u2sa.java-conventions")
}

description = "Perception: what a camera and a laser see, as objects on the ground."

dependencies {
    api(project(":u2sa-abstract"))
    // EJML is ours, and maps of primitives are for recognition that nobody does here.
    api(libs.boofcv.recognition) {
        exclude(group = "org.ejml")
        exclude(group = "net.sf.trove4j", module = "trove4j")
    }
    api(libs.ejml)
    testImplementation(testFixtures(project(":u2sa-abstract")))
}
