package org.u2sa.cli.template;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.regex.Pattern;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

/** What {@code u2sa new} makes is compiled with warnings as errors, and its own tests are run. */
class GeneratedProjectsTest {
  @TempDir Path here;
  private NewProject made;

  @BeforeEach
  void here() {
    made = new NewProject(here);
  }

  static Iterable<String> kinds() throws IOException {
    try (Templates templates = new Templates(Optional.empty())) {
      return templates.kinds().keySet();
    }
  }

  @ParameterizedTest
  @ValueSource(strings = {"controller", "planner", "vehicle-copter"})
  void make_someKinds_compileAndTheirTestsPass(String kind) throws Exception {
    made.make(kind, "first-of-" + kind);
    made.build("first-of-" + kind);
  }

  @Tag("long")
  @ParameterizedTest
  @MethodSource("kinds")
  void make_eachKind_compilesAndItsTestsPass(String kind) throws Exception {
    make_someKinds_compileAndTheirTestsPass(kind);
  }

  @Test
  void make_vehicleOfAKind_isThatOfItsFile() {
    made.make("vehicle", "pier", "--kind", "boat");
    assertThat(made.files())
        .contains("pier/config/pier/vehicle.xml", "pier/config/pier/BOW.xml")
        .doesNotContain("pier/src/main");
    assertThat(made.told()).contains("u2sa simulate config/pier/system.xml");
  }

  @Test
  void make_kindOfSomethingElse_isRefused() {
    assertThatThrownBy(() -> made.make("sensor", "pier", "--kind", "boat"))
        .hasMessageContaining("--kind boat: expected KIND vehicle");
    assertThatThrownBy(() -> made.make("vehicle", "pier", "--kind", "tram"))
        .hasMessageContaining("--kind tram: expected one of boat, copter");
  }

  @Test
  void make_severalServicesInOneProject_allCompileAndTheirTestsPass() throws Exception {
    made.make("mission-goal", "PhotoSpot", "--package", "com.example.boats", "--gradle");
    made.make("mission-goal", "sonar stop", "--into", "photo-spot");
    made.make("sensor", "gps2", "--into", "photo-spot", "--package", "com.example.sense");
    Path project = here.resolve("photo-spot");
    assertThat(project.resolve("src/main/java/com/example/sense/Gps2.java")).exists();
    Path lists = project.resolve("src/main/resources/META-INF/services");
    assertThat(lists.resolve("org.u2sa.messages.schema.MessageTypeProvider"))
        .hasContent("com.example.boats.PhotoSpotProvider\ncom.example.boats.SonarStopProvider\n");
    made.build("photo-spot");
  }

  @Test
  void make_insideAProject_addsToIt() {
    made.make("sensor", "depth-gauge");
    NewProject inside = new NewProject(here.resolve("depth-gauge"));
    inside.make("controller", "rudder-control");
    assertThat(inside.files())
        .contains("config/rudder-control/system.xml")
        .contains("src/main/java/org/example/depthgauge/RudderControl.java")
        .doesNotContain("rudder-control");
  }

  @Test
  void make_controller_takesOverFromTheDemosWhoseVariablesAreOthers() throws IOException {
    made.make("controller", "rudder");
    String ours = Files.readString(Path.of("../config/ugv/Control.xml"));
    Pattern.compile("name=\"[^\"]+\"")
        .matcher(Files.readString(here.resolve("rudder/config/rudder/Control.xml")))
        .results()
        .forEach(each -> assertThat(ours).doesNotContain(each.group()));
  }

  @Test
  void make_gradle_hasNoMavenFiles() {
    made.make("sensor", "depth-gauge", "--gradle");
    assertThat(made.files())
        .contains("depth-gauge/build.gradle.kts", "depth-gauge/.gitignore")
        .doesNotContain("depth-gauge/pom.xml");
  }

  @Test
  void make_gradle_hasTheWrapperOfThisProject() throws IOException {
    made.make("sensor", "depth-gauge", "--gradle");
    Path project = here.resolve("depth-gauge");
    for (String file :
        List.of(
            "gradlew",
            "gradlew.bat",
            "gradle/wrapper/gradle-wrapper.jar",
            "gradle/wrapper/gradle-wrapper.properties")) {
      assertThat(project.resolve(file)).hasSameBinaryContentAs(Path.of("..", file));
    }
    assertThat(project.resolve("gradlew")).isExecutable();
    assertThat(made.told()).contains("./gradlew build");
  }

  @Test
  void make_anyProject_hasTheVersionsOfThisBuild() throws IOException {
    made.make("sensor", "by-maven");
    made.make("sensor", "by-gradle", "--gradle");
    String ours = Files.readString(Path.of("../pom.xml"));
    String maven = Files.readString(here.resolve("by-maven/pom.xml"));
    String gradle = Files.readString(here.resolve("by-gradle/build.gradle.kts"));
    assertThat(maven)
        .contains("<version>" + property(ours, "junit.version") + "</version>")
        .contains("<version>" + property(ours, "assertj.version") + "</version>");
    assertThat(gradle)
        .contains("junit-jupiter:" + property(ours, "junit.version"))
        .contains("assertj-core:" + property(ours, "assertj.version"))
        .contains("junit-platform-launcher:" + property(ours, "junit-platform.version"));
    var plugins = Pattern.compile("<artifactId>(maven-\\w+-plugin)</artifactId>\\s*<version>[^<]+");
    plugins
        .matcher(maven)
        .results()
        .forEach(
            each ->
                assertThat(ours.replaceAll("\\s+", ""))
                    .contains(each.group().replaceAll("\\s+", "")));
  }

  private static String property(String pom, String name) {
    return pom.replaceAll("(?s).*<" + name + ">([^<]+)<.*", "$1");
  }
}
