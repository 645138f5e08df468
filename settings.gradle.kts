pluginManagement {
    includeBuild("build-logic")
    repositories {
        mavenCentral()
    }
}

dependencyResolutionManagement {
    repositoriesMode.set(RepositoriesMode.FAIL_ON_PROJECT_REPOS)
    repositories {
        mavenCentral()
    }
}

rootProject.name = "u2sa"

include("u2sa-messages")
include("u2sa-interfaces")
include("u2sa-abstract")
include("u2sa-core")
include("u2sa-sim")
include("u2sa-drivers")
include("u2sa-gcs")
include("u2sa-flightgear")
include("u2sa-bom")
