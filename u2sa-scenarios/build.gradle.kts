plugins {
    id("u2sa.java-conventions")
}

description = "Demos: vehicles and competitions with their worlds and scorers."

dependencies {
    api(project(":u2sa-trials"))
    api(project(":u2sa-vision"))
    api(project(":u2sa-flightgear"))
    testImplementation(testFixtures(project(":u2sa-abstract")))
    testImplementation(libs.awaitility)
    testImplementation(libs.jackson.databind)
}

// ./gradlew :u2sa-scenarios:run --args="demo cessna" does what ./u2sa does without Maven.
tasks.register<JavaExec>("run") {
    description = "Runs the command line."
    group = "application"
    mainClass.set("org.u2sa.cli.Main")
    classpath = sourceSets.main.get().runtimeClasspath
    workingDir = rootDir
    systemProperty("u2sa.home", rootDir.path)
    standardInput = System.`in`
}
