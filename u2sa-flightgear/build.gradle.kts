plugins {
    id("u2sa.java-conventions")
}

description = "FlightGear link (thesis 4.5), Cessna 172 control, stand-in simulator."

dependencies {
    api(project(":u2sa-core"))
    api(project(":u2sa-sim"))
    api(project(":u2sa-gcs"))
    testImplementation(testFixtures(project(":u2sa-abstract")))
    testImplementation(libs.awaitility)
    testImplementation(libs.archunit)
}

// ./gradlew :u2sa-flightgear:run --args="demo cessna" does what ./u2sa does without Maven.
tasks.register<JavaExec>("run") {
    description = "Runs the command line."
    group = "application"
    mainClass.set("org.u2sa.gcs.Main")
    classpath = sourceSets.main.get().runtimeClasspath
    workingDir = rootDir
    systemProperty("u2sa.home", rootDir.path)
    standardInput = System.`in`
}
