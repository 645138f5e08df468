plugins {
    id("u2sa.java-conventions")
}

description = "Demos: vehicles and competitions with their worlds and scorers."

dependencies {
    api(project(":u2sa-estimation"))
    api(project(":u2sa-world"))
    api(project(":u2sa-mission"))
    api(project(":u2sa-planning"))
    api(project(":u2sa-control"))
    api(project(":u2sa-core"))
    api(project(":u2sa-vision"))
    api(project(":u2sa-drivers"))
    api(project(":u2sa-sim"))
    api(project(":u2sa-report"))
    api(project(":u2sa-cli"))
    api(project(":u2sa-flightgear"))
    api(libs.jackson.core)
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
