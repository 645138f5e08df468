package org.u2sa.build;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.DirectoryStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.Paths;
import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/**
 * Fails where pom.xml and build.gradle.kts drift apart, and proves on a copy that it would see each
 * kind of drift.
 */
class BuildsAgreeTest {
  static final Path ROOT = Paths.get("").toAbsolutePath().getParent();
  private static final List<String> FILES =
      List.of(
          "pom.xml",
          "settings.gradle.kts",
          "gradle.properties",
          "gradle/libs.versions.toml",
          "build-logic/src/main/java/org/u2sa/build/JavaConventionsPlugin.java");

  @TempDir Path copy;

  @Test
  void bothBuilds_asTheyStand_agree() throws IOException {
    assertThat(MavenBuild.read(ROOT).differencesFrom(GradleBuild.read(ROOT))).isEmpty();
  }

  @Test
  void bothBuilds_asTheyStand_listAllModulesWithDependencies() throws IOException {
    assertThat(MavenBuild.read(ROOT).modules())
        .containsKeys("u2sa-messages", "u2sa-core", "u2sa-flightgear", "u2sa-bom");
    assertThat(MavenBuild.read(ROOT).modules().get("u2sa-core")).isNotEmpty();
    assertThat(GradleBuild.read(ROOT).bom())
        .contains("u2sa-messages", "u2sa-flightgear", "u2sa-abstract:test-jar:test-fixtures");
  }

  @ParameterizedTest(name = "{0}: {1} -> {2}")
  @CsvSource(
      delimiter = '|',
      textBlock =
          """
          pom.xml                          | <module>u2sa-sim</module>                 | <!-- -->                                  | module only in Gradle: u2sa-sim
          settings.gradle.kts              | include("u2sa-gcs")                       | // gone                                   | module only in Maven: u2sa-gcs
          pom.xml                          | <jackson.version>2                        | <jackson.version>3                        | version only in Maven: com.fasterxml.jackson.core:jackson-core = 3
          gradle/libs.versions.toml        | logback = "1                              | logback = "2                              | version only in Gradle: ch.qos.logback:logback-classic = 2
          settings.gradle.kts              | include("u2sa-android")                   | // gone                                   | module only in Maven: u2sa-android
          u2sa-android/build.gradle.kts    | api(libs.kotlin.stdlib)                   | // gone                                   | dependency of u2sa-android only in Maven: org.jetbrains.kotlin:kotlin-stdlib
          u2sa-core/build.gradle.kts       | api(libs.slf4j)                           | runtimeOnly(libs.slf4j)                   | dependency of u2sa-core only in Gradle: org.slf4j:slf4j-api
          u2sa-spark/build.gradle.kts      | compileOnly(libs.spark.core)              | api(libs.spark.core)                      | dependency of u2sa-spark only in Gradle: org.apache.spark:spark-core_2.13
          u2sa-spark/build.gradle.kts      | isTransitive = false                      | exclude(group = "x")                      | dependency of u2sa-spark only in Maven: org.scala-lang:scala-library
          u2sa-interfaces/build.gradle.kts | api(libs.paho)                            | // gone                                   | dependency of u2sa-interfaces only in Maven: org.eclipse.paho
          u2sa-core/pom.xml                | <scope>test</scope>                       | <scope>compile</scope>                    | dependency of u2sa-core only in Maven: org.u2sa:u2sa-abstract:test-fixtures
          u2sa-report/build.gradle.kts     | module = "xmlgraphics-commons"            | module = "jackson-core"                   | org.apache.xmlgraphics:jackson-core
          u2sa-bom/build.gradle.kts        | api(project(":u2sa-core"))                | // gone                                   | BOM only in Maven: u2sa-core
          u2sa-bom/build.gradle.kts        | listOf("u2sa-abstract")                   | listOf<String>()                          | BOM only in Maven: u2sa-abstract:test-jar:test-fixtures
          u2sa-bom/build.gradle.kts        | "type" to "test-jar",                     | // gone                                   | BOM only in Maven: u2sa-abstract:test-jar:test-fixtures
          u2sa-bom/pom.xml                 | <classifier>test-fixtures</classifier>    | <!-- -->                                  | BOM only in Gradle: u2sa-abstract:test-jar:test-fixtures
          gradle/libs.versions.toml        | test = ["junit", "assertj", "jqwik"]      | test = ["junit", "assertj"]               | dependency of every module only in Maven: net.jqwik:jqwik
          gradle.properties                | version=0                                 | version=1                                 | setting only in Gradle: version = 1
          pom.xml                          | <maven.compiler.release>17                | <maven.compiler.release>21                | setting only in Maven: Java release = 21
          pom.xml                          | <include>**/*Properties.java</include>    | <!-- -->                                  | setting only in Gradle: test classes = [**/*Properties
          u2sa-android/build.gradle.kts    | it.systemProperty("slf4j.provider"        | println("slf4j.provider"                  | setting only in Maven: test property of u2sa-android, slf4j.provider
          pom.xml                          | <arg>-Werror</arg>                        | <!-- -->                                  | setting only in Gradle: compiler arguments = [-Werror
          """)
  void differencesFrom_oneFileChanged_namesTheDifference(
      String file, String was, String becomes, String expected) throws IOException {
    change(file, was, becomes);
    assertThat(MavenBuild.read(copy).differencesFrom(GradleBuild.read(copy)))
        .anySatisfy(line -> assertThat(line).contains(expected));
  }

  @Test
  void read_dependencyInAFormThatCannotBeCompared_isRefused() throws IOException {
    change(
        "u2sa-core/build.gradle.kts",
        "dependencies {",
        "dependencies {\n    api(files(\"x.jar\"))");
    assertThatThrownBy(() -> GradleBuild.read(copy))
        .hasMessageContaining("u2sa-core")
        .hasMessageContaining("api(files(\"x.jar\"))");
  }

  @Test
  void read_moduleWithAnotherParentVersion_isRefused() throws IOException {
    change("u2sa-sim/pom.xml", "<version>0", "<version>9");
    assertThatThrownBy(() -> MavenBuild.read(copy)).hasMessageContaining("u2sa-sim/pom.xml");
  }

  private void change(String file, String was, String becomes) throws IOException {
    Path target = copy.resolve(file);
    String text = Files.readString(target);
    assertThat(text).contains(was);
    Files.writeString(target, text.replace(was, becomes));
  }

  @BeforeEach
  void copyBuildFiles() throws IOException {
    for (String file : FILES) {
      copyToSamePlace(ROOT.resolve(file));
    }
    try (DirectoryStream<Path> modules = Files.newDirectoryStream(ROOT, "u2sa-*")) {
      for (Path module : modules) {
        copyToSamePlace(module.resolve("pom.xml"));
        copyToSamePlace(module.resolve("build.gradle.kts"));
      }
    }
  }

  private void copyToSamePlace(Path file) throws IOException {
    Path target = copy.resolve(ROOT.relativize(file));
    Files.createDirectories(target.getParent());
    Files.copy(file, target);
  }
}
