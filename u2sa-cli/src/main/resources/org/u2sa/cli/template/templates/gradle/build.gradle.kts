plugins {
    java
}

group = "{{package}}"
version = "1.0"

repositories {
    mavenLocal() // where U2SA is installed
    mavenCentral()
}

dependencies {
    implementation(platform("org.u2sa:u2sa-bom:{{version}}"))
    implementation("org.u2sa:u2sa-estimation")
    implementation("org.u2sa:u2sa-world")
    implementation("org.u2sa:u2sa-mission")
    implementation("org.u2sa:u2sa-planning")
    implementation("org.u2sa:u2sa-control")
    implementation("org.u2sa:u2sa-core")
    testImplementation("org.u2sa:u2sa-sim")
    testImplementation("org.u2sa:u2sa-abstract:{{version}}:test-fixtures")
    testImplementation("org.junit.jupiter:junit-jupiter:5.14.4")
    testImplementation("org.assertj:assertj-core:3.27.7")
    testRuntimeOnly("org.junit.platform:junit-platform-launcher:1.14.4")
}

tasks.withType<JavaCompile> {
    options.encoding = "UTF-8"
    options.release = 17
}

tasks.jar {
    manifest { // u2sa services shows the version
        attributes("Implementation-Version" to project.version)
    }
}

tasks.test {
    useJUnitPlatform()
}
