pluginManagement {
    includeBuild("build-logic")
    repositories {
        mavenCentral()
        google()
    }
    // By module, not by marker: not every mirror carries the markers.
    resolutionStrategy {
        eachPlugin {
            when (requested.id.id) {
                "com.android.application" -> useModule("com.android.tools.build:gradle:8.4.2")
                "org.jetbrains.kotlin.android" -> useModule("org.jetbrains.kotlin:kotlin-gradle-plugin:2.0.21")
            }
        }
    }
}

dependencyResolutionManagement {
    repositoriesMode.set(RepositoriesMode.FAIL_ON_PROJECT_REPOS)
    repositories {
        mavenCentral()
        google()
    }
}

rootProject.name = "u2sa"

include("u2sa-messages")
include("u2sa-interfaces")
include("u2sa-abstract")
include("u2sa-recorder")
include("u2sa-estimation")
include("u2sa-world")
include("u2sa-mission")
include("u2sa-planning")
include("u2sa-control")
include("u2sa-core")
include("u2sa-vision")
include("u2sa-sim")
include("u2sa-mavlink")
include("u2sa-drivers")
include("u2sa-report")
include("u2sa-gcs")
include("u2sa-cli")
include("u2sa-flightgear")
include("u2sa-trials")
include("u2sa-scenarios")
include("u2sa-spark")
include("u2sa-system-tests")
include("u2sa-bom")

// The phone's application needs an Android SDK; without one, all others build nonetheless.
if (System.getenv("ANDROID_HOME") != null || file("local.properties").exists()) {
    include("u2sa-android")
}
