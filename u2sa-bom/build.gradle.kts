plugins {
    `java-platform`
    `maven-publish`
}

description = "One version for all modules of U2SA."

dependencies {
    constraints {
        api(project(":u2sa-messages"))
        api(project(":u2sa-interfaces"))
        api(project(":u2sa-abstract"))
        api(project(":u2sa-estimation"))
        api(project(":u2sa-world"))
        api(project(":u2sa-mission"))
        api(project(":u2sa-planning"))
        api(project(":u2sa-control"))
        api(project(":u2sa-core"))
        api(project(":u2sa-recorder"))
        api(project(":u2sa-sim"))
        api(project(":u2sa-vision"))
        api(project(":u2sa-mavlink"))
        api(project(":u2sa-drivers"))
        api(project(":u2sa-report"))
        api(project(":u2sa-gcs"))
        api(project(":u2sa-cli"))
        api(project(":u2sa-flightgear"))
        api(project(":u2sa-trials"))
        api(project(":u2sa-scenarios"))
        api(project(":u2sa-spark"))
    }
}

// Test kits. Constraints cannot name a jar by its classifier, but Maven's users of one need its version, too.
val testKits = listOf("u2sa-abstract")

publishing {
    publications {
        create<MavenPublication>("maven") {
            from(components["javaPlatform"])
            pom {
                withXml {
                    val document = asElement().ownerDocument
                    val managed = asElement().getElementsByTagName("dependencies").item(0)
                    for (module in testKits) {
                        val entry = managed.appendChild(document.createElement("dependency"))
                        for ((name, text) in listOf(
                            "groupId" to project.group.toString(),
                            "artifactId" to module,
                            "version" to project.version.toString(),
                            "type" to "test-jar",
                            "classifier" to "test-fixtures",
                        )) {
                            entry.appendChild(document.createElement(name)).textContent = text
                        }
                    }
                }
                name.set(project.name)
                description.set(project.description)
                licenses {
                    license {
                        name.set("Apache-2.0")
                        url.set("https://www.apache.org/licenses/LICENSE-2.0.txt")
                    }
                }
            }
        }
    }
}
