plugins {
    id("u2sa.java-conventions")
}

description = "Core services (thesis 3.2.3), Communication Manager and launcher."

dependencies {
    api(project(":u2sa-abstract"))
    testImplementation(testFixtures(project(":u2sa-abstract")))
}
